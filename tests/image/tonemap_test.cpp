#include "shaders/shared/tonemap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/image/colour.h"
#include "engine/image/display.h"
#include "shaders/spirv.h"

namespace vamp {
namespace {

TEST(Tonemap, CompilesAsGlsl) { EXPECT_GT(spirv::tonemap_probe_comp().size(), 100u); }

TEST(Tonemap, NeutralMeetsPointsWorkedOutByHand) {
  EXPECT_EQ(tone_neutral(vec3(0, 0, 0)), vec3(0, 0, 0));
  // x = 0.5 > 2 F90, so f = 0.04; p = 0.46 < Ks: only the offset is taken off.
  EXPECT_NEAR(tone_neutral(vec3(0.5f)).x, 0.46f, 1e-6f);
  // x = 0.04: f = 0.04 - 0.0016 / 0.16 = 0.03.
  EXPECT_NEAR(tone_neutral(vec3(0.04f)).x, 0.01f, 1e-7f);
  // A saturated colour has x = 0 and f = 0.
  EXPECT_NEAR(tone_neutral(vec3(0.7f, 0.2f, 0)).x, 0.7f, 1e-6f);
  EXPECT_NEAR(tone_neutral(vec3(0.7f, 0.2f, 0)).y, 0.2f, 1e-6f);
  // Grey 1.04: p = 1, pn = 1 - 0.24^2 / (1 + 1 - 1.52) = 0.88; grey stays grey whatever g is.
  EXPECT_NEAR(tone_neutral(vec3(1.04f)).x, 0.88f, 1e-6f);
  // Red 2: p = 2, pn = 1 - 0.0576 / 1.48, g = 1 / (0.15 (2 - pn) + 1).
  const double pn = 1 - 0.0576 / 1.48;
  const double g = 1 / (0.15 * (2 - pn) + 1);
  EXPECT_NEAR(static_cast<double>(tone_neutral(vec3(2, 0, 0)).x), pn, 1e-6);
  EXPECT_NEAR(static_cast<double>(tone_neutral(vec3(2, 0, 0)).y), pn * (1 - g), 1e-6);
}

TEST(Tonemap, NeutralRisesAndStaysInRange) {
  for (const vec3 hue : {vec3(1, 1, 1), vec3(1, 0.5f, 0.1f), vec3(0, 0, 1)}) {
    float last = -1;
    for (float level = 1e-4f; level < 1e6f; level *= 1.01f) {
      const vec3 shown = tone_neutral(hue * level);
      const float peak = std::max({shown.x, shown.y, shown.z});
      EXPECT_GE(peak, last - 5e-7f);  // four roundings
      EXPECT_GE(std::min({shown.x, shown.y, shown.z}), 0.0f);
      EXPECT_LE(peak, 1.0f);
      last = peak;
    }
  }
}

TEST(Tonemap, NeutralIsContinuousWhereItsPiecesMeet) {
  EXPECT_NEAR(tone_neutral(vec3(0.079999f)).x, tone_neutral(vec3(0.080001f)).x, 1e-5f);
  EXPECT_NEAR(tone_neutral(vec3(0.799999f)).x, tone_neutral(vec3(0.800001f)).x, 1e-5f);
}

TEST(Tonemap, WhatNoDisplayCanShowStaysFiniteAndInRange) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {kInf, -kInf, kNan, -3.0f, std::numeric_limits<float>::max()})
    for (const int curve : {TONE_CURVE_LINEAR, TONE_CURVE_NEUTRAL}) {
      const vec3 code = srgb_encoded(tone_display(vec3(bad, 0.5f, bad), 2.0f, curve));
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(code[c] >= 0.0f && code[c] <= 1.0f) << bad << " " << curve;
    }
  EXPECT_EQ(srgb_encode(kNan), 0.0f);
}

TEST(Tonemap, ExposureCountsInStops) {
  EXPECT_EQ(tone_exposed(vec3(1, 2, 3), 2.0f), vec3(4, 8, 12));
  EXPECT_EQ(tone_exposed(vec3(1, 2, 3), -1.0f), vec3(0.5f, 1, 1.5f));
}

TEST(Srgb, EncodingUndoesDecodingForEveryCode) {
  for (const size_t count : {size_t{256}, size_t{65536}}) {
    const auto table = decoding_table(count, ColourSpace::srgb);
    const auto top = static_cast<float>(count - 1);
    for (size_t code = 0; code < count; ++code)
      ASSERT_EQ(static_cast<size_t>(srgb_encode(table[code]) * top + 0.5f), code) << count;
  }
}

TEST(Srgb, TableIsTheExactCurve) {
  const auto table = decoding_table(256, ColourSpace::srgb);
  EXPECT_EQ(table[0], 0.0f);
  EXPECT_EQ(table[255], 1.0f);
  EXPECT_NEAR(table[10], 10.0 / 255 / 12.92, 1e-9);
  EXPECT_NEAR(table[128], 0.21586050, 1e-7);  // the well-known middle grey
  for (size_t code = 0; code < 256; ++code)
    EXPECT_NEAR(srgb_decode(static_cast<float>(code) / 255.0f), table[code], 3e-7f);
}

TEST(Display, GreyIsSpreadAndAlphaGoesAlong) {
  Image image(1, 1, {"Y", "A"});
  image.pixels = {0.5f, 0.25f};
  const auto shown = displayed(image, {1.0f, ToneCurve::linear});
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  EXPECT_EQ(shown->pixels, (std::vector<float>{1, 1, 1, 0.25f}));
}

TEST(Chromaticities, TheSameSpaceIsTheUnitMatrix) {
  std::array<double, 9> m{};
  ASSERT_TRUE(matrix_to_rec709(kRec709, m));
  for (size_t i = 0; i < 9; ++i) EXPECT_NEAR(m[i], i % 4 == 0 ? 1.0 : 0.0, 1e-12);
}

TEST(Chromaticities, WhiteStaysWhiteAndRec2020RedIsOutsideRec709) {
  std::array<double, 9> m{};
  // ITU-R BT.2020; the matrix to BT.709 is printed in ITU-R BT.2087.
  ASSERT_TRUE(matrix_to_rec709({0.708f, 0.292f, 0.17f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.329f}, m));
  const double known[] = {1.6605, -0.5876, -0.0728, -0.1246, 1.1329, -0.0083, -0.0182, -0.1006, 1.1187};
  for (size_t i = 0; i < 9; ++i) EXPECT_NEAR(m[i], known[i], 2e-4);
  // ACES AP0 has another white, which the adaptation maps to white.
  ASSERT_TRUE(matrix_to_rec709({0.7347f, 0.2653f, 0, 1, 0.0001f, -0.077f, 0.32168f, 0.33767f}, m));
  for (size_t row = 0; row < 3; ++row) EXPECT_NEAR(m[3 * row] + m[3 * row + 1] + m[3 * row + 2], 1.0, 1e-9);
}

TEST(Chromaticities, NonsenseIsRefused) {
  std::array<double, 9> m{};
  EXPECT_FALSE(matrix_to_rec709({0, 0, 0, 0, 0, 0, 0, 0}, m));
  EXPECT_FALSE(matrix_to_rec709({0.3f, 0.3f, 0.3f, 0.3f, 0.3f, 0.3f, 0.3f, 0.3f}, m));
}

}  // namespace
}  // namespace vamp
