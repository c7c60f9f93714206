#pragma once
// Curves: smooth functions of one variable and space curves by arc length. Lengths in mm.
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace vamp::shoe {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Polyline = std::vector<Vec3>;

// A C2 function through knots (x, y), x increasing: natural cubic spline, continued as straight lines.
class Profile {
 public:
  explicit Profile(std::vector<Vec2> knots);
  double operator()(double x) const;

 private:
  std::vector<Vec2> knots_;
  std::vector<double> bend_;  // second derivatives at the knots
};

// 0 below `a`, 1 above `b`, C2 between (Perlin's quintic).
double smooth_step(double a, double b, double x);

// A space curve given by dense samples, walked by its share of arc length.
class Curve {
 public:
  Curve() = default;
  explicit Curve(Polyline samples);

  Vec3 operator()(double t) const;  // t in [0, 1]
  Vec3 at_length(double s) const;   // s in [0, length()]
  Vec3 tangent(double t) const;     // unit
  double length() const { return along_.back(); }
  double share_of_nearest(const Vec3& p) const;  // t of the sample nearest to p
  double distance(const Vec3& p) const;
  const Polyline& samples() const { return samples_; }

  Curve reversed() const;
  Curve part(double from, double to) const;  // from < to, both in [0, 1]
  Polyline evenly(int count) const;          // `count` points at equal arc length, ends included
  Curve mapped(const std::function<Vec3(const Vec3&)>& map) const;

 private:
  Polyline samples_;
  std::vector<double> along_;
};

// The C2 spline through points, parametrised by chord length.
Curve spline(const Polyline& points, int samples = 600);

// One curve after another; the ends are assumed to meet.
Curve join(const Curve& first, const Curve& second);

}  // namespace vamp::shoe
