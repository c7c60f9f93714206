#include "editor/widgets/dock_layout.h"

#include <algorithm>
#include <functional>
#include <set>

#include "engine/core/check.h"
#include "engine/core/json.h"

namespace vamp::ui {

namespace {

constexpr int kVersion = 1;
constexpr int kDepth = 12;  // of nested splits

using NodePointer = std::unique_ptr<DockNode>;

void for_each_leaf(DockNode& node, const std::function<void(DockNode&)>& visit) {
  if (node.is_leaf()) return visit(node);
  for_each_leaf(*node.first, visit);
  for_each_leaf(*node.second, visit);
}

// Removes empty leaves; their neighbours take the room. The last leaf stays.
void prune(NodePointer& node) {
  if (node->is_leaf()) return;
  prune(node->first);
  prune(node->second);
  const auto empty = [](const DockNode& child) { return child.is_leaf() && child.tabs.empty(); };
  if (empty(*node->first)) {
    NodePointer rest = std::move(node->second);
    node = std::move(rest);
  } else if (empty(*node->second)) {
    NodePointer rest = std::move(node->first);
    node = std::move(rest);
  }
}

NodePointer split(DockNode::Kind kind, NodePointer first, NodePointer second, float pixels, float fraction) {
  auto node = std::make_unique<DockNode>();
  node->kind = kind;
  node->first = std::move(first);
  node->second = std::move(second);
  node->pixels = pixels;
  node->fraction = fraction;
  return node;
}

Json write_node(const DockNode& node) {
  Json json = Json::object();
  if (node.is_leaf()) {
    json["tabs"] = node.tabs;
    json["active"] = node.active;
    return json;
  }
  json["split"] = node.kind == DockNode::Kind::row ? "row" : "column";
  json["pixels"] = json_number(node.pixels);
  json["fraction"] = json_number(node.fraction);
  json["collapsed"] = node.collapsed;
  json["first"] = write_node(*node.first);
  json["second"] = write_node(*node.second);
  return json;
}

NodePointer read_node(const JsonReader& json, int depth, std::set<std::string>& seen) {
  auto node = std::make_unique<DockNode>();
  if (!json.has("split")) {
    const JsonReader tabs = json.member("tabs");
    for (size_t i = 0, count = tabs.size(64); i < count; ++i) {
      std::string panel = tabs.element(i).text(64);
      if (seen.insert(panel).second) node->tabs.push_back(std::move(panel));
    }
    node->active = static_cast<size_t>(json.member("active").integer(0, 63));
    return node;
  }
  const std::string kind = json.member("split").text(16);
  if (kind != "row" && kind != "column") json.member("split").refuse("row or column", kind);
  if (depth >= kDepth) {
    json.refuse("at most 12 nested splits", "more");
    return node;
  }
  node->kind = kind == "row" ? DockNode::Kind::row : DockNode::Kind::column;
  node->pixels = json.member("pixels").number(0, 100000);
  node->fraction = json.member("fraction").number(0, 1);
  node->collapsed = static_cast<int>(json.member("collapsed").integer(0, 2));
  node->first = read_node(json.member("first"), depth + 1, seen);
  node->second = read_node(json.member("second"), depth + 1, seen);
  return node;
}

}  // namespace

bool DockNode::holds(std::string_view panel) const {
  if (is_leaf()) return std::find(tabs.begin(), tabs.end(), panel) != tabs.end();
  return first->holds(panel) || second->holds(panel);
}

NodePointer DockLayout::leaf(std::vector<std::string> tabs) {
  auto node = std::make_unique<DockNode>();
  node->tabs = std::move(tabs);
  return node;
}

NodePointer DockLayout::row(NodePointer first, NodePointer second, float pixels, float fraction) {
  return split(DockNode::Kind::row, std::move(first), std::move(second), pixels, fraction);
}

NodePointer DockLayout::column(NodePointer first, NodePointer second, float pixels, float fraction) {
  return split(DockNode::Kind::column, std::move(first), std::move(second), pixels, fraction);
}

Result<DockLayout> DockLayout::parse(std::string_view text, std::string_view file) {
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader reader(json, file);
  if (reader.member("format").text(32) != "vamp-layout") {
    return fail(ErrorKind::bad_input, file, "format", "vamp-layout");
  }
  reader.member("version").integer(1, kVersion);
  std::set<std::string> seen;
  DockLayout layout(read_node(reader.member("root"), 0, seen));
  const JsonReader closed = reader.member("closed");
  for (size_t i = 0, count = closed.size(64); i < count; ++i) layout.closed_.push_back(closed.element(i).text(64));
  VAMP_CHECK_STATUS(reader.status());
  prune(layout.root_);
  return layout;
}

std::string DockLayout::print() const {
  Json json = Json::object();
  json["format"] = "vamp-layout";
  json["version"] = kVersion;
  json["root"] = write_node(*root_);
  json["closed"] = closed_;
  return print_json(json);
}

DockNode* DockLayout::leaf_of(std::string_view panel) {
  DockNode* found = nullptr;
  for_each_leaf(*root_, [&](DockNode& leaf) {
    if (leaf.holds(panel)) found = &leaf;
  });
  return found;
}

void DockLayout::remove(std::string_view panel) {
  for_each_leaf(*root_, [&](DockNode& leaf) {
    const auto at = std::find(leaf.tabs.begin(), leaf.tabs.end(), panel);
    if (at == leaf.tabs.end()) return;
    const auto index = static_cast<size_t>(at - leaf.tabs.begin());
    leaf.tabs.erase(at);
    if (leaf.active > index || leaf.active >= leaf.tabs.size()) leaf.active = leaf.active > 0 ? leaf.active - 1 : 0;
  });
}

void DockLayout::reconcile(std::span<const DockPlace> places) {
  const auto known = [&](const std::string& panel) {
    return std::any_of(places.begin(), places.end(), [&](const DockPlace& place) { return place.panel == panel; });
  };
  std::vector<std::string> gone;
  for_each_leaf(*root_, [&](DockNode& leaf) {
    for (const std::string& panel : leaf.tabs) {
      if (!known(panel)) gone.push_back(panel);
    }
  });
  for (const std::string& panel : gone) remove(panel);
  std::erase_if(closed_, [&](const std::string& panel) { return !known(panel); });
  for (const DockPlace& place : places) {
    const bool closed = std::find(closed_.begin(), closed_.end(), place.panel) != closed_.end();
    if (visible(place.panel) || closed) continue;
    if (place.hidden) {
      closed_.push_back(place.panel);
      continue;
    }
    // A new panel joins quietly: it does not cover the tab that the user had in front.
    DockNode* target = leaf_of(place.beside);
    if (target == nullptr) for_each_leaf(*root_, [&](DockNode& leaf) { target = &leaf; });
    target->tabs.push_back(place.panel);
  }
  prune(root_);
}

void DockLayout::show(const std::string& panel, std::string_view beside) {
  std::erase(closed_, panel);
  DockNode* target = leaf_of(panel);
  if (target == nullptr) {
    target = leaf_of(beside);
    if (target == nullptr) for_each_leaf(*root_, [&](DockNode& leaf) { target = &leaf; });
    target->tabs.push_back(panel);
  }
  target->active =
      static_cast<size_t>(std::find(target->tabs.begin(), target->tabs.end(), panel) - target->tabs.begin());
  // Open what is collapsed around it.
  for (DockNode* node = root_.get(); !node->is_leaf();) {
    const bool in_first = node->first->holds(panel);
    if (node->collapsed == (in_first ? 1 : 2)) node->collapsed = 0;
    node = in_first ? node->first.get() : node->second.get();
  }
}

void DockLayout::close(std::string_view panel) {
  if (!visible(panel)) return;
  remove(panel);
  closed_.emplace_back(panel);
  prune(root_);
}

void DockLayout::move(const std::string& panel, DockNode& target, DockSide side, size_t index) {
  CHECK(target.is_leaf());
  const bool alone = target.tabs.size() == 1 && target.tabs.front() == panel;
  if (alone) return;
  if (side == DockSide::middle) {
    // An index counted before the removal of the panel from the same leaf.
    const auto old = std::find(target.tabs.begin(), target.tabs.end(), panel);
    if (old != target.tabs.end() && static_cast<size_t>(old - target.tabs.begin()) < index) --index;
    remove(panel);
    index = std::min(index, target.tabs.size());
    target.tabs.insert(target.tabs.begin() + static_cast<std::ptrdiff_t>(index), panel);
    target.active = index;
  } else {
    remove(panel);
    auto rest = std::make_unique<DockNode>(std::move(target));
    NodePointer added = leaf({panel});
    const bool before = side == DockSide::left || side == DockSide::top;
    const bool across = side == DockSide::left || side == DockSide::right;
    target = DockNode();
    target.kind = across ? DockNode::Kind::row : DockNode::Kind::column;
    target.pixels = across ? 260 : 220;
    target.first = before ? std::move(added) : std::move(rest);
    target.second = before ? std::move(rest) : std::move(added);
  }
  prune(root_);
}

}  // namespace vamp::ui
