// Delaunay triangulation of a direction set on the parabolic disk p = (x, y) / (1 + z), which keeps angles and spaces
// the outer rings evenly (Schwartz et al. 2013; algorithms.md 2.8).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/core/check.h"
#include "engine/material/directions.h"
#include "engine/material/tables.h"

namespace vamp {
namespace {

// Virtual vertices past the horizon; their polygon holds the unit disk, with room for directions on the horizon.
constexpr int kRing = 24;
constexpr double kRingRadius = 1.001;

struct Point {
  double x = 0, y = 0;
  double lift = 0;  // x^2 + y^2 and a tiny tie-breaker
  int slot = 0;
};

struct Corners {
  int a, b, c;  // counter-clockwise
};

double area2(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

// Positive where d lies below the plane through the lifted a, b, c: inside the circle of the triangle, were it not for
// the tie-breakers.
double in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, al = a.lift - d.lift - 2 * (d.x * ax + d.y * ay);
  const double bx = b.x - d.x, by = b.y - d.y, bl = b.lift - d.lift - 2 * (d.x * bx + d.y * by);
  const double cx = c.x - d.x, cy = c.y - d.y, cl = c.lift - d.lift - 2 * (d.x * cx + d.y * cy);
  return ax * (by * cl - bl * cy) - ay * (bx * cl - bl * cx) + al * (bx * cy - by * cx);
}

// Rings make many quads with all four corners on a circle. Lifting each point by its own tiny amount, which follows
// from its rank in lexicographic order alone, picks the same diagonal on every machine and in every order of the file.
void lift(std::vector<Point>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rounded = [](double v) { return std::llround(v * 1e6); };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    const Point &p = points[static_cast<size_t>(i)], &q = points[static_cast<size_t>(j)];
    return std::pair(rounded(p.x), rounded(p.y)) < std::pair(rounded(q.x), rounded(q.y));
  });
  for (size_t rank = 0; rank < order.size(); ++rank) {
    Point& p = points[static_cast<size_t>(order[rank])];
    const double golden = static_cast<double>(rank) * std::numbers::phi;
    p.lift = p.x * p.x + p.y * p.y + 1e-7 * (golden - std::floor(golden));
  }
}

// Grows triangles from the outer polygon inwards: each open edge takes, of the points to its left, the one whose circle
// is empty. At most 1047 points, so that no search structure is needed.
std::vector<Corners> delaunay(const std::vector<Point>& points, int ring_first) {
  std::vector<Corners> triangles;
  std::map<std::pair<int, int>, bool> open;  // directed edges that still want a triangle to their left
  std::vector<std::pair<int, int>> queue;
  const auto at = [&](int i) -> const Point& { return points[static_cast<size_t>(i)]; };
  const auto add_edge = [&](int from, int to) {
    if (open.erase({to, from}) > 0) return;  // the neighbour was waiting for this triangle
    open[{from, to}] = true;
    queue.emplace_back(from, to);
  };
  for (int i = 0; i < kRing; ++i) {
    open[{ring_first + i, ring_first + (i + 1) % kRing}] = true;
    queue.emplace_back(ring_first + i, ring_first + (i + 1) % kRing);
  }
  while (!queue.empty()) {
    const auto [a, b] = queue.back();
    queue.pop_back();
    if (open.erase({a, b}) == 0) continue;
    int best = -1;
    for (int c = 0; c < static_cast<int>(points.size()); ++c) {
      if (c == a || c == b || area2(at(a), at(b), at(c)) < 1e-10) continue;
      if (best < 0 || in_circle(at(a), at(b), at(best), at(c)) > 0) best = c;
    }
    CHECK(best >= 0);
    triangles.push_back({a, b, best});
    // The new triangle lies left of a-b; across its other sides the edges run the other way round.
    add_edge(a, best);
    add_edge(best, b);
    CHECK(triangles.size() <= 2 * points.size());
  }
  return triangles;
}

// How well a triangle serves a cell: first the measured directions inside the cell that it touches, so that these are
// met exactly, then how deep the cell's centre lies in it.
struct Candidate {
  int triangle = -1;
  int corners = -1;
  double depth = 0;
};

