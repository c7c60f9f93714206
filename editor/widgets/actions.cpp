#include "editor/widgets/actions.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>

#include "editor/widgets/controls.h"
#include "editor/widgets/edit.h"
#include "engine/core/check.h"

namespace vamp::ui {

namespace {

struct KeyName {
  std::string_view name;
  int key;
};
constexpr std::array kKeys{
    KeyName{"Space", 32},      KeyName{"Esc", 256},    KeyName{"Enter", 257},  KeyName{"Tab", 258},
    KeyName{"Backspace", 259}, KeyName{"Insert", 260}, KeyName{"Delete", 261}, KeyName{"Right", 262},
    KeyName{"Left", 263},      KeyName{"Down", 264},   KeyName{"Up", 265},     KeyName{"PageUp", 266},
    KeyName{"PageDown", 267},  KeyName{"Home", 268},   KeyName{"End", 269},    KeyName{"Plus", 61},
    KeyName{"Minus", 45},
};

int key_of(std::string_view name) {
  for (const KeyName& key : kKeys) {
    if (key.name == name) return key.key;
  }
  if (name.size() == 1) return name[0];
  if (name.size() <= 3 && name[0] == 'F') {
    const int number = name.size() == 2 ? name[1] - '0' : (name[1] - '0') * 10 + name[2] - '0';
    if (number >= 1 && number <= 12) return 289 + number;
  }
  return 0;
}

// Keys that a text field needs for itself.
bool text_field_uses(const Shortcut& s) {
  if (s.alt) return false;
  if (s.key >= 290 && s.key <= 301) return false;
  if (!s.ctrl) return true;
  constexpr std::string_view kEditing = "ZYXCVA";
  return kEditing.find(static_cast<char>(s.key)) != std::string_view::npos || s.key >= 256;
}

}  // namespace

Shortcut parse_shortcut(std::string_view text) {
  Shortcut shortcut;
  while (!text.empty()) {
    const size_t plus = text.find('+');
    const std::string_view part = text.substr(0, plus);
    text = plus == std::string_view::npos ? std::string_view() : text.substr(plus + 1);
    if (part == "Ctrl") {
      shortcut.ctrl = true;
    } else if (part == "Shift") {
      shortcut.shift = true;
    } else if (part == "Alt") {
      shortcut.alt = true;
    } else {
      shortcut.key = key_of(part);
      CHECK(shortcut.key != 0 && text.empty());
    }
  }
  return shortcut;
}

void Actions::add(Action action) {
  CHECK(find(action.id) == nullptr);
  const Shortcut shortcut = parse_shortcut(action.shortcut);
  CHECK(shortcut.key == 0 || std::find(shortcuts_.begin(), shortcuts_.end(), shortcut) == shortcuts_.end());
  shortcuts_.push_back(shortcut);
  actions_.push_back(std::move(action));
}

void Actions::add_menu_part(const std::string& menu, std::function<void()> draw) {
  parts_[menu].push_back(std::move(draw));
}

const Action* Actions::find(std::string_view id) const {
  for (const Action& action : actions_) {
    if (action.id == id) return &action;
  }
  return nullptr;
}

bool Actions::run(std::string_view id) {
  const Action* action = find(id);
  if (action == nullptr || !is_enabled(*action)) return false;
  action->run();
  return true;
}

void Actions::handle_shortcuts() {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::GetTopMostPopupModal() != nullptr || edit_is_open()) return;
  static const int kEscape = parse_shortcut("Esc").key;
  for (size_t i = 0; i < actions_.size(); ++i) {
    const Shortcut& s = shortcuts_[i];
    if (s.key == 0 || s.ctrl != io.KeyCtrl || s.shift != io.KeyShift || s.alt != io.KeyAlt) continue;
    if (!ImGui::IsKeyPressed(s.key, false)) continue;
    if (io.WantTextInput && text_field_uses(s)) continue;
    if (popup_was_open_ && s.key == kEscape) continue;  // it closed that
    run(actions_[i].id);
    return;
  }
}

void Actions::draw_item(const Action& action) {
  const bool checked = action.checked && action.checked();
  const char* shortcut = action.shortcut.empty() ? nullptr : action.shortcut.c_str();
  ImGui::PushID(action.id.c_str());
  const std::string label = action.text ? action.text() : action.label;
  if (ImGui::MenuItem((label + "###item").c_str(), shortcut, checked, is_enabled(action))) action.run();
  ImGui::PopID();
}

// The entries of one menu; submenus where their first action stands.
void Actions::draw_menu(const std::string& path) {
  std::vector<std::string> submenus;
  int group = -1;
  for (size_t i = 0; i < actions_.size(); ++i) {
    const Action& action = actions_[i];
    const bool here = action.menu == path;
    const bool below = action.menu.size() > path.size() && action.menu.starts_with(path + "/");
    if (!here && !below) continue;
    if (below) {
      const std::string sub = action.menu.substr(0, action.menu.find('/', path.size() + 1));
      if (std::find(submenus.begin(), submenus.end(), sub) != submenus.end()) continue;
      submenus.push_back(sub);
      if (group >= 0 && action.group != group) ImGui::Separator();
      if (ImGui::BeginMenu(sub.substr(path.size() + 1).c_str())) {
        draw_menu(sub);
        ImGui::EndMenu();
      }
    } else {
      if (group >= 0 && action.group != group) ImGui::Separator();
      draw_item(action);
    }
    group = action.group;
  }
  if (const auto parts = parts_.find(path); parts != parts_.end()) {
    for (const auto& draw : parts->second) draw();
  }
}

void Actions::draw_menus() {
  std::vector<std::string> menus;
  for (const Action& action : actions_) {
    if (action.menu.empty()) continue;
    std::string top = action.menu.substr(0, action.menu.find('/'));
    if (std::find(menus.begin(), menus.end(), top) == menus.end()) menus.push_back(std::move(top));
  }
  for (const std::string& menu : menus) {
    if (!ImGui::BeginMenu(menu.c_str())) continue;
    draw_menu(menu);
    ImGui::EndMenu();
  }
}

void Actions::tool(std::string_view id, const char* label) {
  const Action* action = find(id);
  CHECK(action != nullptr);
  std::string tip = action->text ? action->text() : action->tooltip.empty() ? action->label : action->tooltip;
  if (!action->shortcut.empty()) tip += "  (" + action->shortcut + ")";
  const std::string shown = (*label != 0 ? std::string(label) : action->label) + "###" + action->id;
  const bool checked = action->checked && action->checked();
  if (tool_button(shown.c_str(), checked, is_enabled(*action), tip.c_str())) action->run();
  ImGui::SameLine();
}

}  // namespace vamp::ui
