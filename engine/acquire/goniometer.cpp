#include "engine/acquire/goniometer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/acquire/parallel.h"
#include "engine/brdf/kernel.h"
#include "engine/core/check.h"
#include "engine/core/progress.h"

namespace vamp::acquire {
namespace {

// Rays leave a facet from this far above it, in periods: some roundings, less than a hundredth of a facet.
constexpr float kLift = 5e-6f;
// Between yarns that nearly touch, a path of a white furnace may take some thousand steps to find its way out. In a
// closed hollow it never would.
constexpr int kMostVertices = 1000000;

float mean(vec3 c) { return (c.x + c.y + c.z) * (1.0f / 3); }

}  // namespace

// Where a path meets a facet: the frame with the normal as z and the fibre as x, and what reflects there.
struct Goniometer::Vertex {
  Vertex(const Goniometer& goniometer, const FacetGrid::Hit& hit, vec3 direction)
      : index(hit.facet),
        facet(goniometer.grid_.facets()[hit.facet]),
        matter(goniometer.matters_[facet.matter]),
        z(goniometer.grid_.normal(hit.facet)),
        point(hit.point + z * kLift) {
    vec3 along = facet.fibre - z * glm::dot(z, facet.fibre);
    if (glm::dot(along, along) < 1e-8f) along = glm::cross(z, std::abs(z.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0));
    x = glm::normalize(along);
    y = glm::cross(z, x);
    wo = to_local(-direction);
    has_coat = matter.coat_colour != vec3(0);
  }
  vec3 to_local(vec3 w) const { return {glm::dot(x, w), glm::dot(y, w), glm::dot(z, w)}; }
  vec3 to_world(vec3 w) const { return x * w.x + y * w.y + z * w.z; }
  // f * cos for a light in the local frame, above the horizon.
  vec3 fcos(vec3 wi) const {
    vec3 value = facet.colour * brdf_f32::eval(matter.body, wi, wo);
    if (has_coat) value += matter.coat_colour * brdf_f32::eval(matter.coat, wi, wo);
    return value;
  }

