#include "app/editor/viewport_picture.h"

#include <algorithm>

namespace vamp {

ViewportPicture::ViewportPicture(window::Textures& textures) : table_(textures) {
  picture_ = table_.add_external();
  const uint8_t nothing[4] = {0, 0, 0, 0};
  outline_ = table_.add(1, 1, window::PixelFormat::rgba8, nothing);
}

void ViewportPicture::update(const RenderSession& session, const Outlined& selected, const Outlined& hovered) {
  int width = 0, height = 0;
  if (session.copy_picture(pixels_, width, height, version_)) {
    table_.set_external(picture_, width, height, window::PixelFormat::rgba8,
                        reinterpret_cast<const uint8_t*>(pixels_.data()),
                        static_cast<size_t>(width) * sizeof(uint32_t));
    table_.touch(picture_);
    shown_.picture = picture_;
    shown_.width = width;
    shown_.height = height;
  }
  const bool new_ids = session.copy_ids(ids_, ids_width_, ids_height_, ids_version_);
  const bool fits = !ids_.empty() && ids_width_ == shown_.width && ids_height_ == shown_.height;
  if (!fits || (selected.part < 0 && hovered.part < 0)) {
    shown_.outline = nullptr;
    selected_ = hovered_ = {};
    return;
  }
  if (!new_ids && shown_.outline != nullptr && selected == selected_ && hovered == hovered_) return;
  selected_ = selected;
  hovered_ = hovered;
  table_.replace(outline_, ids_width_, ids_height_, window::PixelFormat::rgba8,
                 draw_outlines(ids_, ids_width_, ids_height_, selected, hovered));
  shown_.outline = outline_;
}

void ViewportPicture::clear() {
  shown_ = {};
  ids_.clear();
  version_ = ids_version_ = 0;
}

}  // namespace vamp
