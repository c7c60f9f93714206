// Measurements from other laboratories, found through VAMP_TEST_DATA.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>

#include "engine/btf/alta.h"
#include "engine/btf/cursor.h"
#include "engine/btf/light_list.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/ptm.h"
#include "engine/btf/sparse_btf.h"
#include "engine/image/metrics.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

class RealData : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* root = std::getenv("VAMP_TEST_DATA");
    if (root == nullptr) GTEST_SKIP() << "VAMP_TEST_DATA names no folder of measurements";
    data_ = root;
  }
  fs::path sparse(const std::string& name) const {
    return data_ / "btf-ubo2014-chroma" / ("Coeffs_BTF_" + name + "_1e-05_U.bin");
  }
  fs::path data_;
  test::TemporaryFolder folder_;
};

TEST_F(RealData, TheDirectionsOfUbo2014AreThoseOfTheDome) {
  // Three rows of 151 doubles: azimuth, elevation, and the number of a patch.
  const auto bytes = read_file(data_ / "btf-ubo2014-chroma/bonn_angles.bin", 1 << 20);
  ASSERT_TRUE(bytes);
  Cursor cursor(*bytes, "bonn_angles.bin");
  std::vector<double> phi(151), elevation(151);
  for (double& value : phi) value = cursor.number<double>("phi");
  for (double& value : elevation) value = cursor.number<double>("elevation");
  const DirectionSet dome = dome151();
  for (size_t i = 0; i < 151; ++i)
    EXPECT_LT(glm::length(direction_of({1.5707963267948966 - elevation[i], phi[i]}) - dome[i]), 1e-3) << i;
}

TEST_F(RealData, SparseDictionariesAreOrthonormal) {
  const auto felt = read_sparse_btf(sparse("felt05"));
  ASSERT_TRUE(felt) << felt.error().message();
  const SparseChannel& channel = *felt->channels[1];
  ASSERT_EQ(channel.rows.size(), 8u);
  for (size_t dictionary = 0; dictionary < 8; ++dictionary)
    for (size_t axis = 0; axis < 4; ++axis)
      for (size_t a = 0; a < channel.size[axis]; a += 7)
        for (size_t b = 0; b < channel.size[axis]; b += 5) {
          double product = 0;
          for (size_t i = 0; i < channel.size[axis]; ++i)
            product += double{channel.row(dictionary, axis, a)[i]} * double{channel.row(dictionary, axis, b)[i]};
          EXPECT_NEAR(product, a == b ? 1 : 0, 2e-3);
        }
}

TEST_F(RealData, FeltAndCarpetSurviveAsDfmfWithEveryBitOfTheirFactors) {
  for (const char* name : {"felt05", "carpet07"}) {
    SCOPED_TRACE(name);
    const auto material = read_sparse_btf(sparse(name));
    ASSERT_TRUE(material) << material.error().message();
    EXPECT_THAT(material->info.provenance, ::testing::HasSubstr("channel Y absent, filled with zeros"));
    // A part that cuts through patches.
    const TexelRect part{195, 203, 8, 9};
    const FactoredBtf factors = factored(*material, part);
    ASSERT_TRUE(write_factored_btf(folder_ / "a.btf", factors));
    const auto read = read_factored_btf(folder_ / "a.btf");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->info.colour, BtfColour::log_yuv);
    EXPECT_EQ(read->info.views.name, "dome151");
    EXPECT_EQ(read->info.provenance, material->info.provenance);
    ASSERT_EQ(read->factors.size(), 3u);
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(read->factors[c].s, factors.factors[c].s);
      EXPECT_EQ(read->factors[c].u, factors.factors[c].u);
      EXPECT_EQ(read->factors[c].sxv, factors.factors[c].sxv);
    }
    // And the products are the values.
    Btf direct = Btf::in_memory(info_of(*material, part)).value();
    ASSERT_TRUE(decode(*material, part, direct));
    Btf through = Btf::in_memory(read->info).value();
    ASSERT_TRUE(decode(*read, through, "a.btf"));
    double energy = 0, error = 0;
    for (size_t t = 0; t < direct.texel_count(); ++t)
      for (size_t d = 0; d < direct.view_count() * direct.light_count(); ++d)
        for (size_t c = 0; c < 3; ++c) {
          const double expected = double{float_from_half(direct.texel(t)[3 * d + c])};
          const double found = double{float_from_half(through.texel(t)[3 * d + c])};
          energy += expected * expected;
          error += (found - expected) * (found - expected);
          ASSERT_TRUE(c != 0 || expected == 0);
        }
    EXPECT_GT(energy, 0);
    EXPECT_LT(std::sqrt(error / energy), 2e-4);  // halfs round to 2^-11
  }
}

