// What a sample of a picture costs, in units of what Embree's single-ray calls need for the same rays in the same run:
//   bench_frame [--scene FILE, else the shipped shoe in its leather and cloth] [--without PART] [--rounds N] [--size N]
// The picture has one primary, one shadow and one ambient ray a sample and pixel and SPMM shading. Embree traces all of
// them from ready arrays in tile order on as many threads as there are processors; drawing the rays, surfaces, shading
// and accumulation are on our side of the balance alone. Rounds of both alternate; medians and spread over rounds.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/core/check.h"
#include "engine/core/files.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/project/default_project.h"
#include "engine/project/project_file.h"
#include "engine/render/renderer.h"
#include "shaders/shared/random.h"

namespace vamp {
namespace {

using Clock = std::chrono::steady_clock;

unsigned processors() { return std::max(std::thread::hardware_concurrency(), 1u); }

// Both clocks from the moment it is made.
class Stopwatch {
 public:
  struct Times {
    double cpu_ms, wall_ms;
  };
  Times stop() const {
    const double cpu = static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
    const double wall = std::chrono::duration<double>(Clock::now() - wall_).count();
    return {1e3 * cpu / processors(), 1e3 * wall};
  }

 private:
  std::clock_t cpu_ = std::clock();
  Clock::time_point wall_ = Clock::now();
};

struct Series {
  std::vector<double> values, walls;
  void add(Stopwatch::Times times, double share = 1) {
    values.push_back(times.cpu_ms * share);
    walls.push_back(times.wall_ms * share);
  }
  double quantile(double q) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
  }
  std::string text() {
    std::sort(walls.begin(), walls.end());
    return fmt::format("{:7.1f} ms ({:.1f} to {:.1f}; wall {:.1f})", quantile(0.5), quantile(0.1), quantile(0.9),
                       walls[walls.size() / 2]);
  }
};

struct Rays {
  std::vector<RTCRayHit> primary;
  std::vector<RTCRay> shadow, ambient;
};

class Embree {
 public:
  explicit Embree(const Scene& scene) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3),
                                              scene.positions.size());
    std::memcpy(positions, scene.positions.data(), scene.positions.size() * sizeof(vec3));
    void* triangles = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3),
                                              scene.triangles.size());
    std::memcpy(triangles, scene.triangles.data(), scene.triangles.size() * sizeof(uvec3));
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  ~Embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void intersect(RTCRayHit& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
  }
  void occluded(RTCRay& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_, &context, &ray);
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

RTCRay ray_of(vec3 origin, vec3 direction, float t_max) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = t_max;
  ray.mask = ~0u;
  return ray;
}

// The picture's rays: primary through jittered pixels, from each hit one to a point of the light and one
// cosine-weighted.
Rays draw_rays(const Embree& embree, const Project& project, int side) {
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
        RTCRayHit ray{};
        ray.ray = ray_of(camera.origin, direction, 1e30f);
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rays.primary.push_back(ray);
        embree.intersect(ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        vec3 normal = glm::normalize(vec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z));
        if (glm::dot(normal, direction) > 0) normal = -normal;
        const vec3 origin = camera.origin + ray.ray.tfar * direction + 1e-5f * normal;
        const vec2 u = random::random_pair(seed, 0, PAIR_LIGHT);
        const vec3 to =
            light.center + axes.u * light.size.x * (u.x - 0.5f) + axes.v * light.size.y * (u.y - 0.5f) - origin;
        if (glm::dot(to, normal) > 0) rays.shadow.push_back(ray_of(origin, glm::normalize(to), glm::length(to)));
        const vec2 w = random::random_pair(seed, 0, PAIR_AMBIENT);
        const vec3 t = glm::normalize(std::abs(normal.x) > 0.5f ? glm::cross(normal, vec3(0, 1, 0))
                                                                : glm::cross(normal, vec3(1, 0, 0)));
        const float r = std::sqrt(w.x), phi = 6.2831853f * w.y;
        const vec3 d =
            t * (r * std::cos(phi)) + glm::cross(normal, t) * (r * std::sin(phi)) + normal * std::sqrt(1 - w.x);
        rays.ambient.push_back(ray_of(origin, glm::normalize(d), project.settings.ao_radius));
      }
  return rays;
}

