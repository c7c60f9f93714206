// The kernel's SPMM against `evaluate` in double: a plane of the material under parallel light, seen through pixel
// centres.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/material/tables.h"
#include "engine/render/material_tables.h"
#include "engine/render/renderer.h"
#include "tests/render/render_test.h"

namespace vamp {
namespace {

TEST_F(RenderTest, ShadingAgreesWithTheMaterialInDouble) {
  const SpmmPtr fit = make_rich_material(11);
  SceneBuilder scene;
  scene.add_quad("plane", {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  Project project = dark_project(scene.build());
  put_material(project, "plane", fit);
  project.settings.pixel_centres = true;
  const Result<DirectionTables> directions = triangulate(fit->residual.directions, "test");
  ASSERT_TRUE(directions);
  double worst = 0;
  for (const vec3 from : {vec3(0.2f, 1, 0.1f), vec3(-1, 0.6f, 0.4f), vec3(0.3f, 0.15f, -1), vec3(0, 1, 0)}) {
    Light light;
    light.type = LightType::directional;
    light.center = from;
    light.target = vec3(0);
    light.power = 1;
    project.lights = {light};
    project.camera.eye = vec3(0.8f, 0.7f, 0.9f);
    project.camera.target = vec3(0);
    project.camera.fov_degrees = 30;
    // Texels are drawn by the jitter of a tap; where all four taps are the same texel's the tap does not matter: here
    // the four-tap mode gives the blend, and the oracle blends the same.
    project.settings.tap = TexelTap::four;
    const int side = 48;
    const Still still = render(project, side, side, 1, {Layer::uv, Layer::part});
    const size_t u_channel = *still.image.channel("uv.U"), v_channel = *still.image.channel("uv.V");
    const CameraFrame camera = camera_frame(project.camera, 1);
    // The plane's frame: tangent along +x, bitangent along -z, normal up.
    const auto local = [](vec3 w) { return dvec3(w.x, -w.z, w.y); };
    const dvec3 wi = glm::normalize(local(glm::normalize(from)));
    const float mm_per_uv = project.scene->parts[0].mm_per_uv;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        if (still.image.at(x, y, *still.image.channel("part.Y")) < 0) continue;
        const float px = (static_cast<float>(x) + 0.5f) / side, py = (static_cast<float>(y) + 0.5f) / side;
        const dvec3 wo = -local(camera_ray(camera, 2 * px - 1, 1 - 2 * py));
        double s = static_cast<double>(still.image.at(x, y, u_channel) * mm_per_uv) / 16;
        double t = static_cast<double>(still.image.at(x, y, v_channel) * mm_per_uv) / 16;
        s = (s - std::floor(s)) * 16 - 0.5;
        t = (t - std::floor(t)) * 16 - 0.5;
        const int i = static_cast<int>(std::floor(s)), j = static_cast<int>(std::floor(t));
        const double fs = s - i, ft = t - j;
        // UVs through a scale of 125 periods lose 1e-5 of a texel's place; stay away from where that matters.
        if (fs < 0.02 || fs > 0.98 || ft < 0.02 || ft > 0.98) continue;
        dvec3 expected(0);
        for (int b = 0; b < 2; ++b)
          for (int a = 0; a < 2; ++a)
            expected += (a ? fs : 1 - fs) * (b ? ft : 1 - ft) *
                        evaluate(*fit, {}, *directions, (i + a + 16) % 16, (j + b + 16) % 16, wi, wo);
        for (size_t c = 0; c < 3; ++c) {
          const double found = static_cast<double>(still.image.at(x, y, c));
          worst = std::max(worst, std::abs(found - expected[static_cast<int>(c)]) /
                                      (std::abs(expected[static_cast<int>(c)]) + 0.02));
        }
      }
  }
  EXPECT_LT(worst, 1e-3);
  RecordProperty("worst_relative_error", std::to_string(worst));
}

TEST_F(RenderTest, OneTapAtRandomConvergesToFour) {
  SceneBuilder scene;
  scene.add_quad("plane", {-1, 0, 1}, {2, 0, 0}, {0, 0, -2});
  Project project = dark_project(scene.build());
  put_material(project, "plane", make_rich_material(5));
  Light light;
  light.type = LightType::directional;
  light.center = vec3(0.4f, 1, 0.2f);
  light.target = vec3(0);
  light.power = 1;
  project.lights = {light};
  project.camera.eye = vec3(0, 0.02f, 0.02f);
  project.camera.target = vec3(0);
  project.camera.fov_degrees = 30;
  const Still one = render(project, 24, 24, 2048);
  project.settings.tap = TexelTap::four;
  const Still four = render(project, 24, 24, 512);
  double squares = 0, difference = 0, sum = 0, sum2 = 0;
  for (int i = 0; i < 24 * 24; ++i) {
    const double a = static_cast<double>(one.image.at(i % 24, i / 24, 0));
    const double b = static_cast<double>(four.image.at(i % 24, i / 24, 0));
    squares += (a - b) * (a - b);
    difference += a - b;
    sum += b;
    sum2 += b * b;
  }
  // 512 taps a pixel of texels that differ by half their value: 2 % a pixel; 576 pixels together: 0.1 %, held to 4
  // sigma.
  EXPECT_LT(std::sqrt(squares / sum2), 0.04);
  EXPECT_LT(std::abs(difference / sum), 0.004);
}

}  // namespace
}  // namespace vamp
