#include "engine/material/pigments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/half.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

const vec3 kBrown(0.5f, 0.125f, 0.0625f), kNavy(0.0625f, 0.125f, 0.25f), kMoss(0.0625f, 0.5f, 0.25f), kWhite(1);

double half(uint32_t bits) { return double{float_from_half(static_cast<uint16_t>(bits & 0xffffu))}; }
uint32_t bits_of(double value) { return half_from_float(static_cast<float>(value)); }

dvec3 weight_of(const tables::Entry& entry) {
  return {half(entry.basis_red >> 16), half(entry.green_blue), half(entry.green_blue >> 16)};
}
dvec3 value_of(const tables::ResidualRecord& record, size_t k) {
  const auto at = [&](size_t i) { return half(record.halves[i / 2] >> (i % 2 * 16)); };
  return {at(3 * k), at(3 * k + 1), at(3 * k + 2)};
}

// A material all of whose weights and residuals are mixtures of brown, moss and white: amounts that halves hold
// exactly.
Spmm mixed(const std::array<vec3, 3>& colours) {
  Spmm spmm = test::small_spmm();
  std::mt19937 random(3);
  const auto mixture = [&](bool signs) {
    dvec3 sum(0);
    for (const vec3 colour : colours) {
      const double amount = static_cast<double>(random() % 4) - (signs ? 2 : 0);
      sum += amount * dvec3(colour);
    }
    return sum;
  };
  for (tables::Entry& entry : spmm.entries) {
    const dvec3 w = mixture(false);
    entry = {(entry.basis_red & 0xffffu) | bits_of(w.x) << 16, bits_of(w.y) | bits_of(w.z) << 16};
  }
  for (tables::ResidualRecord& record : spmm.residual.records) {
    std::array<double, 16> values{};
    for (size_t k = 0; k <= static_cast<size_t>(spmm.residual.terms); ++k) {
      const dvec3 r = mixture(true);
      values[3 * k] = r.x, values[3 * k + 1] = r.y, values[3 * k + 2] = r.z;
    }
    for (size_t i = 0; i < 8; ++i) record.halves[i] = bits_of(values[2 * i]) | bits_of(values[2 * i + 1]) << 16;
  }
  return spmm;
}

// Relative RMS difference of the weights, and of the residuals.
struct Difference {
  double weights = 0, residual = 0;
};
Difference difference(const Spmm& a, const Spmm& b) {
  double apart = 0, square = 0;
  const auto meet = [&](const dvec3& x, const dvec3& y) {
    apart += dot(x - y, x - y);
    square += dot(y, y);
  };
  Difference found;
  for (size_t i = 0; i < a.entries.size(); ++i) meet(weight_of(a.entries[i]), weight_of(b.entries[i]));
  found.weights = std::sqrt(apart / square);
  apart = square = 0;
  for (size_t i = 0; i < a.residual.records.size(); ++i)
    for (size_t k = 0; k <= static_cast<size_t>(a.residual.terms); ++k)
      meet(value_of(a.residual.records[i], k), value_of(b.residual.records[i], k));
  found.residual = std::sqrt(apart / square);
  return found;
}

// The map of colours is drawn a little to a mere factor: less than a hundredth of the weights, and more of the residual,
// which has colours that the weights of such a small material leave open.
constexpr double kExact = 2e-3, kNear = 0.03;

TEST(Pigments, OfAMixtureOneColourIsExchangedInWeightsAndResidual) {
  const Spmm before = mixed({kBrown, kMoss, kWhite}), after = mixed({kNavy, kMoss, kWhite});
  const Spmm changed = with_pigment(before, {kBrown, kNavy, {kMoss, kWhite}});
  EXPECT_LT(difference(changed, after).weights, kExact);
  EXPECT_LT(difference(changed, after).residual, kNear);
  EXPECT_GT(difference(before, after).residual, 5 * kNear);
  EXPECT_TRUE(validate(changed, "changed").has_value());
}

