// An edit that moves no ray is answered from stored hits and visibility, only where it is seen, and leaves the picture
// that a fresh render gives, byte for byte: whatever was edited, in what order, at which moment and with how much
// memory.
#include "engine/render/replay.h"

#include <cstring>
#include <random>

#include "engine/render/renderer.h"
#include "tests/render/render_test.h"

namespace vamp {
namespace {

constexpr int kWidth = 72, kHeight = 70;

Project two_materials() {
  SceneBuilder scene;
  scene.add_quad("floor", {-2, -0.6f, 2}, {4, 0, 0}, {0, 0, -4});
  scene.add_sphere("ball", vec3(0), 0.6f, 24);
  scene.add_sphere("pearl", {0.9f, -0.3f, 0.3f}, 0.3f, 16);
  Project project = dark_project(scene.build());
  put_material(project, "ball", make_rich_material(7));
  put_material(project, "pearl", make_rich_material(8));
  Light key;
  key.type = LightType::rect;
  key.center = vec3(1, 2, 1);
  key.target = vec3(0);
  key.power = 30;
  project.lights = {key};
  project.ambient = vec3(0.2f);
  project.camera.eye = vec3(0.5f, 0.8f, 3);
  project.camera.target = vec3(0.1f, 0, 0);
  project.camera.fov_degrees = 35;
  return project;
}

class ReplayTest : public RenderTest {
 protected:
  void show(Renderer& renderer, const Project& project) {
    const Result<Change> change = renderer.set_project(std::make_shared<const Project>(project));
    ASSERT_TRUE(change) << change.error().message();
    last = *change;
  }
  // All tiles to the same number of samples.
  std::vector<float> finish(Renderer& renderer, uint32_t samples) {
    uint64_t value = 0;
    while (renderer.replaying()) value = renderer.replay(700);
    for (int tile = 0; tile < renderer.tile_count(); ++tile)
      while (renderer.samples_of(tile) < samples) value = renderer.refine(tile, samples);
    return renderer.linear_picture(value);
  }
  std::vector<float> fresh(const Project& project, uint32_t samples) {
    Renderer renderer(*device);
    show(renderer, project);
    renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
    return finish(renderer, samples);
  }
  static bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
  }
  Change last;
};

void edit_at_random(Project& project, std::mt19937& random) {
  const auto unit = [&] { return static_cast<float>(random() % 1000) / 1000.0f; };
  // The last two are the measured ones.
  MaterialInstance& material = project.materials[project.materials.size() - 1 - random() % 2];
  const int cluster = static_cast<int>(random() % material.fit->clusters.size());
  const int basis = static_cast<int>(random() % material.fit->dictionary.size());
  BasisEdit edit;
  switch (random() % 8) {
    case 0:
    case 1:
      edit.gain = vec3(unit(), 2 * unit(), unit());
      material.edits.set({cluster, basis}, edit);
      break;
    case 2:
    case 3: {
      const float tilt = 0.6f * unit();
      edit.normal = vec3(tilt, 0, std::sqrt(1 - tilt * tilt));
      edit.psi = unit();
      material.edits.set({cluster, basis}, edit);
      break;
    }
    case 4:
      material.edits.residual_terms = static_cast<int>(random() % 5);
      break;
    case 5:
      project.parts[1].texture_rotation = unit();
      break;
    case 6:
      std::swap(project.parts[1].material, project.parts[2].material);
      break;
    case 7:
      project.lights[0].power = 10 + 20 * unit();
      break;
  }
}

TEST_F(ReplayTest, AnySequenceOfEditsEndsInTheFreshPicture) {
  // None, some and all samples can be shaded again without tracing; with a mirror there are two hits a pixel.
  const std::vector<std::pair<uint64_t, float>> cases = {{0, 0.0f}, {80 << 10, 0.0f}, {8 << 20, 0.0f}, {8 << 20, 0.5f}};
  for (size_t c = 0; c < cases.size(); ++c)
    for (uint32_t seed = 0; seed < 3; ++seed) {
      std::mt19937 random(100 * static_cast<uint32_t>(c) + seed);
      Project project = two_materials();
      project.parts[0].mirror_f0 = cases[c].second;
      Renderer renderer(*device);
      renderer.set_history(cases[c].first);
      show(renderer, project);
      renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
      for (int step = 0; step < 24; ++step) {
        if (random() % 3 == 0) {
          edit_at_random(project, random);
          show(renderer, project);
          EXPECT_FALSE(step > 0 && last.restarted) << last.what;
        } else if (renderer.replaying()) {
          renderer.replay(1 + random() % 3000);
        } else {
          renderer.refine(static_cast<int>(random() % static_cast<uint32_t>(renderer.tile_count())), 10);
        }
      }
      EXPECT_TRUE(same_bytes(fresh(project, 10), finish(renderer, 10))) << "case " << c << ", sequence " << seed;
    }
}

TEST_F(ReplayTest, OnlyPixelsThatSeeTheEditAreShadedAgain) {
  Project project = two_materials();
  Renderer renderer(*device);
  renderer.set_history(8 << 20);
  show(renderer, project);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  const std::vector<float> before = finish(renderer, 8);

  BasisEdit edit;
  edit.gain = vec3(0.1f, 0.1f, 0.1f);
  for (int basis = 0; basis < static_cast<int>(project.materials.back().fit->dictionary.size()); ++basis)
    project.materials.back().edits.set({0, basis}, edit);
  show(renderer, project);
  const std::vector<float> after = finish(renderer, 8);
  size_t changed = 0;
  for (size_t i = 0; i < before.size(); i += 4) changed += std::memcmp(&before[i], &after[i], 16) != 0 ? 1 : 0;
  EXPECT_GT(changed, 0u);
  EXPECT_GE(last.reshaded, changed);
  EXPECT_LT(last.reshaded, static_cast<uint64_t>(kWidth * kHeight) / 4);
  // And the edit before that, taken back, is the picture before that.
  project.materials.back().edits = {};
  show(renderer, project);
  EXPECT_TRUE(same_bytes(before, finish(renderer, 8)));
}

TEST(Replay, StepsTakeThePixelsThatWantMoreAndEndAtEachOnesNumber) {
  Replay replay;
  EXPECT_FALSE(replay.active());
  replay.begin({10, 11, 12, 13}, std::vector<uint32_t>{4, 9, 4, 5});
  EXPECT_EQ(replay.pixels(), (std::vector<uint32_t>{11, 13, 10, 12}));
  EXPECT_EQ(replay.step().pixels, 4u);
  EXPECT_EQ(replay.step().limit, 4u);
  replay.advance(4);
  EXPECT_EQ(replay.step().pixels, 2u);
  EXPECT_EQ(replay.step().limit, 5u);
  replay.advance(1);
  EXPECT_EQ(replay.step().pixels, 1u);
  EXPECT_EQ(replay.step().limit, 9u);
  replay.advance(4);
  EXPECT_FALSE(replay.active());
}

}  // namespace
}  // namespace vamp
