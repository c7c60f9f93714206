#include "bench/ray_cost.h"

#include <cmath>

#include "engine/gpu/device.h"
#include "engine/render/trace_path.h"

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
  std::unique_ptr<RayCost> cost(new RayCost(*project.scene));
  const bool storage = trace_paths(device.info()).chosen().storage_fetch;
  VAMP_TRY(cost->own_, GpuTree::make(device, *project.scene, {storage, false}));
  if (device.info().ray_queries) {
    VAMP_TRY(cost->queries_, GpuTree::make(device, *project.scene, {storage, true}));
  }
  ReadyRays drawn = draw_rays(cost->embree_, project, side, SAMPLES_PER_HIT);
  const auto add = [&](const char* name, std::vector<ReadyRay> rays) {
    const RayQuestion question = question_of(name);
    const auto traced = [&](const GpuTree& tree) {
      RayKernel kernel(device, tree, question, rays);
      const size_t others = otherwise(cost->embree_, question, rays, kernel.found());
      return Traced{std::move(kernel), others, {}};
    };
    Traced own = traced(cost->own_);
    std::optional<Traced> queries;
    if (cost->queries_) queries = traced(*cost->queries_);
    cost->kinds_.push_back({name, std::move(rays), std::move(own), std::move(queries), {}});
  };
  add("primary", std::move(drawn.primary));
  add("shadow", std::move(drawn.shadow));
  add("ambient", std::move(drawn.ambient));
  return cost;
}

void RayCost::round() {
  for (Kind& kind : kinds_) {
    kind.embree.add(embree_time(embree_, question_of(kind.name), kind.rays));
    kind.own.series.add(kind.own.kernel.run());
    if (kind.queries) kind.queries->series.add(kind.queries->kernel.run());
  }
}

Json RayCost::Kind::json() const {
  Json json = {{"rays", rays.size()},
               {"otherwise", own.otherwise},
               {"ours", own.series.json()},
               {"embree", embree.json()},
               {"ratio", ratio(own)}};
  if (queries)
    json["ray_queries"] = {
        {"otherwise", queries->otherwise}, {"time", queries->series.json()}, {"ratio", ratio(*queries)}};
  return json;
}

}  // namespace vamp
