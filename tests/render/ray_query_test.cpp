// Pictures whose rays the device traces are those of the program's own tree, but for pixels on the edges of triangles:
// with hidden parts, parts with holes, mirrors, seen from behind, and where there is nothing to see.
#include <cstring>

#include "engine/image/image.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class RayQueryPicture : public test::EditedPicture {
 protected:
  void SetUp() override {
    EditedPicture::SetUp();
    if (device && !device->info().ray_queries) GTEST_SKIP() << device->info().name << " has no ray queries";
  }

  std::vector<float> picture(const Project& project, bool ray_queries, uint32_t samples = 16) {
    Renderer renderer(*device);
    renderer.set_trace_path({true, ray_queries});
    show(renderer, project);
    renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
    return finish(renderer, samples);
  }

  // A stored hit that lies on an edge may be of either triangle: then the pixel's samples differ, by little. Everywhere
  // else the arithmetic after the triangle's number is the same, and so are the bytes.
  void expect_same(const Project& project) {
    const std::vector<float> own = picture(project, false), queries = picture(project, true);
    ASSERT_EQ(own.size(), queries.size());
    size_t different = 0;
    double sum = 0, difference = 0;
    for (size_t pixel = 0; pixel < own.size() / 4; ++pixel) {
      different += std::memcmp(&own[4 * pixel], &queries[4 * pixel], 4 * sizeof(float)) != 0;
      for (size_t c = 0; c < 3; ++c) {
        sum += static_cast<double>(own[4 * pixel + c]);
        difference += std::abs(static_cast<double>(own[4 * pixel + c] - queries[4 * pixel + c]));
      }
    }
    RecordProperty("different_pixels", std::to_string(different));
    EXPECT_GT(sum, 0);
    EXPECT_LE(different, own.size() / 4 / 500);
    EXPECT_LE(difference, 1e-4 * sum);
  }
};

TEST_F(RayQueryPicture, OfTwoMaterialsUnderALampIsTheSame) { expect_same(test::two_materials()); }

TEST_F(RayQueryPicture, HasTheSameMirrors) {
  Project project = test::two_materials();
  project.parts[0].mirror_f0 = 0.5f;
  project.background = vec3(0.3f, 0.2f, 0.1f);
  expect_same(project);
}

TEST_F(RayQueryPicture, LeavesOutWhatIsHidden) {
  Project project = test::two_materials();
  const std::vector<float> whole = picture(project, true, 4);
  project.parts[1].visible = false;
  expect_same(project);
  EXPECT_FALSE(test::same_bytes(whole, picture(project, true, 4)));
  // What is shown again is there as before.
  Renderer renderer(*device);
  renderer.set_trace_path({true, true});
  show(renderer, project);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  finish(renderer, 4);
  project.parts[1].visible = true;
  show(renderer, project);
  EXPECT_TRUE(test::same_bytes(whole, finish(renderer, 4)));
}

TEST_F(RayQueryPicture, OfNothingIsTheBackground) {
  Project project = test::two_materials();
  for (PartState& part : project.parts) part.visible = false;
  project.background = vec3(0.25f);
  const std::vector<float> seen = picture(project, true, 4);
  for (size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], i % 4 == 3 ? 0.0f : 0.25f);
}

// Half of the ball's texture has holes; through them one sees its other side from within.
TEST_F(RayQueryPicture, SeesThroughHoles) {
  Project project = test::two_materials();
  auto scene = std::make_shared<Scene>(*project.scene);
  auto mask = std::make_shared<Image>(64, 64, std::vector<std::string>{"R", "G", "B", "A"});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (size_t c = 0; c < 4; ++c) mask->at(x, y, c) = c < 3 || (x / 8 + y / 8) % 2 == 0 ? 1.0f : 0.0f;
  Texture texture;
  texture.image = mask;
  scene->textures.push_back(texture);
  SurfaceMaterial& ball = scene->parts[1].material;
  ball.alpha_mode = AlphaMode::mask;
  ball.alpha_cutoff = 0.5f;
  ball.base_color_texture.texture = static_cast<int>(scene->textures.size()) - 1;
  const std::vector<float> solid = picture(project, true, 4);
  project.scene = scene;
  expect_same(project);
  EXPECT_FALSE(test::same_bytes(solid, picture(project, true, 4)));
}

TEST_F(RayQueryPicture, SeesTrianglesFromBehind) {
  Project project = test::two_materials();
  project.camera.eye = vec3(0.05f, 0.1f, 0.1f);  // within the ball
  project.camera.target = vec3(1, 0, 0);
  Light bulb;
  bulb.type = LightType::point;
  bulb.center = vec3(0, 0.2f, 0);
  bulb.power = 20;
  project.lights = {bulb};
  expect_same(project);
}

// Batches of one and of four, tiles and the whole region.
TEST_F(RayQueryPicture, IsTheSameBytesHoweverItIsCut) {
  const Project project = test::two_materials();
  const std::vector<float> tiles = picture(project, true, 8);
  Renderer renderer(*device);
  renderer.set_trace_path({true, true});
  show(renderer, project);
  renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  for (uint32_t limit = 1; limit <= 8; ++limit) renderer.refine_all(limit);
  EXPECT_TRUE(test::same_bytes(tiles, renderer.linear_picture(renderer.last_submitted())));
}

}  // namespace
}  // namespace vamp
