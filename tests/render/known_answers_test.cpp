// Scenes whose pictures have closed forms.
#include <cmath>
#include <cstring>

#include "tests/render/render_test.h"

namespace vamp {
namespace {

constexpr double kPi = 3.14159265358979323846;

Project room(vec3 color) {
  SceneBuilder scene;
  scene.add_quad("floor", {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
  scene.set_color("floor", color);
  Project project = dark_project(scene.build());
  project.camera.eye = vec3(0, 2, 0.001f);
  project.camera.target = vec3(0);
  project.camera.fov_degrees = 20;
  return project;
}

TEST_F(RenderTest, WhiteFurnaceIsWhite) {
  // A white diffuse sphere in constant ambient light is invisible: radiance 1 everywhere on it.
  SceneBuilder scene;
  scene.add_sphere("ball", vec3(0), 1, 48);
  scene.set_color("ball", vec3(1));
  Project project = dark_project(scene.build());
  project.camera.eye = vec3(0, 0, 4);
  project.camera.target = vec3(0);
  project.camera.fov_degrees = 25;
  project.ambient = project.background = vec3(1);
  const Still still = render(project, 64, 64, 256);
  double sum = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) sum += static_cast<double>(still.image.at(x, y, 0));
  EXPECT_NEAR(sum / 4096, 1.0, 0.002);
  EXPECT_NEAR(middle_mean(still.image, 1), 1.0, 0.002);
}

TEST_F(RenderTest, SphereLitFromItsCentre) {
  // Point light of P watts in the middle of a diffuse sphere: E = P / (4 pi r^2), L = rho E / pi, everywhere the same.
  SceneBuilder scene;
  scene.add_sphere("shell", vec3(0), 2, 96, true);
  scene.set_color("shell", {0.5f, 0.25f, 0.8f});
  Project project = dark_project(scene.build());
  project.camera.eye = vec3(0.5f, 0.2f, 0.1f);
  project.camera.target = vec3(1, 1, 0);
  project.camera.fov_degrees = 90;
  Light light;
  light.type = LightType::point;
  light.center = vec3(0);
  light.power = 100;
  project.lights = {light};
  const Still still = render(project, 48, 48, 16);
  const double expected = 100 / (4 * kPi * 4) / kPi;
  EXPECT_NEAR(middle_mean(still.image, 0) / (0.5 * expected), 1, 0.005);
  EXPECT_NEAR(middle_mean(still.image, 2) / (0.8 * expected), 1, 0.005);
}

TEST_F(RenderTest, PlaneUnderRectangleLight) {
  // Irradiance below the centre of a parallel rectangle a x b at height h (four corner patches, e.g. Howell C-11):
  // F = 4 / (2 pi) (A / sqrt(1 + A^2) atan(B / sqrt(1 + A^2)) + B / sqrt(1 + B^2) atan(A / sqrt(1 + B^2))).
  Project project = room(vec3(0.6f));
  Light light;
  light.type = LightType::rect;
  light.center = vec3(0, 1, 0);
  light.target = vec3(0);
  light.size = vec2(0.8f, 0.5f);
  light.power = 50;
  project.lights = {light};
  project.camera.eye = vec3(0, 0.6f, 0.001f);
  project.camera.fov_degrees = 2;
  const Still still = render(project, 32, 32, 256);
  const double a = 0.4, b = 0.25;
  const double ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
  const double form = 4 / (2 * kPi) * (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb));
  const double radiance = 50 / (kPi * 0.8 * 0.5);
  EXPECT_NEAR(middle_mean(still.image, 0) / (0.6 * radiance * form), 1, 0.005);
}

TEST_F(RenderTest, PlaneUnderDiskAndSphereLight) {
  // Disk, radius r, height h above the point: F = r^2 / (r^2 + h^2). Sphere at distance d: F = r^2 / d^2.
  Project project = room(vec3(0.6f));
  project.camera.eye = vec3(0, 0.5f, 0.001f);
  project.camera.fov_degrees = 2;
  Light light;
  light.type = LightType::disk;
  light.center = vec3(0, 1, 0);
  light.target = vec3(0);
  light.radius = 0.5f;
  light.power = 50;
  project.lights = {light};
  const double disk = 50 / (kPi * kPi * 0.25) * 0.25 / 1.25;
  EXPECT_NEAR(middle_mean(render(project, 32, 32, 256).image, 0) / (0.6 * disk), 1, 0.005);
  light.type = LightType::sphere;
  project.lights = {light};
  const double sphere = 50 / (kPi * 4 * kPi * 0.25) * 0.25 / 1.0;
  EXPECT_NEAR(middle_mean(render(project, 32, 32, 256).image, 0) / (0.6 * sphere), 1, 0.005);
}

TEST_F(RenderTest, DirectionalAndSpotLight) {
  Project project = room(vec3(0.5f));
  Light light;
  light.type = LightType::directional;
  light.center = vec3(0, 1, 0);
  light.target = vec3(1, 0, 0);  // 45 degrees
  light.power = 3;
  project.lights = {light};
  EXPECT_NEAR(middle_mean(render(project, 32, 32, 8).image, 0) / (0.5 / kPi * 3 * std::sqrt(0.5)), 1, 1e-4);
  light.type = LightType::spot;
  light.center = vec3(0, 1, 0);
  light.target = vec3(0);
  light.inner_degrees = 30;
  light.power = 40;
  project.lights = {light};
  project.camera.fov_degrees = 2;
  EXPECT_NEAR(middle_mean(render(project, 32, 32, 8).image, 0) / (0.5 / kPi * 40 / (4 * kPi)), 1, 0.002);
}

TEST_F(RenderTest, EnvironmentOfOneColourIsAmbientLight) {
  Project project = room(vec3(0.7f));
  auto map = make_environment(64, 32, std::vector<vec3>(64 * 32, vec3(2, 1, 0.5f)), "constant");
  ASSERT_TRUE(map);
  project.environment.map = *map;
  project.environment.path = "constant";
  const Still still = render(project, 32, 32, 256);
  EXPECT_NEAR(middle_mean(still.image, 0), 0.7 * 2, 0.01 * 1.4);
  EXPECT_NEAR(middle_mean(still.image, 2), 0.7 * 0.5, 0.01 * 0.35);
}

TEST_F(RenderTest, OcclusionOfAnOpenPlaneIsOneAndOfACornerHalf) {
  SceneBuilder scene;
  scene.add_quad("floor", {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000});
  Project open = dark_project(scene.build());
  open.camera.eye = vec3(0.1f, 1, 0.1f);
  open.camera.target = vec3(0.1f, 0, 0);
  open.camera.fov_degrees = 5;
  const Still plain = render(open, 16, 16, 37, {Layer::ao});
  const size_t ao = *plain.image.channel("ao.Y");
  for (int i = 0; i < 256; ++i) EXPECT_EQ(plain.image.at(i % 16, i / 16, ao), 1.0f);

  // At the foot of a wall without end half of the cosine-weighted hemisphere is hidden.
  scene.add_quad("wall", {-500, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  SceneBuilder corner;
  corner.add_quad("floor", {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000});
  corner.add_quad("wall", {-500, 0, 0}, {1000, 0, 0}, {0, 1000, 0});
  Project walled = dark_project(corner.build());
  walled.camera.eye = vec3(0, 0.5f, 0.5f);
  walled.camera.target = vec3(0, 0, 0.001f);
  walled.camera.fov_degrees = 0.05f;
  walled.camera.fov_degrees = 1;
  walled.camera.eye = vec3(0, 0.01f, 0.02f);
  const Still half = render(walled, 16, 16, 256, {Layer::ao});
  EXPECT_NEAR(middle_mean(half.image, ao), 0.5, 0.03);
}

TEST_F(RenderTest, PerfectMirrorShowsWhatStandsBeforeIt) {
  // A mirror floor under a bright wall: the reflection has the wall's own radiance.
  SceneBuilder scene;
  scene.add_quad("mirror", {-2, 0, 2}, {4, 0, 0}, {0, 0, -4});
  scene.add_quad("wall", {-2, 0, -2}, {4, 0, 0}, {0, 4, 0});
  scene.set_color("wall", vec3(1));
  Project project = dark_project(scene.build());
  project.parts[0].mirror_f0 = 1;
  Light light;
  light.type = LightType::directional;
  light.center = vec3(0, 0, 1);
  light.target = vec3(0);
  light.power = 2;
  project.lights = {light};
  project.camera.eye = vec3(0, 1, 1);
  project.camera.target = vec3(0, 0, 0);
  project.camera.fov_degrees = 5;
  const Still still = render(project, 32, 32, 8);
  EXPECT_NEAR(middle_mean(still.image, 0), 2 / kPi, 1e-3);
}

TEST_F(RenderTest, LightsAddUpAndScaleExactly) {
  Project project = room(vec3(0.6f));
  Light light;
  light.type = LightType::rect;
  light.center = vec3(0.3f, 1, 0);
  light.target = vec3(0);
  light.power = 8;
  project.lights = {light};
  const Still one = render(project, 16, 16, 8);
  project.lights[0].power = 16;
  const Still two = render(project, 16, 16, 8);
  for (int i = 0; i < 256; ++i) EXPECT_EQ(two.image.at(i % 16, i / 16, 0), 2 * one.image.at(i % 16, i / 16, 0));
}

}  // namespace
}  // namespace vamp
