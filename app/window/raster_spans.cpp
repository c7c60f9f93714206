#include "app/window/raster_spans.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace vamp::window {

namespace {

// round(x / 255) for both 16-bit halves of x, each at most 255 * 255.
inline uint32_t divide_halves(uint32_t x) {
  x += 0x00800080u;
  return ((x + (x >> 8 & 0x00ff00ffu)) >> 8) & 0x00ff00ffu;
}

// `source` over `target` with the given alpha, 0..255; the result is opaque.
inline uint32_t blend(uint32_t target, uint32_t source, uint32_t alpha) {
  const uint32_t rest = 255 - alpha;
  const uint32_t rb = divide_halves((source & 0xff00ffu) * alpha + (target & 0xff00ffu) * rest);
  const uint32_t g = divide_halves((source >> 8 & 0xffu) * alpha + (target >> 8 & 0xffu) * rest);
  return 0xff000000u | rb | g << 8;
}

void blend_span(uint32_t* target, int count, uint32_t colour) {
  const uint32_t alpha = colour >> 24;
  if (alpha == 255) {
    std::fill_n(target, count, colour);
  } else if (alpha != 0) {
    for (int i = 0; i < count; ++i) target[i] = blend(target[i], colour, alpha);
  }
}

uint32_t* row_of(const Canvas& canvas, int y) { return canvas.pixels + static_cast<size_t>(y) * canvas.row_pixels; }

float clamp_coordinate(float t, int size) { return std::clamp(t, 0.0f, static_cast<float>(size)); }

// How a picture's texels lie on the pixels: texel coordinate = origin + (pixel + 0.5) * step.
struct Axis {
  float origin;
  float step;
  bool exact;  // one texel a pixel, centres on centres
  int offset;  // texel = pixel + offset where exact
};

Axis axis_of(float p0, float p1, float t0, float t1, int size) {
  Axis axis{};
  const float scale = static_cast<float>(size);
  axis.step = (t1 - t0) * scale / (p1 - p0);
  axis.origin = t0 * scale - p0 * axis.step;
  const float nearest = std::nearbyint(axis.origin);
  axis.exact = std::abs(axis.step - 1.0f) < 1e-3f && std::abs(axis.origin - nearest) < 0.02f;
  axis.offset = static_cast<int>(nearest);
  return axis;
}

void glyph_row(uint32_t* target, const uint8_t* coverage, int count, uint32_t colour) {
  const uint32_t alpha = colour >> 24;
  for (int i = 0; i < count; ++i) {
    if (coverage[i] == 0) continue;
    const uint32_t t = coverage[i] * alpha + 128;
    target[i] = blend(target[i], colour, (t + (t >> 8)) >> 8);
  }
}

void picture_row(uint32_t* target, const Texture& texture, const uint8_t* source, int count, uint32_t tint) {
  const bool swap = texture.format == PixelFormat::rgba8;
  const bool plain = tint == 0xffffffffu;
  if (plain && texture.opaque && !swap) {
    std::memcpy(target, source, static_cast<size_t>(count) * 4);
    return;
  }
  const auto at = [source](int i) {
    uint32_t c;
    std::memcpy(&c, source + 4 * static_cast<size_t>(i), 4);
    return c;
  };
  if (plain && texture.opaque) {
    for (int i = 0; i < count; ++i) target[i] = swap_red_blue(at(i)) | 0xff000000u;
    return;
  }
  for (int i = 0; i < count; ++i) {
    uint32_t c = at(i);
    // Most of an overlay shows nothing.
    if (c >> 24 == 0 && !texture.opaque) continue;
    if (swap) c = swap_red_blue(c);
    if (texture.opaque) c |= 0xff000000u;
    if (!plain) c = modulate(c, tint);
    target[i] = blend(target[i], c, c >> 24);
  }
}

}  // namespace

uint32_t modulate(uint32_t a, uint32_t b) {
  uint32_t out = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const uint32_t t = (a >> shift & 0xffu) * (b >> shift & 0xffu) + 128;
    out |= ((t + (t >> 8)) >> 8) << shift;
  }
  return out;
}

uint32_t texel(const Texture& texture, int x, int y) {
  const uint8_t* row = texture.pixels + static_cast<size_t>(y) * texture.row_bytes;
  if (texture.format == PixelFormat::alpha8) return 0x00ffffffu | static_cast<uint32_t>(row[x]) << 24;
  uint32_t c;
  std::memcpy(&c, row + 4 * static_cast<size_t>(x), 4);
  if (texture.format == PixelFormat::rgba8) c = swap_red_blue(c);
  return texture.opaque ? c | 0xff000000u : c;
}

