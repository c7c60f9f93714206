#include "engine/acquire/facet_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/core/check.h"

namespace vamp::acquire {
namespace {

using glm::ivec3;

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr int kBlock = 8;
constexpr size_t kCellsInBlock = kBlock * kBlock * kBlock;
// In periods: more than what rounding moves a ray by.
constexpr float kHair = 1e-6f;

// Where the ray meets the facet, or kFar. Moeller and Trumbore 1997; the edges are taken 1e-4 of the facet wider, so
// that no ray slips through between two. With kBacks also from behind.
template <bool kBacks>
float meet(const Facet& facet, vec3 origin, vec3 direction) {
  constexpr float kWider = 1e-4f;
  const vec3 e1 = facet.corner[1] - facet.corner[0], e2 = facet.corner[2] - facet.corner[0];
  const vec3 p = glm::cross(direction, e2);
  const float determinant = glm::dot(e1, p);
  if (kBacks ? determinant == 0 : !(determinant > 0)) return kFar;
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

// Steps of a ray through cells (Amanatides and Woo 1987), axis by axis. The ray is in cells, its parameter its own.
struct Steps {
  Steps(vec3 origin, vec3 direction, ivec3 first) : at(first) {
    for (int a = 0; a < 3; ++a) {
      step[a] = direction[a] > 0 ? 1 : -1;
      delta[a] = direction[a] == 0 ? kFar : std::abs(1 / direction[a]);
      const int side = at[a] + (direction[a] > 0 ? 1 : 0);
      next[a] = direction[a] == 0 ? kFar : (static_cast<float>(side) - origin[a]) / direction[a];
    }
  }
  // Where the ray leaves the cell.
  float leave() const { return std::min({next[0], next[1], next[2]}); }
  // Goes to the next cell and returns the axis.
  int advance() {
    const int a = next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    at[a] += step[a];
    next[a] += delta[a];
    return a;
  }
  ivec3 at, step{0};
  vec3 delta{0}, next{0};
};

size_t in_block(ivec3 cell) {
  const ivec3 in = cell & (kBlock - 1);
  return static_cast<size_t>((in.z * kBlock + in.y) * kBlock + in.x);
}

}  // namespace

// A ray and what it has met. Where the ray wraps, its origin moves by a period and the parameter runs on.
struct FacetGrid::Search {
  vec3 origin, direction;
  uint32_t ignored;
  float nearest = kFar;
  Hit hit;
};

FacetGrid::FacetGrid(std::vector<Facet> facets) : facets_(std::move(facets)) {
  std::erase_if(facets_, [](const Facet& facet) { return !has_area(facet); });
  CHECK(!facets_.empty());
  wrap_facets();
  choose_cells();
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

void FacetGrid::choose_cells() {
  top_ = -kFar, bottom_ = kFar;
  for (const Facet& facet : facets_) {
    const Box box = box_of(facet);
    top_ = std::max(top_, box.high.z + kHair), bottom_ = std::min(bottom_, box.low.z - kHair);
  }
  // About two facets a column, as a height field has, and cells about twice as high as wide.
  const double columns = std::sqrt(static_cast<double>(facets_.size()) / 2);
  const int side = std::clamp(static_cast<int>(std::lround(columns / kBlock)), 1, 256) * kBlock;
  const double height = static_cast<double>(top_ - bottom_) * side;
  const int layers = std::clamp(static_cast<int>(std::lround(height / (2 * kBlock))), 1, 8) * kBlock;
  cells_ = ivec3(side, side, layers);
  scale_ = vec3(static_cast<float>(side), static_cast<float>(side), static_cast<float>(layers) / (top_ - bottom_));
}

// The number of a block's first cell.
size_t FacetGrid::block_start(ivec3 block) const {
  const ivec3 blocks = cells_ / kBlock;
  return static_cast<size_t>((block.z * blocks.y + block.y) * blocks.x + block.x) * kCellsInBlock;
}

size_t FacetGrid::index(ivec3 cell) const { return block_start(cell / kBlock) + in_block(cell); }

template <class Visit>
void FacetGrid::visit_cells(const Facet& facet, Visit visit) const {
  const Box box = box_of(facet);
  // A hair wider, for rays that run along a cell's side.
  const auto cell = [&](vec3 point, float by) {
    const vec3 at = (point - vec3(0, 0, bottom_)) * scale_ + by;
    return glm::clamp(ivec3(glm::floor(at)), ivec3(0), cells_ - 1);
  };
  const ivec3 low = cell(box.low, -1e-3f), high = cell(box.high, 1e-3f);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) visit(index({x, y, z}));
}

void FacetGrid::fill_cells() {
  const size_t count = index(cells_ - 1) + 1;
  first_.assign(count + 1, 0);
  for (const Facet& facet : facets_) visit_cells(facet, [&](size_t cell) { ++first_[cell + 1]; });
  for (size_t i = 1; i <= count; ++i) first_[i] += first_[i - 1];
  references_.resize(first_[count]);
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t i = 0; i < facets_.size(); ++i)
    visit_cells(facets_[i], [&](size_t cell) { references_[next[cell]++] = i; });
}

// True when the search is over.
template <FacetGrid::Sought kSought>
bool FacetGrid::walk_block(ivec3 block, float enter, float leave, Search& search) const {
  const vec3 origin = (search.origin - vec3(0, 0, bottom_)) * scale_, direction = search.direction * scale_;
  const ivec3 low = block * kBlock, high = low + (kBlock - 1);
  Steps steps(origin, direction, glm::clamp(ivec3(glm::floor(origin + direction * enter)), low, high));
  const size_t start = block_start(block);
  while (true) {
    const size_t cell = start + in_block(steps.at);
    for (uint32_t r = first_[cell]; r < first_[cell + 1]; ++r) {
      const uint32_t i = references_[r];
      if (i == search.ignored) continue;
      const float t = meet<kSought != Sought::first_front>(facets_[i], search.origin, search.direction);
      if (t >= search.nearest) continue;
      search.nearest = t;
      search.hit = {i, search.origin + search.direction * t};
      if (kSought == Sought::any) return true;
    }
    const float out = std::min(steps.leave(), leave);
    if (search.nearest <= out) return true;
    if (out >= leave) return false;
    const int axis = steps.advance();
    if (steps.at[axis] < low[axis] || steps.at[axis] > high[axis]) return false;
  }
}

template <FacetGrid::Sought kSought>
FacetGrid::Hit FacetGrid::walk(vec3 origin, vec3 direction, uint32_t ignored) const {
  if (origin.z > top_) {
    if (direction.z >= 0) return {};
    origin += direction * ((top_ - origin.z) / direction.z);
  }
  origin.x -= std::floor(origin.x), origin.y -= std::floor(origin.y);
  Search search{origin, direction, ignored, kFar, {}};
  // A ray that runs level would never leave the layer.
  const float level = std::max(std::abs(direction.x), std::abs(direction.y));
  const float end = level > 0 ? 64 / level : kFar;

  const ivec3 blocks = cells_ / kBlock;
  const vec3 scale = scale_ / static_cast<float>(kBlock);
  const vec3 start = (origin - vec3(0, 0, bottom_)) * scale;
  Steps steps(start, direction * scale, glm::clamp(ivec3(glm::floor(start)), ivec3(0), blocks - 1));
  float enter = 0;
  while (enter < end) {
    const float leave = steps.leave();
    const size_t first = block_start(steps.at);
    const bool is_empty = first_[first] == first_[first + kCellsInBlock];
    if (!is_empty && walk_block<kSought>(steps.at, enter, leave, search)) break;
    if (search.nearest <= leave) break;
    enter = leave;
    const int axis = steps.advance();
    int& at = steps.at[axis];
    if (at >= 0 && at < blocks[axis]) continue;
    if (axis == 2) break;
    at -= steps.step[axis] * blocks[axis];
    search.origin[axis] -= static_cast<float>(steps.step[axis]);
  }
  return search.hit;
}

FacetGrid::Hit FacetGrid::first_hit(vec3 origin, vec3 direction, uint32_t ignored) const {
  return walk<Sought::first_front>(origin, direction, ignored);
}

bool FacetGrid::is_blocked(vec3 origin, vec3 direction, uint32_t ignored) const {
  return walk<Sought::any>(origin, direction, ignored).facet != kNone;
}

bool FacetGrid::is_inside(vec3 point) const {
  const Hit above = walk<Sought::first>(point, vec3(0, 0, 1), kNone);
  return above.facet != kNone && normal(above.facet).z > 0;
}

vec3 FacetGrid::normal(uint32_t facet) const {
  const auto& c = facets_[facet].corner;
  return glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
}

}  // namespace vamp::acquire
