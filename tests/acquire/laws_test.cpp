// What must hold of any goniometer (algorithms.md, section 9). Statistical tests state how far off the mean they allow;
// seeds are fixed.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/acquire/goniometer.h"
#include "engine/acquire/structure.h"
#include "engine/core/direction_set.h"
#include "tests/acquire/shapes.h"

namespace vamp::acquire {
namespace {

constexpr double kPi = std::numbers::pi;
using test::towards;

std::vector<vec3> all_lights() {
  std::vector<vec3> lights;
  for (const dvec3& direction : ubo81().directions) lights.emplace_back(direction);
  return lights;
}

// Mean radiance over the period of `paths` paths for each light, and the variance of that mean. Channel by channel.
struct Mean {
  std::vector<double> value, variance;
};
Mean mean_radiance(const Goniometer& goniometer, vec3 view, int paths, uint64_t seed) {
  std::vector<float> radiance(3 * goniometer.light_count());
  std::vector<double> sum(radiance.size()), square(radiance.size());
  for (int i = 0; i < paths; ++i) {
    Random random(hash_bits(seed, static_cast<uint64_t>(i)));
    std::fill(radiance.begin(), radiance.end(), 0.0f);
    goniometer.trace({random.next(), random.next()}, view, random, radiance);
    for (size_t k = 0; k < radiance.size(); ++k) {
      sum[k] += static_cast<double>(radiance[k]);
      square[k] += static_cast<double>(radiance[k]) * static_cast<double>(radiance[k]);
    }
  }
  Mean mean{sum, square};
  for (size_t k = 0; k < radiance.size(); ++k) {
    mean.value[k] = sum[k] / paths;
    mean.variance[k] = std::max(0.0, square[k] / paths - mean.value[k] * mean.value[k]) / paths;
  }
  return mean;
}

TEST(Goniometer, FlatLambertPlaneSendsAlbedoTimesCosineOverPi) {
  const std::vector<vec3> lights = all_lights();
  const Goniometer goniometer(test::plane(16, 0.6f), lights, Shadows::tabulated, 1);
  for (const vec3& view : lights) {
    const Mean mean = mean_radiance(goniometer, view, 5, 1);
    for (size_t l = 0; l < lights.size(); ++l)
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(mean.value[3 * l + c], 0.6 * static_cast<double>(lights[l].z) / kPi, 1e-6);
  }
}

TEST(Goniometer, TiltedFacetsSendTheCosineOfTheirOwnNormal) {
  // Nearly black, so that the slopes do not light each other.
  constexpr double kHeight = 0.1, kAlbedo = 1e-4;
  const std::vector<vec3> lights = {towards(0, 0), towards(30, 0), towards(50, 180), towards(60, 90)};
  const Goniometer goniometer(test::roof(64, kHeight, static_cast<float>(kAlbedo)), lights, Shadows::traced, 1);
  const vec3 normals[2] = {glm::normalize(vec3(-2 * kHeight, 0, 1)), glm::normalize(vec3(2 * kHeight, 0, 1))};
  for (int side = 0; side < 2; ++side)
    for (size_t l = 0; l < lights.size(); ++l) {
      std::vector<float> radiance(3 * lights.size());
      Random random(7);
      goniometer.trace({side == 0 ? 0.25f : 0.75f, 0.3f}, towards(20, 40), random, radiance);
      const double expected = kAlbedo * static_cast<double>(glm::dot(normals[side], lights[l])) / kPi;
      EXPECT_NEAR(radiance[3 * l], expected, 1e-3 * expected) << side << " " << l;
    }
}

TEST(Goniometer, MeanOverThePeriodIsReciprocal) {
  // F(i, o) = mean radiance / cos i. 4.5 standard deviations over 630 comparisons: a false alarm in 200 runs.
  const std::vector<vec3> directions = {towards(0, 0),   towards(25, 40),  towards(45, 130), towards(60, 200),
                                        towards(60, 20), towards(70, 300), towards(75, 90)};
  auto weave = make_structure("plain");
  ASSERT_TRUE(weave);
  for (Mesostructure structure : {test::bumps(96, 0.8f, false), test::bumps(96, 0.5f, true), (*weave)->build(48)}) {
    const std::string name = structure.name;
    const Goniometer goniometer(std::move(structure), directions, Shadows::traced, 1);
    std::vector<Mean> means;
    for (size_t o = 0; o < directions.size(); ++o) means.push_back(mean_radiance(goniometer, directions[o], 6000, o));
    double worst = 0;
    for (size_t i = 0; i < directions.size(); ++i)
      for (size_t o = 0; o < i; ++o)
        for (size_t c = 0; c < 3; ++c) {
          const double zi = static_cast<double>(directions[i].z), zo = static_cast<double>(directions[o].z);
          const double there = means[o].value[3 * i + c] / zi, back = means[i].value[3 * o + c] / zo;
          const double deviation =
              std::sqrt(means[o].variance[3 * i + c] / (zi * zi) + means[i].variance[3 * o + c] / (zo * zo));
          EXPECT_NEAR(there, back, 4.5 * deviation + 1e-7) << name << " " << i << " " << o << " " << c;
          worst = std::max(worst, std::abs(there - back) / (there + back));
        }
    EXPECT_LT(worst, 0.1) << name << ": too noisy to say";
  }
}

TEST(Goniometer, WhiteFurnaceReturnsOneForEveryPath) {
  std::vector<Mesostructure> structures = {test::bumps(64, 1, false), test::ridge(64, 0.4, 0.2, 1, 1)};
  auto weave = make_structure("plain");
  ASSERT_TRUE(weave);
  structures.push_back((*weave)->build(48));
  for (Mesostructure& structure : structures) {
    const std::string name = structure.name;
    for (Facet& facet : structure.facets) facet.colour = vec3(1);
    structure.matters.assign(structure.matters.size(), Matter{});
    const Goniometer goniometer(std::move(structure), {}, Shadows::traced, 1);
    Random random(11);
    for (int i = 0; i < 20000; ++i) {
      const vec2 place(random.next(), random.next());
      const vec3 left = goniometer.trace_sky(
          place, towards(80.0 * static_cast<double>(random.next()), 360.0 * static_cast<double>(random.next())),
          random);
      ASSERT_NEAR(left.x, 1, 1e-4) << name << " " << i;
    }
  }
}

TEST(Goniometer, LightsOfAWholeSkyAddUpToOneInAWhiteFurnace) {
  // 144 directions that stand for equal solid angles: radiance 1 each comes to 1 within the quadrature's error.
  std::vector<vec3> lights;
  constexpr int kRings = 9, kAround = 16;
  for (int r = 0; r < kRings; ++r)
    for (int a = 0; a < kAround; ++a) {
      const double z = (r + 0.5) / kRings, phi = (a + 0.5 * (r % 2)) * 2 * kPi / kAround;
      lights.emplace_back(static_cast<float>(std::sqrt(1 - z * z) * std::cos(phi)),
                          static_cast<float>(std::sqrt(1 - z * z) * std::sin(phi)), static_cast<float>(z));
    }
  const Goniometer goniometer(test::bumps(96, 1, false), lights, Shadows::tabulated, 1);
  for (const vec3 view : {towards(0, 0), towards(40, 70), towards(70, 200)}) {
    const Mean mean = mean_radiance(goniometer, view, 3000, 5);
    double sum = 0;
    for (size_t l = 0; l < lights.size(); ++l) sum += mean.value[3 * l] * 2 * kPi / static_cast<double>(lights.size());
    // Red is white here.
    EXPECT_NEAR(sum, 1, 0.02);
  }
}

TEST(Goniometer, ShadowOfARidgeSetsInAtItsAngle) {
  constexpr float kHeight = 0.1f;
  const FacetGrid grid(test::ridge(200, static_cast<double>(kHeight), 0.02, 0.5f, 0.5f).facets);
  for (const float distance : {0.05f, 0.1f, 0.2f, 0.35f}) {
    // The ridge's near edge is at 0.49; its slope reaches one cell further. From the left, light comes over it from +x.
    const vec3 point(0.495f - distance, 0.3f, 1e-5f);
    const double onset = std::atan2(static_cast<double>(kHeight), static_cast<double>(distance)) * 180 / kPi;
    EXPECT_TRUE(grid.is_blocked(point, towards(90 - (onset - 0.5), 0)));
    EXPECT_FALSE(grid.is_blocked(point, towards(90 - (onset + 0.5), 0)));
    // Along the ridge there is none.
    EXPECT_FALSE(grid.is_blocked(point, towards(85, 90)));
  }
}

TEST(Goniometer, CrestMovesAgainstTheViewByItsHeightTimesTheTangent) {
  constexpr float kHeight = 0.1f;
  const Goniometer goniometer(test::ridge(200, static_cast<double>(kHeight), 0.02, 0, 1), {towards(0, 0)},
                              Shadows::traced, 1);
  for (const double theta : {0.0, 20.0, 45.0}) {
    // Where white is seen.
    double sum = 0, weight = 0;
    for (int i = 0; i < 2000; ++i) {
      std::vector<float> radiance(3);
      Random random(static_cast<uint64_t>(i));
      const float x = (static_cast<float>(i) + 0.5f) / 2000;
      goniometer.trace({x, 0.4f}, towards(theta, 0), random, radiance);
      // The flat of the crest alone: its flanks see less of the light.
      const double value = radiance[0] > 0.9f / std::numbers::pi_v<float> ? 1.0 : 0.0;
      sum += value * static_cast<double>(x), weight += value;
    }
    ASSERT_GT(weight, 0);
    const double shift = static_cast<double>(kHeight - goniometer.reference_height()) * std::tan(theta * kPi / 180);
    EXPECT_NEAR(sum / weight, 0.4975 - shift, 0.004) << theta;
  }
}

TEST(Goniometer, ErrorFallsWithTheRootOfTheNumberOfPaths) {
  // The spread over 200 means of N paths; four times the paths, half the spread, within 15 % (three standard deviations
  // of an estimated spread's ratio are 15 % at 200).
  const Goniometer goniometer(test::bumps(64, 0.8f, false), {towards(50, 30)}, Shadows::tabulated, 1);
  double before = 0;
  for (const int paths : {4, 16, 64, 256}) {
    double sum = 0, square = 0;
    constexpr int kMeans = 200;
    for (int i = 0; i < kMeans; ++i) {
      const double value =
          mean_radiance(goniometer, towards(40, 250), paths, static_cast<uint64_t>(i * 1000 + paths)).value[0];
      sum += value, square += value * value;
    }
    const double spread = std::sqrt(square / kMeans - sum / kMeans * sum / kMeans);
    if (before > 0) {
      EXPECT_NEAR(before / spread, 2, 0.3) << paths;
    }
    before = spread;
  }
}

TEST(Goniometer, TableOfShadowsKeepsTheMeanOfTracedOnes) {
  auto weave = make_structure("plain");
  ASSERT_TRUE(weave);
  const std::vector<vec3> lights = {towards(15, 60), towards(45, 130), towards(60, 18), towards(75, 200)};
  const Goniometer table((*weave)->build(256), lights, Shadows::tabulated, 1);
  const Goniometer traced((*weave)->build(256), lights, Shadows::traced, 1);
  double difference = 0, value = 0;
  for (const vec3 view : {towards(0, 0), towards(60, 300)}) {
    // The same paths, so that only the shadows differ.
    const Mean a = mean_radiance(table, view, 6000, 4), b = mean_radiance(traced, view, 6000, 4);
    for (size_t k = 0; k < a.value.size(); ++k) {
      difference += a.value[k] - b.value[k];
      value += b.value[k];
    }
  }
  // Of the mean; docs/acquire.md says how far single texels are off.
  EXPECT_LT(std::abs(difference), 0.01 * value);
}

}  // namespace
}  // namespace vamp::acquire
