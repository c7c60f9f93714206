#pragma once
// Lobes and directions that the tests share.
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "engine/brdf/registry.h"

namespace vamp::test {

inline std::string name_of(const Lobe& lobe) {
  const ModelRow& row = model_row(lobe.model);
  std::string name = std::string(row.name) + "/" + std::string(row.variants[lobe.variant].name);
  for (float p : lobe.params) name += " " + std::to_string(p);
  return name;
}

// The nearest floats. Out of line, because g++ 12 drops the rounding of double -> float -> double where it vectorises
// all three components at once.
[[gnu::noinline]] inline vec3 rounded(dvec3 w) {
  return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
}

// Every variant of every model at one width: `width` 0 is sharp, 1 is broad.
inline std::vector<Lobe> lobes_of_width(double width) {
  std::vector<Lobe> lobes;
  const auto between = [&](double sharp, double broad) {
    return static_cast<float>(std::exp(std::log(sharp) + width * (std::log(broad) - std::log(sharp))));
  };
  for (const ModelRow& row : models()) {
    for (size_t v = 0; v < row.variants.size(); ++v) {
      Lobe lobe = default_lobe(row.model, static_cast<uint8_t>(v));
      auto& p = lobe.params;
      switch (row.model) {
        case Model::lambert:
          break;
        case Model::oren_nayar:
          p[1] = static_cast<float>(0.1 + 1.2 * width);
          break;
        case Model::blinn_phong:
          p[1] = between(1e5, 2);
          break;
        case Model::ward:
          p[1] = between(0.005, 0.8);
          p[2] = between(0.01, 0.5);
          break;
        case Model::cook_torrance:
          p[1] = between(0.005, 0.8);
          break;
        case Model::lafortune:
          p[1] = -0.97f;
          p[2] = -0.98f;
          p[4] = between(2e4, 2);
          break;
        case Model::ashikhmin_shirley:
          if (v != kAshikhminShirleyDiffuse) {
            p[2] = between(1e5, 3);
            p[3] = between(1e4, 1);
          }
      }
      lobes.push_back(lobe);
    }
  }
  return lobes;
}

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

}  // namespace vamp::test
