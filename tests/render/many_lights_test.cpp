// Where more than a few lights are on, a sample draws some of them: the same picture in the mean, and everything that
// holds of few lights.
#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/render/renderer.h"
#include "tests/render/render_test.h"

namespace vamp {
namespace {

constexpr int kWidth = 44, kHeight = 36;
constexpr size_t kFew = 3;  // a ray to each up to here

// All kinds of lights about a ball on a floor; among them ones that stand half below it.
std::vector<Light> ring_of_lights(size_t count) {
  std::vector<Light> lights;
  for (size_t i = 0; i < count; ++i) {
    Light light;
    light.type = static_cast<LightType>(i % static_cast<size_t>(kLightTypeCount));
    const float azimuth = 2.4f * static_cast<float>(i);
    const float height = i % 4 == 3 ? -0.5f : 0.4f + 0.2f * static_cast<float>(i % 7);
    light.center = vec3(2 * std::cos(azimuth), height, 2 * std::sin(azimuth));
    light.target = vec3(0, -0.2f, 0);
    light.size = vec2(0.9f, 0.6f);
    light.radius = 0.3f;
    light.inner_degrees = 8;
    light.outer_degrees = 20;
    light.power = light.type == LightType::directional ? 0.5f : 5 + static_cast<float>(i);
    lights.push_back(light);
  }
  return lights;
}

Project ball_under(size_t lights, SpmmPtr fit = make_rich_material(7)) {
  SceneBuilder scene;
  scene.add_quad("floor", {-2, -0.6f, 2}, {4, 0, 0}, {0, 0, -4});
  scene.add_sphere("ball", vec3(0), 0.6f, 24);
  scene.set_color("floor", {0.5f, 0.4f, 0.3f});
  Project project = dark_project(scene.build());
  put_material(project, "ball", std::move(fit));
  project.lights = ring_of_lights(lights);
  project.ambient = vec3(0.1f);
  project.camera = {.eye = vec3(0.5f, 0.9f, 3), .target = vec3(0), .fov_degrees = 40};
  return project;
}

struct Picture {
  std::vector<float> sums, linear;
  bool operator==(const Picture& other) const {
    const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
      return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
    };
    return same(sums, other.sums) && same(linear, other.linear);
  }
};

class ManyLights : public RenderTest {
 protected:
  static Result<Change> show(Renderer& renderer, const Project& project) {
    return renderer.set_project(std::make_shared<const Project>(project));
  }
  static Picture finish(Renderer& renderer, uint32_t samples) {
    uint64_t value = 0;
    while (renderer.replaying()) value = renderer.replay(500);
    while (renderer.samples() < samples) value = renderer.refine_all(samples);
    return {renderer.accumulators(value), renderer.linear_picture(value)};
  }
  void start(Renderer& renderer, const Project& project, int width = kWidth, int height = kHeight) {
    renderer.set_region(width, height, {0, 0, width, height});
    const auto change = show(renderer, project);
    ASSERT_TRUE(change) << change.error().message();
  }
  Picture fresh(const Project& project, uint32_t samples) {
    Renderer renderer(*device);
    start(renderer, project);
    return finish(renderer, samples);
  }

  // Mean of each light's plane over a picture of 16 x 16 pixels, a row for each of 20 seeds.
  std::vector<std::vector<double>> plane_means(Project project, bool drawn, uint32_t samples) {
    Renderer renderer(*device);
    if (!drawn) renderer.set_light_draws({.above = MAX_LIGHTS});
    std::vector<std::vector<double>> rows;
    for (uint32_t seed = 0; seed < 20; ++seed) {
      project.settings.seed = seed + (drawn ? 0 : 100);
      if (seed == 0)
        start(renderer, project, 16, 16);
      else
        EXPECT_TRUE(show(renderer, project));
      const std::vector<float> sums = finish(renderer, samples).sums;
      std::vector<double>& row = rows.emplace_back();
      for (size_t plane = PLANE_LIGHTS; plane < PLANE_LIGHTS + project.lights.size(); ++plane) {
        double sum = 0;
        for (size_t i = 0; i < 256; ++i) sum += static_cast<double>(sums[(plane * 256 + i) * 4]);
        row.push_back(sum / (256.0 * samples));
      }
    }
    return rows;
  }

