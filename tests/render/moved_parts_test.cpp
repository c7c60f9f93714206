// Parts that stand elsewhere than the model has them: the picture is that of a model which has them there, however they
// came there.
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/render/session.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class MovedParts : public test::EditedPicture {
 protected:
  static PartState& part(Project& project, const char* name) {
    return project.parts[static_cast<size_t>(find_part(project, name))];
  }
};

// The model with its vertices where the parts stand.
Project as_a_model(Project project) {
  auto scene = std::make_shared<Scene>(*project.scene);
  std::vector<bool> done(scene->positions.size());
  for (size_t i = 0; i < scene->triangles.size(); ++i) {
    const RigidMotion motion = motion_of(project, scene->triangle_part[i]);
    for (int k = 0; k < 3; ++k) {
      const uint32_t v = scene->triangles[i][k];
      if (done[v]) continue;
      done[v] = true;
      scene->positions[v] = motion.point(scene->positions[v]);
      scene->normals[v] = motion.direction(scene->normals[v]);
      scene->tangents[v] = vec4(motion.direction(vec3(scene->tangents[v])), scene->tangents[v].w);
    }
  }
  finish_scene(*scene);
  for (PartState& part : project.parts) part.place = {};
  project.scene = std::move(scene);
  return project;
}

TEST_F(MovedParts, LookLikeAModelThatHasThemThere) {
  Project project = test::two_materials();
  part(project, "ball").place = {{0.3f, 0.1f, -0.2f}, {0.5f, 1.2f, -0.4f}};
  part(project, "pearl").place.offset = {-1.5f, 0.4f, 0.1f};
  const Project model = as_a_model(project);
  // The floor is the larger, so that the scene's size is the same, and with it how far rays start off a surface.
  ASSERT_EQ(model.scene->bounds.lo.x, project.scene->bounds.lo.x);
  const Still moved = render(project, kWidth, kHeight, 6, {Layer::part, Layer::normal, Layer::depth, Layer::uv});
  const Still there = render(model, kWidth, kHeight, 6, {Layer::part, Layer::normal, Layer::depth, Layer::uv});
  const float size = model.scene->bounds.radius() / project.scene->bounds.radius();
  ASSERT_NEAR(size, 1, 0.05);
  size_t off = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (size_t c = 0; c < moved.image.channels.size(); ++c) {
        const float a = moved.image.at(x, y, c), b = there.image.at(x, y, c);
        // Radiance within a start of rays that is a few millionths off; layers exactly.
        EXPECT_TRUE(c < 4 || a == b) << moved.image.channels[c] << " at " << x << ", " << y << ": " << a << ", " << b;
        off += std::abs(a - b) > 1e-4f * (1 + std::abs(b)) ? 1 : 0;
      }
  EXPECT_LE(off, 8u);
}

TEST_F(MovedParts, GiveTheSameBytesWhicheverWayTheyCame) {
  Project project = test::two_materials();
  part(project, "pearl").place = {{-0.9f, 0.7f, 0.2f}, {0, 2, 1}};
  part(project, "ball").place.offset = {0.1f, 0, 0};
  const std::vector<float> direct = render(project, kWidth, kHeight, 5).image.pixels;

  Renderer renderer(*device);
  Project way = test::two_materials();
  show(renderer, way);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  finish(renderer, 3);
  for (int i = 0; i < 8; ++i) {
    part(way, "pearl").place = {vec3(static_cast<float>(i)), vec3(0, 0, static_cast<float>(i))};
    part(way, i % 2 == 0 ? "ball" : "floor").place.offset.y = 3;
    show(renderer, way);
    EXPECT_TRUE(last.restarted);
    EXPECT_EQ(last.what, "part moved");
  }
  show(renderer, project);
  EXPECT_TRUE(test::same_bytes(finish(renderer, 5), direct));
  // And back where the model has them.
  show(renderer, test::two_materials());
  EXPECT_TRUE(test::same_bytes(finish(renderer, 5), render(test::two_materials(), kWidth, kHeight, 5).image.pixels));
}

