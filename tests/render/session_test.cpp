// What the interactive renderer tells of its picture while the view moves and lights change.
#include "engine/render/session.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/render/render_test.h"

namespace vamp {
namespace {

template <class Holds>
bool soon(Holds holds) {
  for (int i = 0; i < 1200; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(50)))
    if (holds()) return true;
  return false;
}

Project box_under_a_light() {
  SceneBuilder scene;
  scene.add_box("box", vec3(-0.5f), vec3(0.5f));
  Project project = dark_project(scene.build());
  project.camera = {.eye = vec3(0, 1, 3), .target = vec3(0)};
  Light light;
  light.center = vec3(0, 3, 3);
  light.power = 10;
  project.lights = {light};
  return project;
}

TEST_F(RenderTest, ForgetsWhereThingsWereWhenTheViewMovesAndNotWhenALightDoes) {
  Project project = box_under_a_light();
  RenderSession session(*device, std::make_shared<const Project>(project), 32, 24);
  PixelLayer ids;
  ASSERT_TRUE(soon([&] { return session.copy_ids(ids); }));
  EXPECT_EQ(ids.pixels.size(), 32u * 24u);

  // While it is paused each change is shown in a first look, and nothing is refined.
  session.pause(true);
  const auto show = [&](const Project& next) {
    const auto shared = std::make_shared<const Project>(next);
    const uint64_t before = session.picture_version();
    session.set_project(shared, "");
    return soon([&] { return session.status().project == shared && session.picture_version() > before; });
  };
  project.lights[0].center.x = 1;
  ASSERT_TRUE(show(project));
  EXPECT_FALSE(session.copy_ids(ids) && ids.pixels.empty());
  project.camera.eye.x = 1;
  ASSERT_TRUE(show(project));
  EXPECT_TRUE(session.copy_ids(ids));
  EXPECT_TRUE(ids.pixels.empty());

  session.pause(false);
  ASSERT_TRUE(soon([&] { return session.copy_ids(ids); }));
  EXPECT_EQ(ids.pixels.size(), 32u * 24u);
}

TEST_F(RenderTest, SaysThatNoPixelRestartedWhereSumsAreWeighedAnew) {
  Project project = box_under_a_light();
  project.settings.max_samples = 2;
  RenderSession session(*device, std::make_shared<const Project>(project), 32, 24);
  ASSERT_TRUE(soon([&] { return session.status().finished; }));
  EXPECT_EQ(session.status().restarted_pixels, 32u * 24u);
  project.lights[0].power = 20;
  const auto brighter = std::make_shared<const Project>(project);
  session.set_project(brighter, "power of a light");
  ASSERT_TRUE(soon([&] { return session.status().project == brighter; }));
  const RenderStatus status = session.status();
  EXPECT_EQ(status.restarted_pixels, 0u);
  EXPECT_EQ(status.restart_reason, "power of a light");
  EXPECT_EQ(status.samples, 2u);
}

TEST_F(RenderTest, TheSelectedWeightFollowsWithAllItsSamples) {
  Project project = box_under_a_light();
  put_material(project, "box", make_rich_material(5));
  project.settings.max_samples = 32;
  RenderSession session(*device, std::make_shared<const Project>(project), 48, 40);
  WeightGroup group;
  group.material = static_cast<int>(project.materials.size()) - 1;
  group.rows = {{0, 1}, {1, 1}};
  session.set_weights_at_hand(group);
  ASSERT_TRUE(soon([&] { return session.status().finished && session.status().weights_at_hand; }));
  BasisEdit edit;
  edit.gain = vec3(1.5f);
  for (const BasisKey key : group.rows) project.materials.back().edits.set(key, edit);
  session.set_project(std::make_shared<const Project>(project), "weight of a function");
  ASSERT_TRUE(soon([&] { return session.status().restart_reason == "weight of a function"; }));
  const RenderStatus status = session.status();
  EXPECT_EQ(status.samples, 32u);
  EXPECT_EQ(status.restarted_pixels, 0u);
  EXPECT_GT(status.recombined_pixels, 0u);
  PixelLayer restarted;
  ASSERT_TRUE(session.copy_restarted(restarted));
  EXPECT_TRUE(std::all_of(restarted.pixels.begin(), restarted.pixels.end(), [](uint32_t mark) { return mark == 0; }));
}

TEST_F(RenderTest, WithoutMemoryForEditsThePictureIsTheSame) {
  Project project = box_under_a_light();
  put_material(project, "box", make_rich_material(5));
  project.settings.max_samples = 8;
  RenderSession session(*device, std::make_shared<const Project>(project), 48, 40, 0);
  session.set_weights_at_hand({static_cast<int>(project.materials.size()) - 1, {{0, 1}}});
  ASSERT_TRUE(soon([&] { return session.status().finished; }));
  BasisEdit edit;
  edit.gain = vec3(1.5f);
  project.materials.back().edits.set({0, 1}, edit);
  session.set_project(std::make_shared<const Project>(project), "weight of a function");
  ASSERT_TRUE(
      soon([&] { return session.status().restart_reason == "weight of a function" && session.status().finished; }));
  EXPECT_FALSE(session.status().weights_at_hand);
  int width = 0, height = 0;
  uint32_t samples = 0;
  EXPECT_EQ(session.linear_picture(width, height, samples), render(project, 48, 40, 8).image.pixels);
}

TEST_F(RenderTest, AWindowTooLargeForTheDeviceKeepsThePictureAsItWas) {
  Project project = box_under_a_light();
  project.settings.max_samples = 2;
  RenderSession session(*device, std::make_shared<const Project>(project), 32, 24);
  ASSERT_TRUE(soon([&] { return session.status().finished; }));
  session.resize(1 << 15, 1 << 15);
  ASSERT_TRUE(soon([&] { return !session.status().error.empty(); }));
  EXPECT_FALSE(session.status().lost);
  EXPECT_EQ(session.status().width, 32);
  session.resize(40, 30);
  ASSERT_TRUE(soon([&] { return session.status().width == 40 && session.status().finished; }));
  EXPECT_TRUE(session.status().error.empty());
}

TEST_F(RenderTest, WhatAnEditRestartedIsMarked) {
  Project project = box_under_a_light();
  put_material(project, "box", make_rich_material(5));
  project.settings.max_samples = 8;
  RenderSession session(*device, std::make_shared<const Project>(project), 48, 40);
  ASSERT_TRUE(soon([&] { return session.status().finished; }));
  PixelLayer restarted;
  ASSERT_TRUE(session.copy_restarted(restarted));
  const auto marked = [&] { return std::count(restarted.pixels.begin(), restarted.pixels.end(), 1u); };
  EXPECT_EQ(marked(), 48 * 40);
  BasisEdit edit;
  edit.psi = 1;
  project.materials.back().edits.set({0, 1}, edit);
  session.set_project(std::make_shared<const Project>(project), "angle of a function");
  ASSERT_TRUE(soon([&] { return session.copy_restarted(restarted); }));
  EXPECT_EQ(static_cast<uint64_t>(marked()), session.status().restarted_pixels);
  EXPECT_GT(marked(), 0);
  EXPECT_LT(marked(), 48 * 40);
}

}  // namespace
}  // namespace vamp