void rasterise(const std::vector<Point>& points, const std::vector<Corners>& triangles, DirectionTables& tables) {
  constexpr double kCell = 2.0 / kDirectionMapSide;
  const auto cell = [](double p) {
    return std::clamp(static_cast<int>((p * 0.5 + 0.5) * kDirectionMapSide), 0, kDirectionMapSide - 1);
  };
  std::vector<Candidate> best(size_t{kDirectionMapSide} * kDirectionMapSide);
  for (size_t t = 0; t < triangles.size(); ++t) {
    const std::array<Point, 3> v = {points[static_cast<size_t>(triangles[t].a)],
                                    points[static_cast<size_t>(triangles[t].b)],
                                    points[static_cast<size_t>(triangles[t].c)]};
    const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
    const auto& rows = tables.triangles[t];
    // A cell of margin: a cell that only brushes the triangle may have no better one.
    for (int y = cell(y0 - kCell); y <= cell(y1 + kCell); ++y)
      for (int x = cell(x0 - kCell); x <= cell(x1 + kCell); ++x) {
        const double px = (x + 0.5) * kCell - 1, py = (y + 0.5) * kCell - 1;
        const auto row = [&](const float* r) { return double{r[0]} * px + double{r[1]} * py + double{r[2]}; };
        const double l1 = row(rows.row1), l2 = row(rows.row2);
        Candidate found{static_cast<int>(t), 0, std::min({l1, l2, 1 - l1 - l2})};
        for (const Point& p : v) found.corners += cell(p.x) == x && cell(p.y) == y ? 1 : 0;
        Candidate& old = best[static_cast<size_t>(y) * kDirectionMapSide + static_cast<size_t>(x)];
        if (old.triangle < 0 || std::pair(found.corners, found.depth) > std::pair(old.corners, old.depth)) old = found;
      }
  }
  tables.map.resize(best.size());
  // Corners of the square beyond the ring's polygon are no directions; any triangle will do there.
  for (size_t i = 0; i < best.size(); ++i) tables.map[i] = static_cast<uint16_t>(std::max(best[i].triangle, 0));
}

}  // namespace

Result<DirectionTables> triangulate(const std::vector<vec3>& directions, std::string_view file) {
  if (directions.empty() || directions.size() > kMaxDirections)
    return fail(ErrorKind::bad_input, file, "directions", fmt::format("1 to {} directions", kMaxDirections),
                std::to_string(directions.size()));
  std::vector<Point> points;
  for (size_t i = 0; i < directions.size(); ++i) {
    const dvec3 w(directions[i]);
    const double length = std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
    if (!(std::abs(length - 1) < 1e-3) || !(w.z >= 0))
      return fail(ErrorKind::bad_input, file, fmt::format("directions[{}]", i), "a unit vector above the horizon",
                  fmt::format("({}, {}, {})", w.x, w.y, w.z));
    const Point p{w.x / (1 + w.z), w.y / (1 + w.z), 0, static_cast<int>(i)};
    for (const Point& q : points)
      if (std::hypot(p.x - q.x, p.y - q.y) < 2e-3)
        return fail(ErrorKind::bad_input, file, fmt::format("directions[{}]", i),
                    "directions at least 0.2 degrees apart", fmt::format("the same as directions[{}]", q.slot));
    points.push_back(p);
  }
  const int ring_first = static_cast<int>(points.size());
  for (int i = 0; i < kRing; ++i) {
    const double phi = 2 * std::numbers::pi * i / kRing, radius = kRingRadius / std::cos(std::numbers::pi / kRing);
    int nearest = 0;
    double nearest_dot = -2;
    for (size_t d = 0; d < directions.size(); ++d) {
      const double dot = double{directions[d].x} * std::cos(phi) + double{directions[d].y} * std::sin(phi);
      // Ties within rounding go to the first direction.
      if (dot > nearest_dot + 1e-6) nearest_dot = dot, nearest = static_cast<int>(d);
    }
    points.push_back({radius * std::cos(phi), radius * std::sin(phi), 0, nearest});
  }
  lift(points);

  const std::vector<Corners> triangles = delaunay(points, ring_first);
  DirectionTables tables;
  for (const Corners& t : triangles) {
    const Point &a = points[static_cast<size_t>(t.a)], &b = points[static_cast<size_t>(t.b)],
                &c = points[static_cast<size_t>(t.c)];
    const double scale = 1 / area2(a, b, c);
    tables::DirectionTriangle row{};
    const auto affine = [&](float* out, const Point& p, const Point& q) {  // 1 at the corner opposite to p-q, 0 on p-q
      out[0] = static_cast<float>((p.y - q.y) * scale);
      out[1] = static_cast<float>((q.x - p.x) * scale);
      out[2] = static_cast<float>((p.x * q.y - q.x * p.y) * scale);
    };
    affine(row.row1, b, c);
    affine(row.row2, c, a);
    row.slots =
        static_cast<uint32_t>(a.slot) | static_cast<uint32_t>(b.slot) << 10 | static_cast<uint32_t>(c.slot) << 20;
    tables.triangles.push_back(row);
  }
  rasterise(points, triangles, tables);
  return tables;
}

}  // namespace vamp
