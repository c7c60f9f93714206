#pragma once
// The passes as pipelines, specialised for what a scene needs and kept.
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/gpu/pipeline.h"

namespace vamp {

enum class Pass { trace, shade, composite, recombine, aov, occlusion };

// Values of the SPEC_* constants (shaders/shared/frame.h).
struct KernelKey {
  uint32_t samples = 1;
  uint32_t light_count = 0;
  uint32_t light_types = 0;
  bool ambient = true;
  bool environment = false;
  bool mirror = false;
  bool alpha_mask = false;
  uint32_t residual = 0;
  uint32_t lobe_models = 0;
  bool four_taps = false;
  bool storage_fetch = false;
  bool pixel_centres = false;
  bool new_hit = true;
  bool list = false;
  bool highlight = false;
  uint32_t light_slots = 0;
  auto operator<=>(const KernelKey&) const = default;

  // Shadow rays of a sample at one vertex, and accumulator planes.
  uint32_t ray_count() const { return (light_slots > 0 ? light_slots : light_count) + others(); }
  uint32_t planes() const { return 1 + light_count + others(); }

 private:
  uint32_t others() const { return (ambient ? 1u : 0u) + (environment ? 1u : 0u); }
};

// All kernels share one set of bindings.
const std::vector<gpu::Binding>& kernel_bindings();

class Kernels {
 public:
  // `shade`: another build of passes/shade.comp, for measurements; empty: the program's.
  explicit Kernels(gpu::Device& device, std::span<const uint32_t> shade = {}) : device_(&device), shade_(shade) {}

  // Constants that a pass does not read are ignored, so that it is not made twice. Throws MachineError.
  const gpu::ComputePipeline& get(Pass pass, KernelKey key);

 private:
  gpu::Device* device_;
  std::span<const uint32_t> shade_;
  std::map<std::pair<Pass, KernelKey>, gpu::ComputePipeline> pipelines_;
};

}  // namespace vamp
