#include "engine/fit/parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/brdf/registry.h"

namespace vamp::fit {
namespace {

enum class Scale { plain, logarithm, root };

struct Shape {
  size_t slot;
  Scale scale;
  double low, high;  // of the lobe's own value
};

// Shape parameters of a model; the normal's two follow, then the tangent where `directed`.
struct Layout {
  std::array<Shape, 3> shape{};
  size_t shapes = 0;
  bool directed = false;
};

Layout layout(Model model, const LobeLimits& limits) {
  const double n = limits.max_exponent, w = limits.min_width;
  switch (model) {
    case Model::lambert:
      return {};
    case Model::oren_nayar:
      return {{{{1, Scale::plain, 0.1, 1.2}}}, 1};
    case Model::blinn_phong:
      return {{{{1, Scale::logarithm, 1, n}}}, 1};
    case Model::ward:
      return {{{{1, Scale::logarithm, w, 1}, {2, Scale::logarithm, w, 1}}}, 2, true};
    case Model::cook_torrance:
      return {{{{1, Scale::logarithm, w, 1}, {2, Scale::root, 0.01, 1}}}, 2};
    case Model::lafortune:
      return {{{{1, Scale::plain, -1, 1}, {2, Scale::plain, -1, 1}, {4, Scale::logarithm, 1, n}}}, 3, true};
    case Model::ashikhmin_shirley:
      return {
          {{{0, Scale::root, 0.01, 1}, {2, Scale::logarithm, 1, 1.5 * n}, {3, Scale::logarithm, 1, 1.5 * n}}}, 3, true};
  }
  return {};
}

double forward(Scale scale, double value) {
  return scale == Scale::logarithm ? std::log(value) : scale == Scale::root ? std::sqrt(value) : value;
}
double backward(Scale scale, double value) {
  return scale == Scale::logarithm ? std::exp(value) : scale == Scale::root ? value * value : value;
}

}  // namespace

LobeLimits LobeLimits::for_spacing(double radians) {
  const double ratio = radians * 12 / std::numbers::pi;  // to 15 degrees
  LobeLimits limits;
  limits.max_exponent = std::clamp(100 / (ratio * ratio), 20.0, 1e5);
  limits.min_width = std::clamp(0.1 * ratio, 0.005, 0.3);
  return limits;
}

ParameterVector parameters_of(const Basis& basis, const LobeLimits& limits) {
  const Layout rows = layout(basis.lobe.model, limits);
  ParameterVector out;
  const auto push = [&](double value, double low, double high) {
    out.low[out.count] = low, out.high[out.count] = high;
    out.value[out.count++] = std::clamp(value, low, high);
  };
  for (size_t i = 0; i < rows.shapes; ++i) {
    const Shape& row = rows.shape[i];
    const double value = std::clamp(double{basis.lobe.params[row.slot]}, row.low, row.high);
    push(forward(row.scale, value), forward(row.scale, row.low), forward(row.scale, row.high));
  }
  const double reach = std::tan(limits.max_tilt / 2), z = 1 + double{basis.normal.z};
  push(double{basis.normal.x} / z, -reach, reach);
  push(double{basis.normal.y} / z, -reach, reach);
  if (rows.directed) push(double{basis.psi}, -10, 10);
  return out;
}

Basis basis_of(Model model, const double* values, const LobeLimits& limits) {
  const Layout rows = layout(model, limits);
  Basis basis;
  basis.lobe = default_lobe(model);
  for (size_t i = 0; i < rows.shapes; ++i) {
    const Shape& row = rows.shape[i];
    basis.lobe.params[row.slot] = static_cast<float>(std::clamp(backward(row.scale, values[i]), row.low, row.high));
  }
  double a = values[rows.shapes], b = values[rows.shapes + 1];
  const double reach = std::tan(limits.max_tilt / 2), length = std::hypot(a, b);
  if (length > reach) a *= reach / length, b *= reach / length;
  const double square = a * a + b * b, scale = 1 / (1 + square);
  basis.normal = vec3(static_cast<float>(2 * a * scale), static_cast<float>(2 * b * scale),
                      static_cast<float>((1 - square) * scale));
  if (rows.directed) basis.psi = static_cast<float>(std::remainder(values[rows.shapes + 2], 2 * std::numbers::pi));
  return basis;
}

int bounds_hit(const Basis& basis, const LobeLimits& limits) {
  const ParameterVector p = parameters_of(basis, limits);
  const size_t shapes = layout(basis.lobe.model, limits).shapes;
  int hit = 0;
  for (size_t i = 0; i < shapes; ++i) {
    const double slack = 0.01 * (p.high[i] - p.low[i]);
    if (p.value[i] < p.low[i] + slack || p.value[i] > p.high[i] - slack) ++hit;
  }
  const double tilt = std::acos(std::clamp(double{basis.normal.z}, -1.0, 1.0));
  return hit + (tilt > limits.max_tilt * 0.98 ? 1 : 0);
}

}  // namespace vamp::fit
