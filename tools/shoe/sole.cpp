#include "tools/shoe/sole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vamp::shoe {
namespace {

// Heights over the feather line, mm.
constexpr double kWeltTop = 0.4;
constexpr double kMidsoleTop = -2.9;
constexpr double kOutsoleTop = -7.4;
constexpr double kOutsoleBottom = -12.8;
constexpr double kBreast = 84.0;   // x of the heel's front face
constexpr double kTopPiece = 6.0;  // thickness of the rubber the heel stands on
constexpr int kAround = 440;

// How far the sole's edge stands out from the feather line: wide at the forefoot, trimmed close at waist and heel.
double reach(double x) {
  return 8.0 + 1.3 * smooth_step(140.0, 185.0, x) -
         1.0 * smooth_step(50.0, 95.0, x) * (1.0 - smooth_step(120.0, 160.0, x));
}

struct Footprint {
  Curve feather;        // closed: heel, medial, toe, lateral, heel
  Polyline at, normal;  // kAround + 1 points and horizontal outward normals
};

Footprint footprint_of(const Last& last) {
  Footprint f{last.outline(0.0), {}, {}};
  f.at = f.feather.evenly(kAround + 1);
  for (int i = 0; i <= kAround; ++i) {
    const Vec3 before = f.at[static_cast<size_t>((i + kAround - 1) % kAround)];
    const Vec3 after = f.at[static_cast<size_t>((i + 1) % kAround)];
    f.normal.push_back(glm::normalize(Vec3(after.z - before.z, 0.0, before.x - after.x)));
  }
  return f;
}

// The feather line moved out by `out`, `height` up.
Polyline feather_ring(const Footprint& f, double out, double height) {
  Polyline points;
  for (size_t i = 0; i < f.at.size(); ++i) points.push_back(f.at[i] + out * f.normal[i] + Vec3(0.0, height, 0.0));
  return points;
}

// The sole's edge moved out by `out`, `height` over the feather line.
Polyline ring(const Footprint& f, double out, double height) {
  Polyline points = feather_ring(f, out, height);
  for (size_t i = 0; i < points.size(); ++i) points[i] += reach(f.at[i].x) * f.normal[i];
  return points;
}

// A quarter of a circle from direction `from` to `to` (degrees from outward, up positive), as (out, height).
void arc(std::vector<Vec2>& profile, Vec2 centre, double radius, double from, double to) {
  constexpr int kSteps = 4;
  for (int k = 0; k <= kSteps; ++k) {
    const double turn = (from + (to - from) * k / kSteps) * std::numbers::pi / 180.0;
    profile.push_back(centre + radius * Vec2(std::cos(turn), std::sin(turn)));
  }
}

// A band around the sole: profile from the top inner edge over the outer wall to the bottom inner edge.
Mesh band(const Footprint& f, const std::vector<Vec2>& profile) {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  const Curve wall(ring(f, -1.0, 0.0));
  double down = 0.0;
  for (size_t j = 0; j < profile.size(); ++j) {
    if (j > 0) down += glm::distance(profile[j], profile[j - 1]);
    const Polyline row = ring(f, profile[j].x, profile[j].y);
    for (size_t i = 0; i < row.size(); ++i) {
      points.push_back(row[i]);
      uvs.emplace_back(wall.length() * double(i) / kAround, down);
    }
  }
  Mesh mesh = grid(points, uvs, kAround + 1);
  mesh.smooth();
  for (size_t row = 0; row < points.size(); row += kAround + 1) {
    const Vec3 n = glm::normalize(mesh.normals[row] + mesh.normals[row + kAround]);
    mesh.normals[row] = mesh.normals[row + kAround] = n;
  }
  return mesh;
}

// A slab's edge with rounded corners: walls at `out`, faces running `inwards`.
std::vector<Vec2> slab(double top, double bottom, double out, double round, double inwards) {
  std::vector<Vec2> profile = {{-inwards, top}, {out - 2.0 * round, top}};
  arc(profile, {out - round, top - round}, round, 90, 0);
  arc(profile, {out - round, bottom + round}, round, 0, -90);
  profile.emplace_back(out - 2.0 * round, bottom);
  profile.emplace_back(-inwards, bottom);
  return profile;
}

// The area inside a closed outline as rows across it, seen from below or above; planar UVs. `lift` raises a point that
// is the share t of the way across.
Mesh fill(const Polyline& outline, bool from_below, size_t rows,
          const std::function<double(const Vec3&, double t)>& lift) {
  constexpr int kColumns = 14;
  const auto kept = static_cast<uint32_t>(rows);
  const Curve loop(outline);
  const auto tip =
      std::max_element(outline.begin(), outline.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
  const double middle = loop.share_of_nearest(*tip);
  const Polyline medial = loop.part(0.0, middle).evenly(static_cast<int>(rows) + 2);
  const Polyline lateral = loop.part(middle, 1.0).reversed().evenly(static_cast<int>(rows) + 2);
  const auto uv = [&](const Vec3& p) { return Vec2(p.x, from_below ? p.z : -p.z); };
  Mesh mesh;
  for (size_t j = 1; j <= rows; ++j) {
    for (int i = 0; i <= kColumns; ++i) {
      const double t = double(i) / kColumns;
      Vec3 p = glm::mix(medial[j], lateral[j], t);
      p.y += lift(p, t);
      mesh.add(p, uv(p));
    }
  }
  const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    if (from_below) std::swap(b, c);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  for (uint32_t j = 0; j + 1 < kept; ++j) {
    for (uint32_t i = 0; i < kColumns; ++i) {
      const uint32_t a = j * (kColumns + 1) + i;
      triangle(a, a + 1, a + kColumns + 2);
      triangle(a, a + kColumns + 2, a + kColumns + 1);
    }
  }
  const uint32_t heel = mesh.add(medial.front(), uv(medial.front())), toe = mesh.add(medial.back(), uv(medial.back()));
  const uint32_t last_row = (kept - 1) * (kColumns + 1);
  for (uint32_t i = 0; i < kColumns; ++i) {
    triangle(heel, i + 1, i);
    triangle(toe, last_row + i, last_row + i + 1);
  }
  mesh.smooth();
  return mesh;
}

// Grooves across the forefoot's underside that run out towards its edges.
double tread(const Vec3& p, double t) {
  constexpr double kDepth = 1.3, kPitch = 8.0, kFrom = 168.0, kTo = 272.0;
  if (p.x < kFrom || p.x > kTo) return 0.0;
  const double across = std::min(t, 1.0 - t);
  const double from_middle = std::abs(std::fmod(p.x - kFrom, kPitch) - 0.5 * kPitch);
  return kDepth * (1.0 - smooth_step(0.4, 1.8, from_middle)) * smooth_step(0.06, 0.16, across);
}

// A flat area inside a closed outline around its middle, seen from below; planar UVs.
Mesh disc(const Polyline& outline, const Vec3& middle) {
  constexpr int kRings = 5;
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  for (int j = 0; j < kRings; ++j) {
    for (const Vec3& p : outline) {
      points.push_back(glm::mix(p, middle, double(j) / kRings));
      uvs.emplace_back(points.back().x, points.back().z);
    }
  }
  const auto columns = static_cast<uint32_t>(outline.size());
  Mesh mesh = grid(points, uvs, columns);
  const uint32_t centre = mesh.add(middle, {middle.x, middle.z});
  const uint32_t inner = (kRings - 1) * columns;
  for (uint32_t i = 0; i + 1 < columns; ++i)
    mesh.indices.insert(mesh.indices.end(), {inner + i, inner + i + 1, centre});
  mesh.normals.assign(mesh.positions.size(), Vec3(0.0, -1.0, 0.0));
  return mesh;
}

// The heel's outline seen from above, closed: around the back, then along the breast, with rounded corners.
Polyline heel_outline(const Footprint& f) {
  const Curve edge(ring(f, -0.9, 0.0));
  const Curve medial_half = edge.part(0.0, 0.5), lateral_half = edge.part(0.5, 1.0);
  const auto share_at = [](const Curve& half, double x) {
    double best = 0.0;
    for (int i = 0; i <= 2000; ++i) {
      const double t = i / 2000.0;
      if (std::abs(half(t).x - x) < std::abs(half(best).x - x)) best = t;
    }
    return best;
  };
  const Curve medial = medial_half.part(0.0, share_at(medial_half, kBreast));
  const Curve lateral = lateral_half.part(share_at(lateral_half, kBreast), 1.0);
  const Vec3 a = medial(1.0), b = lateral(0.0);
  const Curve breast = spline({a, glm::mix(a, b, 0.5) - Vec3(5.0, 0.0, 0.0), b});
  Polyline loop = join(join(medial, breast), lateral).evenly(kAround + 1);
  for (int round = 0; round < 110; ++round) {
    Polyline next = loop;
    for (size_t i = 0; i < kAround; ++i) {
      next[i] = 0.25 * loop[(i + kAround - 1) % kAround] + 0.5 * loop[i] + 0.25 * loop[(i + 1) % kAround];
    }
    next[kAround] = next[0];
    loop = std::move(next);
  }
  return loop;
}

// Walls of the heel through (inset in mm, share of the way from the outsole down to the ground).
Mesh heel_walls(const Last& last, const Polyline& outline, const std::vector<Vec2>& profile) {
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  const Curve loop(outline);
  double down = 0.0;  // for a heel of 18 mm, its height in the middle
  for (size_t j = 0; j < profile.size(); ++j) {
    if (j > 0) down += std::hypot(profile[j].x - profile[j - 1].x, 18.0 * (profile[j].y - profile[j - 1].y));
    for (size_t i = 0; i <= kAround; ++i) {
      const Vec3 before = outline[(i + kAround - 1) % kAround], after = outline[(i + 1) % kAround];
      const Vec3 normal = glm::normalize(Vec3(after.z - before.z, 0.0, before.x - after.x));
      const double top = last.feather(outline[i].x) + kOutsoleBottom;
      Vec3 p = outline[i] - profile[j].x * normal;
      p.y = top * (1.0 - profile[j].y);
      points.push_back(p);
      uvs.emplace_back(loop.length() * double(i) / kAround, down);
    }
  }
  Mesh mesh = grid(points, uvs, kAround + 1);
  mesh.smooth();
  for (size_t row = 0; row < points.size(); row += kAround + 1) {
    const Vec3 n = glm::normalize(mesh.normals[row] + mesh.normals[row + kAround]);
    mesh.normals[row] = mesh.normals[row + kAround] = n;
  }
  return mesh;
}

// A stacked heel: layers of leather with fine grooves between, tapering by 2 mm.
std::vector<Vec2> stack_profile(double from, double to, int layers) {
  constexpr double kTaper = 2.0, kGroove = 0.35, kHalfGroove = 0.012;
  std::vector<Vec2> profile;
  for (int layer = 0; layer < layers; ++layer) {
    const double a = glm::mix(from, to, double(layer) / layers), b = glm::mix(from, to, (layer + 1.0) / layers);
    for (double t : {0.0, kHalfGroove, 3 * kHalfGroove})
      profile.emplace_back(kTaper * a + (t > 0 ? t > 0.02 ? 0.0 : 0.1 : kGroove), a + t);
    profile.emplace_back(kTaper * 0.5 * (a + b), 0.5 * (a + b));
    for (double t : {3 * kHalfGroove, kHalfGroove}) profile.emplace_back(kTaper * b + (t > 0.02 ? 0.0 : 0.1), b - t);
  }
  profile.emplace_back(kTaper * to + kGroove, to);
  return profile;
}

}  // namespace

Sole make_sole(const Last& last) {
  const Footprint f = footprint_of(last);
  Sole sole;
  sole.welt = band(f, slab(kWeltTop, kMidsoleTop, 0.0, 1.1, 8.0));
  sole.midsole = band(f, slab(kMidsoleTop, kOutsoleTop, -0.9, 0.8, 3.0));
  std::vector<Vec2> edge = slab(kOutsoleTop, kOutsoleBottom, -0.2, 1.2, 3.0);
  edge.pop_back();
  sole.outsole = band(f, edge);
  sole.outsole.append(fill(ring(f, edge.back().x, kOutsoleBottom), true, 300, tread));
  sole.insole = fill(feather_ring(f, 2.0, 2.5), false, 150, [](const Vec3& p, double t) {
    return 1.5 * smooth_step(30.0, 120.0, p.x) * std::sin(std::numbers::pi * t);
  });

  const Polyline heel = heel_outline(f);
  sole.heel = heel_walls(last, heel, stack_profile(-0.02, 0.74, 4));
  sole.top_piece = heel_walls(
      last, heel,
      {{1.9, 0.74}, {1.5, 0.755}, {1.45, 0.78}, {1.75, 0.9}, {1.8, 0.94}, {1.9, 0.965}, {2.1, 0.99}, {2.3, 1.0}});
  Polyline sole_of_heel;
  for (size_t i = 0; i <= kAround; ++i) {
    const Vec3 before = heel[(i + kAround - 1) % kAround], after = heel[(i + 1) % kAround];
    const Vec3 n = glm::normalize(Vec3(after.z - before.z, 0.0, before.x - after.x));
    const Vec3 p = heel[i] - 2.3 * n;
    sole_of_heel.emplace_back(p.x, 0.0, p.z);
  }
  sole.top_piece.append(disc(sole_of_heel, {45.0, 0.0, 0.0}));

  sole.welt_seam = Curve(ring(f, -2.4, kWeltTop));
  return sole;
}

}  // namespace vamp::shoe
