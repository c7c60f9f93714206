// Sums over very many samples, and the layout of what CPU and GPU share.
#include <cmath>
#include <cstddef>

#include "engine/render/renderer.h"
#include "shaders/spirv.h"
#include "tests/gpu/spirv_reflection.h"
#include "tests/render/render_test.h"

namespace vamp {
namespace {

TEST_F(RenderTest, AMillionSamplesSumToWithinOneInAMillion) {
  // A plane under parallel light has the same radiance in every sample: the worst case for rounding, because every
  // addition errs to the same side.
  SceneBuilder scene;
  scene.add_quad("floor", {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  scene.set_color("floor", vec3(0.1f));
  Project project = dark_project(scene.build());
  project.camera.eye = vec3(0, 1, 0.001f);
  project.camera.target = vec3(0);
  project.settings.pixel_centres = true;
  Light light;
  light.type = LightType::directional;
  light.center = vec3(0, 1, 0);
  light.target = vec3(0);
  light.power = 1;
  project.lights = {light};
  Renderer renderer(*device);
  ASSERT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  renderer.set_region(8, 8, {0, 0, 8, 8});
  uint64_t value = renderer.refine_all(1);
  const double one = static_cast<double>(renderer.accumulators(value)[64 * 4]);
  constexpr uint32_t kSamples = 1'000'000;
  while (renderer.samples() < kSamples) value = renderer.refine_all(kSamples);
  const double sum = static_cast<double>(renderer.accumulators(value)[64 * 4]);
  EXPECT_NEAR(sum / (one * kSamples), 1.0, 1e-6);
}

#define EXPECT_OFFSET(layout, type, member) \
  EXPECT_EQ(layout.offsets.at(#member), offsetof(frame::type, member)) << #type "." #member

TEST(SharedStructs, HaveTheSameOffsetsInKernelsAndInCpp) {
  const auto params = test::reflect_struct(spirv::shade_comp(), "FrameParams");
  ASSERT_TRUE(params) << params.error().message();
  EXPECT_OFFSET((*params), FrameParams, origin);
  EXPECT_OFFSET((*params), FrameParams, seed);
  EXPECT_OFFSET((*params), FrameParams, ao_radius);
  EXPECT_OFFSET((*params), FrameParams, offset_scale);
  EXPECT_OFFSET((*params), FrameParams, grid_scale);
  EXPECT_OFFSET((*params), FrameParams, picture_height);
  EXPECT_OFFSET((*params), FrameParams, region_width);
  EXPECT_OFFSET((*params), FrameParams, background);
  EXPECT_OFFSET((*params), FrameParams, exposure);
  EXPECT_OFFSET((*params), FrameParams, environment_sin);
  EXPECT_OFFSET((*params), FrameParams, planes);
  EXPECT_OFFSET((*params), FrameParams, emission);
  const auto light = test::reflect_struct(spirv::trace_comp(), "LightRow");
  ASSERT_TRUE(light) << light.error().message();
  EXPECT_OFFSET((*light), LightRow, center);
  EXPECT_OFFSET((*light), LightRow, type);
  EXPECT_OFFSET((*light), LightRow, half_width);
  EXPECT_OFFSET((*light), LightRow, n);
  EXPECT_OFFSET((*light), LightRow, area);
  EXPECT_OFFSET((*light), LightRow, spot_offset);
  EXPECT_EQ(light->stride, sizeof(frame::LightRow));
  const auto push = test::reflect_struct(spirv::trace_comp(), "TilePush");
  ASSERT_TRUE(push) << push.error().message();
  EXPECT_OFFSET((*push), TilePush, x);
  EXPECT_OFFSET((*push), TilePush, height);
  EXPECT_OFFSET((*push), TilePush, sample_base);
}

}  // namespace
}  // namespace vamp
