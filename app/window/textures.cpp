#include "app/window/textures.h"

#include "engine/core/check.h"

namespace vamp::window {

namespace {

// An identifier is (generation << 20 | slot + 1), so that a removed texture's name does not show another's picture.
constexpr uintptr_t kSlotMask = (1u << 20) - 1;

uintptr_t bits_of(ImTextureID id) { return reinterpret_cast<uintptr_t>(id); }

void fill(Texture& texture, int width, int height, PixelFormat format, std::span<const uint8_t> pixels) {
  CHECK(width > 0 && height > 0);
  const size_t row = static_cast<size_t>(width) * bytes_per_pixel(format);
  CHECK(pixels.size() == row * static_cast<size_t>(height));
  texture.width = width;
  texture.height = height;
  texture.format = format;
  texture.owned.assign(pixels.begin(), pixels.end());
  texture.pixels = texture.owned.data();
  texture.row_bytes = row;
}

}  // namespace

Texture* Textures::lookup(ImTextureID id) const {
  const uintptr_t slot = (bits_of(id) & kSlotMask) - 1;
  if (slot >= slots_.size() || slots_[slot].generation != bits_of(id) >> 20) return nullptr;
  return slots_[slot].texture.get();
}

const Texture* Textures::find(ImTextureID id) const { return lookup(id); }

ImTextureID Textures::add_external() {
  size_t slot = 0;
  while (slot < slots_.size() && slots_[slot].texture) ++slot;
  if (slot == slots_.size()) slots_.emplace_back();
  CHECK(slot < kSlotMask);
  slots_[slot].texture = std::make_unique<Texture>();
  slots_[slot].texture->revision = ++revision_;
  return reinterpret_cast<ImTextureID>(uintptr_t{slots_[slot].generation} << 20 | (slot + 1));
}

ImTextureID Textures::add(int width, int height, PixelFormat format, std::span<const uint8_t> pixels) {
  const ImTextureID id = add_external();
  fill(*lookup(id), width, height, format, pixels);
  return id;
}

void Textures::set_external(ImTextureID id, int width, int height, PixelFormat format, const uint8_t* pixels,
                            size_t row_bytes) {
  Texture* texture = lookup(id);
  CHECK(texture != nullptr);
  texture->owned.clear();
  texture->width = width;
  texture->height = height;
  texture->format = format;
  texture->opaque = format != PixelFormat::alpha8;
  texture->pixels = pixels;
  texture->row_bytes = row_bytes;
  texture->revision = ++revision_;
}

void Textures::touch(ImTextureID id) {
  if (Texture* texture = lookup(id)) texture->revision = ++revision_;
}

void Textures::replace(ImTextureID id, int width, int height, PixelFormat format, std::span<const uint8_t> pixels) {
  Texture* texture = lookup(id);
  CHECK(texture != nullptr);
  fill(*texture, width, height, format, pixels);
  texture->revision = ++revision_;
}

void Textures::remove(ImTextureID id) {
  if (lookup(id) == nullptr) return;
  Slot& slot = slots_[(bits_of(id) & kSlotMask) - 1];
  slot.texture.reset();
  ++slot.generation;
}

void Textures::add_fonts(ImFontAtlas& fonts) {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  fonts.GetTexDataAsAlpha8(&pixels, &width, &height);
  const std::span<const uint8_t> all(pixels, static_cast<size_t>(width) * static_cast<size_t>(height));
  if (lookup(fonts.TexID) != nullptr) {
    replace(fonts.TexID, width, height, PixelFormat::alpha8, all);
  } else {
    fonts.SetTexID(add(width, height, PixelFormat::alpha8, all));
  }
}

}  // namespace vamp::window
