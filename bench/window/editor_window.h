#pragma once
// `vamp edit` in a window of a screen, used through its mouse and keys alone; what it shows of itself and where, it
// tells (app/editor/teller.h).
#include <functional>

#include "bench/window/screen.h"
#include "engine/core/json.h"

namespace vamp {

class EditorWindow {
 public:
  // Starts this very program on a project, with settings of its own below `home`. Returns when the first whole sample
  // is shown. Errors: failed, with what it said, where it ends or does not come that far.
  static Result<std::unique_ptr<EditorWindow>> open(Screen& screen, const fs::path& home, const fs::path& project,
                                                    int width, int height);

  Screen& screen() { return screen_; }
  Child& program() { return *program_; }

  // What it told last, and whether that comes to hold within some seconds.
  const Json& told();
  bool waits_for(const std::function<bool(const Json&)>& holds, double seconds = 60);

  // Resizes the window until the picture in it is that large. Error: failed.
  Status fit_viewport(int width, int height);
  Area viewport();

  // Selects by keys. Errors: failed where the selection does not come to that.
  Status select(int part, int cluster);
  // Turns the wheel over the tab's panel until something of that name is in sight there, and gives its place.
  Result<Area> find(const std::string& panel, const std::string& name);
  void click(const Area& place);
  // Chooses an item of a list.
  Status choose(const std::string& panel, const std::string& list, const std::string& item);

 private:
  EditorWindow(Screen& screen, fs::path log) : screen_(screen), log_(std::move(log)) {}
  tl::unexpected<Error> lost(std::string_view expected);
  bool has(const std::string& name);
  Area place(const std::string& name);
  Status step(Mouse::Key key, bool control, const char* what, int wanted);

  Screen& screen_;
  fs::path log_;
  std::unique_ptr<Child> program_;
  uint64_t read_ = 0;
  Json told_ = Json::object();
};

}  // namespace vamp
