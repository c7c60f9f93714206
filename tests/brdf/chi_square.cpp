#include "tests/brdf/chi_square.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace vamp::test {
namespace {

constexpr int kRows = 16, kColumns = 32;
constexpr double kPi = std::numbers::pi;

}  // namespace

CellsOfDraws::CellsOfDraws(const Lobe& lobe, vec3 wo, int fine)
    : lobe_(lobe), wo_(wo), shares_(kRows * kColumns + 1), seen_(shares_.size()) {
  const auto& p = lobe.params;
  const auto power_width = [](float n) { return std::sqrt(2 / (n + 1.0)); };
  switch (lobe.model) {
    case Model::blinn_phong:
      chart_ = Chart::slopes;
      width_x_ = width_y_ = power_width(p[1]);
      break;
    case Model::ward:
    case Model::cook_torrance:
      chart_ = Chart::slopes;
      width_x_ = p[1];
      width_y_ = lobe.model == Model::ward ? p[2] : p[1];
      break;
    case Model::ashikhmin_shirley:
      if (lobe.variant != kAshikhminShirleySpecular) break;
      chart_ = Chart::slopes;
      width_x_ = power_width(p[2]);
      width_y_ = power_width(p[3]);
      break;
    case Model::lafortune:
      chart_ = Chart::cone;
      width_x_ = width_y_ = power_width(p[4]);
      axis_ = glm::normalize(dvec3(p[1] * wo.x, p[2] * wo.y, p[3] * wo.z));
      tangent_ =
          glm::normalize(std::abs(axis_.x) < 0.9 ? dvec3(1, 0, 0) - axis_.x * axis_ : dvec3(0, 1, 0) - axis_.y * axis_);
      bitangent_ = glm::cross(axis_, tangent_);
      break;
    default:
      break;
  }
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int side = cut_by_horizon(row, column) ? 4 * fine : fine;
      double& share = shares_[static_cast<size_t>(row * kColumns + column)];
      for (int k = 0; k < side * side; ++k) {
        const Point at = point((row + (k / side + 0.5) / side) / kRows, (column + (k % side + 0.5) / side) / kColumns);
        if (at.wi.z > 0) share += lobe_pdf(lobe_, at.wi, wo_) * at.stretch;
      }
      share /= kRows * kColumns * side * side;
      integral_ += share;
    }
  }
  shares_.back() = std::max(0.0, 1 - integral_);
}

// Slopes and cones: rho^2 / (1 + rho^2) = s, rho the distance in widths, so that the square holds all of the plane.
CellsOfDraws::Point CellsOfDraws::point(double s, double t) const {
  const double c = std::cos(2 * kPi * t), n = std::sin(2 * kPi * t);
  if (chart_ == Chart::hemisphere) {
    const double r = std::sqrt(1 - s * s);
    return {dvec3(r * c, r * n, s), 2 * kPi};
  }
  const double rho = std::sqrt(s / (1 - s)), area = kPi * width_x_ * width_y_ / ((1 - s) * (1 - s));
  const double x = width_x_ * rho * c, y = width_y_ * rho * n;
  const double cosine = 1 / std::sqrt(1 + x * x + y * y), area_on_sphere = area * cosine * cosine * cosine;
  if (chart_ == Chart::cone) return {cosine * (x * tangent_ + y * bitangent_ + axis_), area_on_sphere};
  const dvec3 h = cosine * dvec3(x, y, 1);
  const double oh = glm::dot(h, wo_);
  return {2 * oh * h - wo_, 4 * std::abs(oh) * area_on_sphere};
}

bool CellsOfDraws::cut_by_horizon(int row, int column) const {
  constexpr int kSteps = 8;
  int above = 0, all = 0;
  for (int y = 0; y <= kSteps; ++y) {
    for (int x = 0; x <= kSteps; ++x, ++all) {
      const double s = std::min((row + static_cast<double>(y) / kSteps) / kRows, 1 - 1e-12);
      above += point(s, (column + static_cast<double>(x) / kSteps) / kColumns).wi.z > 0;
    }
  }
  return chart_ != Chart::hemisphere && above != 0 && above != all;
}

size_t CellsOfDraws::cell(dvec3 wi) const {
  double s = wi.z, x = wi.x, y = wi.y;
  if (chart_ == Chart::slopes) {
    const dvec3 h = wi + wo_;
    x = h.x / h.z / width_x_;
    y = h.y / h.z / width_y_;
  } else if (chart_ == Chart::cone) {
    const double z = glm::dot(wi, axis_);
    x = glm::dot(wi, tangent_) / z / width_x_;
    y = glm::dot(wi, bitangent_) / z / width_y_;
  }
  if (chart_ != Chart::hemisphere) s = (x * x + y * y) / (1 + x * x + y * y);
  const double turn = std::atan2(y, x) / (2 * kPi);
  const int row = std::clamp(static_cast<int>(s * kRows), 0, kRows - 1);
  const int column = std::clamp(static_cast<int>((turn < 0 ? turn + 1 : turn) * kColumns), 0, kColumns - 1);
  return static_cast<size_t>(row * kColumns + column);
}

void CellsOfDraws::count(dvec3 wi, bool valid) {
  seen_[valid ? cell(wi) : seen_.size() - 1] += 1;
  draws_ += 1;
}

double CellsOfDraws::deviations() const {
  double statistic = 0, pooled_due = 0, pooled_seen = 0;
  int cells = 0;
  const auto add = [&](double due, double seen) {
    statistic += (seen - due) * (seen - due) / due;
    ++cells;
  };
  for (size_t c = 0; c < shares_.size(); ++c) {
    const double due = shares_[c] * draws_;
    if (due >= 5) {
      add(due, seen_[c]);
    } else {
      pooled_due += due;
      pooled_seen += seen_[c];
    }
  }
  // Pooled cells that hardly anything is due in may hold a few draws, not many.
  if (pooled_due > 0 || pooled_seen > 0) add(std::max(pooled_due, 1.0), pooled_seen);
  const double k = cells - 1;
  return (std::cbrt(statistic / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
}

}  // namespace vamp::test