TEST_F(MovedParts, ATreeThatHasBecomeBadIsMadeAnewWhenTheHandRests) {
  Project project = test::two_materials();
  Renderer renderer(*device), another(*device);
  // The program's own tree, whoever else could trace rays.
  for (Renderer* const each : {&renderer, &another}) each->set_trace_path({});
  renderer.make_trees_later();
  show(renderer, project);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  EXPECT_FALSE(renderer.wants_tree());
  const Bvh at_rest = renderer.scene_tables()->bvh;
  part(project, "ball").place.offset.y = 4;
  show(renderer, project);
  EXPECT_TRUE(renderer.wants_tree());
  // The coarse look shows the moved part all the same.
  const std::vector<uint32_t> coarse = renderer.display_picture(renderer.preview(1));
  EXPECT_EQ(renderer.scene_tables()->bvh.order, at_rest.order);
  ASSERT_TRUE(renderer.make_tree());
  EXPECT_FALSE(renderer.wants_tree());
  EXPECT_NE(renderer.scene_tables()->bvh.order, at_rest.order);
  EXPECT_EQ(renderer.display_picture(renderer.preview(1)), coarse);
  show(another, project);
  EXPECT_FALSE(another.wants_tree());
  another.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  EXPECT_TRUE(test::same_bytes(finish(renderer, 5), finish(another, 5)));
  // A step back, and the first tree serves again.
  part(project, "ball").place.offset.y = 0;
  show(renderer, project);
  EXPECT_FALSE(renderer.wants_tree());
  EXPECT_EQ(renderer.scene_tables()->bvh.nodes, at_rest.nodes);
}

TEST_F(MovedParts, AMoveSendsNoMoreThanItsTrianglesAndTheBoxes) {
  Project project = test::two_materials();
  Renderer renderer(*device);
  show(renderer, project);
  const uint64_t whole = last.bytes;
  part(project, "pearl").place.offset.x = 0.01f;
  show(renderer, project);
  EXPECT_GT(last.bytes, 0u);
  EXPECT_LT(last.bytes, whole / 2);
  show(renderer, project);
  EXPECT_EQ(last.bytes, 0u);
  EXPECT_FALSE(last.restarted);
}

TEST_F(MovedParts, AHiddenPartMovesUnseen) {
  Project project = test::two_materials();
  part(project, "pearl").visible = false;
  Renderer renderer(*device);
  show(renderer, project);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  part(project, "pearl").place.offset.x = -0.5f;
  show(renderer, project);
  EXPECT_FALSE(last.restarted);
  part(project, "pearl").visible = true;
  show(renderer, project);
  EXPECT_TRUE(last.restarted);
  EXPECT_TRUE(test::same_bytes(finish(renderer, 3), render(project, kWidth, kHeight, 3).image.pixels));
}

template <class Holds>
bool soon(Holds holds) {
  for (int i = 0; i < 1200; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(50)))
    if (holds()) return true;
  return false;
}

TEST_F(MovedParts, ArePickedWhereTheyStandAndOutlinedThere) {
  Project project = test::two_materials();
  const int ball = find_part(project, "ball");
  project.settings.max_samples = 4;
  RenderSession session(*device, std::make_shared<const Project>(project), kWidth, kHeight);
  ASSERT_TRUE(soon([&] { return session.status().finished; }));
  const Pick before = session.pick(kWidth / 2.0f, kHeight / 2.0f);
  ASSERT_EQ(before.part, ball);
  part(project, "ball").place.offset.x = -0.8f;
  project.camera.eye.x -= 0.8f;
  project.camera.target.x -= 0.8f;
  const auto moved = std::make_shared<const Project>(project);
  session.set_project(moved, "place of ball");
  ASSERT_TRUE(soon([&] { return session.status().project == moved && session.status().finished; }));
  EXPECT_EQ(session.status().restart_reason, "place of ball");
  const Pick after = session.pick(kWidth / 2.0f, kHeight / 2.0f);
  EXPECT_EQ(after.part, ball);
  EXPECT_EQ(after.cluster, before.cluster);
  EXPECT_NEAR(after.position.x, before.position.x - 0.8f, 1e-5f);
  EXPECT_NEAR(after.uv.x, before.uv.x, 1e-4f);
  PixelLayer ids;
  ASSERT_TRUE(soon([&] { return session.copy_ids(ids) && !ids.pixels.empty(); }));
  EXPECT_EQ(ids.pixels[static_cast<size_t>(kHeight / 2 * kWidth + kWidth / 2)] & 0xffffu,
            static_cast<uint32_t>(ball) + 1);
}

TEST_F(MovedParts, AfterADragTheWindowShowsWhatAFreshRenderShows) {
  Project project = test::two_materials();
  project.settings.max_samples = 6;
  RenderSession session(*device, std::make_shared<const Project>(project), kWidth, kHeight);
  for (int i = 1; i <= 30; ++i) {
    part(project, "pearl").place = {vec3(-0.05f, 0.03f, 0) * static_cast<float>(i), vec3(0.1f * static_cast<float>(i))};
    session.set_project(std::make_shared<const Project>(project), "place of pearl");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto end = std::make_shared<const Project>(project);
  session.set_project(end, "place of pearl");
  ASSERT_TRUE(soon([&] { return session.status().project == end && session.status().finished; }));
  int width = 0, height = 0;
  uint32_t samples = 0;
  EXPECT_EQ(session.linear_picture(width, height, samples), render(project, kWidth, kHeight, 6).image.pixels);
}

}  // namespace
}  // namespace vamp
