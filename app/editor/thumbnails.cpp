#include "app/editor/thumbnails.h"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.h"
#include "engine/core/log.h"
#include "engine/image/load.h"

namespace vamp {
namespace {

constexpr int kMaxSide = 512;

struct Decoded {
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

Result<Decoded> decode(const PresetInfo& preset) {
  const std::string file = preset.path.string();
  // The codes are shown as they are: reading them as linear leaves them alone.
  VAMP_TRY(Image image,
           decode_image(preset.thumbnail_png, file, ColourSpace::linear, {.side = 2048, .bytes = 64 << 20}));
  const auto [width, height] = size_within(image.width, image.height, kMaxSide);
  if (width != image.width || height != image.height) image = downsampled(image, width, height);
  Decoded decoded{.width = image.width, .height = image.height};
  const size_t channels = image.channels.size();
  const bool grey = channels < 3;
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const float* p = &image.pixels[i * channels];
    const float alpha = channels == 2 ? p[1] : channels == 4 ? p[3] : 1.0f;
    for (const float value : {p[0], p[grey ? 0 : 1], p[grey ? 0 : 2], alpha})
      decoded.rgba.push_back(static_cast<uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f))));
  }
  return decoded;
}

}  // namespace

Thumbnails::Thumbnails(window::Textures& textures, std::function<void()> wake)
    : textures_(textures), jobs_(1, std::move(wake)) {}

ImTextureID Thumbnails::find(const PresetInfo& preset) {
  if (preset.thumbnail_png.empty()) return nullptr;
  const std::string path = preset.path.string();
  // Length and head tell two pictures of one path apart well enough to be looked at every frame.
  const size_t head = std::min<size_t>(preset.thumbnail_png.size(), 4096);
  const uint64_t checksum = hash64(std::span(preset.thumbnail_png).first(head)) + preset.thumbnail_png.size();
  const auto [found, is_new] = entries_.try_emplace(path);
  if (!is_new && found->second.checksum == checksum) return found->second.texture;
  found->second.checksum = checksum;
  jobs_.start(
      "Thumbnail", [preset](Progress&) { return decode(preset); },
      [this, path, checksum](const Result<Decoded>& decoded) {
        Entry& entry = entries_[path];
        if (entry.checksum != checksum) return;
        if (!decoded) return spdlog::warn("{}", decoded.error().message());
        if (entry.texture != nullptr) textures_.remove(entry.texture);
        entry.texture = textures_.add(decoded->width, decoded->height, window::PixelFormat::rgba8, decoded->rgba);
      });
  return found->second.texture;
}

}  // namespace vamp
