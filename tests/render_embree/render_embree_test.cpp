// The renderer must see what Embree, an independent ray tracer, sees along the same rays: first hits and distances,
// ambient occlusion, and the shadows of a rectangle and a sphere light. At most one pixel in 10,000 may differ: rays
// that pass an edge within the rounding of 32-bit floats.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "bench/embree_scene.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"
#include "shaders/shared/random.h"
#include "tests/render_embree/ray_oracle.h"
#include "tests/render_embree/views.h"

namespace vamp {
namespace {

constexpr int kWidth = 400, kHeight = 300, kPixels = kWidth * kHeight;
constexpr int kAllowed = kPixels / 10000;
constexpr uint32_t kSamples = 4;

// Pixels that differ: how many, and the first few in words.
struct Differences {
  int count = 0;
  std::string first;
  void add(int pixel, const std::string& what) {
    if (count++ < 6) first += fmt::format("  pixel {}, {}: {}\n", pixel % kWidth, pixel / kWidth, what);
  }
};

// What Embree sees of a view: the triangle at each pixel's centre and where it is hit.
struct Traced {
  struct Pixel {
    EmbreeScene::Hit hit;
    OraclePoint point;
    uint32_t seed = 0;
  };

  explicit Traced(View seen)
      : view(std::move(seen)),
        // Watertight, as ours is.
        embree(view.project.scene->positions, view.project.scene->triangles, EmbreeScene::Edges::watertight) {
    const Project& project = view.project;
    const CameraFrame camera = camera_frame(project.camera, static_cast<float>(kWidth) / kHeight);
    for (int i = 0; i < kPixels; ++i) {
      const int x = i % kWidth, y = i / kWidth;
      const vec3 direction = camera_ray(camera, 2 * (static_cast<float>(x) + 0.5f) / kWidth - 1,
                                        1 - 2 * (static_cast<float>(y) + 0.5f) / kHeight);
      Pixel pixel;
      pixel.hit = embree.nearest(camera.origin, direction);
      if (pixel.hit.triangle >= 0)
        pixel.point = oracle_point(*project.scene, pixel.hit.triangle, camera.origin, direction);
      pixel.seed = random::random_pixel(static_cast<uint32_t>(x), static_cast<uint32_t>(y), project.settings.seed);
      pixels.push_back(pixel);
    }
  }

  bool arrives(const Pixel& pixel, const OracleRay& ray) const {
    return ray.carries &&
           embree.unoccluded(vec3(pixel.point.start), vec3(ray.direction), static_cast<float>(ray.distance));
  }

  View view;
  EmbreeScene embree;
  std::vector<Pixel> pixels;
};

class RenderEmbree : public testing::TestWithParam<int> {
 protected:
  static void TearDownTestSuite() { traced().clear(); }

  void SetUp() override {
    auto made = gpu::Device::create({.device = {}, .validate = true});
    if (!made && made.error().kind == ErrorKind::no_device)
      GTEST_SKIP() << "no Vulkan device to compare with Embree: " << made.error().message();
    ASSERT_TRUE(made) << made.error().message();
    device = std::move(*made);

    std::unique_ptr<const Traced>& slot = traced()[GetParam()];
    if (!slot) {
      auto view = make_view(GetParam());
      ASSERT_TRUE(view) << view.error().message();
      slot = std::make_unique<const Traced>(std::move(*view));
    }
    embree = slot.get();
    renderer.emplace(*device);
    const auto change = renderer->set_project(std::make_shared<const Project>(embree->view.project));
    ASSERT_TRUE(change) << change.error().message();
    renderer->set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  }

  void TearDown() override {
    renderer.reset();
    if (!device) return;
    for (const auto& message : device->validation_messages()) ADD_FAILURE() << message;
  }

  // Holds a comparison to its limit and says what came of it. `share`: of what the comparison is about, so that an
  // empty picture does not pass.
  void judge(const std::string& what, const Differences& differences, double share) {
    fmt::print("{}: {}: {} of {} pixels differ, share {:.3f}\n", embree->view.name, what, differences.count, kPixels,
               share);
    EXPECT_LE(differences.count, kAllowed) << embree->view.name << ", " << what << "\n" << differences.first;
    EXPECT_GT(share, 0.02) << what;
    EXPECT_LT(share, 0.98) << what;
  }

  std::unique_ptr<gpu::Device> device;
  std::optional<Renderer> renderer;
  const Traced* embree = nullptr;

