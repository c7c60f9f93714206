#include "tools/shoe/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/check.h"

namespace vamp::shoe {

Profile::Profile(std::vector<Vec2> knots) : knots_(std::move(knots)), bend_(knots_.size(), 0.0) {
  CHECK(knots_.size() >= 2);
  // Thomas' algorithm for the natural spline's tridiagonal system.
  const size_t n = knots_.size();
  std::vector<double> upper(n, 0.0);
  for (size_t i = 1; i + 1 < n; ++i) {
    const Vec2 before = knots_[i] - knots_[i - 1];
    const Vec2 after = knots_[i + 1] - knots_[i];
    CHECK(before.x > 0 && after.x > 0);
    const double right = 6.0 * (after.y / after.x - before.y / before.x);
    const double pivot = 2.0 * (before.x + after.x) - before.x * upper[i - 1];
    upper[i] = after.x / pivot;
    bend_[i] = (right - before.x * bend_[i - 1]) / pivot;
  }
  for (size_t i = n - 1; i-- > 1;) bend_[i] -= upper[i] * bend_[i + 1];
}

double Profile::operator()(double x) const {
  const size_t n = knots_.size();
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), x, [](double v, const Vec2& k) { return v < k.x; });
  const size_t i = static_cast<size_t>(std::clamp<std::ptrdiff_t>(above - knots_.begin(), 1, std::ptrdiff_t(n) - 1));
  const Vec2 a = knots_[i - 1];
  const Vec2 b = knots_[i];
  const double h = b.x - a.x;
  const double slope = (b.y - a.y) / h;
  if (x < a.x) return a.y + (slope - h * (2.0 * bend_[i - 1] + bend_[i]) / 6.0) * (x - a.x);
  if (x > b.x) return b.y + (slope + h * (bend_[i - 1] + 2.0 * bend_[i]) / 6.0) * (x - b.x);
  const double l = (b.x - x) / h;
  const double r = 1.0 - l;
  return l * a.y + r * b.y + ((l * l * l - l) * bend_[i - 1] + (r * r * r - r) * bend_[i]) * h * h / 6.0;
}

double smooth_step(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

Curve::Curve(Polyline samples) : samples_(std::move(samples)), along_(samples_.size(), 0.0) {
  CHECK(samples_.size() >= 2);
  for (size_t i = 1; i < samples_.size(); ++i) along_[i] = along_[i - 1] + glm::distance(samples_[i - 1], samples_[i]);
}

Vec3 Curve::operator()(double t) const { return at_length(t * length()); }

Vec3 Curve::at_length(double s) const {
  const auto above = std::upper_bound(along_.begin(), along_.end(), s);
  const auto last = static_cast<std::ptrdiff_t>(samples_.size()) - 1;
  const auto i = static_cast<size_t>(std::clamp<std::ptrdiff_t>(above - along_.begin(), 1, last));
  const double step = along_[i] - along_[i - 1];
  const double f = step > 0 ? std::clamp((s - along_[i - 1]) / step, 0.0, 1.0) : 0.0;
  return glm::mix(samples_[i - 1], samples_[i], f);
}

Vec3 Curve::tangent(double t) const {
  const double h = std::min(0.5, 0.1 * length()) / length();
  return glm::normalize((*this)(std::min(1.0, t + h)) - (*this)(std::max(0.0, t - h)));
}

double Curve::share_of_nearest(const Vec3& p) const {
  size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (size_t i = 0; i < samples_.size(); ++i) {
    const Vec3 d = samples_[i] - p;
    if (const double square = glm::dot(d, d); square < least) least = square, best = i;
  }
  return along_[best] / length();
}

double Curve::distance(const Vec3& p) const {
  double least = std::numeric_limits<double>::max();
  for (size_t i = 1; i < samples_.size(); ++i) {
    const Vec3 edge = samples_[i] - samples_[i - 1];
    const double square = glm::dot(edge, edge);
    const double f = square > 0 ? std::clamp(glm::dot(p - samples_[i - 1], edge) / square, 0.0, 1.0) : 0.0;
    const Vec3 d = samples_[i - 1] + f * edge - p;
    least = std::min(least, glm::dot(d, d));
  }
  return std::sqrt(least);
}

Curve Curve::reversed() const { return Curve(Polyline(samples_.rbegin(), samples_.rend())); }

Curve Curve::part(double from, double to) const {
  CHECK(from < to);
  Polyline points = {(*this)(from)};
  for (size_t i = 0; i < samples_.size(); ++i) {
    const double margin = 1e-6 * length();
    if (along_[i] > from * length() + margin && along_[i] < to * length() - margin) points.push_back(samples_[i]);
  }
  points.push_back((*this)(to));
  return Curve(std::move(points));
}

Polyline Curve::evenly(int count) const {
  Polyline points;
  for (int i = 0; i < count; ++i) points.push_back((*this)(double(i) / (count - 1)));
  return points;
}

Curve Curve::mapped(const std::function<Vec3(const Vec3&)>& map) const {
  Polyline points;
  for (const Vec3& p : samples_) points.push_back(map(p));
  return Curve(std::move(points));
}

Curve spline(const Polyline& points, int samples) {
  CHECK(points.size() >= 2);
  std::vector<Vec2> knots[3];
  double s = 0.0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (i > 0) s += glm::distance(points[i - 1], points[i]);
    for (int axis = 0; axis < 3; ++axis) knots[axis].emplace_back(s, points[i][axis]);
  }
  const Profile x(knots[0]), y(knots[1]), z(knots[2]);
  Polyline dense;
  for (int i = 0; i < samples; ++i) {
    const double t = s * i / (samples - 1);
    dense.emplace_back(x(t), y(t), z(t));
  }
  return Curve(std::move(dense));
}

Curve join(const Curve& first, const Curve& second) {
  Polyline points = first.samples();
  points.insert(points.end(), second.samples().begin() + 1, second.samples().end());
  return Curve(std::move(points));
}

}  // namespace vamp::shoe
