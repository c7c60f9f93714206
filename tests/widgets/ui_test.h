#pragma once
// ImGui without a window: frames under the test's control, input by hand, as a user would give it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <functional>

#include "editor/widgets/theme.h"

namespace vamp::ui {

// Keys by GLFW's numbers, as the window delivers them.
enum Key : int { kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259, kDown = 264, kUp = 265, kControl = 341 };

class UiTest : public testing::Test {
 protected:
  UiTest() : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(1400, 600);
    io.DeltaTime = 0.05f;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.KeyMap[ImGuiKey_Escape] = kEscape;
    io.KeyMap[ImGuiKey_Enter] = kEnter;
    io.KeyMap[ImGuiKey_Tab] = kTab;
    io.KeyMap[ImGuiKey_Backspace] = kBackspace;
    io.KeyMap[ImGuiKey_DownArrow] = kDown;
    io.KeyMap[ImGuiKey_UpArrow] = kUp;
    io.KeyMap[ImGuiKey_A] = 'A';
    io.KeyMap[ImGuiKey_Space] = ' ';
    apply_theme(1);
    io.Fonts->Build();
  }
  ~UiTest() override { ImGui::DestroyContext(context_); }

  // One frame with `content` in a window of `size_` at (0, 0).
  void frame(const std::function<void()>& content) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(size_);
    ImGui::Begin("test", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
    content();
    ImGui::End();
    ImGui::Render();
  }
  static void move(float x, float y) { ImGui::GetIO().MousePos = ImVec2(x, y); }
  static void press(bool down, int button = 0) { ImGui::GetIO().MouseDown[button] = down; }
  static void key(int code, bool down) { ImGui::GetIO().KeysDown[code] = down; }
  static void type(const char* text) { ImGui::GetIO().AddInputCharactersUTF8(text); }

  ImGuiContext* context_;
  ImVec2 size_{400, 500};
};

}  // namespace vamp::ui
