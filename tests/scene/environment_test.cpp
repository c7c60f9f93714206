#include "engine/scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

namespace vamp {
namespace {

std::vector<vec3> sun_map(uint32_t width, uint32_t height) {
  std::vector<vec3> texels(size_t{width} * height, vec3(0.1f, 0.2f, 0.4f));
  texels[size_t{height / 4} * width + width / 3] = vec3(3000, 2500, 2000);
  for (uint32_t x = 0; x < width; ++x) texels[size_t{height - 1} * width + x] = vec3(0);
  return texels;
}

TEST(Environment, PdfIntegratesToOne) {
  const auto e = make_environment(64, 32, sun_map(64, 32), "test");
  ASSERT_TRUE(e);
  double sum = 0;
  for (uint32_t row = 0; row < 32; ++row) {
    const double angle = 2 * std::numbers::pi / 64 *
                         (std::cos(std::numbers::pi * row / 32) - std::cos(std::numbers::pi * (row + 1) / 32));
    for (uint32_t x = 0; x < 64; ++x) {
      EXPECT_GT((*e)->texels[row * 64 + x].w, 0);
      sum += static_cast<double>((*e)->texels[row * 64 + x].w) * angle;
    }
  }
  EXPECT_NEAR(sum, 1, 1e-6);
}

TEST(Environment, SamplesAgreeWithLookupAndTheirPdf) {
  const auto e = make_environment(32, 16, sun_map(32, 16), "test");
  ASSERT_TRUE(e);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  constexpr int kSamples = 400000;
  double estimate = 0;
  for (int i = 0; i < kSamples; ++i) {
    const float a = unit(random);
    const float b = unit(random);
    const float c = unit(random);
    // Not quite the edges of a texel, where float directions may fall to either side.
    const vec4 u(a, b, 0.01f + 0.98f * c, 0.01f + 0.98f * unit(random));
    const Environment::Sample s = (*e)->sample(u, 0.7f);
    EXPECT_NEAR(glm::length(s.direction), 1, 1e-5f);
    const vec4 there = (*e)->lookup(s.direction, 0.7f);
    ASSERT_EQ(there.w, s.pdf);
    estimate += static_cast<double>(s.radiance.y) / static_cast<double>(s.pdf);
  }
  double exact = 0;
  for (uint32_t row = 0; row < 16; ++row)
    for (uint32_t x = 0; x < 32; ++x)
      exact += static_cast<double>((*e)->texels[row * 32 + x].y) * 2 * std::numbers::pi / 32 *
               (std::cos(std::numbers::pi * row / 16) - std::cos(std::numbers::pi * (row + 1) / 16));
  EXPECT_NEAR(estimate / kSamples / exact, 1, 0.003);
}

TEST(Environment, DirectionsFollowTheStatedConvention) {
  std::vector<vec3> texels(8 * 4, vec3(0));
  texels[0 * 8 + 4] = vec3(1, 0, 0);  // top row, just right of the middle
  texels[2 * 8 + 6] = vec3(0, 1, 0);  // right quarter
  texels[2 * 8 + 4] = vec3(0, 0, 1);  // middle
  const auto e = *make_environment(8, 4, texels, "test");
  EXPECT_EQ(e->lookup(glm::normalize(vec3(0.01f, 1, -0.1f))).x, 1);
  EXPECT_EQ(e->lookup(glm::normalize(vec3(1, -0.3f, 0.1f))).y, 1);
  EXPECT_EQ(e->lookup(glm::normalize(vec3(0.1f, -0.3f, -1))).z, 1);
  // Turned by +90 degrees about +Y, what was along -Z lies along -X.
  EXPECT_EQ(e->lookup(glm::normalize(vec3(-1, -0.3f, -0.1f)), std::numbers::pi_v<float> / 2).z, 1);
}

TEST(Environment, ABlackMapIsSampledEvenly) {
  const auto e = *make_environment(16, 8, std::vector<vec3>(128, vec3(0)), "test");
  for (const vec4& t : e->texels) EXPECT_NEAR(t.w, 1 / (4 * std::numbers::pi), 1e-6);
  EXPECT_EQ(e->mean_luminance, 0);
}

TEST(Environment, TexelsThatNoSkyHasAreNamed) {
  // 1.6e38 is finite, and what a byte changed in an .hdr file can make; three of them are not.
  for (const float bad :
       {-1.0f, 1.6e38f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    std::vector<vec3> texels(128, vec3(1));
    texels[16 * 2 + 5].y = bad;
    const auto e = make_environment(16, 8, texels, "sky.hdr");
    ASSERT_FALSE(e);
    EXPECT_NE(e.error().message().find("texel (5, 2)"), std::string::npos) << e.error().message();
  }
}

}  // namespace
}  // namespace vamp
