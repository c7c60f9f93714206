// What the status line tells of noise.
#include "engine/render/noise.h"

#include <gtest/gtest.h>

#include <random>

namespace vamp {
namespace {

// Means of `samples` draws of 1 +- 0.5 in each of 10,000 pixels, the first draws those of the mean before.
class Draws {
 public:
  std::vector<float> mean(uint32_t samples) {
    for (; taken_ < samples; ++taken_)
      for (double& sum : sums_) sum += uniform_(random_);
    std::vector<float> linear;
    for (const double sum : sums_) {
      const auto value = static_cast<float>(sum / taken_);
      linear.insert(linear.end(), {value, value, value, 1});
    }
    return linear;
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{0.5, 1.5};
  std::vector<double> sums_ = std::vector<double>(10000, 0.0);
  uint32_t taken_ = 0;
};

TEST(NoiseEstimate, IsTheStandardErrorOfIndependentSamples) {
  Draws draws;
  NoiseEstimate noise;
  for (uint32_t n = 4; n <= 64; n *= 2) noise.add(n, draws.mean(n));
  // The deviation of one draw is 1 / sqrt(12), and luminance 1 counts with 1.01: 10,000 pixels give it to 0.7 %, held
  // to 4 sigma.
  EXPECT_NEAR(noise.at(64), 1 / std::sqrt(12 * 64 * 1.01), 0.028 * noise.at(64));
  EXPECT_FLOAT_EQ(noise.at(256), noise.at(64) / 2);
}

TEST(NoiseEstimate, DoesNotGrowWhereAPictureHasNoneToBeComparedWith) {
  Draws draws;
  NoiseEstimate noise;
  for (uint32_t n = 4; n <= 64; n *= 2) noise.add(n, draws.mean(n));
  const float before = noise.at(128);
  noise.forget_picture();
  noise.add(128, draws.mean(128));
  EXPECT_EQ(noise.at(128), before);
  noise.add(256, draws.mean(256));
  EXPECT_LT(noise.at(256), before);
}

}  // namespace
}  // namespace vamp