template <class T, class F>
Stopwatch::Times trace_all(std::vector<T> rays, const F& trace) {
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

// The scene without one of its parts, such as a backdrop that stretches the tree's grid.
std::shared_ptr<const Scene> without_part(const Scene& scene, const std::string& name) {
  auto rest = std::make_shared<Scene>(scene);
  const int part = scene.find_part(name);
  rest->triangles.clear();
  rest->triangle_part.clear();
  for (size_t i = 0; i < scene.triangles.size(); ++i)
    if (static_cast<int>(scene.triangle_part[i]) != part) {
      rest->triangles.push_back(scene.triangles[i]);
      rest->triangle_part.push_back(scene.triangle_part[i]);
    }
  finish_scene(*rest);
  return rest;
}

int run(const std::string& scene_file, const std::string& without, int rounds, int side) {
  Result<Project> opened = scene_file.empty() ? default_project() : open_scene(scene_file);
  if (!opened) {
    fmt::print(stderr, "{}\n", opened.error().message());
    return 3;
  }
  Project project = std::move(*opened);
  CHECK(!project.lights.empty());
  if (!without.empty()) project.scene = without_part(*project.scene, without);
  project.lights.resize(1);
  if (project.ambient == vec3(0)) project.ambient = vec3(0.2f);
  if (project.settings.ao_radius == 0) project.settings.ao_radius = project.scene->bounds.radius() * 0.2f;
  auto device = gpu::Device::create();
  CHECK(device);

  const Embree embree(*project.scene);
  const Rays rays = draw_rays(embree, project, side);
  Renderer renderer(**device);
  CHECK(renderer.set_project(std::make_shared<const Project>(project)));
  renderer.set_region(side, side, {0, 0, side, side});
  // Starts again in the same memory: fresh pages would be paid for in the first sample.
  const auto begin = [&] {
    ++project.settings.seed;
    CHECK(renderer.set_project(std::make_shared<const Project>(project)));
  };
  // Kernels are compiled at their first dispatch.
  begin();
  while (renderer.samples() < 8) (*device)->wait(renderer.refine_all(8));

  Series primary, shadow, ambient, single, batch;
  for (int round = 0; round < rounds; ++round) {
    primary.add(trace_all(rays.primary, [&](RTCRayHit& ray) { embree.intersect(ray); }));
    shadow.add(trace_all(rays.shadow, [&](RTCRay& ray) { embree.occluded(ray); }));
    ambient.add(trace_all(rays.ambient, [&](RTCRay& ray) { embree.occluded(ray); }));
    begin();
    {
      const Stopwatch watch;
      (*device)->wait(renderer.refine_all(1));
      single.add(watch.stop());
    }
    while (renderer.samples() < 4) (*device)->wait(renderer.refine_all(4));
    const Stopwatch watch;
    (*device)->wait(renderer.refine_all(8));
    batch.add(watch.stop(), 0.25);
  }
  const double all = primary.quantile(0.5) + shadow.quantile(0.5) + ambient.quantile(0.5);
  const double reused = primary.quantile(0.5) / SAMPLES_PER_HIT + shadow.quantile(0.5) + ambient.quantile(0.5);
  fmt::print("{}: {} triangles, {} x {}, {} rounds, {}\n", scene_file.empty() ? "the shipped shoe" : scene_file,
             project.scene->triangles.size(), side, side, rounds, (*device)->info().name);
  fmt::print("Embree primary  {}  {:.1f} Mrays/s\n", primary.text(),
             static_cast<double>(rays.primary.size()) / primary.quantile(0.5) * 1e-3);
  fmt::print("Embree shadow   {}  {:.1f} Mrays/s\n", shadow.text(),
             static_cast<double>(rays.shadow.size()) / shadow.quantile(0.5) * 1e-3);
  fmt::print("Embree ambient  {}  {:.1f} Mrays/s\n", ambient.text(),
             static_cast<double>(rays.ambient.size()) / ambient.quantile(0.5) * 1e-3);
  fmt::print("sample, single  {}  {:.2f} x Embree's time for the same rays\n", single.text(),
             single.quantile(0.5) / all);
  fmt::print("sample, of four {}  {:.2f} x Embree tracing every ray, {:.2f} x the same rays\n", batch.text(),
             batch.quantile(0.5) / all, batch.quantile(0.5) / reused);
  return 0;
}

}  // namespace
}  // namespace vamp

int main(int argc, char** argv) {
  vamp::start_log("warn");
  std::string scene, without;
  int rounds = 9, side = 512;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--scene")
      scene = argv[i + 1];
    else if (option == "--without")
      without = argv[i + 1];
    else if (option == "--rounds")
      rounds = std::max(std::atoi(argv[i + 1]), 1);
    else if (option == "--size")
      side = std::max(std::atoi(argv[i + 1]), 64);
  }
  return vamp::run(scene, without, rounds, side);
}
