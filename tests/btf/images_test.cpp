// Folders of pictures: any order of names and files, one picture a pair, all values back.
#include <gmock/gmock.h>

#include <random>

#include "engine/btf/image_folder.h"
#include "engine/btf/image_names.h"
#include "engine/btf/load_btf.h"
#include "engine/image/save.h"
#include "tests/btf/small_btf.h"
#include "tests/image/encoders.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

using ::testing::HasSubstr;

TEST(ImageNames, AreReadAsBothLaboratoriesWriteThem) {
  for (const char* name : {"00008 tl015 pl060 tv030 pv018.jpg", "tl015_pl060_tv030_pv018.png",
                           "tv30_pv18_tl15_pl60.exr", "tv030 pv018 tl015.0 pl60.jpg"}) {
    const auto angles = image_angles(name);
    ASSERT_TRUE(angles) << name;
    EXPECT_EQ(angles->light_theta, 15);
    EXPECT_EQ(angles->light_phi, 60);
    EXPECT_EQ(angles->view_theta, 30);
    EXPECT_EQ(angles->view_phi, 18);
  }
  EXPECT_EQ(image_angles("tl7.5_pl0_tv22.75_pv1.exr")->view_theta, 22.75);
  for (const char* name : {"tl015 pl060 tv030.jpg", "title 0 plane 1 tvset 2 pv 3.jpg", "readme.txt", ""})
    EXPECT_FALSE(image_angles(name)) << name;
}

TEST(ImageNames, StandardDirectionsGiveTheNamesOfUtia) {
  const DirectionSet ubo = ubo81(), dome = dome151();
  EXPECT_EQ(image_name(ubo[0], ubo[40]), "tl000_pl000_tv060_pv054");
  EXPECT_EQ(image_name(dome[7], dome[1]), "tl023.5_pl000_tv011_pv015");
  for (const DirectionSet& set : {ubo, dome})
    for (const dvec3& direction : set.directions) {
      const auto angles = image_angles(image_name(direction, set[0]) + ".png");
      const double degree = 0.017453292519943295;
      EXPECT_LT(glm::length(direction_of({angles->light_theta * degree, angles->light_phi * degree}) - direction),
                1e-6);
    }
}

class Images : public ::testing::Test {
 protected:
  // 3 x 2 texels, 3 views, 4 lights.
  static BtfInfo info() {
    BtfInfo info = test::small_info();
    info.width = 3;
    info.height = 2;
    info.views = named_direction_set({direction_of({0, 0}), direction_of({0.5, 0}), direction_of({0.5, 2})});
    info.lights = info.views;
    return info;
  }
  static Btf small() {
    Btf btf = Btf::in_memory(info()).value();
    std::mt19937 random(5);
    for (size_t t = 0; t < btf.texel_count(); ++t)
      for (Half& value : btf.writable_texel(t)) value = half_from_float(static_cast<float>(random() % 4096) / 1024);
    return btf;
  }
  Error refused(const fs::path& path) {
    const auto loaded = load_btf(path);
    EXPECT_FALSE(loaded);
    return loaded ? Error{} : loaded.error();
  }
  test::TemporaryFolder folder_;
};

TEST_F(Images, OpenExrFoldersKeepEveryValue) {
  const Btf btf = small();
  ASSERT_TRUE(write_images(btf, folder_ / "felt", PictureFormat::exr));
  const auto read = load_btf(folder_ / "felt");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->info().name, "felt");
  EXPECT_EQ(read->info().mm_per_texel, 0);
  ASSERT_EQ(read->texel_count(), btf.texel_count());
  for (size_t t = 0; t < btf.texel_count(); ++t) ASSERT_TRUE(std::ranges::equal(read->texel(t), btf.texel(t))) << t;
}

TEST_F(Images, FilesMayLieInSubfoldersBesideOthersUnderAnyNumber) {
  const Btf btf = small();
  ASSERT_TRUE(write_images(btf, folder_ / "a", PictureFormat::exr));
  // As UBO2003: a folder a view, running numbers, blanks.
  int number = 9999;
  for (const auto& entry : fs::directory_iterator(folder_ / "a")) {
    const std::string name = entry.path().stem().string();
    const size_t view = name.find("_tv");
    std::string words = std::to_string(number--) + " " + name.substr(0, view) + " " + name.substr(view + 1) + ".exr";
    std::ranges::replace(words, '_', ' ');
    const fs::path target = folder_ / "b" / name.substr(view + 1);
    fs::create_directories(target);
    fs::rename(entry.path(), target / words);
  }
  ASSERT_TRUE(write_text_atomically(folder_ / "b" / "readme.txt", "tl000 pl000 tv000 pv000"));
  const auto read = load_btf(folder_ / "b");
  ASSERT_TRUE(read) << read.error().message();
  for (size_t t = 0; t < btf.texel_count(); ++t) ASSERT_TRUE(std::ranges::equal(read->texel(t), btf.texel(t))) << t;
}

