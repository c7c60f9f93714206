#include "app/window/window.h"

#define GLFW_INCLUDE_VULKAN  // for glfwCreateWindowSurface
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "app/window/glfw_input.h"
#include "app/window/input.h"
#include "app/window/painter.h"
#include "app/window/swapchain.h"
#include "app/window/textures.h"
#include "engine/core/clock.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"

namespace vamp::window {

namespace {

std::string glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

// GLFW's own messages go into the errors that we return.
Status start_glfw() {
  static bool started = false;
  if (started) return {};
  if (glfwInit() == GLFW_FALSE) {
    return fail(ErrorKind::failed, "window", "", "a display (DISPLAY or WAYLAND_DISPLAY is set)", glfw_error());
  }
  if (glfwVulkanSupported() == GLFW_FALSE) {
    return fail(ErrorKind::no_device, "window", "", "a Vulkan driver that can show windows", glfw_error());
  }
  started = true;
  return {};
}

// The stored place, moved so that the title bar can be reached on some monitor.
Place on_a_monitor(Place place) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  place.width = std::clamp(place.width, 480, 16384);
  place.height = std::clamp(place.height, 320, 16384);
  bool reachable = false;
  for (int i = 0; i < count; ++i) {
    int x = 0, y = 0, w = 0, h = 0;
    glfwGetMonitorWorkarea(monitors[i], &x, &y, &w, &h);
    if (i == 0) {
      place.width = std::min(place.width, std::max(w, 480));
      place.height = std::min(place.height, std::max(h, 320));
    }
    reachable = reachable ||
                (place.x + place.width > x + 80 && place.x < x + w - 80 && place.y >= y - 8 && place.y < y + h - 80);
  }
  place.placed = place.placed && reachable;
  return place;
}

}  // namespace

struct Window::State {
  gpu::Device* device = nullptr;
  Textures* textures = nullptr;
  GLFWwindow* window = nullptr;
  std::unique_ptr<GlfwInput> input;
  std::unique_ptr<Swapchain> swapchain;  // null where the painter shows its frames itself
  std::unique_ptr<Painter> painter;
  float wanted_scale = 0;
  float scale = 1;
  std::atomic<bool> woken = true;
  std::atomic<bool> awaited = false;  // the next frame shows something that is waited for
  bool quit = false;
  VkExtent2D extent{};   // of what is painted
  bool outdated = true;  // what is painted into must be made again
  bool unshown = false;  // a drawn frame waits for an image
  int settle = 2;        // further frames after an event: ImGui shows some of its effects a frame later
  FrameTimes times;
  Clock::time_point last_frame{};
  Place restored;  // the place when not maximised

  ~State() {
    painter.reset();
    swapchain.reset();
    input.reset();
    if (window != nullptr) glfwDestroyWindow(window);
  }

  Status paint_through_vulkan(bool on_cpu);
};

Status Window::State::paint_through_vulkan(bool on_cpu) {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(device->instance(), window, nullptr, &surface) != VK_SUCCESS) {
    return fail(ErrorKind::no_device, device->info().name, "window", "a Vulkan surface (VK_KHR_surface)", glfw_error());
  }
  VAMP_TRY(Swapchain chain, Swapchain::create(*device, surface));
  swapchain = std::make_unique<Swapchain>(std::move(chain));
  painter = on_cpu ? make_cpu_painter(*device, *textures) : make_vulkan_painter(*device, *textures);
  return {};
}

Window::Window(std::unique_ptr<State> state) : state_(std::move(state)) {}
Window::~Window() = default;

Result<std::vector<std::string>> Window::instance_extensions() {
  VAMP_CHECK_STATUS(start_glfw());
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (names == nullptr) {
    return fail(ErrorKind::no_device, "window", "", "a Vulkan driver that can show windows", glfw_error());
  }
  return std::vector<std::string>(names, names + count);
}

std::vector<std::string> Window::device_extensions() { return {VK_KHR_SWAPCHAIN_EXTENSION_NAME}; }

