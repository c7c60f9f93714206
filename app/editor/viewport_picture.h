#pragma once
// The renderer's picture and the outlines over it as textures of the window.
#include <cstdint>
#include <vector>

#include "app/editor/outline.h"
#include "app/window/textures.h"
#include "editor/panels/context.h"

namespace vamp {

class ViewportPicture {
 public:
  explicit ViewportPicture(window::Textures& textures);

  // Takes over what is newer in the session; redraws the outlines when they or what they are drawn from changed. Once a
  // frame, before anything is drawn. `restarted`: also which pixels the last edit restarted.
  void update(const RenderSession& session, const Outlined& selected, const Outlined& hovered, bool restarted);

  // Nothing to show: another session begins.
  void clear();

  // Changes with every new picture.
  uint64_t version() const { return pixels_.version; }
  const ui::ViewportTextures& textures() const { return shown_; }

 private:
  void mark_restarted(const RenderSession& session);

  window::Textures& table_;
  ui::ViewportTextures shown_;
  ImTextureID picture_ = nullptr, outline_ = nullptr, marks_ = nullptr;
  PixelLayer pixels_, ids_, restarted_;
  Outlined selected_, hovered_;
};

}  // namespace vamp
