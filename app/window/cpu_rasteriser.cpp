#include "app/window/cpu_rasteriser.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/window/raster_spans.h"

namespace vamp::window {

namespace {

constexpr uint64_t kMultiplier = 0x9e3779b97f4a7c15ull;

uint64_t mix(uint64_t hash, uint64_t word) {
  hash = (hash ^ word) * kMultiplier;
  return hash ^ hash >> 29;
}

uint64_t mix_vertex(uint64_t hash, const ImDrawVert& v) {
  uint64_t words[2];
  std::memcpy(words, &v.pos, 8);
  std::memcpy(words + 1, &v.uv, 8);
  return mix(mix(mix(hash, words[0]), words[1]), v.col);
}

bool same_uv(const ImDrawVert& a, const ImDrawVert& b) { return a.uv.x == b.uv.x && a.uv.y == b.uv.y; }

// Whether six indices are a rectangle parallel to the axes: corners a (top left), b, c (bottom right), d of one colour.
bool is_rectangle(const ImDrawIdx* i, const ImDrawVert* v) {
  if (i[3] != i[0] || i[4] != i[2]) return false;
  const ImDrawVert &a = v[i[0]], &b = v[i[1]], &c = v[i[2]], &d = v[i[5]];
  const bool corners = a.pos.y == b.pos.y && b.pos.x == c.pos.x && c.pos.y == d.pos.y && d.pos.x == a.pos.x &&
                       a.pos.x < c.pos.x && a.pos.y < c.pos.y;
  const bool uvs = a.uv.y == b.uv.y && b.uv.x == c.uv.x && c.uv.y == d.uv.y && d.uv.x == a.uv.x;
  return corners && uvs && a.col == b.col && a.col == c.col && a.col == d.col;
}

uint64_t pair(int a, int b) { return static_cast<uint64_t>(a) << 32 | static_cast<uint32_t>(b); }

int whole(float x) { return static_cast<int>(std::floor(std::clamp(x, -32768.0f, 32767.0f))); }

// The first pixel whose centre is at or right of x.
int first_centre(float x) { return static_cast<int>(std::ceil(std::clamp(x, -32768.0f, 32767.0f) - 0.5f)); }

PixelRect intersect(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

bool empty(const PixelRect& r) { return r.x0 >= r.x1 || r.y0 >= r.y1; }

}  // namespace

void CpuRasteriser::set_background(uint32_t rgb) {
  const uint32_t colour = 0xff000000u | rgb;
  if (colour == background_) return;
  background_ = colour;
  forget();
}

void CpuRasteriser::enter(const Primitive& primitive, uint64_t hash) {
  const auto index = static_cast<uint32_t>(primitives_.size());
  primitives_.push_back(primitive);
  const PixelRect& b = primitive.bounds;
  hash = mix(mix(hash, pair(b.x0, b.x1)), pair(b.y0, b.y1));
  hash = mix(mix(hash, primitive.texture->revision), reinterpret_cast<uintptr_t>(primitive.texture));
  // A primitive that hides all below it in a tile makes what is below irrelevant there.
  const bool hides =
      (primitive.kind == Primitive::Kind::solid && constant_colour(primitive) >> 24 == 255) ||
      (primitive.kind == Primitive::Kind::picture && primitive.texture->opaque && primitive.v[0]->col >> 24 == 255);
  for (int ty = b.y0 / kTile; ty <= (b.y1 - 1) / kTile; ++ty) {
    for (int tx = b.x0 / kTile; tx <= (b.x1 - 1) / kTile; ++tx) {
      const auto tile = static_cast<size_t>(ty * columns_ + tx);
      const bool covers = hides && b.x0 <= tx * kTile && b.y0 <= ty * kTile &&
                          b.x1 >= std::min((tx + 1) * kTile, last_.width) &&
                          b.y1 >= std::min((ty + 1) * kTile, last_.height);
      if (covers) {
        tiles_[tile].clear();
        next_hashes_[tile] = 0;
      }
      tiles_[tile].push_back(index);
      next_hashes_[tile] = mix(next_hashes_[tile], hash);
    }
  }
}

void CpuRasteriser::enter_command(const ImDrawList& list, const ImDrawCmd& command, const PixelRect& clip,
                                  const Texture& texture) {
  const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
  const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
  const ImDrawIdx* end = index + command.ElemCount;
  while (index < end) {
    if (end - index >= 6 && is_rectangle(index, vertices)) {
      const ImDrawVert &a = vertices[index[0]], &b = vertices[index[2]];
      index += 6;
      const PixelRect bounds =
          intersect(clip, {first_centre(a.pos.x), first_centre(a.pos.y), first_centre(b.pos.x), first_centre(b.pos.y)});
      if (empty(bounds) || a.col >> 24 == 0) continue;
      const auto kind = same_uv(a, b) ? Primitive::Kind::solid : Primitive::Kind::picture;
      enter({kind, bounds, &texture, {&a, &b, nullptr}}, mix_vertex(mix_vertex(static_cast<uint64_t>(kind) + 1, a), b));
      continue;
    }
    const ImDrawVert &p = vertices[index[0]], &q = vertices[index[1]], &r = vertices[index[2]];
    index += 3;
    const PixelRect bounds = intersect(
        clip, {whole(std::min({p.pos.x, q.pos.x, r.pos.x})), whole(std::min({p.pos.y, q.pos.y, r.pos.y})),
               whole(std::max({p.pos.x, q.pos.x, r.pos.x})) + 1, whole(std::max({p.pos.y, q.pos.y, r.pos.y})) + 1});
    if (empty(bounds) || (p.col | q.col | r.col) >> 24 == 0) continue;
    enter({Primitive::Kind::triangle, bounds, &texture, {&p, &q, &r}}, mix_vertex(mix_vertex(mix_vertex(7, p), q), r));
  }
}

void CpuRasteriser::collect(const ImDrawData& data, const Canvas& canvas) {
  const PixelRect screen{0, 0, canvas.width, canvas.height};
  for (int n = 0; n < data.CmdListsCount; ++n) {
    const ImDrawList& list = *data.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr || command.ElemCount == 0) continue;
      const Texture* texture = textures_.find(command.GetTexID());
      if (texture == nullptr || texture->pixels == nullptr) continue;
      const ImVec4& c = command.ClipRect;
      const PixelRect clip = intersect(
          screen, {static_cast<int>(c.x), static_cast<int>(c.y), static_cast<int>(c.z), static_cast<int>(c.w)});
      if (!empty(clip)) enter_command(list, command, clip, *texture);
    }
  }
}

