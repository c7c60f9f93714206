#include "engine/acquire/facet_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/core/check.h"

namespace vamp::acquire {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr int kBlock = 8;
// In periods: more than what rounding moves a ray by.
constexpr float kHair = 1e-6f;

// Where the ray meets the front of the facet, or kFar. Moeller and Trumbore 1997; the edges are taken 1e-4 of the facet
// wider, so that no ray slips through between two. Backs are not met: what is seen from outside is closed, and a path
// that starts a rounding error below its neighbour in a crease comes out.
float meet(const Facet& facet, vec3 origin, vec3 direction) {
  constexpr float kWider = 1e-4f;
  const vec3 e1 = facet.corner[1] - facet.corner[0], e2 = facet.corner[2] - facet.corner[0];
  const vec3 p = glm::cross(direction, e2);
  const float determinant = glm::dot(e1, p);
  if (!(determinant > 0)) return kFar;
  const float inverse = 1 / determinant;
  const vec3 s = origin - facet.corner[0];
  const float u = glm::dot(s, p) * inverse;
  if (!(u >= -kWider && u <= 1 + kWider)) return kFar;
  const vec3 q = glm::cross(s, e1);
  const float v = glm::dot(direction, q) * inverse;
  if (!(v >= -kWider && u + v <= 1 + kWider)) return kFar;
  const float t = glm::dot(e2, q) * inverse;
  return t > 0 ? t : kFar;
}

struct Box {
  vec3 low, high;
};
Box box_of(const Facet& facet) {
  const auto& c = facet.corner;
  return {glm::min(c[0], glm::min(c[1], c[2])), glm::max(c[0], glm::max(c[1], c[2]))};
}

bool has_area(const Facet& facet) {
  const auto& c = facet.corner;
  const vec3 normal = glm::cross(c[1] - c[0], c[2] - c[0]);
  return glm::dot(normal, normal) > 1e-24f;
}

void move(Facet& facet, vec3 by) {
  for (vec3& corner : facet.corner) corner += by;
}

}  // namespace

FacetGrid::FacetGrid(std::vector<Facet> facets) : facets_(std::move(facets)) {
  std::erase_if(facets_, [](const Facet& facet) { return !has_area(facet); });
  CHECK(!facets_.empty());
  wrap_facets();
  fill_cells();
}

// Each facet is brought to where its lowest corner lies in the unit square, and copied where it reaches beyond.
void FacetGrid::wrap_facets() {
  const size_t count = facets_.size();
  for (size_t i = 0; i < count; ++i) {
    const vec3 low = box_of(facets_[i]).low;
    move(facets_[i], vec3(-std::floor(low.x), -std::floor(low.y), 0));
    const vec3 high = box_of(facets_[i]).high;
    for (int y = 0; y <= (high.y > 1 ? 1 : 0); ++y)
      for (int x = 0; x <= (high.x > 1 ? 1 : 0); ++x) {
        if (x == 0 && y == 0) continue;
        Facet copy = facets_[i];
        move(copy, vec3(static_cast<float>(-x), static_cast<float>(-y), 0));
        facets_.push_back(copy);
      }
  }
}

void FacetGrid::fill_cells() {
  // About two facets a cell, as a height field has.
  const double cells_a_side = std::sqrt(static_cast<double>(facets_.size()) / 2);
  side_ = std::clamp(static_cast<int>(std::lround(cells_a_side / kBlock)), 1, 512) * kBlock;
  const auto count = static_cast<size_t>(side_) * static_cast<size_t>(side_);
  const auto row = static_cast<size_t>(side_ / kBlock);
  ranges_.assign(count, {kFar, -kFar});
  blocks_.assign(row * row, {kFar, -kFar});
  first_.assign(count + 1, 0);
  top_ = -kFar, bottom_ = kFar;
  const auto for_cells = [&](const Box& box, const auto& visit) {
    // A hair wider, for rays that run along a cell's side.
    const auto cell = [&](float at, float by) {
      return std::clamp(static_cast<int>(std::floor(at * static_cast<float>(side_) + by)), 0, side_ - 1);
    };
    for (int y = cell(box.low.y, -1e-3f); y <= cell(box.high.y, 1e-3f); ++y)
      for (int x = cell(box.low.x, -1e-3f); x <= cell(box.high.x, 1e-3f); ++x)
        visit(static_cast<size_t>(x), static_cast<size_t>(y));
  };
  const auto widen = [](Range& range, const Box& box) {
    range = {std::min(range.low, box.low.z - kHair), std::max(range.high, box.high.z + kHair)};
  };
  for (const Facet& facet : facets_) {
    const Box box = box_of(facet);
    top_ = std::max(top_, box.high.z), bottom_ = std::min(bottom_, box.low.z);
    for_cells(box, [&](size_t x, size_t y) {
      const size_t cell = y * static_cast<size_t>(side_) + x;
      widen(ranges_[cell], box);
      widen(blocks_[y / kBlock * row + x / kBlock], box);
      ++first_[cell + 1];
    });
  }
  for (size_t i = 1; i <= count; ++i) first_[i] += first_[i - 1];
  references_.resize(first_[count]);
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t i = 0; i < facets_.size(); ++i)
    for_cells(box_of(facets_[i]),
              [&](size_t x, size_t y) { references_[next[y * static_cast<size_t>(side_) + x]++] = i; });
}

