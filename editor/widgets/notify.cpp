#include "editor/widgets/notify.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "editor/widgets/controls.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/theme.h"
#include "engine/core/check.h"

namespace vamp::ui {

namespace {

struct Message {
  Notice kind;
  std::string text;
  double until;  // ImGui's time; infinite for errors
  std::string button = {};
  std::function<void()> pressed = {};
};
std::vector<Message> g_messages;

double lifetime(Notice kind) {
  if (kind == Notice::error) return 1e30;
  return kind == Notice::warning ? 8 : 4;
}

ImU32 stripe(Notice kind) {
  switch (kind) {
    case Notice::done:
      return IM_COL32(96, 160, 110, 255);
    case Notice::warning:
      return theme().changed;
    case Notice::error:
      return theme().error;
    case Notice::info:
      break;
  }
  return theme().accent_line;
}

void show(Message message) {
  std::erase_if(g_messages, [&](const Message& other) { return other.text == message.text; });
  if (g_messages.size() >= 6) g_messages.erase(g_messages.begin());
  g_messages.push_back(std::move(message));
}

}  // namespace

void notify(Notice kind, std::string text) { show({kind, std::move(text), ImGui::GetTime() + lifetime(kind)}); }

void notify(Notice kind, std::string text, std::string button, std::function<void()> pressed) {
  constexpr double kTimeToDecide = 20;
  show({kind, std::move(text), ImGui::GetTime() + std::max(lifetime(kind), kTimeToDecide), std::move(button),
        std::move(pressed)});
}

void draw_notices(ImVec2 low, ImVec2 high) {
  const double now = ImGui::GetTime();
  std::erase_if(g_messages, [&](const Message& message) { return message.until <= now; });
  std::function<void()> pressed;
  float bottom = high.y - px(12);
  const float width = std::min(px(420), high.x - low.x - px(24));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
  for (size_t i = g_messages.size(); i-- > 0;) {
    Message& message = g_messages[i];
    request_frame(message.until - now);
    char name[32];
    ImFormatString(name, sizeof name, "##notice%zu", i);
    const float wrap = width - px(44);
    const ImVec2 text = ImGui::CalcTextSize(message.text.c_str(), nullptr, false, wrap);
    const bool asks = !message.button.empty();
    const ImVec2 size(width, text.y + px(asks ? 54 : 20));
    ImGui::SetNextWindowPos(ImVec2(high.x - px(12) - width, bottom - size.y));
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(58, 58, 58, 255));
    if (ImGui::Begin(name, nullptr, flags)) {
      ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
      const ImVec2 at = ImGui::GetWindowPos();
      ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + px(4), at.y + size.y), stripe(message.kind));
      ImGui::SetCursorScreenPos(ImVec2(at.x + px(14), at.y + px(10)));
      ImGui::PushTextWrapPos(px(14) + wrap);
      ImGui::TextUnformatted(message.text.c_str());
      ImGui::PopTextWrapPos();
      ImGui::SetCursorScreenPos(ImVec2(at.x + width - px(24), at.y + px(6)));
      if (icon_button("##close", Icon::close, "")) message.until = 0;
      if (asks) {
        ImGui::SetCursorScreenPos(ImVec2(at.x + px(14), at.y + text.y + px(18)));
        if (ImGui::Button(message.button.c_str(), ImVec2(0, px(26)))) {
          pressed = message.pressed;
          message.until = 0;
        }
      } else if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) {
        message.until = 0;
      }
    }
    ImGui::End();
    ImGui::PopStyleColor();
    if (message.until == 0) request_frame(0);
    bottom -= size.y + px(8);
  }
  if (pressed) pressed();  // it may have something to say itself
}

bool begin_dialog(const char* title, bool& open, float width) {
  if (!open) return false;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(width), screen.x - px(20)), 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(14), px(12)));
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse;
  const bool shown = ImGui::BeginPopupModal(title, &open, flags);
  ImGui::PopStyleVar();
  if (!shown) return false;
  // Esc in a text field first leaves the field.
  if (ImGui::IsKeyPressedMap(ImGuiKey_Escape, false) && !ImGui::IsAnyItemActive()) open = false;
  return true;
}

void end_dialog() { ImGui::EndPopup(); }

void Question::ask(std::string title, std::string text, std::vector<std::string> buttons,
                   std::function<void(size_t)> answer) {
  CHECK(!buttons.empty() && buttons.size() <= 4);
  title_ = std::move(title);
  text_ = std::move(text);
  buttons_ = std::move(buttons);
  answer_ = std::move(answer);
  open_ = true;
}

void Question::draw() {
  if (!open_) return;
  size_t chosen = buttons_.size();
  bool open = true;
  if (begin_dialog((title_ + "###question").c_str(), open, 440)) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text_.c_str());
    ImGui::PopTextWrapPos();
    gap(10);
    // Right-aligned, the main button first.
    float total = 0;
    std::vector<float> widths;
    for (const std::string& button : buttons_) {
      widths.push_back(std::max(px(84), ImGui::CalcTextSize(button.c_str()).x + px(24)));
      total += widths.back() + ImGui::GetStyle().ItemSpacing.x;
    }
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetWindowContentRegionMax().x - total));
    for (size_t i = 0; i < buttons_.size(); ++i) {
      const bool pressed = i == 0 ? primary_button(buttons_[i].c_str(), widths[i])
                                  : ImGui::Button(buttons_[i].c_str(), ImVec2(widths[i], px(28)));
      if (pressed) chosen = i;
      if (i == 0 && ImGui::IsWindowAppearing()) ImGui::SetItemDefaultFocus();
      ImGui::SameLine();
    }
    ImGui::NewLine();
    const bool enter =
        ImGui::IsKeyPressedMap(ImGuiKey_Enter, false) || ImGui::IsKeyPressedMap(ImGuiKey_KeyPadEnter, false);
    if (enter && !ImGui::IsWindowAppearing() && chosen == buttons_.size()) chosen = 0;
    if (chosen < buttons_.size() || !open) ImGui::CloseCurrentPopup();
    end_dialog();
  }
  if (!open) chosen = buttons_.size() - 1;
  if (chosen == buttons_.size()) return;
  open_ = false;
  // The answer may ask the next question.
  const auto answer = std::exchange(answer_, nullptr);
  if (answer) answer(chosen);
}

}  // namespace vamp::ui