TEST_F(RealData, APartOfASparseMaterialIsThatPartOfTheWhole) {
  const auto felt = read_sparse_btf(sparse("felt05"));
  ASSERT_TRUE(felt) << felt.error().message();
  const TexelRect large{385, 380, 15, 20}, small{391, 388, 4, 3};
  Btf whole = Btf::in_memory(info_of(*felt, large)).value(), part = Btf::in_memory(info_of(*felt, small)).value();
  ASSERT_TRUE(decode(*felt, large, whole));
  ASSERT_TRUE(decode(*felt, small, part));
  for (uint32_t y = 0; y < small.height; ++y)
    for (uint32_t x = 0; x < small.width; ++x)
      EXPECT_TRUE(std::ranges::equal(part.texel(y * small.width + x),
                                     whole.texel((y + small.y - large.y) * large.width + x + small.x - large.x)));
}

TEST_F(RealData, ThePhotographsOfTheIconAreReadAndAPtmOf54LightsPredictsTheOther18) {
  const auto icon = load_btf(data_ / "rti-icon/exampledataset/dirs.lp");
  ASSERT_TRUE(icon) << icon.error().message();
  EXPECT_EQ(icon->info().width, 402u);
  EXPECT_EQ(icon->info().height, 395u);
  EXPECT_EQ(icon->light_count(), 72u);
  EXPECT_TRUE(icon->info().fixed_view());
  std::vector<size_t> fitted, held_out;
  for (size_t l = 0; l < 72; ++l) (l % 4 == 3 ? held_out : fitted).push_back(l);
  const auto ptm = fit_ptm(*icon, fitted, true, PictureCurve::srgb);
  ASSERT_TRUE(ptm) << ptm.error().message();
  // PSNR of what a display shows, against the mean of the 54 photographs as the guess of one who knows no light.
  double of_ptm = 0, of_mean = 0;
  size_t count = 0;
  for (size_t t = 0; t < icon->texel_count(); t += 13)
    for (size_t c = 0; c < 3; ++c) {
      const auto code = [&](size_t light) {
        const double linear = double{icon->at(t, 0, light, c)};
        return 255 * (linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
      };
      double mean = 0;
      for (const size_t light : fitted) mean += code(light) / static_cast<double>(fitted.size());
      for (const size_t light : held_out) {
        const double shown = std::clamp(ptm->value(t, c, icon->info().lights[light]), 0.0, 255.0);
        of_ptm += std::pow(shown - code(light), 2);
        of_mean += std::pow(mean - code(light), 2);
        ++count;
      }
    }
  const auto psnr_of = [&](double sum) { return 10 * std::log10(255.0 * 255.0 * static_cast<double>(count) / sum); };
  RecordProperty("psnr_ptm", std::to_string(psnr_of(of_ptm)));
  std::printf("PSNR of 18 held-out lights: PTM %.2f dB, mean photograph %.2f dB\n", psnr_of(of_ptm), psnr_of(of_mean));
  EXPECT_GT(psnr_of(of_ptm), psnr_of(of_mean) + 2);
}

TEST_F(RealData, TheTapeSendsLightBackToWhereItCameFrom) {
  const auto tape = read_alta(data_ / "brdf-raw/retro-3M-jaune.dat");
  ASSERT_TRUE(tape) << tape.error().message();
  EXPECT_EQ(tape->name, "3M Yellow");
  EXPECT_EQ(tape->samples.size() + tape->left_out, 7397u);
  // Of all samples under light from 30 degrees the brightest is seen from within 5 degrees of the light.
  const BrdfSample* brightest = nullptr;
  for (const BrdfSample& sample : tape->samples)
    if (std::abs(std::acos(sample.wi.z) - 0.5236) < 1e-3 &&
        (brightest == nullptr || sample.value[0] > brightest->value[0]))
      brightest = &sample;
  ASSERT_NE(brightest, nullptr);
  EXPECT_GT(glm::dot(brightest->wi, brightest->wo), std::cos(0.0873));
}

}  // namespace
}  // namespace vamp
