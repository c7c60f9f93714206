#pragma once
// Lobes and directions that the tests share.
#include <cmath>
#include <vector>

#include "engine/brdf/registry.h"
#include "engine/probe/hard_questions.h"

namespace vamp::test {

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

}  // namespace vamp::test
