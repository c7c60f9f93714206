#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/material/directions.h"
#include "engine/material/tables.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

constexpr uint32_t kOne = 0x3c00;  // a half

// One texel with one function of weight 1 and no residual.
Spmm single(const Basis& basis) {
  Spmm spmm;
  spmm.width = spmm.height = 1;
  spmm.dictionary = {basis};
  spmm.clusters = {{"only"}};
  spmm.texels = {{0, 1u << 8, 0, 0}};
  spmm.entries = {{kOne << 16, kOne | kOne << 16}};
  return spmm;
}

TEST(Evaluate, LambertIsItsCosineOverPi) {
  const Spmm spmm = single({"body", default_lobe(Model::lambert), {0, 0, 1}, 0});
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const dvec3 wi = test::random_direction(random), wo = test::random_direction(random);
    EXPECT_NEAR(evaluate(spmm, {}, {}, 0, 0, wi, wo).x, wi.z / std::numbers::pi, 1e-7);
  }
}

TEST(Evaluate, ATiltedLambertFollowsItsOwnNormalAndIsCutAtBothHorizons) {
  const vec3 n = test::tilted(40, 25);
  const Spmm spmm = single({"body", default_lobe(Model::lambert), n, 0});
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) {
    dvec3 wi = test::random_direction(random), wo = test::random_direction(random);
    if (i % 3 == 0) wi.z = -wi.z;
    if (i % 5 == 0) wo.z = -wo.z;
    const double own = wi.x * double{n.x} + wi.y * double{n.y} + wi.z * double{n.z};
    const double expected = wi.z > 0 && wo.z > 0 ? std::max(own, 0.0) / std::numbers::pi : 0;
    EXPECT_NEAR(evaluate(spmm, {}, {}, 0, 0, wi, wo).y, expected, 1e-6);
  }
}

TEST(Evaluate, AFlatHighlightIsTheModelsOwnValue) {
  for (const Model model : {Model::blinn_phong, Model::ward, Model::cook_torrance, Model::ashikhmin_shirley}) {
    const Basis basis{"gloss", default_lobe(model), {0, 0, 1}, 0};
    const Spmm spmm = single(basis);
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
      const dvec3 wi = test::random_direction(random), wo = test::random_direction(random);
      if (wo.z < 0.031) continue;  // inside the window of the view horizon
      const double expected = fcos(basis.lobe, wi, wo);
      EXPECT_NEAR(evaluate(spmm, {}, {}, 0, 0, wi, wo).x, expected, 1e-5 * std::max(1.0, expected)) << int(model);
    }
  }
}

TEST(Evaluate, TurningATangentTurnsTheHighlightAboutTheNormal) {
  Basis basis{"sheen", default_lobe(Model::ward), {0, 0, 1}, 0};
  basis.lobe.params[1] = 0.1f, basis.lobe.params[2] = 0.5f;
  const Spmm straight = single(basis);
  basis.psi = 0.6f;
  const Spmm turned = single(basis);
  std::mt19937 random(4);
  const double c = std::cos(double{0.6f}), s = std::sin(double{0.6f});
  const auto turn = [&](dvec3 w) { return dvec3(c * w.x - s * w.y, s * w.x + c * w.y, w.z); };
  for (int i = 0; i < 200; ++i) {
    const dvec3 wi = test::random_direction(random), wo = test::random_direction(random);
    const double expected = evaluate(straight, {}, {}, 0, 0, wi, wo).x;
    EXPECT_NEAR(evaluate(turned, {}, {}, 0, 0, turn(wi), turn(wo)).x, expected, 2e-5 * std::max(1.0, expected));
  }
}