 private:
  // Traced once for all tests of a view.
  static std::map<int, std::unique_ptr<const Traced>>& traced() {
    static std::map<int, std::unique_ptr<const Traced>> all;
    return all;
  }
};

TEST_P(RenderEmbree, FirstHitsAndDistancesAgree) {
  const std::vector<float> layers = renderer->aov_layers(renderer->render_aov());
  Differences differences;
  int hits = 0;
  for (int i = 0; i < kPixels; ++i) {
    const EmbreeScene::Hit& hit = embree->pixels[static_cast<size_t>(i)].hit;
    const float depth = layers[static_cast<size_t>(4 * i + 3)];
    const int part = static_cast<int>(layers[static_cast<size_t>(4 * (kPixels + i) + 2)]);
    const int expected =
        hit.triangle < 0
            ? -1
            : static_cast<int>(embree->view.project.scene->triangle_part[static_cast<size_t>(hit.triangle)]);
    hits += hit.triangle >= 0 ? 1 : 0;
    if (part != expected || std::abs(depth - hit.distance) > 1e-4f * hit.distance)
      differences.add(i, fmt::format("part {} at {}, Embree {} at {}", part, depth, expected, hit.distance));
  }
  fmt::print("{}: {:.1f} % covered\n", embree->view.name, 100.0 * hits / kPixels);
  EXPECT_GT(hits, kPixels / 10);
  EXPECT_LE(differences.count, kAllowed) << embree->view.name << "\n" << differences.first;
  fmt::print("{}: first hits: {} of {} pixels differ\n", embree->view.name, differences.count, kPixels);
}

TEST_P(RenderEmbree, OcclusionAgrees) {
  // Open rays and rays that count (above the face) of each pixel, after one sample and after four.
  std::array<std::vector<float>, 2> layers;
  layers[0] = renderer->aov_layers(renderer->render_occlusion(0, 1));
  layers[1] = renderer->aov_layers(renderer->render_occlusion(0, kSamples));
  const double radius = static_cast<double>(embree->view.project.settings.ao_radius);
  std::array<Differences, 2> differences;
  std::array<double, 2> all_open{}, all_counted{};
  for (int i = 0; i < kPixels; ++i) {
    const Traced::Pixel& pixel = embree->pixels[static_cast<size_t>(i)];
    int open = 0, counted = 0;
    for (uint32_t k = 0; k < kSamples; ++k) {
      const OracleRay ray =
          oracle_occlusion_ray(pixel.point, random::random_pair(pixel.seed, k, PAIR_OCCLUSION), radius);
      const bool counts = pixel.hit.triangle >= 0 && ray.carries;
      counted += counts ? 1 : 0;
      open += counts && embree->arrives(pixel, ray) ? 1 : 0;
      if (k != 0 && k != kSamples - 1) continue;
      const size_t stage = k == 0 ? 0 : 1;
      all_open[stage] += open;
      all_counted[stage] += counted;
      const float* sums = &layers[stage][4 * (2 * static_cast<size_t>(kPixels) + static_cast<size_t>(i))];
      if (static_cast<int>(sums[0]) != open || static_cast<int>(sums[1]) != counted)
        differences[stage].add(i, fmt::format("{} open of {}, Embree {} of {}", sums[0], sums[1], open, counted));
    }
  }
  judge("occlusion, 1 sample", differences[0], all_open[0] / all_counted[0]);
  judge("occlusion, 4 samples", differences[1], all_open[1] / all_counted[1]);
}

TEST_P(RenderEmbree, ShadowsAgree) {
  const std::vector<Light>& lights = embree->view.project.lights;
  // Each light has a plane of its own in the accumulators; it grows by a sample where the light arrives. A compensated
  // sum may also move by its last bit when it takes up what it had lost before.
  const auto grew = [](float before, float after) { return after - before > 4e-7f * before; };
  std::vector<std::vector<float>> sums(1);
  for (uint32_t k = 1; k <= kSamples; ++k) sums.push_back(renderer->accumulators(renderer->refine_all(k)));
  ASSERT_EQ(renderer->samples(), kSamples);
  sums[0].assign(sums[1].size(), 0.0f);

  for (size_t l = 0; l < lights.size(); ++l) {
    std::array<Differences, 2> differences;
    std::array<double, 2> lit{};
    double hits = 0;
    for (int i = 0; i < kPixels; ++i) {
      const Traced::Pixel& pixel = embree->pixels[static_cast<size_t>(i)];
      const size_t at = 4 * ((PLANE_LIGHTS + l) * static_cast<size_t>(kPixels) + static_cast<size_t>(i));
      int arrived = 0, expected = 0;
      for (uint32_t k = 0; k < kSamples; ++k) {
        arrived += grew(sums[k][at], sums[k + 1][at]) ? 1 : 0;
        const vec2 u = random::random_pair(pixel.seed, k, PAIR_LIGHT + static_cast<uint32_t>(l));
        expected +=
            pixel.hit.triangle >= 0 && embree->arrives(pixel, oracle_light_ray(pixel.point, lights[l], u)) ? 1 : 0;
        if (k != 0 && k != kSamples - 1) continue;
        const size_t stage = k == 0 ? 0 : 1;
        lit[stage] += expected;
        if (arrived != expected)
          differences[stage].add(i, fmt::format("light arrives {} times, in Embree {}", arrived, expected));
      }
      hits += pixel.hit.triangle >= 0 ? 1 : 0;
    }
    const std::string name(name_of(lights[l].type));
    judge(name + " light, 1 sample", differences[0], lit[0] / hits);
    judge(name + " light, 4 samples", differences[1], lit[1] / (kSamples * hits));
  }
}

INSTANTIATE_TEST_SUITE_P(Views, RenderEmbree, testing::Range(0, kViewCount));

}  // namespace
}  // namespace vamp