Result<std::unique_ptr<Window>> Window::open(gpu::Device& device, Textures& textures, const WindowOptions& options) {
  VAMP_CHECK_STATUS(start_glfw());
  auto state = std::make_unique<State>();
  state->device = &device;
  state->textures = &textures;
  state->wanted_scale = options.scale;
  const Place place = on_a_monitor(options.place);
  state->restored = place;
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_MAXIMIZED, place.maximised ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "vamp");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "vamp");
  state->window = glfwCreateWindow(place.width, place.height, options.title.c_str(), nullptr, nullptr);
  if (state->window == nullptr) return fail(ErrorKind::failed, "window", "", "a window", glfw_error());
  glfwSetWindowSizeLimits(state->window, 480, 320, GLFW_DONT_CARE, GLFW_DONT_CARE);
  if (place.placed && !place.maximised) glfwSetWindowPos(state->window, place.x, place.y);

  state->input = std::make_unique<GlfwInput>(state->window);
  const bool on_cpu =
      options.renderer == UiRenderer::automatic ? device.info().is_cpu : options.renderer == UiRenderer::cpu;
  if (on_cpu) state->painter = make_shared_painter(state->window, textures);
  if (!state->painter) VAMP_CHECK_STATUS(state->paint_through_vulkan(on_cpu));
  float across = 1;
  glfwGetWindowContentScale(state->window, &across, nullptr);
  state->scale = options.scale > 0 ? options.scale : across;
  state->input->events().scale_changed = true;
  glfwShowWindow(state->window);
  spdlog::info("window: {} x {}, user interface drawn by {}, presentation {}", place.width, place.height,
               state->painter->name(), state->swapchain ? state->swapchain->mode() : "through shared memory");
  return std::unique_ptr<Window>(new Window(std::move(state)));
}

void Window::quit() { state_->quit = true; }

void Window::wake() {
  if (!state_->woken.exchange(true)) glfwPostEmptyEvent();
}

void Window::show_soon() {
  state_->awaited = state_->woken = true;
  glfwPostEmptyEvent();
}

void Window::set_title(const std::string& title) { glfwSetWindowTitle(state_->window, title.c_str()); }

Place Window::place() const {
  Place place = state_->restored;
  place.maximised = glfwGetWindowAttrib(state_->window, GLFW_MAXIMIZED) != 0;
  if (!place.maximised) {
    glfwGetWindowPos(state_->window, &place.x, &place.y);
    glfwGetWindowSize(state_->window, &place.width, &place.height);
    place.placed = true;
  }
  return place;
}

float Window::scale() const { return state_->scale; }
void Window::set_scale(float scale) {
  state_->wanted_scale = scale;
  state_->input->events().scale_changed = true;
  state_->woken = true;
}
const FrameTimes& Window::times() const { return state_->times; }
const char* Window::renderer_name() const { return state_->painter->name(); }

// Makes what is painted into anew for a window of this size. False while there is nothing to show it in.
bool Window::fit(uint32_t width, uint32_t height) {
  State& s = *state_;
  std::vector<VkImage> images;
  s.extent = {width, height};
  if (s.swapchain) {
    const Result<bool> made = s.swapchain->resize(width, height);
    if (!made) throw MachineError(made.error().kind, made.error().message());
    if (!*made) return false;
    s.extent = s.swapchain->extent();
    for (uint32_t i = 0; i < s.swapchain->count(); ++i) images.push_back(s.swapchain->image(i));
  }
  if (!s.painter->resize(s.extent.width, s.extent.height, images)) {
    spdlog::warn("the X server shares no memory for {} x {} pixels: the window goes on through Vulkan", width, height);
    const Status made = s.paint_through_vulkan(true);
    if (!made) throw MachineError(made.error().kind, made.error().message());
    return fit(width, height);
  }
  s.outdated = false;
  return true;
}

// Shows the drawn frame if there is an image for it; otherwise it stays to be shown.
void Window::show(bool changed) {
  State& s = *state_;
  if (s.painter->shows_itself()) {
    if (changed) ++s.times.presented;
    return;
  }
  s.unshown = s.unshown || changed;
  if (!s.unshown || s.outdated) return;
  uint32_t index = 0;
  gpu::SubmitSync sync;
  switch (s.swapchain->acquire(index, sync)) {
    case Swapchain::Acquired::later:
      return;
    case Swapchain::Acquired::outdated:
      s.outdated = true;
      return;
    case Swapchain::Acquired::yes:
      break;
  }
  gpu::CommandList list = s.device->begin("user interface");
  s.painter->record(list, s.swapchain->image(index), index);
  const uint64_t value = s.device->submit(std::move(list), sync);
  s.painter->submitted(value);
  s.outdated = !s.swapchain->present(index, value);
  s.unshown = false;
  ++s.times.presented;
}