// A ray and what it has met. Where the ray wraps, its origin moves by a period and the parameter runs on.
struct FacetGrid::Search {
  vec3 origin, direction;
  uint32_t ignored;
  float end;  // of the ray
  float nearest = kFar;
  Hit hit;

  bool overlaps(const Range& range, float enter, float leave) const {
    const float z0 = origin.z + direction.z * enter, z1 = origin.z + direction.z * leave;
    return std::min(z0, z1) <= range.high && std::max(z0, z1) >= range.low;
  }
};

namespace {

// Steps of a ray along one axis of a grid with `scale` cells a period (Amanatides and Woo 1987).
struct Steps {
  Steps(float origin, float direction, float scale, int cell)
      : step(direction > 0 ? 1 : -1),
        delta(direction == 0 ? kFar : 1 / (scale * std::abs(direction))),
        next(direction == 0 ? kFar
                            : (static_cast<float>(cell + (step > 0 ? 1 : 0)) - origin * scale) / (scale * direction)) {}
  int step;
  float delta;  // between two sides of cells
  float next;   // where the ray meets the next side
};

}  // namespace

// True when the search is over.
template <bool kAny>
bool FacetGrid::walk_block(int block_x, int block_y, float enter, float leave, Search& search) const {
  const auto side = static_cast<float>(side_);
  const vec3 at = search.origin + search.direction * enter;
  const int low_x = block_x * kBlock, low_y = block_y * kBlock;
  int x = std::clamp(static_cast<int>(at.x * side), low_x, low_x + kBlock - 1);
  int y = std::clamp(static_cast<int>(at.y * side), low_y, low_y + kBlock - 1);
  Steps across(search.origin.x, search.direction.x, side, x), along(search.origin.y, search.direction.y, side, y);
  while (true) {
    const float out = std::min({across.next, along.next, leave});
    const size_t cell = static_cast<size_t>(y) * static_cast<size_t>(side_) + static_cast<size_t>(x);
    if (search.overlaps(ranges_[cell], enter, out)) {
      for (uint32_t r = first_[cell]; r < first_[cell + 1]; ++r) {
        const uint32_t i = references_[r];
        if (i == search.ignored) continue;
        const float t = meet(facets_[i], search.origin, search.direction);
        if (t >= search.nearest) continue;
        search.nearest = t;
        search.hit = {i, search.origin + search.direction * t};
        if (kAny) return true;
      }
    }
    if (search.nearest <= out) return true;
    if (out >= leave) return false;
    enter = out;
    if (across.next <= along.next) {
      x += across.step, across.next += across.delta;
      if (x < low_x || x >= low_x + kBlock) return false;
    } else {
      y += along.step, along.next += along.delta;
      if (y < low_y || y >= low_y + kBlock) return false;
    }
  }
}

template <bool kAny>
FacetGrid::Hit FacetGrid::walk(vec3 origin, vec3 direction, uint32_t ignored) const {
  if (origin.z > top_) {
    if (direction.z >= 0) return {};
    origin += direction * ((top_ - origin.z) / direction.z);
  }
  origin.x -= std::floor(origin.x), origin.y -= std::floor(origin.y);
  Search search{origin, direction, ignored, kFar, kFar, {}};
  // Where the ray leaves the layer; one that runs level would never.
  if (direction.z != 0) search.end = ((direction.z > 0 ? top_ : bottom_) - origin.z) / direction.z + kHair;
  const float level = std::max(std::abs(direction.x), std::abs(direction.y));
  if (level > 0) search.end = std::min(search.end, 64 / level);

  const int row = side_ / kBlock;
  const auto scale = static_cast<float>(row);
  int x = std::min(static_cast<int>(origin.x * scale), row - 1),
      y = std::min(static_cast<int>(origin.y * scale), row - 1);
  Steps across(origin.x, direction.x, scale, x), along(origin.y, direction.y, scale, y);
  float enter = 0;
  while (true) {
    const float leave = std::min({across.next, along.next, search.end});
    const Range& block = blocks_[static_cast<size_t>(y * row + x)];
    if (search.overlaps(block, enter, leave) && walk_block<kAny>(x, y, enter, leave, search)) break;
    if (search.nearest <= leave || leave >= search.end) break;
    enter = leave;
    if (across.next <= along.next) {
      x += across.step, across.next += across.delta;
      if (x < 0 || x >= row) x -= across.step * row, search.origin.x -= static_cast<float>(across.step);
    } else {
      y += along.step, along.next += along.delta;
      if (y < 0 || y >= row) y -= along.step * row, search.origin.y -= static_cast<float>(along.step);
    }
  }
  return search.hit;
}

FacetGrid::Hit FacetGrid::first_hit(vec3 origin, vec3 direction, uint32_t ignored) const {
  return walk<false>(origin, direction, ignored);
}

bool FacetGrid::is_blocked(vec3 origin, vec3 direction, uint32_t ignored) const {
  return walk<true>(origin, direction, ignored).facet != kNone;
}

vec3 FacetGrid::normal(uint32_t facet) const {
  const auto& c = facets_[facet].corner;
  return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
}

}  // namespace vamp::acquire
