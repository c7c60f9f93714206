#include "engine/image/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "tests/image/pictures.h"

namespace vamp {
namespace {

TEST(Image, LayersAreNamedAsInOpenExr) {
  EXPECT_EQ(layer_of("R"), "");
  EXPECT_EQ(component_of("R"), "R");
  EXPECT_EQ(layer_of("light.key.R"), "light.key");
  EXPECT_EQ(component_of("light.key.R"), "R");
}

TEST(Image, AddedLayersKeepTheirValues) {
  Image image = testing::noise_image(3, 2, {"R", "G", "B"}, 1);
  const Image before = image;
  const Image depth = testing::noise_image(3, 2, {"Z"}, 2);
  add_layer(image, depth, "depth");
  EXPECT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B", "depth.Z"}));
  EXPECT_EQ(select_channels(image, before.channels).pixels, before.pixels);
  EXPECT_EQ(select_channels(image, std::vector<std::string>{"depth.Z"}).pixels, depth.pixels);
}

TEST(Image, ColourOfALayerWithoutColoursIsAnError) {
  const Image image(1, 1, {"depth.Z"});
  const auto colour = colour_of(image, "", "x.exr");
  ASSERT_FALSE(colour);
  EXPECT_EQ(colour.error().message(), "x.exr: channels: expected R, G and B or Y, found depth.Z");
}

TEST(Image, TheFirstBadValueIsNamedWithItsPlace) {
  Image image(3, 2, {"R", "G"});
  EXPECT_FALSE(first_not_finite(image));
  image.at(2, 1, 1) = -std::numeric_limits<float>::infinity();
  ASSERT_TRUE(first_not_finite(image));
  EXPECT_EQ(first_not_finite(image)->first, "pixel (2, 1), channel G");
  EXPECT_EQ(first_not_finite(image)->second, "-infinity");
}

TEST(Downsample, AveragesWholeBlocks) {
  Image image(4, 2, {"Y"});
  image.pixels = {1, 3, 10, 20, 5, 7, 30, 40};
  const Image small = downsampled(image, 2, 1);
  EXPECT_EQ(small.pixels, (std::vector<float>{4, 25}));
}

TEST(Downsample, SplitsPixelsThatLieOnABorder) {
  Image image(3, 1, {"Y"});
  image.pixels = {3, 6, 9};
  const Image small = downsampled(image, 2, 1);
  EXPECT_NEAR(small.pixels[0], (3 + 0.5 * 6) / 1.5, 1e-6);
  EXPECT_NEAR(small.pixels[1], (0.5 * 6 + 9) / 1.5, 1e-6);
}

TEST(Downsample, KeepsTheMeanAtAnySize) {
  const Image image = testing::noise_image(37, 23, {"R", "A"}, 7);
  const auto mean = [](const Image& i) {
    return std::accumulate(i.pixels.begin(), i.pixels.end(), 0.0) / static_cast<double>(i.pixels.size());
  };
  for (const auto& [w, h] : {std::pair(37, 23), std::pair(36, 22), std::pair(11, 5), std::pair(1, 1), std::pair(37, 1)})
    EXPECT_NEAR(mean(downsampled(image, w, h)), mean(image), 1e-6) << w << " x " << h;
  EXPECT_EQ(downsampled(image, 37, 23).pixels, image.pixels);
}

TEST(Downsample, SizesKeepTheirShape) {
  EXPECT_EQ(size_within(1920, 1080, 256), std::pair(256, 144));
  EXPECT_EQ(size_within(100, 50, 256), std::pair(100, 50));
  EXPECT_EQ(size_within(16384, 1, 256), std::pair(256, 1));
}

}  // namespace
}  // namespace vamp
