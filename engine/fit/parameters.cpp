#include "engine/fit/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/brdf/registry.h"
#include "engine/core/check.h"

namespace vamp::fit {
namespace {

// One shape parameter of a model: its row, on the scale of its slider, and the part of its range that a measurement can
// tell apart.
struct Shape {
  const ParameterRow* row = nullptr;
  double low = 0, high = 0;  // of the lobe's own value

  double forward(double value) const {
    return row->mapping == Mapping::logarithmic ? std::log(value)
           : row->mapping == Mapping::square    ? std::sqrt(value)
                                                : value;
  }
  double backward(double value) const {
    return row->mapping == Mapping::logarithmic ? std::exp(value)
           : row->mapping == Mapping::square    ? value * value
                                                : value;
  }
};

// Shape parameters of a model; the normal's two follow, then the tangent where `directed`.
struct Layout {
  std::array<Shape, 3> shape{};
  size_t shapes = 0;
  bool directed = false;
};

Layout layout(Model model, const LobeLimits& limits) {
  Layout layout;
  const uint8_t variant = model_row(model).default_variant;
  const auto add = [&](std::string_view name, double least, double most) {
    const ParameterRow* row = find_parameter(model, variant, name);
    CHECK(row != nullptr);
    layout.shape[layout.shapes++] = {row, std::max(double{row->min}, least), std::min(double{row->max}, most)};
  };
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const double low = limits.min_exponent, high = limits.max_exponent, width = limits.min_width;
  switch (model) {
    case Model::lambert:
      break;
    case Model::oren_nayar:
      add("sigma", limits.min_sigma, kAny);
      break;
    case Model::blinn_phong:
      add("n", low, high);
      break;
    case Model::ward:
      add("alpha_x", width, kAny), add("alpha_y", width, kAny);
      layout.directed = true;
      break;
    case Model::cook_torrance:
      add("m", width, kAny), add("f0", limits.min_f0, kAny);
      break;
    case Model::lafortune:
      add("cx", -kAny, kAny), add("cy", -kAny, kAny), add("n", low, high);
      layout.directed = true;
      break;
    case Model::ashikhmin_shirley:
      add("rs", limits.min_f0, kAny), add("nu", low, 1.5 * high), add("nv", low, 1.5 * high);
      layout.directed = true;
      break;
  }
  return layout;
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
    const double value = std::clamp(double{basis.lobe.params[row.row->slot]}, row.low, row.high);
    push(row.forward(value), row.forward(row.low), row.forward(row.high));
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
    basis.lobe.params[row.row->slot] = static_cast<float>(std::clamp(row.backward(values[i]), row.low, row.high));
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
