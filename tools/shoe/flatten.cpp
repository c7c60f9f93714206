#include "tools/shoe/flatten.h"

#include <array>
#include <cmath>

namespace vamp::shoe {
namespace {

constexpr int kRounds = 30;
constexpr int kSolverSteps = 60;  // warm-started, so that the rounds together converge

struct Triangle {
  std::array<uint32_t, 3> corner;
  std::array<Vec2, 3> edge;      // flat copy of the edge opposite each corner
  std::array<double, 3> weight;  // half the cotangent at each corner
};

// Solving amplifies differences in the last bits, and a machine's sine may differ there: what the solver sees is
// rounded, and from there on only exactly rounded operations are used, so that patterns are the same everywhere.
constexpr double kSeen = 1e-4;  // mm

Vec3 seen(const Vec3& p) { return glm::round(p / kSeen) * kSeen; }

std::vector<Triangle> flat_triangles(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    Triangle triangle{};
    for (size_t k = 0; k < 3; ++k) triangle.corner[k] = mesh.indices[t + k];
    const Vec3 a = seen(mesh.positions[triangle.corner[0]]);
    const Vec3 ab = seen(mesh.positions[triangle.corner[1]]) - a;
    const Vec3 ac = seen(mesh.positions[triangle.corner[2]]) - a;
    const double base = glm::length(ab);
    const double area = glm::length(glm::cross(ab, ac));
    const std::array<Vec2, 3> p = {Vec2(0.0), Vec2(base, 0.0), Vec2(glm::dot(ab, ac) / base, area / base)};
    for (size_t k = 0; k < 3; ++k) {
      const Vec2 e = p[(k + 1) % 3] - p[k];
      const Vec2 f = p[(k + 2) % 3] - p[k];
      triangle.edge[k] = f - e;
      triangle.weight[k] = 0.5 * glm::dot(e, f) / area;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

// The cotangent Laplacian as a list of edges, applied to pairs of numbers.
class Laplacian {
 public:
  Laplacian(const std::vector<Triangle>& triangles, size_t vertices) : triangles_(triangles), diagonal_(vertices, 0.0) {
    for (const Triangle& t : triangles) {
      for (size_t k = 0; k < 3; ++k) {
        diagonal_[t.corner[(k + 1) % 3]] += t.weight[k];
        diagonal_[t.corner[(k + 2) % 3]] += t.weight[k];
      }
    }
  }

  void apply(const std::vector<Vec2>& x, std::vector<Vec2>& y) const {
    y.assign(x.size(), Vec2(0.0));
    for (const Triangle& t : triangles_) {
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t i = t.corner[(k + 1) % 3], j = t.corner[(k + 2) % 3];
        const Vec2 d = t.weight[k] * (x[i] - x[j]);
        y[i] += d;
        y[j] -= d;
      }
    }
  }

  // Conjugate gradients with the diagonal as preconditioner, from the x given.
  void solve(const std::vector<Vec2>& b, std::vector<Vec2>& x) const {
    const size_t n = x.size();
    std::vector<Vec2> r(n), z(n), p(n), q(n);
    apply(x, q);
    double rz = 0.0;
    for (size_t i = 0; i < n; ++i) {
      r[i] = b[i] - q[i];
      p[i] = z[i] = r[i] / diagonal_[i];
      rz += glm::dot(r[i], z[i]);
    }
    for (int step = 0; step < kSolverSteps && rz > 1e-12; ++step) {
      apply(p, q);
      double pq = 0.0;
      for (size_t i = 0; i < n; ++i) pq += glm::dot(p[i], q[i]);
      const double alpha = rz / pq;
      double next = 0.0;
      for (size_t i = 0; i < n; ++i) {
        x[i] += alpha * p[i];
        r[i] -= alpha * q[i];
        z[i] = r[i] / diagonal_[i];
        next += glm::dot(r[i], z[i]);
      }
      const double beta = next / rz;
      rz = next;
      for (size_t i = 0; i < n; ++i) p[i] = z[i] + beta * p[i];
    }
  }

 private:
  const std::vector<Triangle>& triangles_;
  std::vector<double> diagonal_;
};

// The rotation nearest to what maps the flat triangle onto its place in the pattern, as (cos, sin).
Vec2 rotation(const Triangle& t, const std::vector<Vec2>& uvs) {
  double c = 0.0, s = 0.0;
  for (size_t k = 0; k < 3; ++k) {
    const Vec2 from = t.edge[k];
    const Vec2 to = uvs[t.corner[(k + 2) % 3]] - uvs[t.corner[(k + 1) % 3]];
    c += t.weight[k] * glm::dot(from, to);
    s += t.weight[k] * (from.x * to.y - from.y * to.x);
  }
  const double size = std::sqrt(c * c + s * s);
  return size > 0 ? Vec2(c, s) / size : Vec2(1.0, 0.0);
}

Vec2 turned(const Vec2& v, const Vec2& turn) { return {turn.x * v.x - turn.y * v.y, turn.y * v.x + turn.x * v.y}; }

}  // namespace

void flatten(Mesh& mesh, const Vec3& grain) {
  for (Vec2& uv : mesh.uvs) uv = glm::round(uv / kSeen) * kSeen;
  const std::vector<Triangle> triangles = flat_triangles(mesh);
  const Laplacian laplacian(triangles, mesh.positions.size());
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec2> right(mesh.uvs.size(), Vec2(0.0));
    for (const Triangle& t : triangles) {
      const Vec2 turn = rotation(t, mesh.uvs);
      for (size_t k = 0; k < 3; ++k) {
        const Vec2 d = t.weight[k] * turned(t.edge[k], turn);
        right[t.corner[(k + 2) % 3]] += d;
        right[t.corner[(k + 1) % 3]] -= d;
      }
    }
    laplacian.solve(right, mesh.uvs);
  }

  // The grain as seen in the pattern: the area-weighted mean over the triangles of the gradient of dot(P, grain).
  Vec2 along(0.0), middle(0.0);
  double area = 0.0, flat_area = 0.0;
  for (const Triangle& t : triangles) {
    const Vec2 a = mesh.uvs[t.corner[0]], b = mesh.uvs[t.corner[1]] - a, c = mesh.uvs[t.corner[2]] - a;
    const Vec3 p = mesh.positions[t.corner[0]];
    const Vec3 pb = mesh.positions[t.corner[1]] - p, pc = mesh.positions[t.corner[2]] - p;
    const double gb = glm::dot(pb, grain), gc = glm::dot(pc, grain);
    along += Vec2(gb * c.y - gc * b.y, gc * b.x - gb * c.x);
    const double twice = b.x * c.y - b.y * c.x;
    flat_area += twice;
    area += glm::length(glm::cross(pb, pc));
    middle += twice / 3.0 * (3.0 * a + b + c);
  }
  middle /= flat_area;
  const double size = glm::length(along);
  const Vec2 turn = size > 0 ? Vec2(along.x, -along.y) / size : Vec2(1.0, 0.0);
  const double scale = std::sqrt(area / std::abs(flat_area));
  for (Vec2& uv : mesh.uvs) uv = scale * turned(uv - middle, turn);
}

}  // namespace vamp::shoe
