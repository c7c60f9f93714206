#pragma once
// The pictures that the user interface shows: the font atlas, thumbnails, the viewport. One table for both renderers.
#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vamp::window {

// rgba8, bgra8: straight alpha, encoded for the display. alpha8: white with this coverage (the font atlas).
enum class PixelFormat : uint8_t { rgba8, bgra8, alpha8 };

inline size_t bytes_per_pixel(PixelFormat format) { return format == PixelFormat::alpha8 ? 1 : 4; }

struct Texture {
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::rgba8;
  bool opaque = false;  // alpha is ignored and taken as 1
  const uint8_t* pixels = nullptr;
  size_t row_bytes = 0;
  uint64_t revision = 0;  // grows with every change of the pixels
  std::vector<uint8_t> owned;
};

class Textures {
 public:
  // Copies `pixels` (width * height, rows without padding).
  ImTextureID add(int width, int height, PixelFormat format, std::span<const uint8_t> pixels);

  // A picture that lives elsewhere, such as the renderer's mapped output buffer: blitted from there, never copied here.
  // Start with add_external(), then point it at the pixels and call touch() whenever they changed. The pixels must stay
  // valid and unchanged while a frame is drawn. They are taken as opaque.
  ImTextureID add_external();
  void set_external(ImTextureID id, int width, int height, PixelFormat format, const uint8_t* pixels, size_t row_bytes);
  void touch(ImTextureID id);

  // New pixels, perhaps of another size, under the same name.
  void replace(ImTextureID id, int width, int height, PixelFormat format, std::span<const uint8_t> pixels);
  void remove(ImTextureID id);

  // Builds ImGui's font atlas if need be and enters it under io.Fonts->TexID; call again after the fonts changed.
  void add_fonts(ImFontAtlas& fonts);

  // nullptr when the texture was removed: such a draw is skipped.
  const Texture* find(ImTextureID id) const;

 private:
  struct Slot {
    uint32_t generation = 1;
    std::unique_ptr<Texture> texture;
  };
  Texture* lookup(ImTextureID id) const;
  std::vector<Slot> slots_;
  uint64_t revision_ = 0;
};

}  // namespace vamp::window