TEST(Evaluate, AtMeasuredDirectionsTheResidualIsTheStoredRecord) {
  const Spmm spmm = test::small_spmm();
  const DirectionTables directions = triangulate(spmm.residual.directions, "t").value();
  EditLayer silent;
  BasisEdit mute;
  mute.mute = true;
  for (int c = 0; c < 3; ++c)
    for (int j = 0; j < 5; ++j) silent.set({c, j}, mute);
  silent.residual_policy = ResidualPolicy::keep;
  const EditedTables tables = edited_tables(spmm, silent);
  const auto half = [](uint32_t bits) { return double{float_from_half(static_cast<uint16_t>(bits))}; };
  for (size_t v = 0; v < 81; v += 4)
    for (size_t l = 0; l < 81; l += 3) {
      const auto& texel = spmm.texels[4];  // cluster 1
      const auto& record = spmm.residual.records[(81 + v) * 81 + l];
      const double mean = half(record.halves[0] & 0xffffu);
      const double term = half(record.halves[1] >> 16);  // red of the first term
      const dvec3 wi(spmm.residual.directions[l]), wo(spmm.residual.directions[v]);
      EXPECT_NEAR(evaluate(spmm, tables, 0, directions, 4, 0, wi, wo).x, mean, 1e-6);
      EXPECT_NEAR(evaluate(spmm, tables, 1, directions, 4, 0, wi, wo).x,
                  mean + term * half(texel.coefficients01 & 0xffffu), 1e-6);
    }
}

TEST(Evaluate, TheResidualFadesToTheHorizonPastTheLastRing) {
  Spmm spmm = test::small_spmm();
  for (auto& texel : spmm.texels) texel.cluster_count &= 0xffu;  // no functions
  const DirectionTables directions = triangulate(spmm.residual.directions, "t").value();
  const auto at = [&](double degrees) {
    const double t = degrees * std::numbers::pi / 180;
    return evaluate(spmm, {}, directions, 0, 0, {std::sin(t), 0, std::cos(t)}, {0, 0, 1});
  };
  const dvec3 ring = at(75);
  // Along a spoke through a measured direction the nearest one is that direction itself, all the way out.
  for (const double degrees : {80.0, 85.0, 89.9}) {
    const double fade = std::cos(degrees * std::numbers::pi / 180) / std::cos(75 * std::numbers::pi / 180);
    EXPECT_NEAR(at(degrees).x, ring.x * fade, 2e-3 * std::abs(ring.x) + 1e-6) << degrees;
  }
  EXPECT_NEAR(at(89.9999).x, 0, 1e-5);
}

TEST(Evaluate, IsLinearInGainsWhenTheResidualFollows) {
  const Spmm spmm = test::small_spmm();
  const DirectionTables directions = triangulate(spmm.residual.directions, "t").value();
  EditLayer doubled;
  BasisEdit edit;
  edit.gain = vec3(2);
  for (int c = 0; c < 3; ++c)
    for (int j = 0; j < 5; ++j) doubled.set({c, j}, edit);
  const EditedTables one = edited_tables(spmm, {}), two = edited_tables(spmm, doubled);
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    const dvec3 wi = test::random_direction(random), wo = test::random_direction(random);
    const int x = i % spmm.width, y = i % spmm.height;
    const dvec3 a = evaluate(spmm, one, 4, directions, x, y, wi, wo);
    const dvec3 b = evaluate(spmm, two, 4, directions, x, y, wi, wo);
    const bool empty = spmm.texels[static_cast<size_t>(y * spmm.width + x)].cluster_count >> 8 == 0;
    if (!empty) {
      EXPECT_NEAR(b.y, 2 * a.y, 1e-5 * std::max(1.0, std::abs(a.y)));
    }
  }
}

TEST(Evaluate, ATexelWithoutFunctionsIsItsResidual) {
  const Spmm spmm = test::small_spmm();
  const DirectionTables directions = triangulate(spmm.residual.directions, "t").value();
  EXPECT_NE(evaluate(spmm, {}, directions, 0, 0, {0, 0, 1}, {0, 0, 1}).x, 0);
}

}  // namespace
}  // namespace vamp
