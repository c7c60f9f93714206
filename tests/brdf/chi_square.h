#pragma once
// Whether draws follow a density: counts in cells against the density's integrals over them (Pearson's chi-square).
#include <vector>

#include "engine/brdf/lobe.h"

namespace vamp::test {

// One bound for all such tests of this folder: 4.1 standard deviations, 2.1e-5 for each, 1 % for 480 together (Sidak).
inline constexpr double kChiSquareDeviations = 4.1;

// Cells over what a lobe's sampler can draw for one viewer, in coordinates in which the lobe is broad whatever its
// width: directions for the cosine, slopes of the half vector for highlights, a cone about its axis for Lafortune's.
// Nothing of the sampler is used, only its density.
class CellsOfDraws {
 public:
  // `fine` x `fine` midpoints integrate each cell, four times as many a side where the horizon cuts it.
  CellsOfDraws(const Lobe& lobe, vec3 wo, int fine);

  void count(dvec3 wi, bool valid);
  // How many standard deviations above its expectation the statistic lies (Wilson and Hilferty 1931). Cells in which
  // fewer than 5 draws are due are pooled; draws below the horizon have a cell of their own.
  double deviations() const;
  // The density's integral over all directions.
  double integral() const { return integral_; }

 private:
  enum class Chart { hemisphere, slopes, cone };
  struct Point {
    dvec3 wi{0};
    double stretch = 0;  // steradians per unit of the chart's square
  };
  Point point(double s, double t) const;
  bool cut_by_horizon(int row, int column) const;
  size_t cell(dvec3 wi) const;

  Lobe lobe_;
  dvec3 wo_;
  Chart chart_ = Chart::hemisphere;
  double width_x_ = 1, width_y_ = 1;
  dvec3 axis_{0, 0, 1}, tangent_{1, 0, 0}, bitangent_{0, 1, 0};  // of the cone
  std::vector<double> shares_, seen_;
  double integral_ = 0, draws_ = 0;
};

}  // namespace vamp::test
