#include "tools/shoe/panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/shoe/flatten.h"

namespace vamp::shoe {
namespace {

constexpr double kSeamDepth = 0.35;  // how deep the thread pulls the leather in, mm
constexpr double kSeamWidth = 0.75;
constexpr int kRimRows = 7;
constexpr double kFlange = 2.5;  // how far the flesh side is modelled behind the rim, mm

// Shares of a length of `mm` at which the grid has lines: dense near the ends that are asked for, else about `cell`.
std::vector<double> lines(double mm, double cell, bool fine_start, bool fine_end) {
  const std::vector<double> dense = {0.4, 0.8, 1.2, 1.6, 2.0, 2.4, 2.8, 3.2, 3.7, 4.3, 5.0, 5.8, 6.8};
  std::vector<double> at = {0.0};
  if (fine_start) at.insert(at.end(), dense.begin(), dense.end());
  const double from = at.back();
  const double to = fine_end ? mm - dense.back() : mm;
  const int cells = std::max(1, static_cast<int>(std::lround((to - from) / cell)));
  for (int i = 1; i <= cells; ++i) at.push_back(from + (to - from) * i / cells);
  if (fine_end) {
    for (size_t i = dense.size() - 1; i-- > 0;) at.push_back(mm - dense[i]);
    at.push_back(mm);
  }
  for (double& a : at) a /= mm;
  return at;
}

// Coons' patch between the four edges.
Vec3 coons(const Panel& p, double u, double v) {
  const Vec3 ruled = glm::mix(glm::mix(p.bottom(u), p.top(u), v), glm::mix(p.left(v), p.right(v), u), 0.5) * 2.0;
  const Vec3 corners = glm::mix(glm::mix(p.bottom(0), p.bottom(1), u), glm::mix(p.top(0), p.top(1), u), v);
  return ruled - corners;
}

struct Border {
  std::vector<uint32_t> loop;  // counter-clockwise seen from outside
  std::vector<Vec3> normals, outward;
  std::vector<Vec2> uv_outward;
};

Border border_of(const Mesh& mesh, uint32_t columns, uint32_t rows, const std::vector<Vec3>& normals) {
  Border b;
  for (uint32_t i = 0; i + 1 < columns; ++i) b.loop.push_back(i);
  for (uint32_t j = 0; j + 1 < rows; ++j) b.loop.push_back(j * columns + columns - 1);
  for (uint32_t i = columns - 1; i > 0; --i) b.loop.push_back((rows - 1) * columns + i);
  for (uint32_t j = rows - 1; j > 0; --j) b.loop.push_back(j * columns);
  const size_t n = b.loop.size();
  for (size_t k = 0; k < n; ++k) {
    const uint32_t at = b.loop[k], before = b.loop[(k + n - 1) % n], after = b.loop[(k + 1) % n];
    const Vec3 normal = normals[at];
    const Vec3 along = glm::normalize(mesh.positions[after] - mesh.positions[at]) +
                       glm::normalize(mesh.positions[at] - mesh.positions[before]);
    b.normals.push_back(normal);
    b.outward.push_back(glm::normalize(glm::cross(along, normal)));
    const Vec2 flat = glm::normalize(mesh.uvs[after] - mesh.uvs[before]);
    b.uv_outward.emplace_back(flat.y, -flat.x);
  }
  return b;
}

// The edge rolled over in a half circle, then a strip of flesh side.
void add_rim(Mesh& mesh, const Border& border, double thickness) {
  const auto n = static_cast<uint32_t>(border.loop.size());
  std::vector<uint32_t> previous = border.loop;
  const double radius = 0.5 * thickness;
  for (int row = 1; row <= kRimRows + 1; ++row) {
    const bool flange = row > kRimRows;
    const double turn = std::numbers::pi * std::min(row, kRimRows) / kRimRows;
    const double out = flange ? -kFlange : radius * std::sin(turn);
    const double down = radius * (1.0 - std::cos(turn));
    const double along = radius * turn + (flange ? kFlange : 0.0);
    std::vector<uint32_t> current;
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t edge = border.loop[k];
      current.push_back(mesh.add(mesh.positions[edge] + out * border.outward[k] - down * border.normals[k],
                                 mesh.uvs[edge] + along * border.uv_outward[k]));
    }
    for (uint32_t k = 0; k < n; ++k) {
      const uint32_t next = (k + 1) % n;
      mesh.quad(previous[k], current[k], current[next], previous[next]);
    }
    previous = std::move(current);
  }
}

}  // namespace

