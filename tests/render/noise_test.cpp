// What is told of noise, and stopping at it.
#include "engine/render/noise.h"

#include <cmath>
#include <random>

#include "tests/render/render_test.h"

namespace vamp {
namespace {

constexpr int kSide = 100;
const std::vector<Region> kTiles = {{0, 0, 64, kSide}, {64, 0, 36, kSide}};

// Means of `samples` draws of 1 +- 0.5 in each of 10,000 pixels, the first draws those of the mean before.
class Draws {
 public:
  std::vector<float> mean(uint32_t samples) {
    for (; taken_ < samples; ++taken_)
      for (double& sum : sums_) sum += uniform_(random_);
    std::vector<float> linear;
    for (const double sum : sums_) {
      const auto value = static_cast<float>(sum / taken_);
      linear.insert(linear.end(), {value, value, value, 1});
    }
    return linear;
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{0.5, 1.5};
  std::vector<double> sums_ = std::vector<double>(kSide * kSide, 0.0);
  uint32_t taken_ = 0;
};

std::vector<uint32_t> both(uint32_t samples) { return {samples, samples}; }

class NoiseOfDraws : public testing::Test {
 protected:
  NoiseOfDraws() { noise.restart(kTiles, kSide); }
  NoiseEstimate noise;
  Draws draws;
};

TEST_F(NoiseOfDraws, IsTheStandardErrorOfIndependentSamples) {
  for (uint32_t n = 4; n <= 64; n *= 2) noise.add(both(n), draws.mean(n));
  // The deviation of one draw is 1 / sqrt(12), and luminance 1 counts with 1.01: 10,000 pixels give d to 0.7 % and the
  // factor r = 2 to 2.8 %, of which half of the estimates are cut off; held to 4 sigma of both.
  const float at_64 = noise.of_picture(both(64));
  EXPECT_NEAR(at_64, 1 / std::sqrt(12 * 64 * 1.01), 0.09 * at_64);
  EXPECT_NEAR(noise.of_picture(both(256)), at_64 / 2, 0.05 * at_64);
  EXPECT_NEAR(noise.of_tile(0, 64), at_64, 0.06 * at_64);
}

TEST_F(NoiseOfDraws, IsNotKnownBeforeTwoPicturesWereCompared) {
  EXPECT_LT(noise.of_picture(both(4)), 0);
  noise.add(both(4), draws.mean(4));
  EXPECT_LT(noise.of_picture(both(4)), 0);
  EXPECT_LT(noise.of_tile(1, 4), 0);
  noise.add(both(8), draws.mean(8));
  EXPECT_GT(noise.of_picture(both(8)), 0);
}

TEST_F(NoiseOfDraws, DoesNotGrowWhereAPictureHasNoneToBeComparedWith) {
  for (uint32_t n = 4; n <= 64; n *= 2) noise.add(both(n), draws.mean(n));
  const float before = noise.of_picture(both(128));
  noise.forget_picture();
  noise.add(both(128), draws.mean(128));
  EXPECT_EQ(noise.of_picture(both(128)), before);
  noise.add(both(256), draws.mean(256));
  EXPECT_LT(noise.of_picture(both(256)), before);
}

TEST_F(NoiseOfDraws, OfATileThatStaysIsItsOwn) {
  for (uint32_t n = 4; n <= 16; n *= 2) noise.add(both(n), draws.mean(n));
  const float stays = noise.of_tile(1, 16);
  for (uint32_t n = 32; n <= 128; n *= 2) noise.add(std::vector<uint32_t>{n, 16}, draws.mean(n));
  EXPECT_EQ(noise.of_tile(1, 16), stays);
  EXPECT_LT(noise.of_tile(0, 128), 0.5f * stays);
}

// A ball in two lights on a floor, a dark corner of which needs more samples.
class NoiseGoal : public RenderTest {
 protected:
  static constexpr int kWidth = 144, kHeight = 80;
  NoiseGoal() {
    SceneBuilder scene;
    scene.add_quad("floor", {-3, -0.6f, 3}, {6, 0, 0}, {0, 0, -6});
    scene.add_sphere("ball", vec3(-1.4f, 0, 0), 0.6f, 24);
    scene.add_sphere("pearl", {1.4f, 0, 0}, 0.6f, 24);
    project = dark_project(scene.build());
    put_material(project, "ball", make_rich_material(7));
    Light key;
    key.type = LightType::rect;
    key.center = vec3(2, 2, 1);
    key.target = vec3(0);
    key.size = vec2(1.5f);
    key.power = 30;
    project.lights = {key};
    project.camera.eye = vec3(0, 1, 4.5f);
    project.camera.target = vec3(0);
    project.camera.fov_degrees = 35;
  }
  Still stopped_at(float goal) {
    auto still = render_still(*device, std::make_shared<const Project>(project),
                              {.width = kWidth, .height = kHeight, .samples = 4096, .noise_goal = goal}, nullptr);
    EXPECT_TRUE(still) << still.error().message();
    return still ? std::move(*still) : Still{};
  }
  // Rendered once, with other random numbers.
  const Image& truth_of_the_scene() {
    static Image truth;
    if (truth.pixels.empty()) {
      Project other = project;
      other.settings.seed = 99;
      truth = render(other, kWidth, kHeight, 4096).image;
    }
    return truth;
  }
  static double relative_error(const Image& image, const Image& truth) {
    double sum = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const auto luminance = [&](const Image& i) {
          return 0.2126 * double{i.at(x, y, 0)} + 0.7152 * double{i.at(x, y, 1)} + 0.0722 * double{i.at(x, y, 2)};
        };
        const double d = luminance(image) - luminance(truth);
        sum += d * d / (luminance(truth) * luminance(truth) + 0.01);
      }
    return std::sqrt(sum / (kWidth * kHeight));
  }
  Project project;
};

TEST_F(NoiseGoal, EstimatesAreWithinAFifthOfTheErrorThatThereIs) {
  const Image& truth = truth_of_the_scene();
  for (const uint32_t samples : {16u, 64u, 256u}) {
    const Still still = render(project, kWidth, kHeight, samples);
    const double error = relative_error(still.image, truth);
    EXPECT_NEAR(double{still.noise}, error, 0.2 * error) << samples << " samples";
  }
}

TEST_F(NoiseGoal, TilesStopWhereTheirNoiseIsLowAndThePictureKeepsTheGoal) {
  const Image& truth = truth_of_the_scene();
  const Still still = stopped_at(0.03f);
  EXPECT_TRUE(still.complete);
  EXPECT_LE(still.noise, 0.03f);
  EXPECT_LT(relative_error(still.image, truth), 1.2 * 0.03);
  // Some tiles have more samples than others.
  EXPECT_GT(still.mean_samples, 1.2 * still.samples);
}

TEST_F(NoiseGoal, AskedForTwiceThePictureIsTheSame) {
  EXPECT_EQ(stopped_at(0.05f).image.pixels, stopped_at(0.05f).image.pixels);
}

}  // namespace
}  // namespace vamp
