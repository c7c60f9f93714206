// An edit that moves no ray is answered from stored hits and visibility, only where it is seen, and leaves the picture
// that a fresh render gives, byte for byte: whatever was edited, in what order, at which moment and with how much
// memory.
#include "engine/render/replay.h"

#include <cstring>

#include "engine/render/trace_path.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class ReplayTest : public test::EditedPicture {};

TEST_F(ReplayTest, AnySequenceOfEditsEndsInTheFreshPicture) {
  // None, some and all samples can be shaded again without tracing; with a mirror there are two hits a pixel.
  for (const auto& [history, mirror] : {std::pair(0u, 0.0f), {80u << 10, 0.0f}, {8u << 20, 0.0f}, {8u << 20, 0.5f}})
    for (uint32_t seed = 0; seed < 3; ++seed) run({.history = history, .mirror = mirror, .seed = seed});
}

TEST_F(ReplayTest, SoDoesAnySequenceOfEditsAndMovesOfParts) {
  for (const auto& [history, mirror] : {std::pair(0u, 0.0f), {8u << 20, 0.0f}, {8u << 20, 0.5f}})
    for (uint32_t seed = 0; seed < 3; ++seed)
      run({.history = history, .mirror = mirror, .weights = true, .moves = true, .seed = 50 + seed});
  if (!trace_paths(device->info()).chosen().ray_queries) {
    EXPECT_GT(trees, 3u);
  }
}

TEST_F(ReplayTest, OnlyPixelsThatSeeTheEditAreShadedAgain) {
  Project project = test::two_materials();
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
  EXPECT_TRUE(test::same_bytes(before, finish(renderer, 8)));
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