TEST(Pigments, WhiteToBlackLeavesTheBody) {
  const Spmm before = mixed({kBrown, kMoss, kWhite}), after = mixed({kBrown, kMoss, vec3(0)});
  const Spmm changed = with_pigment(before, {kWhite, vec3(0), {kBrown, kMoss}});
  EXPECT_LT(difference(changed, after).weights, kExact);
  EXPECT_LT(difference(changed, after).residual, 2 * kNear);
}

TEST(Pigments, AColourForItselfChangesNothing) {
  const Spmm spmm = mixed({kBrown, kMoss, kWhite});
  const Difference found = difference(with_pigment(spmm, {kMoss, kMoss, {kBrown, kWhite}}), spmm);
  EXPECT_EQ(found.weights, 0);
  EXPECT_LT(found.residual, 1e-3);
}

TEST(Pigments, WhatNoMixtureTellsStays) {
  const dvec3 green(0.05, 0.5, 0.05);
  const std::vector<dvec3> changed =
      changed_colours({dvec3(kBrown), green, 2.0 * dvec3(kWhite), dvec3(0)}, {kBrown, kNavy, {kWhite}});
  EXPECT_NEAR(length(changed[0] - dvec3(kNavy)), 0, 1e-9);
  // Green is nearer to white than to brown, and is neither.
  EXPECT_NEAR(length(changed[1] - green), 0, 1e-9);
  EXPECT_NEAR(length(changed[2] - 2.0 * dvec3(kWhite)), 0, 1e-9);
  EXPECT_EQ(changed[3], dvec3(0));
}

TEST(Pigments, SharesTellHowMuchOfAMaterialIsOfAColour) {
  // One function throughout, every weight of the same mixture: the light is split as the mixture is.
  Spmm spmm = mixed({kBrown, kMoss, kWhite});
  const dvec3 colour = 2.0 * dvec3(kBrown) + 0.5 * dvec3(kWhite);
  for (tables::Entry& entry : spmm.entries)
    entry = {bits_of(colour.x) << 16, bits_of(colour.y) | bits_of(colour.z) << 16};
  const double sum = colour.x + colour.y + colour.z;
  const PigmentShares brown = pigment_shares(spmm, {kBrown, kNavy, {kWhite}});
  EXPECT_NEAR(brown.light, 1 - 1.5 / sum, 1e-3);
  const auto lit = std::count_if(spmm.texels.begin(), spmm.texels.end(),
                                 [](const tables::Texel& texel) { return (texel.cluster_count >> 8 & 0xffu) > 0; });
  EXPECT_DOUBLE_EQ(brown.texels, static_cast<double>(lit) / static_cast<double>(spmm.texels.size()));
  EXPECT_LT(brown.untold, 1e-3);
  EXPECT_NEAR(pigment_shares(spmm, {kWhite, vec3(0), {kBrown}}).light, 1.5 / sum, 1e-3);
  // A colour that a third one has, and none of which the mixtures know.
  const PigmentShares moss = pigment_shares(spmm, {kMoss, kNavy, {kBrown, kWhite}});
  EXPECT_LT(moss.light, 1e-3);
  EXPECT_EQ(moss.texels, 0);
  for (tables::Entry& entry : spmm.entries) entry = {bits_of(1) << 16, 0};
  EXPECT_NEAR(pigment_shares(spmm, {vec3(0, 1, 0), vec3(0), {vec3(1, 0, 1)}}).untold, std::sqrt(0.5), 1e-3);
}

TEST(Pigments, ColoursThatAreMixturesOfOthersDoNoHarm) {
  const std::vector<dvec3> changed = changed_colours({dvec3(kBrown) + dvec3(kWhite)},
                                                     {kBrown, kNavy, {kWhite, 2.f * kWhite, kBrown + kWhite, kBrown}});
  for (int c = 0; c < 3; ++c) {
    EXPECT_GE(changed[0][c], 0);
    EXPECT_LE(changed[0][c], 2);
  }
}

}  // namespace
}  // namespace vamp
