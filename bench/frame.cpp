#include "bench/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "bench/embree_scene.h"
#include "bench/scene.h"
#include "bench/series.h"
#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"
#include "shaders/shared/random.h"

namespace vamp {
namespace {

struct Rays {
  std::vector<RTCRayHit> primary;
  std::vector<RTCRay> shadow, ambient;
};

// The picture's rays: primary through jittered pixels, from each hit one to a point of the light and one
// cosine-weighted.
Rays draw_rays(const EmbreeScene& embree, const Project& project, int side) {
  Rays rays;
  const CameraFrame camera = camera_frame(project.camera, 1);
  const LightFrame axes = light_frame(project.lights[0]);
  const Light& light = project.lights[0];
  for (int tile_y = 0; tile_y < side; tile_y += TILE_SIDE)
    for (int tile_x = 0; tile_x < side; tile_x += TILE_SIDE)
      for (int i = 0; i < TILE_SIDE * TILE_SIDE; ++i) {
        const int x = tile_x + i % TILE_SIDE, y = tile_y + i / TILE_SIDE;
        const uint32_t seed = random::random_pixel(static_cast<uint32_t>(x), static_cast<uint32_t>(y), 0);
        const vec2 jitter = random::random_pair(seed, 0, PAIR_PIXEL);
        const float px = (static_cast<float>(x) + jitter.x) / static_cast<float>(side);
        const float py = (static_cast<float>(y) + jitter.y) / static_cast<float>(side);
        const vec3 direction = camera_ray(camera, 2 * px - 1, 1 - 2 * py);
        rays.primary.push_back(EmbreeScene::ray_hit(camera.origin, direction));
        const EmbreeScene::Hit hit = embree.nearest(camera.origin, direction);
        if (hit.triangle < 0) continue;
        vec3 normal = glm::normalize(hit.normal);
        if (glm::dot(normal, direction) > 0) normal = -normal;
        const vec3 origin = camera.origin + hit.distance * direction + 1e-5f * normal;
        const vec2 u = random::random_pair(seed, 0, PAIR_LIGHT);
        const vec3 to =
            light.center + axes.u * light.size.x * (u.x - 0.5f) + axes.v * light.size.y * (u.y - 0.5f) - origin;
        if (glm::dot(to, normal) > 0)
          rays.shadow.push_back(EmbreeScene::ray(origin, glm::normalize(to), glm::length(to)));
        const vec2 w = random::random_pair(seed, 0, PAIR_AMBIENT);
        const vec3 t = glm::normalize(std::abs(normal.x) > 0.5f ? glm::cross(normal, vec3(0, 1, 0))
                                                                : glm::cross(normal, vec3(1, 0, 0)));
        const float r = std::sqrt(w.x), phi = 6.2831853f * w.y;
        const vec3 d =
            t * (r * std::cos(phi)) + glm::cross(normal, t) * (r * std::sin(phi)) + normal * std::sqrt(1 - w.x);
        rays.ambient.push_back(EmbreeScene::ray(origin, glm::normalize(d), project.settings.ao_radius));
      }
  return rays;
}

template <class T, class F>
Times trace_all(std::vector<T> rays, const F& trace) {
  constexpr size_t kChunk = 4096;
  std::atomic<size_t> next{0};
  const Stopwatch watch;
  std::vector<std::thread> pool;
  for (unsigned i = 0; i < processors(); ++i)
    pool.emplace_back([&] {
      for (size_t begin = next.fetch_add(kChunk); begin < rays.size(); begin = next.fetch_add(kChunk))
        for (size_t k = begin; k < std::min(begin + kChunk, rays.size()); ++k) trace(rays[k]);
    });
  for (std::thread& thread : pool) thread.join();
  return watch.stop();
}

}  // namespace

Result<Report> bench_frame(gpu::Device& device, Project project, const FrameBench& options) {
  if (project.lights.empty()) return fail(ErrorKind::bad_input, "", "lights", "at least one", "none");
  project.lights.resize(1);
  if (project.ambient == vec3(0)) project.ambient = vec3(0.2f);
  if (project.settings.ao_radius == 0) project.settings.ao_radius = project.scene->bounds.radius() * 0.2f;

  const EmbreeScene embree(project.scene->positions, project.scene->triangles, EmbreeScene::Edges::fast);
  const Rays rays = draw_rays(embree, project, options.side);
  Renderer renderer(device);
  // Starts again in the same memory: fresh pages would be paid for in the first sample.
  const auto begin = [&] {
    ++project.settings.seed;
    return renderer.set_project(std::make_shared<const Project>(project));
  };
  VAMP_CHECK_STATUS(begin());
  renderer.set_region(options.side, options.side, {0, 0, options.side, options.side});
  // Kernels are compiled at their first dispatch.
  while (renderer.samples() < 8) device.wait(renderer.refine_all(8));

  Series primary, shadow, ambient, single, batch;
  for (int round = 0; round < options.rounds; ++round) {
    primary.add(trace_all(rays.primary, [&](RTCRayHit& ray) { embree.intersect(ray); }));
    shadow.add(trace_all(rays.shadow, [&](RTCRay& ray) { embree.occluded(ray); }));
    ambient.add(trace_all(rays.ambient, [&](RTCRay& ray) { embree.occluded(ray); }));
    VAMP_CHECK_STATUS(begin());
    {
      const Stopwatch watch;
      device.wait(renderer.refine_all(1));
      single.add(watch.stop());
    }
    while (renderer.samples() < 4) device.wait(renderer.refine_all(4));
    const Stopwatch watch;
    device.wait(renderer.refine_all(8));
    batch.add(watch.stop(), 0.25);
  }

  const double all = primary.cpu() + shadow.cpu() + ambient.cpu();
  const double reused = primary.cpu() / SAMPLES_PER_HIT + shadow.cpu() + ambient.cpu();
  Report report(options.name, fmt::format("{}, {} x {}, medians of {} rounds, {}.", options.scene_words, options.side,
                                          options.side, options.rounds, device.info().name));
  report.table({"", "a sample", "of Embree's time"});
  const auto peer = [&](const char* name, const Series& series, size_t count) {
    report.row({std::string("Embree, ") + name, series.text(),
                fmt::format("{:.1f} Mrays/s", static_cast<double>(count) / series.cpu() * 1e-3)});
    report.data()["embree"][name] = series.json();
  };
  peer("primary", primary, rays.primary.size());
  peer("shadow", shadow, rays.shadow.size());
  peer("ambient", ambient, rays.ambient.size());
  report.row({"a single sample with a primary ray of its own", single.text(),
              fmt::format("{:.2f} of the same rays", single.cpu() / all)});
  report.row(
      {"four samples a primary ray, four a dispatch", batch.text(),
       fmt::format("{:.2f} of tracing every ray, {:.2f} of the same rays", batch.cpu() / all, batch.cpu() / reused)});
  report.data()["single"] = single.json();
  report.data()["single"]["of_embree"] = single.cpu() / all;
  report.data()["batch"] = batch.json();
  report.data()["batch"]["of_embree"] = batch.cpu() / all;
  report.data()["batch"]["of_embree_same_rays"] = batch.cpu() / reused;
  return report;
}

}  // namespace vamp
