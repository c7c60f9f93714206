#include "bench/ray_cost.h"

#include <cmath>

#include "engine/gpu/device.h"

namespace vamp {
namespace {

RayQuestion question_of(const char* kind) {
  return std::string_view(kind) == "primary" ? RayQuestion::nearest : RayQuestion::any;
}

size_t otherwise(const EmbreeScene& embree, RayQuestion question, std::span<const ReadyRay> rays,
                 std::span<const float> found) {
  size_t count = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    const ReadyRay& ray = rays[i];
    if (question == RayQuestion::any) {
      count += embree.unoccluded(ray.origin, ray.direction, ray.distance) != (found[i] > 0);
      continue;
    }
    const EmbreeScene::Hit hit = embree.nearest(ray.origin, ray.direction);
    const bool both = hit.triangle >= 0 && found[i] >= 0;
    const bool neither = hit.triangle < 0 && found[i] < 0;
    count += !neither && !(both && std::abs(found[i] - hit.distance) < 1e-4f * hit.distance);
  }
  return count;
}

}  // namespace

Result<std::unique_ptr<RayCost>> RayCost::make(gpu::Device& device, const Project& project, int side) {
  VAMP_TRY(GpuTree tree, GpuTree::make(device, *project.scene));
  std::unique_ptr<RayCost> cost(new RayCost(*project.scene, std::move(tree)));
  ReadyRays drawn = draw_rays(cost->embree_, project, side, SAMPLES_PER_HIT);
  const auto add = [&](const char* name, std::vector<ReadyRay> rays) {
    const RayQuestion question = question_of(name);
    RayKernel kernel(device, cost->tree_, question, rays);
    const size_t others = otherwise(cost->embree_, question, rays, kernel.found());
    cost->kinds_.push_back({name, std::move(rays), std::move(kernel), others, {}, {}});
  };
  add("primary", std::move(drawn.primary));
  add("shadow", std::move(drawn.shadow));
  add("ambient", std::move(drawn.ambient));
  return cost;
}

void RayCost::round() {
  for (Kind& kind : kinds_) {
    kind.embree.add(embree_time(embree_, question_of(kind.name), kind.rays));
    kind.ours.add(kind.kernel.run());
  }
}

Json RayCost::Kind::json() const {
  return {{"rays", rays.size()},
          {"otherwise", otherwise},
          {"ours", ours.json()},
          {"embree", embree.json()},
          {"ratio", ratio()}};
}

}  // namespace vamp
