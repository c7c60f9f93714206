#include "engine/acquire/strand.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/acquire/noise.h"
#include "engine/core/check.h"

namespace vamp::acquire {
namespace {

using glm::dvec3;
constexpr double kTurn = 2 * std::numbers::pi;

struct Ring {
  dvec3 centre, along, side, up;  // `side` and `up` span the cross-section
};

// Cross-sections stand as upright as the curve lets them.
std::vector<Ring> rings_of(const Strand& strand) {
  const auto count = static_cast<int>(strand.centre.size());
  const auto at = [&](int i) {
    if (strand.endless) {
      if (i < 0) return strand.centre[static_cast<size_t>(i + count)] - strand.period;
      if (i >= count) return strand.centre[static_cast<size_t>(i - count)] + strand.period;
    }
    return strand.centre[static_cast<size_t>(std::clamp(i, 0, count - 1))];
  };
  std::vector<Ring> rings;
  for (int i = 0; i < count + (strand.endless ? 1 : 0); ++i) {
    Ring ring{at(i), glm::normalize(at(i + 1) - at(i - 1)), {}, {}};
    const dvec3 upright = std::abs(ring.along.z) < 0.999 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    ring.up = glm::normalize(upright - ring.along * glm::dot(upright, ring.along));
    ring.side = glm::cross(ring.up, ring.along);
    rings.push_back(ring);
  }
  return rings;
}

}  // namespace

void add_strand(std::vector<Facet>& facets, double mm, const Strand& strand) {
  CHECK(strand.centre.size() >= 2 && strand.sides >= 3);
  const std::vector<Ring> rings = rings_of(strand);
  const auto sides = static_cast<size_t>(strand.sides);
  const size_t last = rings.size() - 1;
  // An endless strand's twist must meet itself.
  const double turns = strand.endless ? std::round(strand.turns) : strand.turns;
  // A fibre's own angle about the axis, in turns: the same all along it.
  const auto fibre_angle = [&](size_t i, size_t k) {
    const double angle =
        static_cast<double>(k) / strand.sides - turns * static_cast<double>(i) / static_cast<double>(last);
    return angle - std::floor(angle);
  };
  const auto fibre_noise = [&](size_t i, size_t k, uint32_t seed) {
    if (strand.fibre_cells == 0) return 0.0;
    const double v = static_cast<double>(i % last) / static_cast<double>(last);
    return noise::gradient(fibre_angle(i, k), v, 11, strand.fibre_cells, strand.seed + seed);
  };
  std::vector<dvec3> points(rings.size() * sides);
  for (size_t i = 0; i < rings.size(); ++i)
    for (size_t k = 0; k < sides; ++k) {
      double radius = 1 + strand.unevenness * fibre_noise(i, k, 1);
      if (strand.plies > 1)
        radius -=
            strand.ply_depth * (1 - std::sqrt(std::abs(std::cos(0.5 * strand.plies * kTurn * fibre_angle(i, k)))));
      if (!strand.endless) {
        const double end = 2 * static_cast<double>(std::min(i, last - i)) / static_cast<double>(last);
        radius *= std::sqrt(std::min(1.0, 0.02 + 3 * end));
      }
      const double angle = kTurn * static_cast<double>(k) / strand.sides;
      points[i * sides + k] = rings[i].centre + rings[i].side * (strand.half_width * radius * std::cos(angle)) +
                              rings[i].up * (strand.half_thickness * radius * std::sin(angle));
    }

  for (size_t i = 0; i < last; ++i) {
    const double step = glm::length(rings[i + 1].centre - rings[i].centre);
    for (size_t k = 0; k < sides; ++k) {
      const auto point = [&](size_t ring, size_t side) { return points[ring * sides + side % sides]; };
      const dvec3 a = point(i, k), b = point(i, k + 1), c = point(i + 1, k + 1), d = point(i + 1, k);
      // While the strand goes on by `step`, its fibres go round by this share of a side.
      const double round = turns / static_cast<double>(last) * strand.sides;
      const dvec3 fibre = rings[i].along * step + (b - a) * round;
      const auto mix = static_cast<float>(std::clamp(0.5 + 0.9 * fibre_noise(i, k, 2), 0.0, 1.0)) * strand.blend;
      Facet facet;
      facet.colour = strand.colour + (strand.second_colour - strand.colour) * mix;
      facet.fibre = vec3(glm::normalize(fibre));
      facet.matter = strand.matter;
      const auto corner = [mm](dvec3 p) { return vec3(p / mm); };
      facet.corner = {corner(a), corner(b), corner(c)};
      facets.push_back(facet);
      facet.corner = {corner(a), corner(c), corner(d)};
      facets.push_back(facet);
    }
  }
}

void add_ground(std::vector<Facet>& facets, double mm, int cells, double height, vec3 colour, uint8_t matter) {
  const auto z = static_cast<float>(height / mm);
  const auto side = static_cast<float>(cells);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      const auto corner = [&](int dx, int dy) {
        return vec3(static_cast<float>(x + dx) / side, static_cast<float>(y + dy) / side, z);
      };
      facets.push_back({{corner(0, 0), corner(1, 0), corner(1, 1)}, colour, vec3(1, 0, 0), matter});
      facets.push_back({{corner(0, 0), corner(1, 1), corner(0, 1)}, colour, vec3(1, 0, 0), matter});
    }
}

std::vector<dvec3> wander(const Wander& how, const std::function<double(double)>& rise) {
  std::vector<dvec3> points;
  dvec3 at = how.start;
  const double step = how.length / (how.points - 1);
  const double phase = 10 * noise::hash01(how.seed, 1, 77);
  for (int i = 0; i < how.points; ++i) {
    const double way = static_cast<double>(i) / (how.points - 1);
    points.push_back({at.x, at.y, how.start.z + rise(way)});
    // Two waves that never fall into step look like chance.
    const double angle = how.angle + how.curl * (std::sin(phase + 3.1 * way) + 0.6 * std::sin(2.3 * phase + 7.7 * way));
    at += dvec3(std::cos(angle), std::sin(angle), 0) * step;
  }
  return points;
}

}  // namespace vamp::acquire