// One frame of ImGui. False while the window has no area (minimised).
bool Window::draw_frame(const Hooks& hooks) {
  State& s = *state_;
  int width = 0, height = 0;
  glfwGetFramebufferSize(s.window, &width, &height);
  if (width <= 0 || height <= 0) return false;
  const auto w = static_cast<uint32_t>(width), h = static_cast<uint32_t>(height);
  if ((s.outdated || s.extent.width != w || s.extent.height != h) && !fit(w, h)) return false;
  ImGuiIO& io = ImGui::GetIO();
  const double elapsed = s.times.frames == 0 ? 1.0 / 60 : seconds_since(s.last_frame);
  io.DeltaTime = static_cast<float>(std::clamp(elapsed, 1e-4, 1.0));
  s.last_frame = Clock::now();
  io.DisplaySize = ImVec2(static_cast<float>(s.extent.width), static_cast<float>(s.extent.height));
  io.DisplayFramebufferScale = ImVec2(1, 1);
  s.input->queue().apply(io);

  const auto start = Clock::now();
  ImGui::NewFrame();
  hooks.frame();
  ImGui::Render();
  s.times.build_ms = seconds_since(start) * 1e3;
  ++s.times.frames;
  const auto drawing = Clock::now();
  const bool changed = s.painter->prepare(*ImGui::GetDrawData());
  s.times.draw_ms = seconds_since(drawing) * 1e3;
  const auto presenting = Clock::now();
  show(changed);
  s.times.present_ms = seconds_since(presenting) * 1e3;
  s.input->update_cursor();
  return true;
}

void Window::run(const Hooks& hooks) {
  State& s = *state_;
  constexpr double kFrame = 1.0 / 60;     // s, at the least between two frames
  constexpr double kAwaited = 1.0 / 500;  // s, the same before what is waited for
  // Mesa reads the X connection too and may take an event off it while we sleep on the socket, so never sleep long.
  constexpr double kLook = 0.05;   // s, at the most between looks at the world
  constexpr double kIdle = 3600;   // s, before the first frame and without a wish
  constexpr double kCursor = 0.4;  // s, half a blink of the text cursor
  double wake_at = 0;              // s after the last frame
  bool shown = true;
  while (!s.quit) {
    // Sleep until an event, a wish or the rate limit. A frame that found no image is shown as soon as one is free.
    const double past = s.times.frames == 0 ? kIdle : seconds_since(s.last_frame);
    const bool due = s.woken || s.input->pending() || s.settle > 0 || past >= wake_at;
    double timeout = due ? (s.awaited ? kAwaited : kFrame) - past : std::min(wake_at - past, kLook);
    if (s.unshown) timeout = std::min(timeout, 0.004);
    if (!shown) timeout = 0.25;  // minimised
    if (timeout > 0) {
      glfwWaitEventsTimeout(timeout);
    } else {
      glfwPollEvents();
    }
    WindowEvents& events = s.input->events();
    if (std::exchange(events.close_wanted, false)) {
      if (hooks.close_wanted) {
        hooks.close_wanted();
        s.woken = true;
      } else {
        quit();
      }
    }
    const double now = s.times.frames == 0 ? kIdle : seconds_since(s.last_frame);
    const bool wanted = s.woken || s.input->pending() || s.settle > 0 || now >= wake_at || !shown;
    if (!wanted || (now < (s.awaited ? kAwaited : kFrame * 0.9) && shown)) {
      if (s.unshown) show(false);
      continue;
    }

    // React to what happened to the window, then draw.
    if (s.input->pending()) s.settle = 3;
    s.woken = s.awaited = false;
    if (std::exchange(events.scale_changed, false)) {
      float across = 1;
      glfwGetWindowContentScale(s.window, &across, nullptr);
      s.scale = s.wanted_scale > 0 ? s.wanted_scale : across;
      if (hooks.rescale) hooks.rescale(s.scale);
      s.textures->add_fonts(*ImGui::GetIO().Fonts);
    }
    if (!events.dropped.empty() && hooks.dropped) hooks.dropped(std::exchange(events.dropped, {}));
    events.dropped.clear();
    if (std::exchange(events.exposed, false)) s.painter->forget();
    events.resized = false;
    s.settle = std::max(0, s.settle - 1);
    shown = draw_frame(hooks);
    if (shown && !s.unshown && hooks.shown) hooks.shown();
    wake_at = hooks.wake_after ? std::max(0.0, hooks.wake_after()) : kIdle;
    if (ImGui::GetIO().WantTextInput) wake_at = std::min(wake_at, kCursor);
    wake_at = std::min(wake_at, kIdle);
  }
}

}  // namespace vamp::window
