#pragma once
// The program's traversal on rays that are ready, as a kernel of its own.
#include <memory>
#include <vector>

#include "bench/ready_rays.h"
#include "engine/render/gpu_scene.h"

namespace vamp {

// A scene's triangles on the device, with what the kernels need to trace them.
struct GpuTree {
  // Errors: a scene too large for the device.
  static Result<GpuTree> make(gpu::Device& device, const Scene& scene, const TracePath& path);
  GpuScene tables;
  TracePath path;
};

class RayKernel {
 public:
  // RayQuestion::any: each SAMPLES_PER_HIT rays begin at one point. The tree must outlive this.
  RayKernel(gpu::Device& device, const GpuTree& tree, RayQuestion question, std::span<const ReadyRay> rays);

  Times run();
  // For each ray the nearest hit's distance, or 1 where nothing is in the way; else -1. After run().
  std::vector<float> found() const;
  // For each ray the nearest hit's triangle, in the tree's order, or -1. After run().
  std::vector<int> triangles() const;

 private:
  gpu::Device* device_;
  uint32_t invocations_;
  gpu::TypedBuffer<ReadyRay> rays_;
  gpu::TexelView rays_view_;
  gpu::TypedBuffer<float> found_;
  gpu::TypedBuffer<int> triangles_;
  gpu::ComputePipeline pipeline_;
  gpu::DescriptorSet set_;
};

}  // namespace vamp
