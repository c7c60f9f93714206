#include "bench/window/mouse.h"

#include <xcb/xcb.h>
#include <xcb/xtest.h>

#include <array>
#include <cstdlib>

namespace vamp {
namespace {

template <class T>
std::unique_ptr<T, decltype(&std::free)> owned(T* reply) {
  return {reply, &std::free};
}

}  // namespace

struct Mouse::State {
  xcb_connection_t* connection = nullptr;
  xcb_window_t root = 0;
  ~State() { xcb_disconnect(connection); }

  void send(uint8_t type, uint8_t detail, int x = 0, int y = 0) const {
    xcb_test_fake_input(connection, type, detail, XCB_CURRENT_TIME, root, static_cast<int16_t>(x),
                        static_cast<int16_t>(y), 0);
    xcb_flush(connection);
  }

  // Of the key that bears a symbol; 0: none does.
  uint8_t code_of(uint32_t symbol) const {
    const xcb_setup_t* const setup = xcb_get_setup(connection);
    const auto count = static_cast<uint8_t>(setup->max_keycode - setup->min_keycode + 1);
    const auto map = owned(xcb_get_keyboard_mapping_reply(
        connection, xcb_get_keyboard_mapping(connection, setup->min_keycode, count), nullptr));
    if (!map) return 0;
    const xcb_keysym_t* const symbols = xcb_get_keyboard_mapping_keysyms(map.get());
    for (int i = 0; i < count; ++i)
      if (symbols[i * map->keysyms_per_keycode] == symbol) return static_cast<uint8_t>(setup->min_keycode + i);
    return 0;
  }
};

Mouse::Mouse(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mouse::~Mouse() = default;

std::unique_ptr<Mouse> Mouse::of_display(const std::string& display) {
  auto state = std::make_unique<State>();
  int screen = 0;
  state->connection = xcb_connect(display.c_str(), &screen);
  if (xcb_connection_has_error(state->connection) != 0) return nullptr;
  const xcb_query_extension_reply_t* const test = xcb_get_extension_data(state->connection, &xcb_test_id);
  if (test == nullptr || test->present == 0) return nullptr;
  xcb_screen_iterator_t screens = xcb_setup_roots_iterator(xcb_get_setup(state->connection));
  for (; screen > 0 && screens.rem > 1; --screen) xcb_screen_next(&screens);
  state->root = screens.data->root;
  return std::unique_ptr<Mouse>(new Mouse(std::move(state)));
}

void Mouse::move(int x, int y) { state_->send(XCB_MOTION_NOTIFY, 0, x, y); }
void Mouse::press(int button) { state_->send(XCB_BUTTON_PRESS, static_cast<uint8_t>(button)); }
void Mouse::release(int button) { state_->send(XCB_BUTTON_RELEASE, static_cast<uint8_t>(button)); }
void Mouse::click(int button) {
  press(button);
  release(button);
}
void Mouse::key(Key key) {
  const uint8_t code = state_->code_of(key);
  state_->send(XCB_KEY_PRESS, code);
  state_->send(XCB_KEY_RELEASE, code);
}
void Mouse::key_with_control(Key which) {
  const uint8_t control = state_->code_of(kControl);
  state_->send(XCB_KEY_PRESS, control);
  key(which);
  state_->send(XCB_KEY_RELEASE, control);
}

void Mouse::resize_window(int width, int height) {
  const auto tree =
      owned(xcb_query_tree_reply(state_->connection, xcb_query_tree(state_->connection, state_->root), nullptr));
  if (!tree) return;
  const xcb_window_t* const windows = xcb_query_tree_children(tree.get());
  for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
    const auto about = owned(xcb_get_window_attributes_reply(
        state_->connection, xcb_get_window_attributes(state_->connection, windows[i]), nullptr));
    if (!about || about->map_state != XCB_MAP_STATE_VIEWABLE) continue;
    const std::array<uint32_t, 2> size{static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
    xcb_configure_window(state_->connection, windows[i], XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT,
                         size.data());
    xcb_flush(state_->connection);
    return;
  }
}

}  // namespace vamp
