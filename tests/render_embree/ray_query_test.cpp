// The device's ray queries must find what the program's own tree finds on the rays of a picture: two million of them.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>

#include "bench/ray_kernel.h"
#include "engine/gpu/device.h"
#include "engine/project/default_project.h"

namespace vamp {
namespace {

class RayQueryTest : public testing::Test {
 protected:
  void SetUp() override {
    auto made = gpu::Device::create({.device = {}, .validate = true});
    ASSERT_TRUE(made) << made.error().message();
    device = std::move(*made);
    if (!device->info().ray_queries) GTEST_SKIP() << device->info().name << " has no ray queries";
  }
  void TearDown() override {
    if (!device) return;
    for (const auto& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  GpuTree tree_of(const Scene& scene, bool ray_queries) {
    Result<GpuTree> tree = GpuTree::make(*device, scene, {true, ray_queries});
    EXPECT_TRUE(tree) << tree.error().message();
    return std::move(*tree);
  }

  struct Hit {
    float distance = 0;
    int triangle = -1;
  };
  std::vector<Hit> hits_of(const GpuTree& tree, const std::vector<ReadyRay>& rays) {
    const RayKernel kernel(*device, tree, RayQuestion::nearest, rays);
    const std::vector<float> distances = kernel.found();
    const std::vector<int> triangles = kernel.triangles();
    std::vector<Hit> hits;
    for (size_t i = 0; i < rays.size(); ++i) hits.push_back({distances[i], triangles[i]});
    return hits;
  }

  std::unique_ptr<gpu::Device> device;
};

// Two distances of the same place: rounded differently along a ray whose origin and corners have these sizes.
bool same_distance(float a, float b, float size) { return std::abs(a - b) <= 16 * 0x1p-24f * (size + std::abs(a)); }

TEST_F(RayQueryTest, FindsWhatTheTreeFinds) {
  Result<Project> project = default_project();
  ASSERT_TRUE(project) << project.error().message();
  const Scene& scene = *project->scene;
  const EmbreeScene embree(scene.positions, scene.triangles, EmbreeScene::Edges::watertight);
  constexpr int kSide = 512;
  if (project->settings.ao_radius == 0) project->settings.ao_radius = scene.bounds.radius() * 0.2f;
  const ReadyRays rays = draw_rays(embree, *project, kSide, SAMPLES_PER_HIT);
  const GpuTree own = tree_of(scene, false), queries = tree_of(scene, true);
  const auto unoccluded = [&](const GpuTree& tree, const std::vector<ReadyRay>& asked) {
    return RayKernel(*device, tree, RayQuestion::any, asked).found();
  };
  ASSERT_GT(rays.primary.size() + rays.shadow.size() + rays.ambient.size(), 1'000'000u);

  // Nearest hits: the same triangle at the same distance; another one where two meet at the ray.
  const std::vector<Hit> a = hits_of(own, rays.primary), b = hits_of(queries, rays.primary);
  size_t hits = 0, ties = 0, otherwise = 0;
  float worst = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    hits += a[i].triangle >= 0;
    if (a[i].triangle < 0 && b[i].triangle < 0) continue;
    const float size = scene.bounds.radius() + std::abs(rays.primary[i].origin.x);
    const bool same = a[i].triangle >= 0 && b[i].triangle >= 0 && same_distance(a[i].distance, b[i].distance, size);
    if (same && a[i].triangle == b[i].triangle)
      worst = std::max(worst, std::abs(a[i].distance - b[i].distance) / (size + a[i].distance) * 0x1p24f);
    else if (same)
      ++ties;
    else
      ++otherwise;
  }
  RecordProperty("nearest_hits", std::to_string(hits));
  RecordProperty("on_an_edge", std::to_string(ties));
  RecordProperty("otherwise", std::to_string(otherwise));
  RecordProperty("largest_difference_in_2^-24", std::to_string(worst));
  EXPECT_GT(hits, a.size() / 4);
  // Of those that pass within rounding of an edge, of one in a hundred thousand something else may be said.
  EXPECT_LE(ties, hits / 1000);
  EXPECT_LE(otherwise, hits / 100'000);

  for (const auto* asked : {&rays.shadow, &rays.ambient}) {
    const std::vector<float> c = unoccluded(own, *asked), d = unoccluded(queries, *asked);
    size_t free = 0, different = 0;
    for (size_t i = 0; i < c.size(); ++i) {
      free += c[i] > 0;
      different += (c[i] > 0) != (d[i] > 0);
    }
    RecordProperty(asked == &rays.shadow ? "shadow_otherwise" : "ambient_otherwise", std::to_string(different));
    EXPECT_GT(free, c.size() / 20);
    EXPECT_LT(free, c.size());
    EXPECT_LE(different, c.size() / 100'000);
  }
}

// What is moved in the table of triangles is where it has gone once the rays are built again.
TEST_F(RayQueryTest, FollowsTrianglesThatMove) {
  Scene scene;
  scene.parts.resize(1);
  scene.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 5}, {1, -1, 5}, {0, 1, 5}};
  scene.normals.assign(6, vec3(0, 0, 1));
  scene.tangents.assign(6, vec4(1, 0, 0, 1));
  scene.uvs.assign(6, vec2(0));
  scene.triangles = {{0, 1, 2}, {3, 4, 5}};
  scene.triangle_part = {0, 0};
  finish_scene(scene);
  GpuTree tree = tree_of(scene, true);
  const std::vector<ReadyRay> rays = {{vec3(0, 0, -1), 100, vec3(0, 0, 1)}, {vec3(9, 0, -1), 100, vec3(0, 0, 1)}};
  RayKernel kernel(*device, tree, RayQuestion::nearest, rays);
  EXPECT_FLOAT_EQ(kernel.found()[0], 1);
  EXPECT_EQ(kernel.found()[1], -1);

  std::vector<vec4> corners = device->readback_rows<vec4>(tree.tables.triangles.rows, 0, 6, device->last_submitted());
  for (vec4& corner : corners) corner.z += 2;
  device->upload_rows<vec4>(tree.tables.triangles.rows, 0, corners);
  tree.tables.build_rays(*device);
  kernel.run();
  EXPECT_FLOAT_EQ(kernel.found()[0], 3);
  for (vec4& corner : corners) corner.x += 9;
  device->upload_rows<vec4>(tree.tables.triangles.rows, 0, corners);
  tree.tables.build_rays(*device);
  kernel.run();
  EXPECT_EQ(kernel.found()[0], -1);
  EXPECT_FLOAT_EQ(kernel.found()[1], 3);
}

}  // namespace
}  // namespace vamp
