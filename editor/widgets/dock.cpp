#include "editor/widgets/dock.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/places.h"
#include "editor/widgets/theme.h"
#include "engine/core/check.h"

namespace vamp::ui {

namespace {
constexpr float kSplitter = 4;
constexpr float kTabHeight = 30;
}  // namespace

Dock::Dock(std::function<DockLayout()> make_default)
    : make_default_(std::move(make_default)), layout_(make_default_()) {}

void Dock::add(Panel panel) {
  CHECK(find(panel.id) == nullptr);
  if (panel.central) central_ = panel.id;
  panels_.push_back(std::move(panel));
  reconciled_ = false;
}

const Panel* Dock::find(std::string_view id) const {
  for (const Panel& panel : panels_) {
    if (panel.id == id) return &panel;
  }
  return nullptr;
}

void Dock::reconcile() {
  if (std::exchange(reconciled_, true)) return;
  std::vector<DockPlace> places;
  for (const Panel& panel : panels_) places.push_back({panel.id, panel.beside, panel.hidden});
  layout_.reconcile(places);
  if (!central_.empty() && !layout_.visible(central_)) layout_.show(central_, "");
}

Status Dock::restore(std::string_view text, std::string_view file) {
  Result<DockLayout> stored = DockLayout::parse(text, file);
  layout_ = stored ? std::move(*stored) : make_default_();
  reconciled_ = false;
  if (!stored) return tl::unexpected(std::move(stored).error());
  return {};
}

void Dock::reset() {
  if (drawing_) {
    later_.emplace_back([this] { reset(); });
    return;
  }
  layout_ = make_default_();
  reconciled_ = false;
  changed_ = true;
}

void Dock::show(const std::string& panel) {
  if (drawing_) {
    later_.emplace_back([this, panel] { show(panel); });
    return;
  }
  reconcile();
  const Panel* known = find(panel);
  if (known == nullptr) return;
  layout_.show(panel, known->beside);
  changed_ = true;
}

void Dock::close(const std::string& panel) {
  if (drawing_) {
    later_.emplace_back([this, panel] { close(panel); });
    return;
  }
  if (panel == central_) return;
  layout_.close(panel);
  changed_ = true;
}

const Panel* Dock::central_in(const DockNode& node) const {
  return !central_.empty() && node.holds(central_) ? find(central_) : nullptr;
}

// The least room for a part of the tree.
ImVec2 Dock::least(const DockNode& node) const {
  if (node.is_leaf()) return central_in(node) != nullptr ? ImVec2(px(160), px(120)) : ImVec2(px(150), px(90));
  const ImVec2 a = node.collapsed == 1 ? ImVec2() : least(*node.first);
  const ImVec2 b = node.collapsed == 2 ? ImVec2() : least(*node.second);
  if (node.kind == DockNode::Kind::row) return ImVec2(a.x + b.x + px(kSplitter), std::max(a.y, b.y));
  return ImVec2(std::max(a.x, b.x), a.y + b.y + px(kSplitter));
}

void Dock::draw(ImVec2 low, ImVec2 high) {
  reconcile();
  drop_ = {};
  focused_.clear();
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, theme().line);
  drawing_ = true;
  draw_node(layout_.root(), low, high);
  drawing_ = false;
  finish_drag();
  for (const auto& wish : std::exchange(later_, {})) wish();
}

void Dock::draw_node(DockNode& node, ImVec2 low, ImVec2 high) {
  if (high.x - low.x < 1 || high.y - low.y < 1) return;
  if (node.is_leaf()) {
    draw_leaf(node, low, high);
  } else {
    draw_split(node, low, high);
  }
}