  // Two-sided, by Student's t of two rows of 20 (38 degrees of freedom): beyond 4.6 in 1 of 20,000 cases, so in 1 of
  // 600 tests of 32 lights.
  static void expect_same_means(const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
    ASSERT_EQ(a.front().size(), b.front().size());
    for (size_t light = 0; light < a.front().size(); ++light) {
      const auto moments = [&](const std::vector<std::vector<double>>& rows) {
        double mean = 0, squares = 0;
        for (const auto& row : rows) mean += row[light] / static_cast<double>(rows.size());
        for (const auto& row : rows) squares += (row[light] - mean) * (row[light] - mean);
        return std::pair(mean, squares / static_cast<double>((rows.size() - 1) * rows.size()));
      };
      const auto [mean_a, error_a] = moments(a);
      const auto [mean_b, error_b] = moments(b);
      // And a little for what floats make of a light without noise.
      EXPECT_LE(std::abs(mean_a - mean_b), 4.6 * std::sqrt(error_a + error_b) + 2e-6 * mean_b)
          << "light " << light << ": " << mean_a << " drawn, " << mean_b << " by a ray to each";
    }
  }
};

TEST_F(ManyLights, DrawnInTheMeanGiveWhatARayToEachGives) {
  const Project project = ball_under(12);
  expect_same_means(plane_means(project, true, 36), plane_means(project, false, 12));
}

TEST_F(ManyLights, DrawnFromASharpHighlightTooGiveTheSame) {
  const Project project = ball_under(6, make_lacquer(0.05f));
  expect_same_means(plane_means(project, true, 64), plane_means(project, false, 24));
}

TEST_F(ManyLights, DrawnBehindAMirrorGiveTheSame) {
  Project project = ball_under(6);
  project.parts[0].mirror_f0 = 0.5f;
  expect_same_means(plane_means(project, true, 36), plane_means(project, false, 12));
}

TEST_F(ManyLights, TheirPictureIsTheSumOfThatOfEach) {
  Project project = ball_under(32);
  const auto together = plane_means(project, true, 36);
  std::vector<std::vector<double>> apart(together.size());
  const std::vector<Light> lights = project.lights;
  for (const Light& light : lights) {
    project.lights = {light};
    const auto rows = plane_means(project, false, 4);
    for (size_t i = 0; i < rows.size(); ++i) apart[i].push_back(rows[i][0]);
  }
  expect_same_means(together, apart);
}

TEST_F(ManyLights, TilesRegionsAndBatchesGiveTheSameBytes) {
  for (const auto& [lights, mirror] : {std::pair<size_t, float>{kFew + 1, 0.0f}, {16, 0.5f}, {32, 0.0f}}) {
    Project project = ball_under(lights);
    project.parts[0].mirror_f0 = mirror;
    const Picture whole = fresh(project, 9);

    Renderer renderer(*device);
    start(renderer, project, kWidth, kHeight);
    for (uint32_t k = 1; k < 9; ++k) device->wait(renderer.refine_all(k));
    EXPECT_TRUE(whole == finish(renderer, 9)) << lights << " lights, one sample at a time";

    renderer.set_region(kWidth, kHeight, {10, 6, 20, 24});
    const Picture part = finish(renderer, 9);
    for (size_t y = 0; y < 24; ++y)
      EXPECT_EQ(std::memcmp(&part.linear[y * 20 * 4], &whole.linear[((y + 6) * kWidth + 10) * 4], 20 * 16), 0)
          << lights << " lights, row " << y << " of a region";
  }
}

TEST_F(ManyLights, AnEditIsShadedAgainFromStoredHits) {
  for (const uint64_t history : {uint64_t{0}, uint64_t{20} << 10, uint64_t{8} << 20}) {
    Project project = ball_under(16);
    Renderer renderer(*device);
    renderer.set_history(history);
    start(renderer, project);
    finish(renderer, 10);
    BasisEdit edit;
    edit.normal = vec3(0.3f, 0, std::sqrt(0.91f));
    project.materials.back().edits.set({0, 2}, edit);
    project.lights[5].power *= 3;
    const auto change = show(renderer, project);
    ASSERT_TRUE(change);
    EXPECT_FALSE(change->restarted) << change->what;
    EXPECT_GT(change->reshaded, 0u);
    EXPECT_TRUE(fresh(project, 10) == finish(renderer, 10)) << history;
  }
}

TEST_F(ManyLights, PowerAndColourAreRecomposedToTheFreshPicture) {
  for (const size_t lights : {16u, 32u}) {
    Project project = ball_under(lights);
    Renderer renderer(*device);
    start(renderer, project);
    const Picture before = finish(renderer, 7);
    project.lights[2].power = 80;
    project.lights[lights - 1].color = vec3(0, 1, 2);
    project.lights[0].power = 0;
    const auto change = show(renderer, project);
    ASSERT_TRUE(change);
    EXPECT_FALSE(change->restarted) << change->what;
    EXPECT_TRUE(change->recomposed);
    const std::vector<uint32_t> shown = renderer.display_picture(renderer.recompose());
    const Picture after = finish(renderer, 7);
    EXPECT_TRUE(fresh(project, 7) == after);
    EXPECT_EQ(before.sums, after.sums);
    // Shown alike by the kernel that shades and by the one that composes.
    Renderer other(*device);
    start(other, project);
    finish(other, 7);
    EXPECT_EQ(shown, other.display_picture(device->last_submitted()));
  }
}

// Lights that can send nothing to a floor: below it, turned away, with a cone elsewhere. One that can is drawn by every
// slot, and its picture is that of itself alone.
TEST_F(ManyLights, WhatCannotContributeTakesNoDraw) {
  SceneBuilder scene;
  scene.add_quad("floor", {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
  Project project = dark_project(scene.build());
  project.camera = {.eye = vec3(0, 2, 0.001f), .target = vec3(0), .fov_degrees = 20};
  Light seen;
  seen.type = LightType::point;
  seen.center = vec3(0.3f, 1, 0.2f);
  Light below = seen;
  below.center.y = -1;
  Light sphere = below;
  sphere.type = LightType::sphere;
  sphere.radius = 0.9f;
  Light turned;
  turned.center = vec3(0, 1, 0);
  turned.target = vec3(0, 2, 0);
  Light aside = seen;
  aside.type = LightType::spot;
  aside.target = vec3(5, 1.2f, 0);
  Light sunk;
  sunk.type = LightType::directional;
  sunk.center = vec3(0, -1, 0);
  sunk.target = vec3(0);
  project.lights = {seen};
  const Image alone = render(project, 24, 24, 8).image;
  project.lights = {below, sphere, seen, turned, aside, sunk};
  ASSERT_GT(project.lights.size(), kFew);
  const Image among = render(project, 24, 24, 8).image;
  for (int i = 0; i < 24 * 24; ++i)
    ASSERT_NEAR(among.at(i % 24, i / 24, 0) / alone.at(i % 24, i / 24, 0), 1, 1e-5f) << i;

  // And where no light can, it is dark.
  project.lights = {below, sphere, turned, aside, sunk};
  const Image dark = render(project, 24, 24, 8).image;
  for (int i = 0; i < 24 * 24; ++i) ASSERT_EQ(dark.at(i % 24, i / 24, 0), 0.0f) << i;
}

TEST_F(ManyLights, AFewGetARayEach) {
  Renderer renderer(*device);
  start(renderer, ball_under(kFew));
  EXPECT_EQ(renderer.key().light_slots, 0u);
  EXPECT_EQ(renderer.key().ray_count(), kFew + 1);
  ASSERT_TRUE(show(renderer, ball_under(MAX_LIGHTS)));
  EXPECT_GT(renderer.key().light_slots, 0u);
  EXPECT_LT(renderer.key().ray_count(), kFew + 1);
  EXPECT_EQ(renderer.key().planes(), 2u + MAX_LIGHTS);
}

}  // namespace
}  // namespace vamp