  uint32_t index;
  const Facet& facet;
  const Matter& matter;
  vec3 z, point, x, y, wo;
  bool has_coat;
};

Goniometer::Goniometer(Mesostructure structure, std::vector<vec3> lights, Shadows shadows, int threads,
                       const Progress* progress)
    : grid_(std::move(structure.facets)), matters_(std::move(structure.matters)), lights_(std::move(lights)) {
  CHECK(lights_.size() <= kMaxLights);
  for (const Matter& matter : matters_)
    coat_albedo_.push_back(lobe_albedo(matter.coat, 0.7f) * mean(matter.coat_colour));
  if (shadows == Shadows::tabulated) tabulate_shadows(threads, progress);
  find_reference_height();
}

void Goniometer::tabulate_shadows(int threads, const Progress* progress) {
  const std::vector<Facet>& facets = grid_.facets();
  lit_.assign(facets.size(), {});
  constexpr size_t kBlock = 4096;
  const auto blocks = static_cast<int>((facets.size() + kBlock - 1) / kBlock);
  parallel(threads, blocks, [&](int block) {
    const size_t first = static_cast<size_t>(block) * kBlock;
    for (size_t i = first; i < std::min(first + kBlock, facets.size()); ++i) tabulate_facet(static_cast<uint32_t>(i));
    return progress == nullptr || !progress->cancelled();
  });
}

void Goniometer::tabulate_facet(uint32_t index) {
  // Any points of the facet, not its middle alone: that would miss shadows that cover less than half of it and so
  // brighten creases. Those inside another yarn are never seen.
  constexpr size_t kPoints = 8;
  const auto& c = grid_.facets()[index].corner;
  const vec3 normal = grid_.normal(index);
  std::array<vec3, kPoints> points;
  size_t count = 0;
  Random random(index);
  for (size_t i = 0; i < kPoints; ++i) {
    const float root = std::sqrt(random.next()), along = random.next();
    points[count] = c[0] * (1 - root) + (c[1] * (1 - along) + c[2] * along) * root + normal * kLift;
    if (!grid_.is_inside(points[count])) ++count;
  }
  if (count == 0) return;
  const auto turn = static_cast<size_t>(random.bits() >> 32);
  for (size_t l = 0; l < lights_.size(); ++l)
    if (glm::dot(normal, lights_[l]) > 0 && !grid_.is_blocked(points[(l + turn) % count], lights_[l], index))
      lit_[index][l / 64] |= uint64_t{1} << (l % 64);
}

void Goniometer::find_reference_height() {
  constexpr int kRays = 128;  // a side
  double sum = 0;
  for (int y = 0; y < kRays; ++y)
    for (int x = 0; x < kRays; ++x) {
      const vec3 above((static_cast<float>(x) + 0.5f) / kRays, (static_cast<float>(y) + 0.5f) / kRays, grid_.top() + 1);
      const FacetGrid::Hit hit = grid_.first_hit(above, vec3(0, 0, -1));
      sum += static_cast<double>(hit.facet == FacetGrid::kNone ? grid_.bottom() : hit.point.z);
    }
  reference_height_ = static_cast<float>(sum / (kRays * kRays));
}

bool Goniometer::is_lit(const Vertex& vertex, size_t light) const {
  return lit_.empty() ? !grid_.is_blocked(vertex.point, lights_[light], vertex.index)
                      : (lit_[vertex.index][light / 64] >> (light % 64) & 1) != 0;
}

void Goniometer::gather_lights(const Vertex& vertex, vec3 throughput, std::span<float> radiance) const {
  for (size_t l = 0; l < lights_.size(); ++l) {
    const vec3 wi = vertex.to_local(lights_[l]);
    if (!(wi.z > 0) || !is_lit(vertex, l)) continue;
    const vec3 value = throughput * vertex.fcos(wi);
    for (int c = 0; c < 3; ++c) radiance[3 * l + static_cast<size_t>(c)] += value[c];
  }
}

// Draws the next direction from the body or the coat, weighted by the density of both (Veach and Guibas 1995).
bool Goniometer::scatter(const Vertex& vertex, Random& random, vec3& throughput, vec3& direction) const {
  float share = 0;
  if (vertex.has_coat) {
    const float coat = coat_albedo_[vertex.facet.matter];
    share = std::clamp(coat / (coat + mean(vertex.facet.colour)), 0.1f, 0.9f);
  }
  const bool from_coat = random.next() < share;
  const float u0 = random.next(), u1 = random.next();
  vec3 wi(0);
  float pdf = 0, weight = 0;
  const Lobe& drawn = from_coat ? vertex.matter.coat : vertex.matter.body;
  if (!brdf_f32::sample(drawn, vertex.wo, u0, u1, wi, pdf, weight) || !(wi.z > 0)) return false;
  if (!vertex.has_coat) {
    throughput *= vertex.facet.colour * weight;
  } else {
    const float coat_pdf = from_coat ? pdf : brdf_f32::pdf(vertex.matter.coat, wi, vertex.wo);
    const float body_pdf = from_coat ? brdf_f32::pdf(vertex.matter.body, wi, vertex.wo) : pdf;
    throughput *= vertex.fcos(wi) / (share * coat_pdf + (1 - share) * body_pdf);
  }
  // Russian roulette by what is left.
  const float left = std::max({throughput.x, throughput.y, throughput.z});
  const float stay = std::min(left, 1.0f);
  if (!(random.next() < stay)) return false;
  throughput /= stay;
  direction = vertex.to_world(wi);
  return true;
}

template <class Gather>
vec3 Goniometer::follow(vec2 place, vec3 view, Random& random, Gather gather) const {
  vec3 origin = vec3(place.x, place.y, reference_height_) + view * ((grid_.top() - reference_height_ + 1e-4f) / view.z);
  vec3 direction = -view, throughput(1);
  uint32_t from = FacetGrid::kNone;
  for (int i = 0; i < kMostVertices; ++i) {
    const FacetGrid::Hit hit = grid_.first_hit(origin, direction, from);
    if (hit.facet == FacetGrid::kNone) return direction.z > 0 ? throughput : vec3(0);
    const Vertex vertex(*this, hit, direction);
    if (!(vertex.wo.z > 0)) return vec3(0);
    gather(vertex, throughput);
    if (!scatter(vertex, random, throughput, direction)) return vec3(0);
    origin = vertex.point;
    from = hit.facet;
  }
  return vec3(0);
}

void Goniometer::trace(vec2 place, vec3 view, Random& random, std::span<float> radiance) const {
  follow(place, view, random,
         [&](const Vertex& vertex, vec3 throughput) { gather_lights(vertex, throughput, radiance); });
}

vec3 Goniometer::trace_sky(vec2 place, vec3 view, Random& random) const {
  return follow(place, view, random, [](const Vertex&, vec3) {});
}

}  // namespace vamp::acquire
