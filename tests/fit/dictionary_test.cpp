#include "engine/fit/dictionary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/brdf/registry.h"
#include "engine/fit/measurement.h"
#include "engine/fit/names.h"
#include "engine/material/directions.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

Basis lobe(Model model, std::initializer_list<std::pair<size_t, float>> params, double tilt = 0) {
  Basis basis;
  basis.lobe = default_lobe(model);
  for (const auto& [slot, value] : params) basis.lobe.params[slot] = value;
  basis.normal = vec3(static_cast<float>(std::sin(tilt)), 0, static_cast<float>(std::cos(tilt)));
  return basis;
}

TEST(Guard, RefusesWhatIsBrightBetweenTheSamplesOnly) {
  const Pairs pairs = {ubo2003_directions(), ubo2003_directions()};
  EXPECT_FALSE(explodes(lobe(Model::lambert, {}), pairs, 1.5));
  EXPECT_FALSE(explodes(lobe(Model::cook_torrance, {{1, 0.3f}}), pairs, 1.5));
  // A highlight of 2 degrees whose mirror directions miss all that was measured.
  Basis needle = lobe(Model::ward, {{1, 0.01f}, {2, 0.01f}}, 0.065);
  needle.normal = vec3(0.03f, 0.057f, std::sqrt(1 - 0.03f * 0.03f - 0.057f * 0.057f));
  EXPECT_TRUE(explodes(needle, pairs, 1.5));
}

TEST(Parameters, AreReadBackAsTheyWereWritten) {
  std::mt19937 random(3);
  const LobeLimits limits;
  for (const Basis& basis : test::random_dictionary(random, 28)) {
    const ParameterVector p = parameters_of(basis, limits);
    const Basis back = basis_of(basis.lobe.model, p.value.data(), limits);
    for (size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(back.lobe.params[i], basis.lobe.params[i], 1e-4f * std::abs(basis.lobe.params[i]) + 1e-6f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(back.normal[i], basis.normal[i], 1e-5f);
  }
}

// Not even where directions are measured so densely that they would tell any lobe apart.
TEST(Parameters, NeverLeaveTheirRange) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-20, 20);
  for (int i = 0; i < 700; ++i) {
    const LobeLimits limits = i % 2 == 0 ? LobeLimits() : LobeLimits::for_spacing(1e-4);
    std::array<double, kMaxParameters> wild;
    for (double& value : wild) value = uniform(random);
    const Basis basis = basis_of(static_cast<Model>(i % kModelCount), wild.data(), limits);
    EXPECT_TRUE(validate(basis.lobe, "", "").has_value());
    EXPECT_GE(basis.normal.z, std::cos(limits.max_tilt) - 1e-4);
    EXPECT_NEAR(basis.normal.x * basis.normal.x + basis.normal.y * basis.normal.y + basis.normal.z * basis.normal.z, 1,
                1e-5);
  }
}

TEST(Dictionary, OfRepeatsKeepsOne) {
  const test::Synthetic truth = test::random_synthetic(9, 8, 6, 3);
  const Btf btf = test::measure(truth, 8, 1);
  const Measurement measurement(btf);
  Exemplars exemplars{&measurement.pairs(), &measurement.roots(), LobeLimits(), Rows(8, measurement.values())};
  for (size_t t = 0; t < 8; ++t) measurement.read(t, exemplars.rows.row(t));
  // More than are compared at a time.
  std::vector<Basis> often;
  for (int i = 0; i < 20; ++i) often.insert(often.end(), truth.dictionary.begin(), truth.dictionary.end());
  for (int threads = 1; threads <= 2; ++threads)
    EXPECT_EQ(without_repeats(often, exemplars, 1.5, {threads}), truth.dictionary);
}

TEST(Names, AreUniqueAndSayWhatAFunctionLooksLike) {
  std::vector<Basis> bases = {
      lobe(Model::lambert, {}), lobe(Model::lambert, {}), lobe(Model::ward, {{1, 0.15f}, {2, 0.5f}}, 0.4),
      lobe(Model::cook_torrance, {{1, 0.2f}, {2, 0.05f}}), lobe(Model::cook_torrance, {{1, 1.f}})};
  name_functions(bases, LobeLimits());
  EXPECT_EQ(bases[0].name, "matte");
  EXPECT_EQ(bases[1].name, "matte 2");
  EXPECT_EQ(bases[2].name, "satin sheen, leaning right");
  EXPECT_EQ(bases[3].name, "satin coat");
  EXPECT_EQ(bases[4].name, "filler");
  const auto clusters = name_clusters({{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}, {0.12f, 0.06f, 0.03f}, {0, 0, 0.2f}});
  EXPECT_EQ(clusters[1].name, "light grey 2");
  EXPECT_EQ(clusters[2].name, "dark brown");
  EXPECT_EQ(clusters[3].name, "very dark blue");
}

}  // namespace
}  // namespace vamp::fit
