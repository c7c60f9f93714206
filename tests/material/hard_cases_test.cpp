// Hard cases of the mixture, by the numbers that docs/brdf.md lists: frames, horizons, weights, borders of the
// residual.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/material/directions.h"
#include "engine/material/tables.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

// One texel with one function of this weight and no residual.
Spmm single(const Basis& basis, float weight = 1) {
  const uint32_t half = half_from_float(weight);
  Spmm spmm;
  spmm.width = spmm.height = 1;
  spmm.dictionary = {basis};
  spmm.clusters = {{"only"}};
  spmm.texels = {{0, 1u << 8, 0, 0}};
  spmm.entries = {{half << 16, half | half << 16}};
  return spmm;
}

Basis stretched(vec3 normal) {
  Basis basis{"sheen", default_lobe(Model::ward), normal, 0};
  basis.lobe.params[1] = 0.05f, basis.lobe.params[2] = 0.5f;
  return basis;
}

dvec3 at(double theta, double phi) {
  const double t = theta * std::numbers::pi / 180, p = phi * std::numbers::pi / 180;
  return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

double value(const Basis& basis, dvec3 wi, dvec3 wo) { return evaluate(single(basis), {}, {}, 0, 0, wi, wo).x; }

TEST(MaterialHardCase28, AnUprightFrameIsTheTexelsOwnAndASteepOneIsStillAFrame) {
  const Basis upright = stretched({0, 0, 1});
  const dvec3 wi = at(30, 70), wo = at(25, 240);
  const double own = fcos(upright.lobe, wi, wo);
  EXPECT_NEAR(value(upright, wi, wo), own, 1e-5 * own);
  // Mirrored about a steep normal, with the lobe's peak: what the model gives for light and viewer there.
  for (const double tilt : {60.0, 80.0, 87.0}) {
    for (const double azimuth : {0.0, 45.0, 130.0, 300.0}) {
      const vec3 n = test::tilted(tilt, azimuth);
      const dvec3 w = glm::normalize(dvec3(n) + dvec3(0, 0, 0.2));
      const double c = glm::dot(w, glm::normalize(dvec3(n)));
      const dvec3 mirrored = 2 * c * glm::normalize(dvec3(n)) - w;
      if (mirrored.z <= 0) continue;
      const double peak = 1 / (std::numbers::pi * 0.05 * 0.5) / (4 * c * c) * c;
      EXPECT_NEAR(value(stretched(n), mirrored, w), peak, 1e-4 * peak) << tilt << " " << azimuth;
    }
  }
}

TEST(MaterialHardCase29, TangentsDoNotJumpWhereANormalIsNearlyUpright) {
  const dvec3 wi = at(30, 70), wo = at(25, 240);
  const double upright = value(stretched({0, 0, 1}), wi, wo);
  for (int azimuth = 0; azimuth < 360; azimuth += 5) {
    const vec3 n = test::tilted(1e-6 * 180 / std::numbers::pi, azimuth);
    EXPECT_NEAR(value(stretched(n), wi, wo), upright, 1e-4 * upright) << azimuth;
  }
}

TEST(MaterialHardCase31, BelowAFunctionsOwnHorizonOnlyTheResidualIsLit) {
  Spmm spmm = test::small_spmm();
  for (Basis& basis : spmm.dictionary) basis.normal = test::tilted(60, 0);
  const DirectionTables directions = triangulate(spmm.residual.directions, "t").value();
  EditLayer keep;
  keep.residual_policy = ResidualPolicy::keep;
  Spmm without = spmm;
  for (auto& texel : without.texels) texel.cluster_count &= 0xffu;  // no functions
  const dvec3 wi = at(50, 180), wo = at(20, 0);                     // behind the tilted frames, above the surface
  for (int x = 0; x < spmm.width; ++x) {
    const dvec3 all = evaluate(spmm, keep, directions, x, 0, wi, wo);
    EXPECT_EQ(all.x, evaluate(without, keep, directions, x, 0, wi, wo).x);
    EXPECT_NE(all.x, 0);
  }
}

TEST(MaterialHardCase34, WeightsOfZeroAndOfTenThousandAreExact) {
  const Basis body{"body", default_lobe(Model::lambert), {0, 0, 1}, 0};
  const dvec3 wi = at(30, 0), wo = at(10, 0);
  for (const float weight : {0.0f, 1e4f, 65504.0f}) {
    const double expected = static_cast<double>(weight) * wi.z / std::numbers::pi;
    EXPECT_NEAR(evaluate(single(body, weight), {}, {}, 0, 0, wi, wo).x, expected, 1e-6 * expected);
  }
}

TEST(MaterialHardCase40, TheDisksVeryBorderReadsInsideItsTables) {
  const std::vector<vec3> measured = ubo2003_directions();
  const DirectionTables directions = triangulate(measured, "t").value();
  for (const dvec3 w : {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0.6, 0.8, 0),
                        dvec3(-0.8, -0.6, 1e-12), dvec3(0, 0, 1)}) {
    const auto found = find_direction(directions, w);
    double sum = 0;
    for (size_t v = 0; v < 3; ++v) {
      EXPECT_TRUE(found.slot[v] >= 0 && found.slot[v] < static_cast<int>(measured.size()));
      EXPECT_GE(found.weight[v], 0);
      sum += found.weight[v];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

}  // namespace
}  // namespace vamp
