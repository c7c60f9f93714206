// Weights at hand: an edit of gains, tints or mutes of what is selected is answered from sums gathered beforehand, in
// the whole picture at once, and leaves what a fresh render gives.
#include <cmath>

#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class WeightsTest : public test::EditedPicture {
 protected:
  void SetUp() override {
    EditedPicture::SetUp();
    project = test::two_materials();
    group.material = static_cast<int>(project.materials.size()) - 1;
    group.rows = {{0, 2}, {1, 2}};
    renderer = std::make_unique<Renderer>(*device);
    renderer->set_history(8 << 20);
    show(*renderer, project);
    renderer->set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
    before = finish(*renderer, 8);
  }
  void TearDown() override {
    renderer.reset();
    EditedPicture::TearDown();
  }
  void gather() {
    renderer->set_weights_at_hand(group);
    while (renderer->wants_weights(true)) renderer->gather_weights(true, 900);
  }
  void pull(vec3 gain, bool mute = false) {
    for (const BasisKey key : group.rows) {
      EditLayer& edits = project.materials[static_cast<size_t>(group.material)].edits;
      BasisEdit edit = edits.edit_of(key);
      edit.gain = gain;
      edit.mute = mute;
      edits.set(key, edit);
    }
    show(*renderer, project);
  }
  std::vector<float> now() { return renderer->linear_picture(device->last_submitted()); }
  void expect_fresh(uint32_t samples) {
    EXPECT_LT(test::largest_difference(fresh(project, samples), now(), before), 1e-5);
  }

  Project project;
  WeightGroup group;
  std::unique_ptr<Renderer> renderer;
  std::vector<float> before;
};

TEST_F(WeightsTest, APulledWeightIsAnsweredWithoutShading) {
  gather();
  EXPECT_TRUE(renderer->weights_ready());
  EXPECT_TRUE(renderer->tints_ready());
  for (const vec3 gain : {vec3(0.3f), vec3(2), vec3(1, 0.2f, 0.1f), vec3(0, 1, 0), vec3(0)}) {
    pull(gain);
    EXPECT_GT(last.recombined, 0u);
    EXPECT_EQ(last.reshaded, 0u);
    EXPECT_FALSE(renderer->replaying());
    expect_fresh(8);
  }
  pull(vec3(1));
  pull(vec3(1), true);
  EXPECT_GT(last.recombined, 0u);
  expect_fresh(8);
}

TEST_F(WeightsTest, TakenBackTheEditLeavesThePictureFromBefore) {
  gather();
  for (int i = 0; i < 300; ++i) pull(vec3(2 * std::abs(std::sin(static_cast<float>(i)))));
  pull(vec3(1));
  EXPECT_LT(test::largest_difference(before, now(), before), 2e-6);
}

TEST_F(WeightsTest, TheShownPictureIsThatOfTheSums) {
  gather();
  pull(vec3(0.2f, 1.5f, 0.7f));
  const std::vector<uint32_t> shown = renderer->display_picture(device->last_submitted());
  EXPECT_EQ(shown, renderer->display_picture(renderer->recompose()));
}

TEST_F(WeightsTest, LaterSamplesAreOfTheEditedMaterialAndGatheredToo) {
  gather();
  pull(vec3(0.4f));
  for (int tile = 0; tile < renderer->tile_count(); ++tile) renderer->refine(tile, 12);
  expect_fresh(12);
  // The tiles are one batch ahead of the sums: the edit has them caught up first.
  pull(vec3(1.7f));
  EXPECT_GT(last.recombined, 0u);
  expect_fresh(12);
}

TEST_F(WeightsTest, BeforeTheirSumsAreThereWeightsAreShadedAgain) {
  // The larger ball: more than is caught up at once.
  group.material -= 1;
  before = finish(*renderer, 400);
  renderer->set_weights_at_hand(group);
  renderer->gather_weights(true, 100);
  EXPECT_FALSE(renderer->weights_ready());
  pull(vec3(0.4f));
  EXPECT_EQ(last.recombined, 0u);
  EXPECT_GT(last.reshaded, 0u);
  EXPECT_TRUE(test::same_bytes(fresh(project, 400), finish(*renderer, 400)));
  // What was gathered is not lost.
  gather();
  pull(vec3(1.1f));
  EXPECT_GT(last.recombined, 0u);
  expect_fresh(400);
}

TEST_F(WeightsTest, AnEditOfShapeIsShadedAgainAndTheSumsAreMadeAnew) {
  gather();
  BasisEdit edit;
  edit.normal = vec3(0.6f, 0, 0.8f);
  project.materials.back().edits.set(group.rows[0], edit);
  show(*renderer, project);
  EXPECT_EQ(last.recombined, 0u);
  EXPECT_TRUE(test::same_bytes(fresh(project, 8), finish(*renderer, 8)));
  gather();
  pull(vec3(0.2f));
  EXPECT_GT(last.recombined, 0u);
  expect_fresh(8);
}

TEST_F(WeightsTest, AnotherFunctionsWeightIsShadedAgain) {
  gather();
  BasisEdit edit;
  edit.gain = vec3(0.5f);
  project.materials.back().edits.set({0, 3}, edit);
  show(*renderer, project);
  EXPECT_EQ(last.recombined, 0u);
  EXPECT_GT(last.reshaded, 0u);
}

TEST_F(WeightsTest, RowsOfDifferentGainsAreBroughtToOneAtOnce) {
  BasisEdit edit;
  edit.gain = vec3(0.3f, 0.2f, 0);
  project.materials.back().edits.set(group.rows[1], edit);
  show(*renderer, project);
  before = finish(*renderer, 8);
  gather();
  for (const float gain : {0.8f, 0.1f, 1.7f}) {
    pull(vec3(gain, 0.5f * gain, 0.9f));
    EXPECT_GT(last.recombined, 0u);
    expect_fresh(8);
  }
}

TEST_F(WeightsTest, ATintedWeightIsScaledByTheFirstSums) {
  pull(vec3(0.5f, 0.25f, 0.1f));
  before = finish(*renderer, 8);
  renderer->set_weights_at_hand(group);
  while (renderer->wants_weights(false)) renderer->gather_weights(false, 900);
  EXPECT_TRUE(renderer->weights_ready());
  pull(vec3(1, 0.5f, 0.2f));
  EXPECT_GT(last.recombined, 0u);
  expect_fresh(8);
}

TEST_F(WeightsTest, AMirrorsReflectionOfALampIsNotPulled) {
  project.parts[0].mirror_f0 = 0.6f;
  // Behind the camera's view of the floor, so that the lamp itself is seen in it.
  project.lights[0].center = vec3(-0.2f, 1.5f, -2);
  project.lights[0].size = vec2(2, 2);
  show(*renderer, project);
  before = finish(*renderer, 8);
  gather();
  pull(vec3(0.2f));
  EXPECT_GT(last.recombined, 0u);
  expect_fresh(8);
}

TEST_F(WeightsTest, AnySequenceOfEditsAndSelectionsEndsInTheFreshPicture) {
  for (const auto& [history, mirror] : {std::pair(0u, 0.0f), {80u << 10, 0.0f}, {8u << 20, 0.0f}, {8u << 20, 0.5f}})
    for (uint32_t seed = 0; seed < 4; ++seed)
      run({.history = history, .mirror = mirror, .weights = true, .seed = 100 + seed});
  // A tint is taken back while its sums are still being gathered for later samples.
  run({.history = 8 << 20, .mirror = 0.5f, .weights = true, .seed = 1224});
  EXPECT_GT(recombined, 0u);
}

}  // namespace
}  // namespace vamp
