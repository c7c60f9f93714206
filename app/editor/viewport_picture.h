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
  // frame, before anything is drawn.
  void update(const RenderSession& session, const Outlined& selected, const Outlined& hovered);

  // Nothing to show: another session begins.
  void clear();

  // Changes with every new picture.
  uint64_t version() const { return version_; }
  const ui::ViewportTextures& textures() const { return shown_; }

 private:
  window::Textures& table_;
  ui::ViewportTextures shown_;
  ImTextureID picture_ = nullptr, outline_ = nullptr;
  std::vector<uint32_t> pixels_, ids_;
  int ids_width_ = 0, ids_height_ = 0;
  uint64_t version_ = 0, ids_version_ = 0;
  Outlined selected_, hovered_;
};

}  // namespace vamp
