#include "tools/shoe/sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/check.h"

namespace vamp::shoe {
namespace {

struct Frame {
  Vec3 origin, side, up;
  double scale, along;
};

std::vector<Frame> frames_of(const Sweep& sweep, double reach) {
  const size_t n = sweep.path.size();
  CHECK(n >= 2 && sweep.up.size() == n && (sweep.scale.empty() || sweep.scale.size() == n));
  std::vector<Frame> frames;
  double along = 0.0;
  const auto frame = [&](size_t i) {
    const Vec3 tangent = glm::normalize(sweep.path[std::min(i + 1, n - 1)] - sweep.path[i > 0 ? i - 1 : 0]);
    const Vec3 up = glm::normalize(sweep.up[i] - glm::dot(sweep.up[i], tangent) * tangent);
    return Frame{sweep.path[i], glm::cross(up, tangent), up, sweep.scale.empty() ? 1.0 : sweep.scale[i], along};
  };
  const auto dome = [&](Frame end, double direction) {
    const Vec3 tangent = glm::cross(end.side, end.up);
    std::vector<Frame> rows;
    for (double turn : {0.35, 0.7, 1.0, 1.25, 1.45, 1.555}) {
      Frame f = end;
      const double out = direction * reach * end.scale;
      f.origin += out * std::sin(turn) * tangent;
      f.scale = end.scale * std::cos(turn);
      f.along += out * turn;
      rows.push_back(f);
    }
    return rows;
  };
  if (sweep.round_start) {
    frames = dome(frame(0), -1.0);
    std::reverse(frames.begin(), frames.end());
  }
  for (size_t i = 0; i < n; ++i) {
    if (i > 0) along += glm::distance(sweep.path[i - 1], sweep.path[i]);
    frames.push_back(frame(i));
  }
  if (sweep.round_end) {
    const std::vector<Frame> rows = dome(frames.back(), 1.0);
    frames.insert(frames.end(), rows.begin(), rows.end());
  }
  return frames;
}

}  // namespace

Mesh build(const Sweep& sweep) {
  std::vector<Vec2> section = sweep.section;
  section.push_back(section.front());
  std::vector<double> around = {0.0};
  double reach = 1e9;
  for (size_t k = 1; k < section.size(); ++k) {
    around.push_back(around.back() + glm::distance(section[k], section[k - 1]));
    reach = std::min(reach, glm::length(section[k]));
  }
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  for (const Frame& f : frames_of(sweep, reach)) {
    for (size_t k = 0; k < section.size(); ++k) {
      points.push_back(f.origin + f.scale * (section[k].x * f.side + section[k].y * f.up));
      // v runs against the section's turn, so that (u, v) is right-handed seen from outside.
      uvs.emplace_back(f.along, -around[k]);
    }
  }
  const auto columns = static_cast<uint32_t>(section.size());
  Mesh mesh = grid(points, uvs, columns);
  mesh.smooth();
  // One normal on both sides of the UV seam.
  for (size_t row = 0; row < points.size(); row += columns) {
    const Vec3 n = glm::normalize(mesh.normals[row] + mesh.normals[row + columns - 1]);
    mesh.normals[row] = mesh.normals[row + columns - 1] = n;
  }
  return mesh;
}

std::vector<Vec2> ellipse(double side, double up, int corners, Vec2 centre) {
  std::vector<Vec2> section;
  for (int k = 0; k < corners; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / corners;
    section.push_back(centre + Vec2(side * std::cos(turn), up * std::sin(turn)));
  }
  return section;
}

std::vector<Vec2> flat_oval(double width, double height, int corners_per_end) {
  std::vector<Vec2> section;
  const double r = 0.5 * height;
  for (int end = 0; end < 2; ++end) {
    const double middle = (end == 0 ? 1.0 : -1.0) * (0.5 * width - r);
    for (int k = 0; k <= corners_per_end; ++k) {
      const double turn = std::numbers::pi * (end + double(k) / corners_per_end - 0.5);
      section.emplace_back(middle + r * std::cos(turn), r * std::sin(turn));
    }
  }
  return section;
}

}  // namespace vamp::shoe
