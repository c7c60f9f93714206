#pragma once
// The inner loops of the CPU rasteriser: one primitive into one clipped rectangle.
#include <imgui.h>

#include "app/window/cpu_rasteriser.h"

namespace vamp::window {

// Colours in ImGui's order (0xAABBGGRR) as the canvas stores them (0xAARRGGBB), and back.
inline uint32_t swap_red_blue(uint32_t c) { return (c & 0xff00ff00u) | (c & 0xffu) << 16 | (c >> 16 & 0xffu); }

// Texel (x, y) as 0xAARRGGBB; the coordinates are inside the texture.
uint32_t texel(const Texture& texture, int x, int y);

// Bilinear, clamped to the edge; u and v in texels, centres at .5.
uint32_t sample(const Texture& texture, float u, float v);

// The product of two 0xAARRGGBB colours.
uint32_t modulate(uint32_t a, uint32_t b);

// All draw inside `clip`, which is inside the primitive's bounds and the canvas.
void draw_solid(const CpuRasteriser::Primitive& primitive, const PixelRect& clip, const Canvas& canvas);
void draw_picture(const CpuRasteriser::Primitive& primitive, const PixelRect& clip, const Canvas& canvas);
void draw_triangle(const CpuRasteriser::Primitive& primitive, const PixelRect& clip, const Canvas& canvas);
void fill(const PixelRect& clip, uint32_t colour, const Canvas& canvas);

// What the texture holds at the first vertex.
uint32_t constant_texel(const CpuRasteriser::Primitive& primitive);

// The constant colour of a primitive whose vertices share one uv and colour.
uint32_t constant_colour(const CpuRasteriser::Primitive& primitive);

}  // namespace vamp::window