void Dock::draw_split(DockNode& node, ImVec2 low, ImVec2 high) {
  const int axis = node.kind == DockNode::Kind::row ? 0 : 1;
  const float bar = px(kSplitter);
  const float room = std::max((high[static_cast<size_t>(axis)] - low[static_cast<size_t>(axis)]) - bar, 0.0f);
  const auto along = [&](const ImVec2& v) { return axis == 0 ? v.x : v.y; };
  const bool fixed_first = central_in(*node.second) != nullptr;
  const bool fixed_second = central_in(*node.first) != nullptr;
  const int collapsible = fixed_first ? 1 : 2;

  // How much the first child gets; a too small window shares by what each needs at least.
  const float least_first = along(least(*node.first)), least_second = along(least(*node.second));
  float size = fixed_first ? px(node.pixels) : fixed_second ? room - px(node.pixels) : std::round(room * node.fraction);
  if (least_first + least_second >= room) {
    size = std::round(room * least_first / std::max(least_first + least_second, 1.0f));
  } else {
    size = std::clamp(size, least_first, room - least_second);
  }
  if (node.collapsed == 1) size = 0;
  if (node.collapsed == 2) size = room;

  const float at = along(low) + size;
  const ImRect splitter = axis == 0 ? ImRect(at, low.y, at + bar, high.y) : ImRect(low.x, at, high.x, at + bar);
  ImGui::PushID(&node);
  const ImGuiID id = ImGui::GetID("splitter");
  ImGui::PopID();
  bool hovered = false, held = false;
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  if (ImGui::ItemAdd(splitter, id)) ImGui::ButtonBehavior(splitter, id, &hovered, &held);
  ImGui::PopItemFlag();
  if (hovered || held) ImGui::SetMouseCursor(axis == 0 ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (hovered && ImGui::IsMouseDoubleClicked(0)) {
    node.collapsed = node.collapsed != 0 ? 0 : collapsible;
    changed_ = true;
    held = false;
  }
  if (held && ImGui::IsMouseDragging(0, 1) && room > 0) {
    const float wanted = along(ImGui::GetIO().MousePos) - along(low) - bar / 2;
    const float admitted = std::clamp(wanted, std::min(least_first, room), std::max(room - least_second, least_first));
    node.collapsed = 0;
    node.fraction = std::clamp(admitted / room, 0.0f, 1.0f);
    node.pixels = (fixed_first ? admitted : room - admitted) / theme().scale;
    changed_ = true;
  }
  ImGui::GetWindowDrawList()->AddRectFilled(splitter.Min, splitter.Max,
                                            held || hovered ? theme().accent : theme().line);
  const ImVec2 first_high = axis == 0 ? ImVec2(at, high.y) : ImVec2(high.x, at);
  const ImVec2 second_low = axis == 0 ? ImVec2(at + bar, low.y) : ImVec2(low.x, at + bar);
  draw_node(*node.first, low, first_high);
  draw_node(*node.second, second_low, high);
}

void Dock::draw_leaf(DockNode& leaf, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (leaf.tabs.empty()) {
    list.AddRectFilled(low, high, theme().ground);
    return;
  }
  leaf.active = std::min(leaf.active, leaf.tabs.size() - 1);
  const bool bare = leaf.tabs.size() == 1 && leaf.tabs.front() == central_;
  const float top = bare ? low.y : draw_tabs(leaf, low, ImVec2(high.x, low.y + px(kTabHeight)));
  const Panel* panel = find(leaf.tabs[leaf.active]);
  if (panel != nullptr && high.y > top) {
    ImGui::SetCursorScreenPos(ImVec2(low.x, top));
    const bool padded = !panel->central;
    ImGuiWindowFlags flags = padded ? ImGuiWindowFlags_AlwaysUseWindowPadding
                                    : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    flags |= ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padded ? ImVec2(px(8), px(6)) : ImVec2(0, 0));
    const bool open = ImGui::BeginChild(panel->id.c_str(), ImVec2(high.x - low.x, high.y - top), false, flags);
    ImGui::PopStyleVar();
    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows)) focused_ = panel->id;
    if (open) panel->draw();
    ImGui::EndChild();
  }
  if (!dragged_.empty()) aim(leaf, low, high, top);
}

