#include "app/editor/viewport_picture.h"

#include <algorithm>

namespace vamp {

ViewportPicture::ViewportPicture(window::Textures& textures) : table_(textures) {
  picture_ = table_.add_external();
  const uint8_t nothing[4] = {0, 0, 0, 0};
  outline_ = table_.add(1, 1, window::PixelFormat::rgba8, nothing);
  marks_ = table_.add(1, 1, window::PixelFormat::rgba8, nothing);
}

void ViewportPicture::update(const RenderSession& session, const Outlined& selected, const Outlined& hovered,
                             bool restarted) {
  if (session.copy_picture(pixels_)) {
    table_.set_external(picture_, pixels_.width, pixels_.height, window::PixelFormat::rgba8,
                        reinterpret_cast<const uint8_t*>(pixels_.pixels.data()),
                        static_cast<size_t>(pixels_.width) * sizeof(uint32_t));
    table_.touch(picture_);
    shown_.picture = picture_;
    shown_.width = pixels_.width;
    shown_.height = pixels_.height;
  }
  if (restarted)
    mark_restarted(session);
  else
    shown_.restarted = nullptr;
  const bool new_ids = session.copy_ids(ids_);
  const bool fits = !ids_.pixels.empty() && ids_.width == shown_.width && ids_.height == shown_.height;
  if (!fits || (selected.part < 0 && hovered.part < 0)) {
    shown_.outline = nullptr;
    selected_ = hovered_ = {};
    return;
  }
  if (!new_ids && shown_.outline != nullptr && selected == selected_ && hovered == hovered_) return;
  selected_ = selected;
  hovered_ = hovered;
  table_.replace(outline_, ids_.width, ids_.height, window::PixelFormat::rgba8,
                 draw_outlines(ids_.pixels, ids_.width, ids_.height, selected, hovered));
  shown_.outline = outline_;
}

void ViewportPicture::mark_restarted(const RenderSession& session) {
  if (session.copy_restarted(restarted_) || shown_.restarted == nullptr) {
    // Straight alpha; a colour that leather and cloth rarely have.
    constexpr uint8_t kMark[4] = {255, 0, 200, 120};
    std::vector<uint8_t> marks(4 * restarted_.pixels.size());
    for (size_t i = 0; i < restarted_.pixels.size(); ++i)
      if (restarted_.pixels[i] != 0) std::copy(kMark, kMark + 4, &marks[4 * i]);
    if (!marks.empty()) table_.replace(marks_, restarted_.width, restarted_.height, window::PixelFormat::rgba8, marks);
  }
  const bool fits = restarted_.width == shown_.width && restarted_.height == shown_.height && shown_.width > 0;
  shown_.restarted = fits ? marks_ : nullptr;
}

void ViewportPicture::clear() {
  shown_ = {};
  pixels_ = ids_ = restarted_ = {};
}

}  // namespace vamp
