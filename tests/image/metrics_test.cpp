#include "engine/image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/image/pictures.h"

namespace vamp {
namespace {

TEST(Metrics, ErrorsAreTheHandComputedOnes) {
  const std::vector<float> a = {1, 2, 3, 4};
  const std::vector<float> r = {1, 1, 5, 4};
  EXPECT_DOUBLE_EQ(rmse(a, r), std::sqrt(5.0 / 4));
  EXPECT_NEAR(rel_mse(a, r), (1 / 1.01 + 4 / 25.01) / 4, 1e-12);
  EXPECT_DOUBLE_EQ(max_error(a, r), 2.0);
  EXPECT_NEAR(psnr(a, r), -10 * std::log10(1.25), 1e-12);
  EXPECT_EQ(rmse(a, a), 0.0);
  EXPECT_TRUE(std::isinf(psnr(a, a)));
}

TEST(Metrics, RelativeErrorTakesTheSecondAsReference) {
  const std::vector<float> one = {1};
  const std::vector<float> ten = {10};
  EXPECT_NEAR(rel_mse(one, ten), 81 / 100.01, 1e-9);
  EXPECT_NEAR(rel_mse(ten, one), 81 / 1.01, 1e-9);
}

TEST(Mssim, EqualPicturesHaveOne) {
  const Image image = testing::noise_image(32, 20, {"Y"}, 1);
  EXPECT_NEAR(*mssim(image.pixels, image.pixels, 32, 20), 1.0, 1e-12);
}

TEST(Mssim, FlatPicturesKeepOnlyTheLuminanceTerm) {
  const std::vector<float> a(16 * 16, 0.25f);
  const std::vector<float> r(16 * 16, 0.75f);
  EXPECT_NEAR(*mssim(a, r, 16, 16), (2 * 0.25 * 0.75 + 1e-4) / (0.25 * 0.25 + 0.75 * 0.75 + 1e-4), 1e-9);
}

TEST(Mssim, OneWindowIsTheFormula) {
  // 11 x 11 is a single window: the weighted moments written out in full, not separably.
  const Image a = testing::noise_image(11, 11, {"Y"}, 3);
  const Image r = testing::noise_image(11, 11, {"Y"}, 4);
  double total = 0, ma = 0, mr = 0, aa = 0, rr = 0, ar = 0;
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 11; ++x) {
      const double w = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5);
      const double p = static_cast<double>(a.at(x, y, 0));
      const double q = static_cast<double>(r.at(x, y, 0));
      total += w, ma += w * p, mr += w * q, aa += w * p * p, rr += w * q * q, ar += w * p * q;
    }
  ma /= total, mr /= total, aa /= total, rr /= total, ar /= total;
  const double expected = (2 * ma * mr + 1e-4) * (2 * (ar - ma * mr) + 9e-4) /
                          ((ma * ma + mr * mr + 1e-4) * (aa - ma * ma + rr - mr * mr + 9e-4));
  EXPECT_NEAR(*mssim(a.pixels, r.pixels, 11, 11), expected, 1e-12);
}

TEST(Mssim, IsTheMeanOverAllWindowsInside) {
  const Image a = testing::noise_image(14, 13, {"Y"}, 5);
  const Image r = testing::noise_image(14, 13, {"Y"}, 6);
  double sum = 0;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      std::vector<float> pa, pr;
      for (int j = 0; j < 11; ++j)
        for (int i = 0; i < 11; ++i) {
          pa.push_back(a.at(x + i, y + j, 0));
          pr.push_back(r.at(x + i, y + j, 0));
        }
      sum += *mssim(pa, pr, 11, 11);
    }
  EXPECT_NEAR(*mssim(a.pixels, r.pixels, 14, 13), sum / 12, 1e-12);
}

TEST(Mssim, NoWindowFitsIntoTenPixels) {
  const Image image = testing::noise_image(10, 40, {"Y"}, 1);
  EXPECT_FALSE(mssim(image.pixels, image.pixels, 10, 40));
}

}  // namespace
}  // namespace vamp
