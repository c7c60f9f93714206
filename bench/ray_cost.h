#pragma once
// The program's rays, and the device's own where it has ray queries, beside Embree's: the very same ones, in
// alternating rounds.
#include <memory>
#include <optional>

#include "bench/ray_kernel.h"
#include "engine/core/json.h"

namespace vamp {

class RayCost {
 public:
  // Shadow and ambient rays are SAMPLES_PER_HIT from each hit, as in a batch. The project needs a light. Errors: a
  // scene too large for the device.
  static Result<std::unique_ptr<RayCost>> make(gpu::Device& device, const Project& project, int side);

  void round();

  struct Traced {
    RayKernel kernel;
    size_t otherwise = 0;  // rays of which Embree says something else: hit or not, or 1e-4 nearer or farther
    Series series;
  };
  struct Kind {
    const char* name;
    std::vector<ReadyRay> rays;
    Traced own;
    std::optional<Traced> queries;
    Series embree;

    // Of Embree's speed.
    double ratio(const Traced& traced) const { return embree.cpu() / traced.series.cpu(); }
    double million_a_second(const Series& series) const {
      return static_cast<double>(rays.size()) / series.cpu() * 1e-3;
    }
    Json json() const;
  };
  const std::vector<Kind>& kinds() const { return kinds_; }  // primary, shadow, ambient

 private:
  explicit RayCost(const Scene& scene) : embree_(scene.positions, scene.triangles, EmbreeScene::Edges::fast) {}

  EmbreeScene embree_;
  GpuTree own_;
  std::optional<GpuTree> queries_;
  std::vector<Kind> kinds_;
};

}  // namespace vamp