double face_height(const Panel& panel, const Vec3& on_last) {
  double dip = 0.0;
  for (const Curve& seam : panel.seams) {
    const double d = seam.distance(on_last) / kSeamWidth;
    if (d < 4.0) dip = std::max(dip, kSeamDepth * std::exp(-d * d));
  }
  return panel.base + panel.thickness + (panel.lift ? panel.lift(on_last) : 0.0) - dip;
}

namespace {

// The points of a panel's grid: on its face, on its flesh side, and the last's normals there.
struct Lattice {
  std::vector<Vec3> face, back, normals;
  std::vector<Vec2> uvs;
  uint32_t columns, rows;
};

Lattice lattice_of(const Panel& panel, const Last& last) {
  const double width = 0.5 * (panel.bottom.length() + panel.top.length());
  const double depth = 0.5 * (panel.left.length() + panel.right.length());
  const std::vector<double> us = lines(width, panel.cell, panel.fine_left, panel.fine_right);
  const std::vector<double> vs = lines(depth, panel.cell, panel.fine_bottom, panel.fine_top);
  Lattice l;
  l.columns = static_cast<uint32_t>(us.size());
  l.rows = static_cast<uint32_t>(vs.size());
  for (double v : vs) {
    for (double u : us) {
      const Vec3 on = last.project(coons(panel, u, v));
      const Vec3 n = last.normal(on);
      const double height = face_height(panel, on);
      l.face.push_back(on + height * n);
      l.back.push_back(on + (height - panel.thickness) * n);
      l.normals.push_back(n);
      l.uvs.emplace_back(u * width, v * depth);
    }
  }
  return l;
}

// Where a corner's two edges run on straight, the diagonal has to start at that corner.
Mesh corner_fanned(const std::vector<Vec3>& points, const Lattice& l) {
  Mesh mesh;
  mesh.positions = points;
  mesh.uvs = l.uvs;
  for (uint32_t j = 0; j + 1 < l.rows; ++j) {
    for (uint32_t i = 0; i + 1 < l.columns; ++i) {
      const uint32_t a = j * l.columns + i;
      mesh.quad(a, a + 1, a + l.columns + 1, a + l.columns, (i < l.columns / 2) != (j < l.rows / 2));
    }
  }
  return mesh;
}

// Seen from the other side, without mirroring the pattern.
void turn_over(Mesh& mesh) {
  for (size_t t = 0; t < mesh.indices.size(); t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
  for (Vec2& uv : mesh.uvs) uv.x = -uv.x;
}

}  // namespace

Mesh build(const Panel& panel, const Last& last) {
  const Lattice lattice = lattice_of(panel, last);
  Mesh mesh = corner_fanned(lattice.face, lattice);
  add_rim(mesh, border_of(mesh, lattice.columns, lattice.rows, lattice.normals), panel.thickness);
  flatten(mesh, panel.grain);
  mesh.smooth();
  if (panel.whole_back) {
    Mesh back = corner_fanned(lattice.back, lattice);
    std::copy_n(mesh.uvs.begin(), back.uvs.size(), back.uvs.begin());
    turn_over(back);
    back.smooth();
    mesh.append(back);
  }
  return mesh;
}

Mesh build_lining(const Panel& panel, const Last& last) {
  Panel even = panel;
  even.cell = 4.0;
  even.fine_bottom = even.fine_top = even.fine_left = even.fine_right = false;
  const Lattice lattice = lattice_of(even, last);
  Mesh mesh = corner_fanned(lattice.back, lattice);
  turn_over(mesh);
  flatten(mesh, panel.grain);
  mesh.smooth();
  return mesh;
}

Curve inset(const Last& last, const Curve& edge, double inside) {
  Polyline points;
  const int count = 300;
  for (int i = 0; i < count; ++i) {
    const double t = double(i) / (count - 1);
    const Vec3 p = edge(t);
    points.push_back(last.project(p + inside * glm::cross(last.normal(p), edge.tangent(t))));
  }
  return Curve(std::move(points));
}

}  // namespace vamp::shoe
