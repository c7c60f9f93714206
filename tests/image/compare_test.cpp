#include "engine/image/compare.h"

#include <gtest/gtest.h>

#include "engine/core/json.h"
#include "engine/image/save.h"
#include "tests/image/pictures.h"

namespace vamp {
namespace {

using testing::noise_image;

TEST(Compare, EqualPicturesHaveNoError) {
  const Image image = noise_image(16, 16, {"R", "G", "B", "A", "depth.Z"}, 1);
  const auto report = compare_images(image, image, {}, "a", "b");
  ASSERT_TRUE(report);
  ASSERT_EQ(report->sets.size(), 3u);
  EXPECT_EQ(report->sets[0].name, "colour");
  EXPECT_EQ(report->sets[1].name, "alpha");
  EXPECT_EQ(report->sets[2].name, "depth");
  for (const auto& set : report->sets) {
    EXPECT_TRUE(set.equal);
    EXPECT_EQ(set.rmse, 0.0);
    EXPECT_FALSE(set.psnr);
  }
  EXPECT_NEAR(*report->sets[0].mssim, 1.0, 1e-12);
  EXPECT_FALSE(report->sets[2].mssim);
}

TEST(Compare, ErrorsAreOfTheLinearValues) {
  Image a(12, 12, {"R", "G", "B"});
  Image b = a;
  std::fill(a.pixels.begin(), a.pixels.end(), 2.5f);
  std::fill(b.pixels.begin(), b.pixels.end(), 2.0f);
  const auto report = compare_images(a, b, {}, "a", "b");
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->sets[0].rmse, 0.5, 1e-12);
  EXPECT_NEAR(report->sets[0].rel_mse, 0.25 / 4.01, 1e-12);
  EXPECT_FALSE(report->sets[0].equal);
  EXPECT_GT(*report->sets[0].psnr, 20.0);
}

TEST(Compare, SizesMustMatch) {
  const auto report = compare_images(Image(2, 3, {"Y"}), Image(3, 2, {"Y"}), {}, "a.exr", "b.exr");
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::bad_input);
  EXPECT_EQ(report.error().message(), "a.exr: size: expected 3 x 2 as in b.exr, found 2 x 3");
}

TEST(Compare, ChannelsOfOneAloneAreListed) {
  const auto report =
      compare_images(Image(1, 1, {"R", "G", "B", "A"}), Image(1, 1, {"R", "G", "B", "depth.Z"}), {}, "", "");
  ASSERT_TRUE(report);
  EXPECT_EQ(report->only_in_a, std::vector<std::string>{"A"});
  EXPECT_EQ(report->only_in_b, std::vector<std::string>{"depth.Z"});
  EXPECT_FALSE(compare_images(Image(1, 1, {"Z"}), Image(1, 1, {"Y"}), {}, "", ""));
}

TEST(Compare, FilesAreToldApartByKind) {
  const testing::TemporaryFolder folder;
  const Image image = noise_image(16, 16, {"R", "G", "B"}, 1);
  ASSERT_TRUE(save_png(folder.path() / "a.png", image));
  ASSERT_TRUE(save_exr(folder.path() / "a.exr", image));
  const auto same = compare_files(folder.path() / "a.png", folder.path() / "a.png");
  ASSERT_TRUE(same);
  EXPECT_EQ(same->display.curve, ToneCurve::linear);
  EXPECT_EQ(compare_files(folder.path() / "a.exr", folder.path() / "a.exr")->display.curve, ToneCurve::neutral);
  const auto mixed = compare_files(folder.path() / "a.png", folder.path() / "a.exr");
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().kind, ErrorKind::bad_input);
  EXPECT_EQ(compare_files(folder.path() / "none.png", folder.path() / "a.exr").error().kind, ErrorKind::bad_input);
}

TEST(Compare, JsonCanBeRead) {
  const Image a = noise_image(16, 16, {"R", "G", "B"}, 1);
  const Image b = noise_image(16, 16, {"R", "G", "B"}, 2);
  const auto json = parse_json(compare_json(*compare_images(a, b, {}, "a", "b")), "report");
  ASSERT_TRUE(json);
  EXPECT_TRUE(json->at("rmse").is_number_float());
  EXPECT_FALSE(json->at("equal").get<bool>());
  const auto equal = parse_json(compare_json(*compare_images(a, a, {}, "a", "b")), "report");
  EXPECT_TRUE(equal->at("equal").get<bool>());
  EXPECT_TRUE(equal->at("psnr").is_null());
}

}  // namespace
}  // namespace vamp
