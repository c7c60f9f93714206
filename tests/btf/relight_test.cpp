// Measurements with less than a BTF: light lists, polynomial texture maps, lists of samples.
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <random>

#include "engine/btf/alta.h"
#include "engine/btf/light_list.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/ptm.h"
#include "engine/image/save.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

using ::testing::HasSubstr;

TEST(LightList, NormalisesLightsAndTakesBlanksInNames) {
  const auto images = parse_light_list("2\r\nmy icon 1.jpg 0 0 20\r\n\r\nb.jpg +3 -4.0 12e0\r\n", "a.lp");
  ASSERT_TRUE(images) << images.error().message();
  EXPECT_EQ(images->files[0], "my icon 1.jpg");
  EXPECT_EQ(images->lights[0], dvec3(0, 0, 1));
  EXPECT_LT(glm::length(images->lights[1] - dvec3(3, -4, 12) / 13.0), 1e-15);
  EXPECT_EQ(images->views.size(), 1u);
}

TEST(LightList, SaysWhatIsWrongAndWhere) {
  const auto message = [](const char* text) { return parse_light_list(text, "a.lp").error().message(); };
  EXPECT_EQ(message("2\na.jpg 0 0 1\n"), "a.lp: end: expected 2 pictures, found 1");
  EXPECT_EQ(message("1\na.jpg 0 0 1\nb.jpg 0 0 1\n"), "a.lp: line 3: expected the end after 1 pictures, found more");
  EXPECT_EQ(message("1\na.jpg 0 0\n"), "a.lp: line 2: expected a file and three numbers, found \"a.jpg 0 0\"");
  EXPECT_EQ(message("1\na.jpg 0 0 nan\n"), "a.lp: line 2: expected a file and three numbers, found \"a.jpg 0 0 nan\"");
  EXPECT_EQ(message("1\na.jpg 0 1 -0.1\n"),
            "a.lp: line 2: expected a light in front of the object (z > 0), found 0 1 -0.1");
  EXPECT_EQ(message("2\na.jpg 0 0 1\nb.jpg 0.6 0 0.5\n"),
            "a.lp: line 3: expected a unit vector, as in the other lines, found one of length 0.7810");
  EXPECT_THAT(message("a.jpg 0 0 1\n"), HasSubstr("how many pictures follow"));
  EXPECT_THAT(message(""), HasSubstr("end: expected 1 pictures, found 0"));
}

class Relight : public ::testing::Test {
 protected:
  // Four photographs of 2 x 3 pixels, each of one grey.
  std::vector<float> photographs(const std::string& prefix_in_list) {
    std::vector<float> greys = {0.1f, 0.2f, 0.4f, 0.8f};
    std::vector<std::string> names;
    std::vector<dvec3> lights;
    for (size_t i = 0; i < greys.size(); ++i) {
      Image picture(2, 3, {"R", "G", "B"});
      std::ranges::fill(picture.pixels, greys[i]);
      const std::string name = "p" + std::to_string(i) + ".exr";
      EXPECT_TRUE(save_exr(folder_ / name, picture));
      names.push_back(prefix_in_list + name);
      lights.push_back(direction_of({0.2 + 0.1 * static_cast<double>(i), 1.0}));
    }
    EXPECT_TRUE(write_light_list(folder_ / "a.lp", names, named_direction_set(lights)));
    return greys;
  }
  test::TemporaryFolder folder_;
};

TEST_F(Relight, PhotographsBecomeABtfWithOneView) {
  for (const char* prefix : {"", "./", "C:\\dome\\", "/home/somebody/"}) {
    const auto greys = photographs(prefix);
    const auto btf = load_btf(folder_ / "a.lp");
    ASSERT_TRUE(btf) << btf.error().message();
    EXPECT_TRUE(btf->info().fixed_view());
    ASSERT_EQ(btf->light_count(), greys.size());
    for (size_t l = 0; l < greys.size(); ++l) {
      EXPECT_NEAR(btf->at(5, 0, l, 2), greys[l], 1e-3);
      EXPECT_NEAR(angles_of(btf->info().lights[l]).theta, 0.2 + 0.1 * static_cast<double>(l), 1e-9);
    }
  }
}

TEST_F(Relight, AListNeverReadsOutsideItsFolder) {
  photographs("");
  ASSERT_TRUE(write_text_atomically(folder_ / "b.lp", "1\n../../../etc/passwd 0 0 1\n"));
  const auto btf = load_btf(folder_ / "b.lp");
  ASSERT_FALSE(btf);
  EXPECT_THAT(btf.error().message(), HasSubstr("expected a picture beside the list"));
}

// A BTF whose codes are a biquadratic of the light times a colour.
Btf polynomial() {
  BtfInfo info;
  info.width = 4;
  info.height = 3;
  info.views = named_direction_set({{0, 0, 1}});
  info.lights = ubo81();
  Btf btf = Btf::in_memory(info).value();
  std::vector<float> values(btf.values_per_texel());
  for (size_t t = 0; t < btf.texel_count(); ++t) {
    for (size_t l = 0; l < btf.light_count(); ++l) {
      const dvec3& w = info.lights[l];
      const double at = static_cast<double>(t) / 12;
      const double code =
          0.5 + 0.2 * at - 0.15 * w.x * w.x - 0.1 * w.y * w.y + 0.05 * w.x * w.y + at * 0.2 * w.x - 0.1 * w.y;
      const double colour[3] = {1, 0.6, 0.2 + 0.5 * at};
      for (size_t c = 0; c < 3; ++c) values[3 * l + c] = static_cast<float>(code * colour[c]);
    }
    btf.write_texel(t, values);
  }
  return btf;
}

