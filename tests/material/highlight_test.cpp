#include "engine/material/highlight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

Spmm of(const std::vector<Basis>& bases, const std::vector<float>& weights) {
  Spmm spmm;
  spmm.width = spmm.height = 1;
  spmm.clusters.resize(1);
  spmm.dictionary = bases;
  spmm.texels = {{0, static_cast<uint32_t>(bases.size()) << 8, 0, 0}};
  for (uint32_t j = 0; j < bases.size(); ++j) {
    const uint32_t h = half_from_float(weights[j]);
    spmm.entries.push_back({j | h << 16, h | h << 16});
  }
  return spmm;
}

float width_of(const Spmm& spmm) { return highlight_width(spmm, fit_sums(spmm)); }

Basis basis_of(Model model, std::initializer_list<std::pair<const char*, float>> values) {
  Basis basis;
  basis.lobe = default_lobe(model);
  for (const auto& [name, value] : values)
    basis.lobe.params[find_parameter(model, basis.lobe.variant, name)->slot] = value;
  return basis;
}

TEST(Highlight, IsTheWidthOfASharpFunctionThatCarriesLight) {
  const Basis base = basis_of(Model::lambert, {});
  EXPECT_EQ(width_of(of({base}, {1})), 0);
  EXPECT_EQ(width_of(of({base, basis_of(Model::cook_torrance, {{"m", 0.02f}, {"f0", 1.f}})}, {0.5f, 0.5f})), 0.02f);
  EXPECT_EQ(width_of(of({base, basis_of(Model::ward, {{"alpha_x", 0.01f}, {"alpha_y", 0.04f}})}, {1, 1})), 0.04f);
  EXPECT_EQ(width_of(of({base, basis_of(Model::ward, {{"alpha_x", 0.01f}, {"alpha_y", 0.3f}})}, {1, 1})), 0);
  EXPECT_EQ(width_of(of({base, basis_of(Model::cook_torrance, {{"m", 0.02f}, {"f0", 1.f}})}, {1, 0.001f})), 0);
  EXPECT_EQ(width_of(of({base, basis_of(Model::oren_nayar, {})}, {1, 1})), 0);
}

// exp(-tan^2 / alpha^2) and the power of a cosine fall alike at the peak.
TEST(Highlight, OfAnExponentFallsLikeItsPower) {
  for (const auto& [model, name] : {std::pair{Model::blinn_phong, "n"}, std::pair{Model::ashikhmin_shirley, "nu"}}) {
    Basis gloss = basis_of(model, {{name, 4000.f}});
    if (model == Model::ashikhmin_shirley) gloss = basis_of(model, {{"nu", 4000.f}, {"nv", 4000.f}, {"rs", 1.f}});
    const float alpha = *highlight_slopes(gloss.lobe);
    const double theta = 0.01;
    const double power = 4000 * std::log(std::cos(theta)), gauss = -std::pow(std::tan(theta) / double{alpha}, 2);
    EXPECT_NEAR(power / gauss, 1, 1e-3);
  }
}

TEST(Highlight, GrowsWithTheTiltOfItsFunctionUntilItIsNoHighlightOfThePart) {
  Basis gloss = basis_of(Model::cook_torrance, {{"m", 0.02f}, {"f0", 1.f}});
  gloss.normal = test::tilted(1, 30);
  EXPECT_NEAR(width_of(of({gloss}, {1})), std::hypot(0.02, std::tan(0.0174533)), 1e-4);
  gloss.normal = test::tilted(10, 30);
  EXPECT_EQ(width_of(of({gloss}, {1})), 0);
}

}  // namespace
}  // namespace vamp
