#include "tests/editor/drop.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <thread>

namespace vamp::editor_test {
namespace {

class Source {
 public:
  explicit Source(const std::string& name) : display_(XOpenDisplay(name.c_str())) {
    if (display_ == nullptr) return;
    window_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), window_, CurrentTime);
  }
  ~Source() {
    if (display_ != nullptr) XCloseDisplay(display_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  bool drop(int x, int y, const std::string& uris) {
    if (display_ == nullptr) return false;
    uris_ = uris;
    target_ = aware_below(DefaultRootWindow(display_));
    if (target_ == None) return false;
    send("XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, (static_cast<long>(x) << 16) | y, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    if (!wait_for("XdndStatus")) return false;
    // A frame of the window sees where the mouse is before the button is let go.
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    send("XdndDrop", 0, CurrentTime, 0, 0);
    return wait_for("XdndFinished");
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  // The first window in the tree that says that it takes drops.
  Window aware_below(Window window) const {
    Atom type = None;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(display_, window, atom("XdndAware"), 0, 1, False, AnyPropertyType, &type, &format, &count, &left,
                       &data);
    if (data != nullptr) XFree(data);
    if (count > 0) return window;
    Window root = None, parent = None, *children = nullptr, found = None;
    unsigned int number = 0;
    if (XQueryTree(display_, window, &root, &parent, &children, &number) == 0) return None;
    for (unsigned int i = 0; i < number && found == None; ++i) found = aware_below(children[i]);
    if (children != nullptr) XFree(children);
    return found;
  }

  void send(const char* message, long a, long b, long c, long d) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    const long data[] = {static_cast<long>(window_), a, b, c, d};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  // Hands out the names of the files meanwhile.
  bool wait_for(const char* message) {
    for (int attempt = 0; attempt < 200; ++attempt) {
      while (XPending(display_) > 0) {
        XEvent event;
        XNextEvent(display_, &event);
        if (event.type == SelectionRequest) answer(event.xselectionrequest);
        if (event.type == ClientMessage && event.xclient.message_type == atom(message)) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  void answer(const XSelectionRequestEvent& request) const {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(uris_.data()), static_cast<int>(uris_.size()));
    XEvent event{};
    event.xselection.type = SelectionNotify;
    event.xselection.requestor = request.requestor;
    event.xselection.selection = request.selection;
    event.xselection.target = request.target;
    event.xselection.property = request.property;
    event.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &event);
    XFlush(display_);
  }

  ::Display* display_ = nullptr;
  Window window_ = None, target_ = None;
  std::string uris_;
};

}  // namespace

bool drop_files(const std::string& display, int x, int y, const std::vector<std::string>& paths) {
  std::string uris;
  for (const std::string& path : paths) uris += "file://" + path + "\r\n";
  return Source(display).drop(x, y, uris);
}

}  // namespace vamp::editor_test
