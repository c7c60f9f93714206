#include "app/window/shared_window.h"

#include <dlfcn.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <xcb/shm.h>
#include <xcb/xcb.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <optional>

namespace vamp::window {
namespace {

template <class T>
std::unique_ptr<T, decltype(&std::free)> owned(T* reply) {
  return {reply, &std::free};
}

// GLFW has this function where it was built for X11 (glfw3native.h, whose headers want all of Xlib's).
xcb_window_t x11_window(GLFWwindow* window) {
  void* const symbol = dlsym(RTLD_DEFAULT, "glfwGetX11Window");
  if (symbol == nullptr) return XCB_NONE;
  return static_cast<xcb_window_t>(reinterpret_cast<unsigned long (*)(GLFWwindow*)>(symbol)(window));
}

// A server elsewhere might take memory of its own machine for ours.
bool is_on_this_machine(xcb_connection_t* connection) {
  sockaddr_storage peer{};
  socklen_t size = sizeof(peer);
  const int socket = xcb_get_file_descriptor(connection);
  return getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &size) == 0 && peer.ss_family == AF_UNIX;
}

bool is_rgb(const xcb_setup_t& setup, const xcb_get_window_attributes_reply_t& about, int depth) {
  for (auto screens = xcb_setup_roots_iterator(&setup); screens.rem > 0; xcb_screen_next(&screens))
    for (auto depths = xcb_screen_allowed_depths_iterator(screens.data); depths.rem > 0; xcb_depth_next(&depths))
      for (auto visuals = xcb_depth_visuals_iterator(depths.data); visuals.rem > 0; xcb_visualtype_next(&visuals)) {
        const xcb_visualtype_t& visual = *visuals.data;
        if (visual.visual_id == about.visual && depths.data->depth == depth)
          return visual.red_mask == 0xff0000u && visual.green_mask == 0xff00u && visual.blue_mask == 0xffu;
      }
  return false;
}

bool is_32_bits(const xcb_setup_t& setup, int depth) {
  const xcb_format_t* const formats = xcb_setup_pixmap_formats(&setup);
  return std::endian::native == std::endian::little && setup.image_byte_order == XCB_IMAGE_ORDER_LSB_FIRST &&
         std::any_of(formats, formats + xcb_setup_pixmap_formats_length(&setup),
                     [&](const xcb_format_t& format) { return format.depth == depth && format.bits_per_pixel == 32; });
}

}  // namespace

struct SharedWindow::State {
  xcb_connection_t* connection = nullptr;
  xcb_window_t window = XCB_NONE;
  xcb_gcontext_t context = XCB_NONE;
  uint8_t depth = 0;
  xcb_shm_seg_t segment = XCB_NONE;
  void* memory = nullptr;
  int width = 0, height = 0;
  std::optional<xcb_get_input_focus_cookie_t> put;  // answered after what was put last

  ~State() {
    release();
    xcb_disconnect(connection);
  }

  void release() {
    if (memory == nullptr) return;
    wait();
    xcb_shm_detach(connection, segment);
    xcb_flush(connection);
    shmdt(memory);
    memory = nullptr;
  }

  void wait() {
    if (put) owned(xcb_get_input_focus_reply(connection, *put, nullptr));
    put.reset();
    // What is still put into a window that has just been closed comes back as an error.
    while (const auto event = owned(xcb_poll_for_event(connection))) {
    }
  }
};

SharedWindow::SharedWindow(std::unique_ptr<State> state) : state_(std::move(state)) {}
SharedWindow::~SharedWindow() = default;

std::unique_ptr<SharedWindow> SharedWindow::open(GLFWwindow* window) {
  auto state = std::make_unique<State>();
  state->connection = xcb_connect(nullptr, nullptr);
  state->window = x11_window(window);
  if (xcb_connection_has_error(state->connection) != 0 || state->window == XCB_NONE) return nullptr;
  xcb_connection_t* const c = state->connection;
  if (!is_on_this_machine(c)) return nullptr;
  const xcb_query_extension_reply_t* const shm = xcb_get_extension_data(c, &xcb_shm_id);
  const auto about = owned(xcb_get_window_attributes_reply(c, xcb_get_window_attributes(c, state->window), nullptr));
  const auto geometry = owned(xcb_get_geometry_reply(c, xcb_get_geometry(c, state->window), nullptr));
  if (shm == nullptr || shm->present == 0 || !about || !geometry) return nullptr;
  const xcb_setup_t& setup = *xcb_get_setup(c);
  state->depth = geometry->depth;
  if (!is_rgb(setup, *about, state->depth) || !is_32_bits(setup, state->depth)) return nullptr;
  state->context = xcb_generate_id(c);
  xcb_create_gc(c, state->context, state->window, 0, nullptr);
  auto made = std::unique_ptr<SharedWindow>(new SharedWindow(std::move(state)));
  // A server in a container of its own says only now that it shares no memory with us.
  if (!made->resize(1, 1)) return nullptr;
  return made;
}

bool SharedWindow::resize(int width, int height) {
  State& s = *state_;
  s.release();
  const size_t bytes = static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(uint32_t);
  const int id = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  if (id < 0) return false;
  void* const memory = shmat(id, nullptr, 0);
  const bool ours = memory != reinterpret_cast<void*>(-1);
  s.segment = xcb_generate_id(s.connection);
  const auto attached = xcb_shm_attach_checked(s.connection, s.segment, static_cast<uint32_t>(id), 1);
  const bool theirs = !owned(xcb_request_check(s.connection, attached)) && xcb_connection_has_error(s.connection) == 0;
  shmctl(id, IPC_RMID, nullptr);  // gone once both sides have let go of it
  if (ours && !theirs) shmdt(memory);
  if (!ours && theirs) xcb_shm_detach(s.connection, s.segment);
  if (!ours || !theirs) return false;
  s.memory = memory;
  s.width = width;
  s.height = height;
  return true;
}

Canvas SharedWindow::canvas() {
  State& s = *state_;
  s.wait();
  return {static_cast<uint32_t*>(s.memory), s.width, s.height, static_cast<size_t>(s.width)};
}

void SharedWindow::put(std::span<const PixelRect> changed) {
  State& s = *state_;
  for (const PixelRect& r : changed) {
    const auto x = static_cast<int16_t>(r.x0), y = static_cast<int16_t>(r.y0);
    xcb_shm_put_image(s.connection, s.window, s.context, static_cast<uint16_t>(s.width),
                      static_cast<uint16_t>(s.height), static_cast<uint16_t>(r.x0), static_cast<uint16_t>(r.y0),
                      static_cast<uint16_t>(r.x1 - r.x0), static_cast<uint16_t>(r.y1 - r.y0), x, y, s.depth,
                      XCB_IMAGE_FORMAT_Z_PIXMAP, 0, s.segment, 0);
  }
  s.put = xcb_get_input_focus(s.connection);
  xcb_flush(s.connection);
}

}  // namespace vamp::window