uint32_t sample(const Texture& texture, float u, float v) {
  u = clamp_coordinate(u - 0.5f, texture.width - 1);
  v = clamp_coordinate(v - 0.5f, texture.height - 1);
  const int x = static_cast<int>(u);
  const int y = static_cast<int>(v);
  const int x1 = std::min(x + 1, texture.width - 1);
  const int y1 = std::min(y + 1, texture.height - 1);
  const auto fx = static_cast<uint32_t>((u - static_cast<float>(x)) * 256.0f);
  const auto fy = static_cast<uint32_t>((v - static_cast<float>(y)) * 256.0f);
  const uint32_t c[4] = {texel(texture, x, y), texel(texture, x1, y), texel(texture, x, y1), texel(texture, x1, y1)};
  const uint32_t w[4] = {(256 - fx) * (256 - fy), fx * (256 - fy), (256 - fx) * fy, fx * fy};
  uint32_t out = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    uint32_t sum = 0x8000;
    for (int k = 0; k < 4; ++k) sum += (c[k] >> shift & 0xffu) * w[k];
    out |= (sum >> 16) << shift;
  }
  return out;
}

uint32_t constant_texel(const CpuRasteriser::Primitive& primitive) {
  const Texture& texture = *primitive.texture;
  const ImVec2 uv = primitive.v[0]->uv;
  return sample(texture, uv.x * static_cast<float>(texture.width), uv.y * static_cast<float>(texture.height));
}

uint32_t constant_colour(const CpuRasteriser::Primitive& primitive) {
  const uint32_t tint = swap_red_blue(primitive.v[0]->col);
  const uint32_t texel_colour = constant_texel(primitive);
  return texel_colour == 0xffffffffu ? tint : modulate(texel_colour, tint);
}

void fill(const PixelRect& clip, uint32_t colour, const Canvas& canvas) {
  for (int y = clip.y0; y < clip.y1; ++y) blend_span(row_of(canvas, y) + clip.x0, clip.x1 - clip.x0, colour);
}

void draw_solid(const CpuRasteriser::Primitive& primitive, const PixelRect& clip, const Canvas& canvas) {
  fill(clip, constant_colour(primitive), canvas);
}

void draw_picture(const CpuRasteriser::Primitive& primitive, const PixelRect& clip, const Canvas& canvas) {
  const Texture& texture = *primitive.texture;
  const ImDrawVert& a = *primitive.v[0];
  const ImDrawVert& b = *primitive.v[1];
  const Axis ax = axis_of(a.pos.x, b.pos.x, a.uv.x, b.uv.x, texture.width);
  const Axis ay = axis_of(a.pos.y, b.pos.y, a.uv.y, b.uv.y, texture.height);
  const uint32_t tint = swap_red_blue(a.col);
  const int count = clip.x1 - clip.x0;

  // One texel a pixel: copy or blend rows. The whole span must lie in the texture.
  const bool inside = clip.x0 + ax.offset >= 0 && clip.x1 + ax.offset <= texture.width && clip.y0 + ay.offset >= 0 &&
                      clip.y1 + ay.offset <= texture.height;
  if (ax.exact && ay.exact && inside) {
    for (int y = clip.y0; y < clip.y1; ++y) {
      uint32_t* target = row_of(canvas, y) + clip.x0;
      const uint8_t* source = texture.pixels + static_cast<size_t>(y + ay.offset) * texture.row_bytes +
                              static_cast<size_t>(clip.x0 + ax.offset) * bytes_per_pixel(texture.format);
      if (texture.format == PixelFormat::alpha8) {
        glyph_row(target, source, count, tint);
      } else {
        picture_row(target, texture, source, count, tint);
      }
    }
    return;
  }
  for (int y = clip.y0; y < clip.y1; ++y) {
    uint32_t* target = row_of(canvas, y);
    const float v = ay.origin + (static_cast<float>(y) + 0.5f) * ay.step;
    for (int x = clip.x0; x < clip.x1; ++x) {
      const uint32_t c = modulate(sample(texture, ax.origin + (static_cast<float>(x) + 0.5f) * ax.step, v), tint);
      target[x] = blend(target[x], c, c >> 24);
    }
  }
}

namespace {

// Positions with 8 bits below the pixel, as the graphics pipeline snaps them, so that edges are exact integers.
struct Point {
  int64_t x;
  int64_t y;
};

Point snap(const ImVec2& p) {
  const auto one = [](float t) {
    return static_cast<int64_t>(std::floor(std::clamp(t, -32768.0f, 32767.0f) * 256 + 0.5f));
  };
  return {one(p.x), one(p.y)};
}

int64_t floor_divide(int64_t a, int64_t b) {  // b > 0
  const int64_t q = a / b;
  return a % b < 0 ? q - 1 : q;
}

struct Edge {
  Point from;
  int64_t dx, dy;
  int64_t bias;  // 0 when pixels on the edge belong to the triangle

