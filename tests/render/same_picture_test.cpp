// The same picture: whatever the order, the batches, the tiles and the edits on the way, k samples are k samples.
#include <chrono>
#include <cstring>
#include <thread>

#include "engine/project/job.h"
#include "engine/render/renderer.h"
#include "engine/render/session.h"
#include "tests/render/render_test.h"

namespace vamp {
namespace {

Project rich_project() {
  SceneBuilder scene;
  scene.add_quad("floor", {-2, -0.6f, 2}, {4, 0, 0}, {0, 0, -4});
  scene.add_sphere("ball", vec3(0), 0.6f, 24);
  scene.add_box("block", {0.7f, -0.6f, -0.4f}, {1.2f, 0.1f, 0.2f});
  scene.set_color("block", {0.2f, 0.5f, 0.7f});
  Project project = dark_project(scene.build());
  put_material(project, "ball", make_rich_material(7));
  Light rect;
  rect.type = LightType::rect;
  rect.name = "key";
  rect.center = vec3(1, 2, 1);
  rect.target = vec3(0);
  rect.power = 30;
  Light disk = rect;
  disk.type = LightType::disk;
  disk.name = "fill";
  disk.center = vec3(-2, 1, 1);
  disk.radius = 0.4f;
  disk.power = 10;
  project.lights = {rect, disk};
  project.ambient = vec3(0.2f);
  project.background = vec3(0.1f);
  project.camera.eye = vec3(0.5f, 0.8f, 3);
  project.camera.target = vec3(0.1f, 0, 0);
  project.camera.fov_degrees = 35;
  return project;
}

bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

std::vector<float> fresh(gpu::Device& device, const Project& project, int width, int height, uint32_t samples) {
  Renderer renderer(device);
  EXPECT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  renderer.set_region(width, height, {0, 0, width, height});
  uint64_t value = 0;
  while (renderer.samples() < samples) value = renderer.refine_all(samples);
  return renderer.linear_picture(value);
}

TEST_F(RenderTest, TilesRegionsAndBatchesGiveTheSameBytes) {
  const Project project = rich_project();
  const auto shared = std::make_shared<const Project>(project);
  const std::vector<float> whole = fresh(*device, project, 100, 70, 9);

  // Tile by tile, each to the end before the next.
  Renderer renderer(*device);
  ASSERT_TRUE(renderer.set_project(shared));
  renderer.set_region(100, 70, {0, 0, 100, 70});
  uint64_t value = 0;
  for (int tile = renderer.tile_count() - 1; tile >= 0; --tile)
    while (renderer.samples_of(tile) < 9) value = renderer.refine(tile, 9);
  EXPECT_TRUE(same_bytes(whole, renderer.linear_picture(value)));

  // One by one: the limit cuts every batch of four.
  renderer.set_region(100, 70, {0, 0, 100, 70});
  for (uint32_t k = 1; k <= 9; ++k) value = renderer.refine_all(k);
  EXPECT_TRUE(same_bytes(whole, renderer.linear_picture(value)));

  // A region of the picture holds the picture's pixels.
  renderer.set_region(100, 70, {30, 20, 40, 30});
  while (renderer.samples() < 9) value = renderer.refine_all(9);
  const std::vector<float> part = renderer.linear_picture(value);
  for (int y = 0; y < 30; ++y)
    EXPECT_EQ(std::memcmp(&part[static_cast<size_t>(y) * 40 * 4],
                          &whole[((static_cast<size_t>(y) + 20) * 100 + 30) * 4], 40 * 16),
              0);
}

TEST_F(RenderTest, EditsOnTheWayLeaveNoTrace) {
  Project project = rich_project();
  Renderer renderer(*device);
  renderer.set_region(64, 48, {0, 0, 64, 48});
  const auto show = [&] {
    const auto change = renderer.set_project(std::make_shared<const Project>(project));
    ASSERT_TRUE(change) << change.error().message();
  };
  show();
  const auto refine = [&](uint32_t samples) {
    uint64_t value = 0;
    while (renderer.replaying()) value = renderer.replay(1000);
    while (renderer.samples() < samples) value = renderer.refine_all(samples);
    return renderer.linear_picture(value);
  };
  refine(5);
  // One edit of every kind, each compared with a fresh render of the same project.
  const std::vector<std::function<void()>> edits = {
      [&] {
        BasisEdit edit;
        edit.gain = vec3(0.5f, 1.5f, 1);
        project.materials.back().edits.set({0, 3}, edit);
      },
      [&] {
        BasisEdit edit;
        edit.normal = vec3(0.3f, 0.1f, std::sqrt(0.9f));
        edit.psi = 0.7f;
        project.materials.back().edits.set({1, 4}, edit);
      },
      [&] { project.materials.back().edits.residual_terms = 2; },
      [&] { project.materials.back().edits.residual_policy = ResidualPolicy::keep; },
      [&] { project.lights[0].power = 5; },
      [&] { project.lights[0].on = false; },
      [&] { project.lights[0].on = true; },
      [&] { project.lights[1].on = false; },
      [&] { project.lights[1].on = true; },
      [&] { project.lights[1].center.x += 0.5f; },
      [&] { project.ambient = vec3(0.3f, 0.1f, 0.1f); },
      [&] { project.display.exposure = 1; },
      [&] { project.parts[0].mirror_f0 = 0.4f; },
      [&] { project.parts[2].visible = false; },
      [&] { project.parts[1].texture_rotation = 0.4f; },
      [&] { project.camera.eye.x += 0.3f; },
      [&] { project.settings.tap = TexelTap::four; },
      [&] { project.settings.seed = 3; },
      [&] { project.lights.erase(project.lights.begin()); },
  };
  for (size_t i = 0; i < edits.size(); ++i) {
    edits[i]();
    show();
    const std::vector<float> now = refine(6);
    EXPECT_TRUE(same_bytes(fresh(*device, project, 64, 48, 6), now)) << "edit " << i;
  }
}

TEST_F(RenderTest, ACoarseLookShowsBlocksOfTheFirstSampleAndLeavesNoTrace) {
  constexpr int kSide = 45, kStride = 4;
  const Project project = rich_project();
  Renderer renderer(*device);
  ASSERT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  renderer.set_region(kSide, kSide, {0, 0, kSide, kSide});
  const std::vector<uint32_t> coarse = renderer.display_picture(renderer.preview(kStride));
  const std::vector<uint32_t> fine = renderer.display_picture(renderer.refine_all(1));
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      ASSERT_EQ(coarse[static_cast<size_t>(y * kSide + x)],
                fine[static_cast<size_t>((y - y % kStride) * kSide + x - x % kStride)])
          << x << ", " << y;
  uint64_t value = 0;
  while (renderer.samples() < 6) value = renderer.refine_all(6);
  EXPECT_TRUE(same_bytes(fresh(*device, project, kSide, kSide, 6), renderer.linear_picture(value)));
}

TEST_F(RenderTest, LightsAndExposureDoNotRestart) {
  Project project = rich_project();
  Renderer renderer(*device);
  renderer.set_region(32, 32, {0, 0, 32, 32});
  ASSERT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  while (renderer.samples() < 4) device->wait(renderer.refine_all(4));
  project.lights[0].power = 77;
  project.lights[1].color = vec3(1, 0, 0);
  project.display.exposure = -1;
  const auto change = renderer.set_project(std::make_shared<const Project>(project));
  ASSERT_TRUE(change);
  EXPECT_FALSE(change->restarted);
  EXPECT_TRUE(change->recomposed);
  EXPECT_EQ(renderer.samples(), 4u);
}

TEST_F(RenderTest, AnEditSendsOnlyTheRowsThatChanged) {
  Project project = rich_project();
  Renderer renderer(*device);
  renderer.set_region(32, 32, {0, 0, 32, 32});
  ASSERT_TRUE(renderer.set_project(std::make_shared<const Project>(project)));
  BasisEdit edit;
  edit.gain = vec3(2, 1, 1);
  project.materials.back().edits.set({0, 2}, edit);
  const auto change = renderer.set_project(std::make_shared<const Project>(project));
  ASSERT_TRUE(change);
  EXPECT_FALSE(change->restarted);
  // One row of the function and the cluster's residual scale.
  EXPECT_LE(change->bytes, sizeof(tables::BasisRow) + sizeof(tables::ClusterRow));
  EXPECT_GE(change->bytes, sizeof(tables::BasisRow));
}

TEST_F(RenderTest, TheSessionsPictureIsTheCommandLines) {
  Project project = rich_project();
  project.settings.max_samples = 12;
  RenderSession session(*device, std::make_shared<const Project>(project), 80, 60);
  BasisEdit edit;
  edit.gain = vec3(0.2f, 1, 1);
  project.materials.back().edits.set({0, 1}, edit);
  for (int i = 0; i < 3000 && session.status().samples < 4; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_GE(session.status().samples, 4u);
  session.set_project(std::make_shared<const Project>(project), "weight of a function");
  for (int i = 0; i < 600 && !(session.status().finished && session.status().restart_reason == "weight of a function");
       ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  int width = 0, height = 0;
  uint32_t samples = 0;
  const std::vector<float> live = session.linear_picture(width, height, samples);
  ASSERT_EQ(samples, 12u);
  const Still still = render(project, 80, 60, 12);
  EXPECT_TRUE(same_bytes(live, still.image.pixels));
  // Those that saw the edited cluster.
  EXPECT_GT(session.status().restarted_pixels, 0u);
  EXPECT_LT(session.status().restarted_pixels, 4800u);
}

}  // namespace
}  // namespace vamp