TEST_F(Relight, APtmReproducesABiquadraticAndSurvivesItsFile) {
  const Btf btf = polynomial();
  std::vector<size_t> lights(btf.light_count());
  std::iota(lights.begin(), lights.end(), size_t{0});
  for (const bool has_luminance : {true, false}) {
    const auto ptm = fit_ptm(btf, lights, has_luminance, PictureCurve::linear);
    ASSERT_TRUE(ptm) << ptm.error().message();
    ASSERT_TRUE(write_ptm(folder_ / "a.ptm", *ptm));
    const auto read = read_ptm(folder_ / "a.ptm");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->scale, ptm->scale);
    EXPECT_EQ(read->bias, ptm->bias);
    EXPECT_EQ(read->coefficients, ptm->coefficients);
    EXPECT_EQ(read->colours, ptm->colours);
    // Eight bits a coefficient: an error of half a step of each of six, and of the colour.
    const auto shown = load_btf(folder_ / "a.ptm", {.curve = PictureCurve::linear, .output = {}});
    ASSERT_TRUE(shown) << shown.error().message();
    for (size_t t = 0; t < btf.texel_count(); ++t)
      for (size_t l = 0; l < btf.light_count(); ++l)
        for (size_t c = 0; c < 3; ++c) ASSERT_NEAR(shown->at(t, 0, l, c), btf.at(t, 0, l, c), 0.006) << t << " " << l;
  }
}

TEST_F(Relight, APtmWrittenByHandIsReadFromTheBottomUp) {
  // 1 x 2 texels; the file's first row is the lower one. Only the constant term is not zero.
  std::string text = "PTM_1.2\r\nPTM_FORMAT_LRGB\r\n1 2\r\n1 1 1 1 1 2\r\n0 0 0\r\n0 0 10\r\n";
  text += std::string("\0\0\0\0\0\x6e\0\0\0\0\0\x1e\xff\x80\0\xff\xff\xff", 18);
  ASSERT_TRUE(write_text_atomically(folder_ / "a.ptm", text));
  const auto ptm = read_ptm(folder_ / "a.ptm");
  ASSERT_TRUE(ptm) << ptm.error().message();
  EXPECT_EQ(ptm->value(0, 0, {0.3, 0.2, 0.9}), (30 - 10) * 2);
  EXPECT_EQ(ptm->value(1, 0, {0.3, 0.2, 0.9}), (110 - 10) * 2);
  EXPECT_NEAR(ptm->value(1, 1, {0, 0, 1}), 200.0 * 128 / 255, 1e-12);
}

TEST_F(Relight, TooFewLightsMakeNoPtm) {
  const Btf btf = polynomial();
  const std::vector<size_t> ring = {1, 2, 3, 4, 5, 6};
  EXPECT_FALSE(fit_ptm(btf, ring, true, PictureCurve::srgb));  // on one circle
}

constexpr const char* kAltaHead = "#SAMPLE \"tape\"\n#DIM 3 1\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n";

TEST(Alta, SamplesBecomeReflectedCos) {
  const std::string lines = "0.5 -0.6 0.8 0.2\n\n0.5 0 0 3\n0.5 1.57 0 7\n";
  const auto plain = parse_alta(std::string(kAltaHead) + "#PARAM_OUT INV_STERADIAN\n" + lines, "a.dat");
  ASSERT_TRUE(plain) << plain.error().message();
  EXPECT_EQ(plain->name, "tape");
  EXPECT_EQ(plain->left_out, 1u);
  ASSERT_EQ(plain->samples.size(), 2u);
  EXPECT_NEAR(plain->samples[0].value[1], 0.2 * std::cos(0.5), 1e-6);
  EXPECT_NEAR(plain->samples[0].wo.z, std::cos(1.0), 1e-12);
  EXPECT_NEAR(plain->samples[0].wo.x / plain->samples[0].wo.y, -0.6 / 0.8, 1e-12);
  const auto viewer = parse_alta(std::string(kAltaHead) + "#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n" + lines, "a.dat");
  ASSERT_TRUE(viewer) << viewer.error().message();
  EXPECT_NEAR(viewer->samples[0].value[2], 0.2 * std::cos(0.5) / std::cos(1.0), 1e-6);
}

TEST(Alta, SaysWhatIsWrongAndWhere) {
  const auto message = [](const std::string& text) { return parse_alta(text, "a.dat").error().message(); };
  EXPECT_THAT(message("#DIM 1 3\n"), HasSubstr("line 1: expected #DIM 3 1 or 3 3"));
  EXPECT_THAT(message("#DIM 3 1\n#PARAM_IN COS_TH\n"),
              HasSubstr("line 2: expected #PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI"));
  EXPECT_THAT(message("0 0 0 1\n"), HasSubstr("line 1: expected #DIM, #PARAM_IN and #PARAM_OUT before the samples"));
  const std::string head = std::string(kAltaHead) + "#PARAM_OUT INV_STERADIAN\n";
  EXPECT_THAT(message(head + "0 0 0 inf\n"), HasSubstr("line 5: expected three angles in radians and 1 values"));
  EXPECT_THAT(message(head + "0 0 0 1 2\n"), HasSubstr("line 5"));
  EXPECT_THAT(message(head), HasSubstr("expected samples above the horizon, found none"));
}

}  // namespace
}  // namespace vamp