std::span<const PixelRect> CpuRasteriser::draw(const ImDrawData& data, const Canvas& canvas) {
  changed_.clear();
  if (canvas.width <= 0 || canvas.height <= 0) return changed_;
  if (canvas.pixels != last_.pixels || canvas.width != last_.width || canvas.height != last_.height ||
      canvas.row_pixels != last_.row_pixels) {
    forget();
  }
  last_ = canvas;
  columns_ = (canvas.width + kTile - 1) / kTile;
  rows_ = (canvas.height + kTile - 1) / kTile;
  const auto count = static_cast<size_t>(columns_) * static_cast<size_t>(rows_);
  tiles_.resize(count);
  for (auto& tile : tiles_) tile.clear();
  next_hashes_.assign(count, 0);
  primitives_.clear();
  collect(data, canvas);

  const bool all = hashes_.size() != count;
  for (int ty = 0; ty < rows_; ++ty) {
    bool joined = false;  // to the changed tile on the left
    for (int tx = 0; tx < columns_; ++tx) {
      const auto tile = static_cast<size_t>(ty * columns_ + tx);
      if (!all && hashes_[tile] == next_hashes_[tile]) {
        joined = false;
        continue;
      }
      const PixelRect area{tx * kTile, ty * kTile, std::min((tx + 1) * kTile, canvas.width),
                           std::min((ty + 1) * kTile, canvas.height)};
      fill(area, background_, canvas);
      for (const uint32_t index : tiles_[tile]) {
        const Primitive& primitive = primitives_[index];
        const PixelRect clip = intersect(primitive.bounds, area);
        switch (primitive.kind) {
          case Primitive::Kind::solid:
            draw_solid(primitive, clip, canvas);
            break;
          case Primitive::Kind::picture:
            draw_picture(primitive, clip, canvas);
            break;
          case Primitive::Kind::triangle:
            draw_triangle(primitive, clip, canvas);
            break;
        }
      }
      if (joined) {
        changed_.back().x1 = area.x1;
      } else {
        changed_.push_back(area);
      }
      joined = true;
    }
  }
  hashes_.swap(next_hashes_);
  return changed_;
}

}  // namespace vamp::window
