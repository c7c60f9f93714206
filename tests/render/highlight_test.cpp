// Rays drawn from a part's sharp highlight: the same picture as from points on lights alone, with less noise, and
// nothing that an edit could move.
#include "engine/material/highlight.h"

#include <cmath>
#include <cstring>
#include <functional>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/render/renderer.h"
#include "tests/render/render_test.h"

namespace vamp {
namespace {

constexpr float kWidth = 0.03f;

Project ball(SpmmPtr fit) {
  SceneBuilder scene;
  scene.add_sphere("ball", vec3(0), 1, 64);
  Project project = dark_project(scene.build());
  put_material(project, "ball", std::move(fit));
  project.camera.eye = vec3(0, 0, 4);
  project.camera.target = vec3(0);
  project.camera.fov_degrees = 30;
  return project;
}

// The same look by an edit of a broad fit, whose rays are drawn from lights alone.
Project edited_ball() {
  Project project = ball(make_lacquer(0.5f));
  BasisEdit edit;
  edit.lobe = make_lacquer(kWidth)->dictionary[1].lobe;
  project.materials.back().edits.set({0, 1}, edit);
  return project;
}

Light light_of(LightType type) {
  Light light;
  light.type = type;
  light.center = vec3(1.5f, 1.5f, 2.5f);
  light.target = vec3(0);
  light.size = vec2(1.6f, 1.2f);
  light.radius = 0.7f;
  light.power = 20;
  return light;
}

double mean_of(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += static_cast<double>(image.at(x, y, 0));
  return sum / (image.width * image.height);
}

double squared_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const double d = static_cast<double>(a.at(x, y, 0) - b.at(x, y, 0));
      sum += d * d;
    }
  return sum;
}

// The picture is that of points on lights, and at 16 samples nearer to it.
class HighlightTest : public RenderTest {
 protected:
  void expect_same_with_less_noise(const std::function<void(Project&)>& light, double slack = 0.01) {
    Project drawn = ball(make_lacquer(kWidth)), plain = edited_ball();
    light(drawn);
    light(plain);
    const Still reference = render(plain, 24, 24, 4096);
    const Still many = render(drawn, 24, 24, 4096);
    EXPECT_NEAR(mean_of(many.image) / mean_of(reference.image), 1, slack);
    drawn.settings.seed = plain.settings.seed = 7;
    const double with = squared_difference(render(drawn, 24, 24, 16).image, many.image);
    const double without = squared_difference(render(plain, 24, 24, 16).image, many.image);
    EXPECT_LT(with, 0.5 * without);
  }
};

TEST_F(HighlightTest, UnderARectangle) {
  expect_same_with_less_noise([](Project& p) { p.lights = {light_of(LightType::rect)}; });
}
TEST_F(HighlightTest, UnderADisk) {
  expect_same_with_less_noise([](Project& p) { p.lights = {light_of(LightType::disk)}; });
}
TEST_F(HighlightTest, UnderASphere) {
  expect_same_with_less_noise([](Project& p) { p.lights = {light_of(LightType::sphere)}; });
}
TEST_F(HighlightTest, InAmbientLight) {
  expect_same_with_less_noise([](Project& p) { p.ambient = vec3(1); });
}
// `rows` rows of radiance 1 above others.
void put_under_a_sky(Project& project, int rows, float others) {
  std::vector<vec3> sky;
  for (int i = 0; i < 32 * 16; ++i) sky.emplace_back(i / 32 < rows ? 1.f : others);
  const auto map = make_environment(32, 16, sky, "made in memory");
  ASSERT_TRUE(map);
  project.environment.map = *map;
  project.environment.path = "made in memory";
  project.environment.visible = false;
}

// The mean of 4,096 samples without the highlight differs by 3 % from seed to seed.
TEST_F(HighlightTest, InAnEnvironment) {
  expect_same_with_less_noise([](Project& p) { put_under_a_sky(p, 8, 0.2f); }, 0.1);
}

TEST_F(HighlightTest, AConstantEnvironmentIsAmbientLight) {
  Project sky = ball(make_lacquer(kWidth)), ambient = sky;
  put_under_a_sky(sky, 16, 1);
  ambient.ambient = vec3(1);
  const double expected = mean_of(render(ambient, 24, 24, 2048).image);
  EXPECT_NEAR(mean_of(render(sky, 24, 24, 2048).image) / expected, 1, 0.005);
}

TEST_F(HighlightTest, LightsWithoutSizeAreDrawnAsBefore) {
  Project drawn = ball(make_lacquer(kWidth)), plain = edited_ball();
  drawn.lights = plain.lights = {light_of(LightType::point), light_of(LightType::spot)};
  const Still a = render(drawn, 24, 24, 4), b = render(plain, 24, 24, 4);
  EXPECT_LE(squared_difference(a.image, b.image), 1e-12 * squared_difference(b.image, Image(24, 24, {"R"})));
}

// An edit of the sharp highlight, even one that takes it away, is shaded again from the rays that were traced for it.
TEST_F(HighlightTest, AnEditMovesNoRay) {
  Project project = ball(make_lacquer(kWidth));
  project.lights = {light_of(LightType::rect)};
  project.ambient = vec3(0.2f);
  const auto finish = [&](Renderer& renderer) {
    uint64_t done = 0;
    while (renderer.replaying()) done = renderer.replay(~0u);
    while (renderer.samples() < 8) done = renderer.refine_all(8);
    return renderer.linear_picture(done);
  };
  Renderer renderer(*device);
  renderer.set_history(1 << 20);
  ASSERT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  renderer.set_region(40, 40, {0, 0, 40, 40});
  finish(renderer);
  BasisEdit edit;
  edit.lobe = make_lacquer(0.4f)->dictionary[1].lobe;
  project.materials.back().edits.set({0, 1}, edit);
  const auto change = renderer.set_project(std::make_shared<const Project>(project));
  ASSERT_TRUE(change);
  EXPECT_FALSE(change->restarted) << change->what;
  EXPECT_GT(change->reshaded, 0u);
  const std::vector<float> replayed = finish(renderer);
  Renderer other(*device);
  ASSERT_TRUE(other.set_project(std::make_shared<const Project>(project)));
  other.set_region(40, 40, {0, 0, 40, 40});
  const std::vector<float> fresh = finish(other);
  ASSERT_EQ(replayed.size(), fresh.size());
  EXPECT_EQ(std::memcmp(replayed.data(), fresh.data(), fresh.size() * sizeof(float)), 0);
}

// A material whose rays are drawn another way comes with other rays.
TEST_F(HighlightTest, AnotherMaterialStartsAgain) {
  Project project = ball(make_lacquer(0.5f));
  project.lights = {light_of(LightType::rect)};
  Renderer renderer(*device);
  ASSERT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  renderer.set_region(16, 16, {0, 0, 16, 16});
  device->wait(renderer.refine_all(1));
  project.materials.back().fit = make_lacquer(kWidth);
  const auto change = renderer.set_project(std::make_shared<const Project>(project));
  ASSERT_TRUE(change);
  EXPECT_TRUE(change->restarted);
}

}  // namespace
}  // namespace vamp