float Dock::draw_tabs(DockNode& leaf, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, theme().ground);
  // Tabs as wide as their titles, all a little narrower where they do not fit.
  std::vector<float> widths;
  float sum = 0;
  for (const std::string& id : leaf.tabs) {
    const Panel* panel = find(id);
    widths.push_back(ImGui::CalcTextSize(panel != nullptr ? panel->title.c_str() : "").x + px(24));
    sum += widths.back();
  }
  const float squeeze = std::min(1.0f, (high.x - low.x) / std::max(sum, 1.0f));
  float x = low.x;
  for (size_t i = 0; i < leaf.tabs.size(); ++i) {
    const std::string id = leaf.tabs[i];
    const Panel* panel = find(id);
    if (panel == nullptr) continue;
    const ImRect tab(x, low.y, std::floor(x + widths[i] * squeeze), high.y);
    x = tab.Max.x;
    ImGui::PushID(id.c_str());
    const ImGuiID item = ImGui::GetID("tab");
    if (panel != nullptr) note_place(panel->title.c_str(), tab.Min, tab.Max);
    bool hovered = false, held = false;
    if (ImGui::ItemAdd(tab, item)) {
      const ImGuiButtonFlags on_press = ImGuiButtonFlags_PressedOnClick;
      if (ImGui::ButtonBehavior(tab, item, &hovered, &held, on_press) && leaf.active != i) {
        leaf.active = i;
        changed_ = true;
      }
      if (held && ImGui::IsMouseDragging(0, px(6)) && id != central_) dragged_ = id;
      if (hovered && ImGui::IsMouseClicked(2) && id != central_) close(id);
      if (hovered && ImGui::IsMouseReleased(1)) ImGui::OpenPopup("menu");
    }
    const bool selected = leaf.active == i;
    if (selected) {
      list.AddRectFilled(tab.Min, tab.Max, theme().panel);
      list.AddRectFilled(tab.Min, ImVec2(tab.Max.x, tab.Min.y + px(2)), theme().accent_line);
    } else if (hovered) {
      list.AddRectFilled(tab.Min, tab.Max, IM_COL32(44, 44, 44, 255));
    }
    ImGui::RenderNavHighlight(tab, item);
    ImGui::PushStyleColor(ImGuiCol_Text, selected ? theme().text : theme().label);
    const ImVec2 text(tab.Min.x + px(12) * squeeze, std::floor(tab.GetCenter().y - ImGui::GetFontSize() / 2));
    const float end = tab.Max.x - px(12) * squeeze + 2;
    ImGui::RenderTextEllipsis(&list, text, ImVec2(end, tab.Max.y), end, end, panel->title.c_str(), nullptr, nullptr);
    ImGui::PopStyleColor();
    if (ImGui::BeginPopup("menu")) {
      if (ImGui::MenuItem("Close panel", nullptr, false, id != central_)) close(id);
      if (ImGui::MenuItem("Reset layout")) reset();
      ImGui::EndPopup();
    }
    ImGui::PopID();
  }
  return high.y;
}

// Where the dragged tab would go, if the pointer is over this leaf.
void Dock::aim(DockNode& leaf, ImVec2 low, ImVec2 high, float tabs_end) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (mouse.x < low.x || mouse.x >= high.x || mouse.y < low.y || mouse.y >= high.y) return;
  ImRect preview(low, high);
  drop_ = {&leaf, DockSide::middle, leaf.tabs.size()};
  const bool central_alone = tabs_end <= low.y;
  if (mouse.y < tabs_end) {
    // Between tabs: before the one under the pointer.
    float x = low.x;
    for (size_t i = 0; i < leaf.tabs.size(); ++i) {
      const Panel* panel = find(leaf.tabs[i]);
      const float width = ImGui::CalcTextSize(panel != nullptr ? panel->title.c_str() : "").x + px(24);
      if (mouse.x < x + width / 2) {
        drop_.index = i;
        break;
      }
      x += width;
    }
    preview = ImRect(x - px(1), low.y, x + px(2), tabs_end);
  } else {
    const float fx = (mouse.x - low.x) / (high.x - low.x), fy = (mouse.y - low.y) / (high.y - low.y);
    const float edge = std::min({fx, 1 - fx, fy, 1 - fy});
    if (edge < 0.28f || central_alone) {
      const ImVec2 half((high.x - low.x) / 2, (high.y - low.y) / 2);
      if (edge == fx) {
        drop_.side = DockSide::left;
        preview.Max.x = low.x + half.x;
      } else if (edge == 1 - fx) {
        drop_.side = DockSide::right;
        preview.Min.x = low.x + half.x;
      } else if (edge == fy) {
        drop_.side = DockSide::top;
        preview.Max.y = low.y + half.y;
      } else {
        drop_.side = DockSide::bottom;
        preview.Min.y = low.y + half.y;
      }
    }
  }
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRectFilled(preview.Min, preview.Max, IM_COL32(74, 144, 200, 70));
  list.AddRect(preview.Min, preview.Max, theme().accent_line, 0, 0, px(1));
}

void Dock::finish_drag() {
  if (dragged_.empty()) return;
  if (ImGui::IsKeyPressedMap(ImGuiKey_Escape, false)) {
    dragged_.clear();
    return;
  }
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (ImGui::IsMouseDown(0)) return;
  if (drop_.leaf != nullptr) {
    layout_.move(dragged_, *drop_.leaf, drop_.side, drop_.index);
    changed_ = true;
  }
  dragged_.clear();
}

}  // namespace vamp::ui
