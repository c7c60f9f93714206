// What ships in presets/: that they load, are rich enough to edit, and keep energy.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "engine/core/files.h"
#include "engine/image/load.h"
#include "engine/material/preset.h"
#include "engine/material/tables.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

class ShippedPreset : public testing::TestWithParam<const char*> {
 protected:
  fs::path path() const { return fs::path("presets") / (std::string(GetParam()) + ".vamp"); }
};

TEST_P(ShippedPreset, IsRichEnoughToEdit) {
  const auto preset = load_preset(path());
  ASSERT_TRUE(preset) << preset.error().message();
  const Spmm& fit = *preset->fit;
  EXPECT_GE(fit.width, 128);
  EXPECT_EQ(fit.height, fit.width);
  EXPECT_GE(fit.size_mm().x, 12);  // less would repeat too often
  EXPECT_EQ(preset->edits, EditLayer{});
  EXPECT_FALSE(preset->licence.empty());
  EXPECT_FALSE(preset->provenance.empty());

  std::set<uint32_t> clusters, models, tilted;
  for (const auto& texel : fit.texels) clusters.insert(texel.cluster_count & 0xffu);
  for (const auto& entry : fit.entries) {
    const Basis& basis = fit.dictionary[entry.basis_red & 0xffffu];
    models.insert(static_cast<uint32_t>(basis.lobe.model));
    if (basis.normal.z < 0.99f) tilted.insert(entry.basis_red & 0xffffu);
  }
  EXPECT_GE(clusters.size(), 8u);
  EXPECT_EQ(clusters.size(), fit.clusters.size());  // none is empty
  EXPECT_GE(fit.dictionary.size(), 8u);
  EXPECT_LE(fit.dictionary.size(), 32u);
  // Patent leather is nearly flat and has one finish.
  if (GetParam() != std::string_view("patent")) {
    EXPECT_GE(models.size(), 4u);
    EXPECT_GE(tilted.size(), 6u);
    EXPECT_GE(fit.dictionary.size(), 16u);
  }
  EXPECT_EQ(fit.residual.directions.size(), 81u);
  EXPECT_EQ(fit.residual.terms, 4);
  EXPECT_EQ(fit.residual.records.size(), fit.clusters.size() * 81 * 81);

  std::set<std::string> names;
  for (const Basis& basis : fit.dictionary) names.insert(basis.name);
  EXPECT_EQ(names.size(), fit.dictionary.size());
  names.clear();
  for (const Cluster& cluster : fit.clusters) names.insert(cluster.name);
  EXPECT_EQ(names.size(), fit.clusters.size());
}

TEST_P(ShippedPreset, IsSmall) {
  EXPECT_LE(fs::file_size(path()), uintmax_t{4} << 20);
  EXPECT_LE(bytes_on_gpu(*load_preset(path()).value().fit), uint64_t{12} << 20);
}

TEST_P(ShippedPreset, HasAThumbnail) {
  const auto info = load_preset_info(path());
  ASSERT_TRUE(info) << info.error().message();
  const auto image = decode_image(info->thumbnail_png, "thumbnail");
  ASSERT_TRUE(image) << image.error().message();
  EXPECT_EQ(image->width, 256);
  EXPECT_EQ(image->height, 256);
}

TEST_P(ShippedPreset, NeverReflectsMoreThanArrivesAndHardlyLessThanNothing) {
  const Preset preset = load_preset(path()).value();
  const Spmm& fit = *preset.fit;
  const DirectionTables directions = triangulate(fit.residual.directions, "t").value();
  const EditedTables tables = edited_tables(fit, {});
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0, 1);
  double below = 0, all = 0;  // light, of all viewers; what is below zero is a residual that overshoots
  for (const double degrees : {0.0, 30.0, 60.0, 80.0, 88.0}) {
    const double t = degrees * std::numbers::pi / 180;
    dvec3 sum(0);
    constexpr int kSamples = 6000;
    for (int i = 0; i < kSamples; ++i) {
      const double turn = 2 * std::numbers::pi * uniform(random);
      const dvec3 wi = test::random_direction(random);
      const dvec3 wo(std::sin(t) * std::cos(turn), std::sin(t) * std::sin(turn), std::cos(t));
      const dvec3 value = evaluate(fit, tables, 4, directions, static_cast<int>(uniform(random) * fit.width),
                                   static_cast<int>(uniform(random) * fit.height), wi, wo);
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(value[c]));
      sum += value * (2 * std::numbers::pi);
      for (int c = 0; c < 3; ++c) {
        below += std::max(-value[c], 0.0);
        all += value[c];
      }
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(sum[c] / kSamples, 1) << degrees << " degrees";
      EXPECT_GT(sum[c] / kSamples, 0.02) << degrees << " degrees";
    }
  }
  // Most in glossy ones, whose highlights are narrower than the measured directions are apart.
  EXPECT_LT(below, 0.05 * all);
}

TEST_P(ShippedPreset, RepeatsWithoutASeam) {
  // Weights of texels across the border differ no more than those of neighbours inside do.
  const Preset preset = load_preset(path()).value();
  const Spmm& fit = *preset.fit;
  const DirectionTables directions = triangulate(fit.residual.directions, "t").value();
  const EditedTables tables = edited_tables(fit, {});
  const auto value = [&](int x, int y) {
    return evaluate(fit, tables, 4, directions, x, y, {0.3, 0.2, std::sqrt(0.87)}, {0, 0, 1}).y;
  };
  const int side = fit.width;
  const auto step = [&](int x, bool across) {
    double sum = 0;
    for (int i = 0; i < side; ++i)
      sum += std::abs(across ? value(x % side, i) - value((x + 1) % side, i)
                             : value(i, x % side) - value(i, (x + 1) % side));
    return sum;
  };
  for (const bool across : {false, true}) {
    double inside = 0;
    for (int x = 0; x < side - 1; ++x) inside = std::max(inside, step(x, across));
    EXPECT_LE(step(side - 1, across), 1.1 * inside);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedPreset,
                         testing::Values("calf", "patent", "nubuck", "suede", "crocodile", "perforated", "twill",
                                         "denim", "canvas", "corduroy", "felt", "air-mesh"),
                         [](const auto& preset) {
                           std::string name = preset.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace vamp
