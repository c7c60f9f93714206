#include "engine/fit/fit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "engine/fit/quality.h"
#include "engine/material/preset_tables.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

FitOptions small_options() {
  FitOptions options;
  options.clusters = 4;
  options.representatives = 3;
  options.bases = 16;
  return options;
}

TEST(Fit, MakesAMaterialThatIsValidAndNearItsMeasurement) {
  const Btf btf = test::measure(test::random_synthetic(5, 144, 8, 3), 12, 12);
  const auto result = fit_spmm(btf, small_options());
  ASSERT_TRUE(result.has_value()) << result.error().message();
  const Spmm& spmm = result->spmm;
  EXPECT_TRUE(validate(spmm, "").has_value());
  EXPECT_EQ(spmm.width, 12);
  EXPECT_FLOAT_EQ(spmm.mm_per_texel, 0.1f);
  EXPECT_LE(spmm.dictionary.size(), 16u);
  EXPECT_EQ(spmm.residual.records.size(), spmm.clusters.size() * 81 * 81);
  const auto& errors = result->report.errors;
  ASSERT_EQ(errors.size(), 6u);
  for (size_t i = 1; i < errors.size(); ++i) EXPECT_LE(errors[i], errors[i - 1]);
  EXPECT_LT(errors.back(), 0.03);
}

// What the report says is what the stored material does: the same figure through tables, halves and interpolation.
TEST(Fit, ReportsTheErrorThatTheMaterialHas) {
  const Btf btf = test::measure(test::random_synthetic(6, 144, 10, 4), 12, 12);
  FitOptions options = small_options();
  options.bases = 8;
  const auto result = fit_spmm(btf, options);
  ASSERT_TRUE(result.has_value());
  const auto quality = measure_quality(result->spmm, btf, nullptr, {});
  ASSERT_TRUE(quality.has_value()) << quality.error().message();
  for (size_t i = 0; i < result->report.errors.size(); ++i)
    EXPECT_NEAR(quality->representations[i].weighted, result->report.errors[i], 0.01 * result->report.errors[i] + 5e-4)
        << quality->representations[i].name;
}

TEST(Fit, TheCurveFallsWithFunctionsAndEndsWithAllOfThem) {
  const Btf btf = test::measure(test::random_synthetic(5, 144, 8, 3), 12, 12);
  FitOptions options = small_options();
  options.curve = true;
  const auto result = fit_spmm(btf, options);
  ASSERT_TRUE(result.has_value()) << result.error().message();
  const std::vector<CurvePoint>& curve = result->report.curve;
  ASSERT_GT(curve.size(), 6u);
  for (size_t i = 1; i < curve.size(); ++i) {
    if (curve[i].bases != curve[i - 1].bases) continue;
    EXPECT_GE(curve[i].functions, curve[i - 1].functions);
    EXPECT_LE(curve[i].error, curve[i - 1].error + 1e-9);
  }
  EXPECT_EQ(curve.back().bases, result->spmm.dictionary.size());
  EXPECT_NEAR(curve.back().error, result->report.all_functions_error, 1e-6);
}

TEST(Fit, IsTheSameForASeedWhateverTheNumberOfThreads) {
  const Btf btf = test::measure(test::random_synthetic(8, 100, 8, 3), 10, 10);
  std::vector<std::byte> first;
  for (const int threads : {1, 2, 3}) {
    FitOptions options = small_options();
    options.threads = threads;
    const auto result = fit_spmm(btf, options);
    ASSERT_TRUE(result.has_value());
    const std::vector<std::byte> bytes = encode_tables(result->spmm);
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first) << threads << " threads";
  }
}

TEST(Fit, TakesAsFewFunctionsAsTheErrorAsks) {
  const Btf btf = test::measure(test::random_synthetic(5, 64, 8, 4), 8, 8);
  FitOptions options = small_options();
  options.error = 0.2;
  const auto coarse = fit_spmm(btf, options);
  options.error = 0.05;
  const auto fine = fit_spmm(btf, options);
  ASSERT_TRUE(coarse && fine);
  EXPECT_LE(coarse->report.errors[0], 0.201);
  EXPECT_LT(coarse->report.functions_per_texel, fine->report.functions_per_texel);
}

