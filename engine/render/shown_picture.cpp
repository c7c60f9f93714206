#include "engine/render/shown_picture.h"

#include <cstring>

namespace vamp {

bool ShownPicture::copy(const PixelLayer& from, PixelLayer& to) const {
  const std::lock_guard lock(mutex_);
  if (to.version == from.version) return false;
  to = from;
  return true;
}

Drawn ShownPicture::drawn() const {
  const std::lock_guard lock(mutex_);
  Drawn drawn = drawn_;
  drawn.width = picture_.width;
  drawn.height = picture_.height;
  return drawn;
}

void ShownPicture::draw(std::shared_ptr<const Project> project, const Renderer& renderer) {
  const std::lock_guard lock(mutex_);
  drawn_ = {std::move(project), renderer.scene_tables(), renderer.part_rows()};
}

void ShownPicture::resize(int width, int height) {
  constexpr uint32_t kDark = 0xff202020u;
  forget_ids();
  const std::lock_guard lock(mutex_);
  // The old picture, stretched, until the first look at the new one is there.
  const PixelLayer old = std::move(picture_);
  picture_.width = width;
  picture_.height = height;
  picture_.pixels.assign(static_cast<size_t>(width) * static_cast<size_t>(height), kDark);
  if (old.pixels.empty()) return;
  for (int y = 0; y < height; ++y) {
    const size_t row = static_cast<size_t>(y * int64_t{old.height} / height) * static_cast<size_t>(old.width);
    for (int x = 0; x < width; ++x)
      picture_.pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] =
          old.pixels[row + static_cast<size_t>(x * int64_t{old.width} / width)];
  }
  version_.store(++picture_.version, std::memory_order_release);
}

void ShownPicture::show_tile(Renderer& renderer, int tile, uint64_t value) {
  const uint32_t* display = renderer.mapped_display();
  if (display == nullptr) {
    // Without mapped memory a copy is only worth while for a whole pass.
    if (tile + 1 == renderer.tile_count()) show_all(renderer, value);
    return;
  }
  const Region area = renderer.tile(tile);
  const std::lock_guard lock(mutex_);
  for (int y = area.y; y < area.y + area.height; ++y) {
    const size_t at = static_cast<size_t>(y) * static_cast<size_t>(picture_.width) + static_cast<size_t>(area.x);
    std::memcpy(&picture_.pixels[at], &display[at], static_cast<size_t>(area.width) * sizeof(uint32_t));
  }
  version_.store(++picture_.version, std::memory_order_release);
}

void ShownPicture::show_all(Renderer& renderer, uint64_t value) {
  std::vector<uint32_t> display = renderer.display_picture(value);
  const std::lock_guard lock(mutex_);
  picture_.pixels = std::move(display);
  version_.store(++picture_.version, std::memory_order_release);
}

void ShownPicture::replace(PixelLayer& layer, std::vector<uint32_t> pixels) {
  layer.pixels = std::move(pixels);
  layer.width = layer.pixels.empty() ? 0 : picture_.width;
  layer.height = layer.pixels.empty() ? 0 : picture_.height;
  ++layer.version;
}

void ShownPicture::forget_ids() {
  const std::lock_guard lock(mutex_);
  if (!ids_.pixels.empty()) replace(ids_, {});
}

double ShownPicture::read_ids(Renderer& renderer, uint64_t value) {
  // Layer 1: texture coordinates, part, cluster.
  const std::vector<vec4> layer = renderer.aov_layer(1, value);
  std::vector<uint32_t> ids(layer.size());
  size_t covered = 0;
  for (size_t i = 0; i < layer.size(); ++i) {
    const float part = layer[i].z, cluster = layer[i].w;
    if (part < 0) continue;
    ++covered;
    ids[i] = (static_cast<uint32_t>(part) + 1) | static_cast<uint32_t>(cluster + 1) << 16;
  }
  const std::lock_guard lock(mutex_);
  replace(ids_, std::move(ids));
  return static_cast<double>(covered) / static_cast<double>(layer.size());
}

void ShownPicture::set_restarted(const std::vector<uint32_t>& pixels) {
  const std::lock_guard lock(mutex_);
  std::vector<uint32_t> marks(picture_.pixels.size());
  for (const uint32_t pixel : pixels) marks[pixel] = 1;
  replace(restarted_, std::move(marks));
}

void ShownPicture::set_all_restarted() {
  const std::lock_guard lock(mutex_);
  replace(restarted_, std::vector<uint32_t>(picture_.pixels.size(), 1));
}

}  // namespace vamp
