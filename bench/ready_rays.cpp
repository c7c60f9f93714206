#include "bench/ready_rays.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <thread>

#include "engine/core/check.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/random.h"

namespace vamp {
namespace {

constexpr float kFar = 3.0e38f;

// As shaders/lib/bindings.glsl orders a workgroup's pixels.
uvec2 inside_block(uint32_t i) {
  return {(i & 1u) | (i >> 1 & 2u) | (i >> 2 & 4u), (i >> 1 & 1u) | (i >> 2 & 2u) | (i >> 3 & 4u)};
}

uvec2 pixel_of(uint32_t i, uint32_t side) {
  constexpr uint32_t kTile = TILE_SIDE * TILE_SIDE, kBlocks = TILE_SIDE / 8;
  const uint32_t tile = i / kTile, block = i % kTile / 64, tiles = side / TILE_SIDE;
  return uvec2(tile % tiles, tile / tiles) * uint32_t{TILE_SIDE} + uvec2(block % kBlocks, block / kBlocks) * 8u +
         inside_block(i % 64);
}

// A point of a surface on the viewer's side, off it as the kernels leave it (shaders/lib/surface.glsl).
struct Start {
  vec3 origin, normal;
};

vec3 cosine_weighted(vec3 normal, vec2 u) {
  const vec3 t = glm::normalize(glm::cross(normal, std::abs(normal.x) > 0.5f ? vec3(0, 1, 0) : vec3(1, 0, 0)));
  const float r = std::sqrt(u.x), phi = 6.2831853f * u.y;
  return glm::normalize(t * (r * std::cos(phi)) + glm::cross(normal, t) * (r * std::sin(phi)) +
                        normal * std::sqrt(1 - u.x));
}

void add_rays_from(const Start& start, const Project& project, uint32_t seed, int each, ReadyRays& rays) {
  const Light& light = project.lights[0];
  const LightFrame axes = light_frame(light);
  bool above = true;
  const size_t before = rays.shadow.size();
  for (int k = 0; k < each; ++k) {
    const auto sample = static_cast<uint32_t>(k);
    const vec2 u = random::random_pair(seed, sample, PAIR_LIGHT) - 0.5f;
    const vec3 to = light.center + axes.u * light.size.x * u.x + axes.v * light.size.y * u.y - start.origin;
    above = above && glm::dot(to, start.normal) > 0;
    rays.shadow.push_back({start.origin, 0.9999f * glm::length(to), glm::normalize(to)});
    const vec2 w = random::random_pair(seed, sample, PAIR_AMBIENT);
    rays.ambient.push_back({start.origin, project.settings.ao_radius, cosine_weighted(start.normal, w)});
  }
  if (!above) rays.shadow.resize(before);
}

// `Asked` is Embree's form of a ray.
template <class Asked, class Trace>
Times trace_all(std::vector<Asked> rays, const Trace& trace) {
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

ReadyRays draw_rays(const EmbreeScene& embree, const Project& project, int side, int each) {
  CHECK(side % TILE_SIDE == 0 && !project.lights.empty());
  ReadyRays rays;
  const CameraFrame camera = camera_frame(project.camera, 1);
  const auto pixels = static_cast<uint32_t>(side);
  const float radius = project.scene->bounds.radius();
  for (uint32_t i = 0; i < pixels * pixels; ++i) {
    const uvec2 pixel = pixel_of(i, pixels);
    const uint32_t seed = random::random_pixel(pixel.x, pixel.y, 0);
    const vec2 at = (vec2(pixel) + random::random_pair(seed, 0, PAIR_PIXEL)) / static_cast<float>(side);
    const vec3 direction = camera_ray(camera, 2 * at.x - 1, 1 - 2 * at.y);
    rays.primary.push_back({camera.origin, kFar, direction});
    const EmbreeScene::Hit hit = embree.nearest(camera.origin, direction);
    if (hit.triangle < 0) continue;
    vec3 normal = glm::normalize(hit.normal);
    if (glm::dot(normal, direction) > 0) normal = -normal;
    const vec3 point = camera.origin + hit.distance * direction, m = glm::abs(point);
    const float off = 4e-6f * std::max({m.x, m.y, m.z, 0.25f * hit.distance}) + 1e-6f * radius;
    add_rays_from({point + off * normal, normal}, project, seed, each, rays);
  }
  return rays;
}

Times embree_time(const EmbreeScene& embree, RayQuestion question, std::span<const ReadyRay> rays) {
  if (question == RayQuestion::nearest) {
    std::vector<RTCRayHit> asked;
    for (const ReadyRay& ray : rays) asked.push_back(EmbreeScene::ray_hit(ray.origin, ray.direction));
    return trace_all(std::move(asked), [&](RTCRayHit& ray) { embree.intersect(ray); });
  }
  std::vector<RTCRay> asked;
  for (const ReadyRay& ray : rays) asked.push_back(EmbreeScene::ray(ray.origin, ray.direction, ray.distance));
  return trace_all(std::move(asked), [&](RTCRay& ray) { embree.occluded(ray); });
}

}  // namespace vamp