TEST(Fit, CanGiveEachClusterFunctionsOfItsOwn) {
  const Btf btf = test::measure(test::random_synthetic(5, 64, 8, 3), 8, 8);
  FitOptions options = small_options();
  options.per_cluster = true;
  options.bases = 5;
  const auto result = fit_spmm(btf, options);
  ASSERT_TRUE(result.has_value());
  const Spmm& spmm = result->spmm;
  EXPECT_LE(spmm.dictionary.size(), 5 * spmm.clusters.size());
  std::vector<int> owner(spmm.dictionary.size(), -1);
  for (const tables::Texel& texel : spmm.texels)
    for (uint32_t i = 0; i < (texel.cluster_count >> 8 & 255u); ++i) {
      int& cluster = owner[spmm.entries[texel.first_entry + i].basis_red & 0xffffu];
      if (cluster < 0) cluster = static_cast<int>(texel.cluster_count & 255u);
      EXPECT_EQ(cluster, static_cast<int>(texel.cluster_count & 255u));
    }
}

TEST(Fit, OfOneTexelIsAMaterial) {
  const Btf btf = test::measure(test::random_synthetic(2, 1, 5, 3), 1, 1);
  const auto result = fit_spmm(btf, {});
  ASSERT_TRUE(result.has_value()) << result.error().message();
  EXPECT_EQ(result->spmm.clusters.size(), 1u);
}

TEST(Fit, LeavesRingsOutAndSaysHowTheyArePredicted) {
  const Btf btf = test::measure(test::random_synthetic(5, 64, 8, 3), 8, 8);
  FitOptions options = small_options();
  options.left_out = {45};
  const auto result = fit_spmm(btf, options);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->spmm.residual.directions.size(), 63u);
  const auto quality = measure_quality(result->spmm, btf, nullptr, {});
  ASSERT_TRUE(quality.has_value());
  ASSERT_TRUE(quality->representations[0].held_out.has_value());
  EXPECT_LT(*quality->representations[0].held_out, 0.2);
}

TEST(Fit, RefusesWhatFunctionsCannotStandFor) {
  BtfInfo info;
  info.width = info.height = 2;
  info.views = info.lights = ubo81();
  info.name = "chroma";
  info.colour = BtfColour::log_yuv;
  auto signed_values = Btf::in_memory(info);
  ASSERT_TRUE(signed_values.has_value());
  EXPECT_EQ(fit_spmm(*signed_values, {}).error().kind, ErrorKind::bad_input);
  info.colour = BtfColour::rec709;
  auto black = Btf::in_memory(info);
  EXPECT_EQ(fit_spmm(*black, {}).error().kind, ErrorKind::bad_input);
  info.views = DirectionSet{"own", {dvec3(0, 0, 1)}};
  auto one_view = Btf::in_memory(info);
  EXPECT_EQ(fit_spmm(*one_view, {}).error().kind, ErrorKind::bad_input);
  FitOptions options;
  options.clusters = 0;
  EXPECT_EQ(fit_spmm(*black, options).error().kind, ErrorKind::usage);
}

TEST(Fit, StopsWhenItIsAskedTo) {
  const Btf btf = test::measure(test::random_synthetic(5, 144, 8, 3), 12, 12);
  Progress before;
  before.cancel();
  EXPECT_EQ(fit_spmm(btf, small_options(), &before).error().kind, ErrorKind::interrupted);
  Progress during;
  std::atomic<bool> over{false};
  std::thread stopper([&] {
    while (during.stage() != "Fitting lobes" && !over) std::this_thread::yield();
    during.cancel();
  });
  const auto result = fit_spmm(btf, small_options(), &during);
  over = true;
  stopper.join();
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace vamp::fit
