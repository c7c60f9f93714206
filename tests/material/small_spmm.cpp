#include "tests/material/small_spmm.h"

#include <cmath>
#include <numbers>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/material/directions.h"

namespace vamp::test {

dvec3 random_direction(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double z = 1 - uniform(random), phi = 2 * std::numbers::pi * uniform(random), s = std::sqrt(1 - z * z);
  return {s * std::cos(phi), s * std::sin(phi), z};
}

vec3 tilted(double tilt, double azimuth) {
  const double t = tilt * std::numbers::pi / 180, a = azimuth * std::numbers::pi / 180;
  return {static_cast<float>(std::sin(t) * std::cos(a)), static_cast<float>(std::sin(t) * std::sin(a)),
          static_cast<float>(std::cos(t))};
}

Spmm small_spmm(uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  const auto half = [](float v) { return uint32_t{half_from_float(v)}; };
  Spmm spmm;
  spmm.width = 6, spmm.height = 4;
  spmm.mm_per_texel = 0.15f;
  spmm.clusters = {{"plate"}, {"crease"}, {"pore"}};
  spmm.dictionary = {{"body", default_lobe(Model::lambert), {0, 0, 1}, 0},
                     {"dust", default_lobe(Model::oren_nayar), tilted(20, 40), 0},
                     {"sheen", default_lobe(Model::ward), tilted(25, 200), 0.7f},
                     {"finish", default_lobe(Model::cook_torrance), tilted(10, 300), 0},
                     {"fibre", default_lobe(Model::ashikhmin_shirley), tilted(35, 100), -1.1f}};
  spmm.dictionary[2].lobe.params[2] = 0.45f;
  for (int i = 0; i < spmm.width * spmm.height; ++i) {
    const uint32_t count = static_cast<uint32_t>(i % 6), cluster = static_cast<uint32_t>(i % 3);
    spmm.texels.push_back({static_cast<uint32_t>(spmm.entries.size()), cluster | count << 8,
                           half(uniform(random) - 0.5f) | half(uniform(random) - 0.5f) << 16,
                           half(uniform(random) - 0.5f) | half(uniform(random) - 0.5f) << 16});
    for (uint32_t basis = 0; basis < count; ++basis)
      spmm.entries.push_back(
          {basis | half(uniform(random)) << 16, half(uniform(random)) | half(uniform(random)) << 16});
  }
  spmm.residual.directions = ubo2003_directions();
  spmm.residual.terms = 4;
  spmm.residual.records.resize(3 * 81 * 81);
  for (auto& record : spmm.residual.records) {
    for (uint32_t& two : record.halves)
      two = half((uniform(random) - 0.5f) * 0.1f) | half((uniform(random) - 0.5f) * 0.1f) << 16;
    record.halves[7] &= 0xffffu;
  }
  return spmm;
}

}  // namespace vamp::test
