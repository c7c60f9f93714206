#include "app/window/glfw_input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cstring>

#include "app/window/input.h"

namespace vamp::window {

namespace {

GlfwInput& of(GLFWwindow* window) { return *static_cast<GlfwInput*>(glfwGetWindowUserPointer(window)); }

// Pointer positions are in window coordinates, ImGui's in framebuffer pixels.
void move_to(GLFWwindow* window, double x, double y) {
  int width = 0, height = 0, pixels_x = 0, pixels_y = 0;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &pixels_x, &pixels_y);
  if (width > 0) x *= static_cast<double>(pixels_x) / width;
  if (height > 0) y *= static_cast<double>(pixels_y) / height;
  of(window).queue().mouse_moved(static_cast<float>(x), static_cast<float>(y));
}

// GLFW numbers keys by their place on a US keyboard; shortcuts mean the letter that is printed on the key.
int printed_key(int key, int scancode) {
  if (key < GLFW_KEY_APOSTROPHE || key > GLFW_KEY_GRAVE_ACCENT) return key;
  const char* name = glfwGetKeyName(key, scancode);
  if (name == nullptr || name[0] == 0 || name[1] != 0) return key;
  if (name[0] >= 'a' && name[0] <= 'z') return name[0] - 'a' + GLFW_KEY_A;
  if ((name[0] >= 'A' && name[0] <= 'Z') || (name[0] >= '0' && name[0] <= '9')) return name[0];
  return std::strchr("-=,./;'[]\\", name[0]) != nullptr ? name[0] : key;
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int) {
  if (action == GLFW_REPEAT || key < 0) return;  // ImGui repeats by itself
  of(window).queue().key(printed_key(key, scancode), action == GLFW_PRESS);
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
  for (int i = 0; i < count; ++i) of(window).events().dropped.emplace_back(paths[i]);
}

}  // namespace

GlfwInput::GlfwInput(GLFWwindow* window) : window_(window), queue_(std::make_unique<InputQueue>()) {
  glfwSetWindowUserPointer(window, this);
  glfwSetCursorPosCallback(window, move_to);
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (!entered && !ImGui::IsAnyMouseDown()) of(w).queue().mouse_left_window();
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
    of(w).queue().mouse_button(button, action == GLFW_PRESS);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    of(w).queue().wheel(static_cast<float>(x), static_cast<float>(y));
  });
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned c) { of(w).queue().character(c); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) { of(w).queue().focus(focused != 0); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).events().resized = true; });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).events().exposed = true; });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { of(w).events().scale_changed = true; });
  glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
    glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides: there may be unsaved changes
    of(w).events().close_wanted = true;
  });
  glfwSetDropCallback(window, on_drop);

  ImGuiIO& io = ImGui::GetIO();
  io.BackendPlatformName = "vamp_glfw";
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  map_keys(io);
  io.ClipboardUserData = window;
  io.GetClipboardTextFn = [](void* w) {
    const char* text = glfwGetClipboardString(static_cast<GLFWwindow*>(w));
    return text != nullptr ? text : "";
  };
  io.SetClipboardTextFn = [](void* w, const char* text) { glfwSetClipboardString(static_cast<GLFWwindow*>(w), text); };

  cursors_.assign(ImGuiMouseCursor_COUNT, nullptr);
  const auto cursor = [&](ImGuiMouseCursor shape, int glfw) {
    cursors_[static_cast<size_t>(shape)] = glfwCreateStandardCursor(glfw);
  };
  cursor(ImGuiMouseCursor_Arrow, GLFW_ARROW_CURSOR);
  cursor(ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR);
  cursor(ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR);
  cursor(ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR);
  cursor(ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR);
  cursor(ImGuiMouseCursor_ResizeAll, GLFW_CROSSHAIR_CURSOR);
}

GlfwInput::~GlfwInput() {
  for (GLFWcursor* cursor : cursors_) {
    if (cursor != nullptr) glfwDestroyCursor(cursor);
  }
  ImGuiIO& io = ImGui::GetIO();
  io.GetClipboardTextFn = nullptr;
  io.SetClipboardTextFn = nullptr;
}

bool GlfwInput::pending() const {
  return !queue_->empty() || events_.resized || events_.close_wanted || events_.exposed || events_.scale_changed ||
         !events_.dropped.empty();
}

void GlfwInput::update_cursor() {
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  if (wanted == shown_cursor_) return;
  shown_cursor_ = wanted;
  GLFWcursor* cursor = wanted >= 0 ? cursors_[static_cast<size_t>(wanted)] : nullptr;
  glfwSetCursor(window_, cursor != nullptr ? cursor : cursors_[ImGuiMouseCursor_Arrow]);
}

}  // namespace vamp::window