TEST_F(Images, CodesOfJpegAndPngAreReadByTheCurveThatIsAskedFor) {
  const Image grey(3, 2, {"R", "G", "B"});
  Image picture = grey;
  std::ranges::fill(picture.pixels, 0.5f);
  ASSERT_TRUE(save_png(folder_ / "tl0_pl0_tv0_pv0.png", picture, {.space = ColourSpace::linear}));
  const auto value = [&](PictureCurve curve) {
    return load_btf(folder_.path(), {.curve = curve, .output = {}}).value().at(0, 0, 0, 0);
  };
  // Code 128 of 255.
  EXPECT_NEAR(value(PictureCurve::linear), 0.50196, 3e-4);
  EXPECT_NEAR(value(PictureCurve::srgb), 0.21586, 2e-4);
  EXPECT_NEAR(value(PictureCurve::gamma22), 0.21952, 2e-4);
}

TEST_F(Images, JpegFilesAreRead) {
  const auto bytes = testing::oiio_encoded("jpeg", OIIO::ImageSpec(16, 16, 3, OIIO::TypeDesc::FLOAT),
                                           std::vector<float>(16 * 16 * 3, 0.5f));
  ASSERT_TRUE(write_file_atomically(folder_ / "00001 tl000 pl000 tv000 pv000.jpg", bytes));
  const auto btf = load_btf(folder_.path());
  ASSERT_TRUE(btf) << btf.error().message();
  EXPECT_NEAR(btf->at(0, 0, 0, 1), 0.2159, 0.01);
}

TEST_F(Images, XyzOfOpenExrBecomesRec709) {
  // The white of D65 is (1, 1, 1).
  Image xyz(2, 2, {"X", "Y", "Z"});
  for (size_t i = 0; i < xyz.pixels.size(); i += 3)
    xyz.pixels[i] = 0.95047f, xyz.pixels[i + 1] = 1, xyz.pixels[i + 2] = 1.08883f;
  ASSERT_TRUE(save_exr(folder_ / "tl000_pl000_tv000_pv000.exr", xyz));
  const auto btf = load_btf(folder_.path());
  ASSERT_TRUE(btf) << btf.error().message();
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(btf->at(3, 0, 0, c), 1, 1e-3);
}

TEST_F(Images, APairThatIsMissingOrThereTwiceIsNamed) {
  ASSERT_TRUE(write_images(small(), folder_ / "a", PictureFormat::exr));
  const fs::path one = folder_ / "a" / (image_name(info().lights[1], info().views[2]) + ".exr");
  fs::copy_file(one, folder_ / "a" / "tl028.6479_pl0.0_tv028.6479_pv114.5916.exr");
  EXPECT_THAT(refused(folder_ / "a").message(),
              HasSubstr("light 28.6479 0, view 28.6479 114.5916: expected one picture"));
  fs::remove(folder_ / "a" / "tl028.6479_pl0.0_tv028.6479_pv114.5916.exr");
  fs::remove(one);
  EXPECT_THAT(refused(folder_ / "a").message(),
              HasSubstr("expected a picture for each of 3 views and 3 lights, found none among 8"));
}

TEST_F(Images, OneOfAnotherSizeIsNamed) {
  ASSERT_TRUE(write_images(small(), folder_ / "a", PictureFormat::exr));
  const fs::path one = folder_ / "a" / (image_name(info().lights[1], info().views[2]) + ".exr");
  ASSERT_TRUE(save_exr(one, Image(4, 2, {"R", "G", "B"})));
  const Error error = refused(folder_ / "a");
  EXPECT_EQ(error.file, one.string());
  EXPECT_EQ(error.expected, "3 x 2");
  EXPECT_EQ(error.found, "4 x 2");
}

TEST_F(Images, AFolderWithoutPicturesSaysWhatItLookedFor) {
  EXPECT_THAT(refused(folder_.path()).message(), HasSubstr("tl000_pl000_tv000_pv000"));
}

TEST_F(Images, FoldersWithFilesInThemAreNotWrittenTo) {
  ASSERT_TRUE(write_text_atomically(folder_ / "mine.txt", "x"));
  EXPECT_FALSE(write_images(small(), folder_.path(), PictureFormat::png));
}

}  // namespace
}  // namespace vamp