  // Narrows [first, last] in row y to pixels on the inner side.
  void narrow(int y, int64_t& first, int64_t& last) const {
    const int64_t at_zero = dx * (y * 256 + 128 - from.y) - dy * (128 - from.x) + bias;  // value at pixel x = 0
    const int64_t step = -dy * 256;
    if (step > 0) {
      first = std::max(first, -floor_divide(at_zero, step));
    } else if (step < 0) {
      last = std::min(last, floor_divide(at_zero, -step));
    } else if (at_zero < 0) {
      last = first - 1;
    }
  }
};

// A value that is linear over the triangle: value at (x, y) = c + x * gx + y * gy.
struct Plane {
  float c, gx, gy;
  float at(float x, float y) const { return c + x * gx + y * gy; }
};

Plane plane_of(const ImDrawVert* const* v, float a, float b, float c) {
  const float x1 = v[1]->pos.x - v[0]->pos.x, y1 = v[1]->pos.y - v[0]->pos.y;
  const float x2 = v[2]->pos.x - v[0]->pos.x, y2 = v[2]->pos.y - v[0]->pos.y;
  const float inverse = 1.0f / (x1 * y2 - x2 * y1);
  const float gx = ((b - a) * y2 - (c - a) * y1) * inverse;
  const float gy = ((c - a) * x1 - (b - a) * x2) * inverse;
  return {a - v[0]->pos.x * gx - v[0]->pos.y * gy, gx, gy};
}

bool same_texel(const ImDrawVert* const* v) {
  return v[1]->uv.x == v[0]->uv.x && v[1]->uv.y == v[0]->uv.y && v[2]->uv.x == v[0]->uv.x && v[2]->uv.y == v[0]->uv.y;
}

// Colour and texture coordinates over a triangle.
class Gradient {
 public:
  explicit Gradient(const CpuRasteriser::Primitive& primitive) : texture_(*primitive.texture) {
    const ImDrawVert* const* v = primitive.v;
    flat_ = same_texel(v);
    if (flat_) {
      texel_ = constant_texel(primitive);
    } else {
      const float w = static_cast<float>(texture_.width), h = static_cast<float>(texture_.height);
      u_ = plane_of(v, v[0]->uv.x * w, v[1]->uv.x * w, v[2]->uv.x * w);
      v_ = plane_of(v, v[0]->uv.y * h, v[1]->uv.y * h, v[2]->uv.y * h);
    }
    // The soft edges of shapes: one colour that fades.
    colour_ = swap_red_blue(v[0]->col);
    fades_ = flat_ && texel_ == 0xffffffffu && ((v[0]->col ^ v[1]->col) | (v[0]->col ^ v[2]->col)) << 8 == 0;
    for (int k = fades_ ? 3 : 0; k < 4; ++k) {
      const auto part = [&](int i) { return static_cast<float>(swap_red_blue(v[i]->col) >> (k * 8) & 0xffu); };
      channel_[k] = plane_of(v, part(0), part(1), part(2));
    }
  }

  void draw(uint32_t* row, int y, int first, int last) const {
    const float yc = static_cast<float>(y) + 0.5f;
    if (fades_) {
      for (int x = first; x <= last; ++x) {
        const float alpha = std::clamp(channel_[3].at(static_cast<float>(x) + 0.5f, yc) + 0.5f, 0.0f, 255.0f);
        row[x] = blend(row[x], colour_, static_cast<uint32_t>(static_cast<int>(alpha)));
      }
      return;
    }
    for (int x = first; x <= last; ++x) {
      const float xc = static_cast<float>(x) + 0.5f;
      uint32_t c = 0;
      for (int k = 0; k < 4; ++k) {
        const float value = std::clamp(channel_[k].at(xc, yc) + 0.5f, 0.0f, 255.0f);
        c |= static_cast<uint32_t>(static_cast<int>(value)) << (8 * k);
      }
      const uint32_t s = flat_ ? texel_ : sample(texture_, u_.at(xc, yc), v_.at(xc, yc));
      if (s != 0xffffffffu) c = modulate(c, s);
      row[x] = blend(row[x], c, c >> 24);
    }
  }

 private:
  const Texture& texture_;
  Plane channel_[4];
  Plane u_, v_;
  bool flat_;
  bool fades_;
  uint32_t texel_ = 0;
  uint32_t colour_;
};

}  // namespace

void draw_triangle(const CpuRasteriser::Primitive& primitive, const PixelRect& clip, const Canvas& canvas) {
  const ImDrawVert* const* v = primitive.v;
  Point p[3] = {snap(v[0]->pos), snap(v[1]->pos), snap(v[2]->pos)};
  const int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  if (area == 0) return;
  if (area < 0) std::swap(p[1], p[2]);
  Edge edges[3];
  for (int i = 0; i < 3; ++i) {
    const Point& a = p[i];
    const Point& b = p[(i + 1) % 3];
    const int64_t dx = b.x - a.x, dy = b.y - a.y;
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    edges[i] = {a, dx, dy, top_left ? 0 : -1};
  }
  const bool constant = v[1]->col == v[0]->col && v[2]->col == v[0]->col && same_texel(v);
  const uint32_t colour = constant ? constant_colour(primitive) : 0;
  std::optional<Gradient> gradient;
  if (!constant) gradient.emplace(primitive);
  for (int y = clip.y0; y < clip.y1; ++y) {
    int64_t first = clip.x0, last = clip.x1 - 1;
    for (const Edge& edge : edges) edge.narrow(y, first, last);
    if (first > last) continue;
    uint32_t* row = row_of(canvas, y);
    if (constant) {
      blend_span(row + first, static_cast<int>(last - first + 1), colour);
    } else {
      gradient->draw(row, y, static_cast<int>(first), static_cast<int>(last));
    }
  }
}

}  // namespace vamp::window
