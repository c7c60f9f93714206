#pragma once
// Questions that are hard to answer in float, and how far answers are from the double build on the same floats.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "engine/probe/brdf_probe.h"

namespace vamp {

// "ward/duer 1 0.1 0.3": the variant, then its parameters in the papers' order.
std::string words_of(const Lobe& lobe);

// The nearest floats. Out of line, because g++ 12 drops the rounding of double -> float -> double where it vectorises
// all three components at once.
vec3 rounded(dvec3 w);

// A repeatable sequence of directions above the horizon.
class Directions {
 public:
  explicit Directions(uint32_t seed) : engine_(seed) {}
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(engine_); }
  dvec3 at(double cosine, double phi) {
    const double s = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {s * std::cos(phi), s * std::sin(phi), cosine};
  }
  dvec3 at_angle(double degrees) { return at(std::cos(degrees * std::numbers::pi / 180), azimuth()); }
  dvec3 hemisphere() { return at(uniform(), azimuth()); }
  double azimuth() { return 2 * std::numbers::pi * uniform(); }
  // Cosine log-uniform between low and high.
  dvec3 grazing(double low, double high) { return at(low * std::pow(high / low, uniform()), azimuth()); }

 private:
  std::mt19937 engine_;
};

// `lobes` sets of parameters over the whole of the rows' ranges, ends included (exponents to 1e5, Lafortune's to 2e4),
// each with `pairs` directions: down the highlight and its tail, at its very peak, near the normal, towards one
// another, along the axes, with one or both at the horizon (cosines to 1e-6), and at random.
std::vector<BrdfQuestion> hard_questions(Model model, uint8_t variant, uint32_t seed, int lobes, int pairs);

// Regions of f, the brightest for the same viewer being f_max.
enum class ErrorRegion : uint8_t {
  core,     // f >= 1e-3 f_max, both directions at most 80 degrees from the normal
  grazing,  // f >= 1e-3 f_max, a direction beyond
  tail,     // f >= 1e-12 f_max
  deep      // darker still
};
inline constexpr ErrorRegion kErrorRegions[] = {ErrorRegion::core, ErrorRegion::grazing, ErrorRegion::tail,
                                                ErrorRegion::deep};
std::string_view name_of(ErrorRegion region);

// What the double build answers, and what an error counts in proportion to: |fcos|, in the deep region f_max cos; of
// Oren and Nayar's full model, which crosses zero, at least Lambert's value.
struct Truth {
  double fcos = 0;
  double measure = 0;
  ErrorRegion region = ErrorRegion::core;
};
std::vector<Truth> truths_of(std::span<const BrdfQuestion> questions);

// The errors in one region. Below 1e-12 / sr nothing counts. What is no number counts as an infinite error.
struct RegionErrors {
  std::vector<float> all;
  double worst = 0;
  size_t where = 0;  // question of the worst

  double quantile(double q) const;
};
// By region. One truth and one answer a question.
std::array<RegionErrors, 4> errors_of(std::span<const Truth> truths, std::span<const float> fcos);

}  // namespace vamp
