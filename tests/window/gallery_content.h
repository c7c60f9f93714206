#pragma once
// Every widget of the kit in the editor's arrangement, over invented data: the fixture for looking and for tests.
#include <memory>

#include "app/window/textures.h"
#include "editor/widgets/shell.h"

namespace vamp::gallery {

class Gallery {
 public:
  explicit Gallery(window::Textures& textures);
  ~Gallery();
  void draw();  // one frame, between NewFrame and Render
  ui::Actions& actions();
  ui::Dock& dock();
  bool quit_wanted() const;
  int edits() const;     // edit events of all kinds so far
  size_t steps() const;  // committed edits

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vamp::gallery
