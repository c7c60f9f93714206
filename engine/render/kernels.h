#pragma once
// The passes as pipelines, specialised for what a scene needs and kept.
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/gpu/background_pipelines.h"
#include "engine/gpu/device.h"
#include "engine/gpu/pipeline.h"
#include "engine/render/kernel_key.h"

namespace vamp {

enum class Pass { trace, shade, composite, recombine, aov, occlusion };

// All kernels share one set of bindings.
const std::vector<gpu::Binding>& kernel_bindings(const TracePath& path);

class Kernels {
 public:
  using Urgency = gpu::BackgroundPipelines::Urgency;

  // `shade`: another build of passes/shade.comp, for measurements; empty: the program's.
  explicit Kernels(gpu::Device& device, std::span<const uint32_t> shade = {}) : device_(&device), shade_(shade) {}

  // From now on kernels are made beside the queue, if that is of use on this device; `arrived` is called on another
  // thread when one is there.
  void make_in_background(std::function<void()> arrived);
  bool in_background() const { return background_ != nullptr; }
  // Generic kernels for everything, to compare what they give and cost.
  void use_generic_alone() { generic_alone_ = true; }
  // What will stand at the bindings.
  void bound_as(const std::vector<gpu::Binding>& bindings, const std::vector<gpu::Bound>& bound);

  // Whether generic kernels give the same bits as specialised ones.
  bool same_bits() const { return device_->info().is_lavapipe; }

  // Constants that a pass does not read are ignored, so that it is not made twice. In the background a generic kernel
  // stands in for one that is not there yet; if that is not there either, waits. Throws MachineError.
  const gpu::ComputePipeline& get(Pass pass, KernelKey key);
  // Whether get() would not wait for another thread.
  bool ready(Pass pass, const KernelKey& key) const;
  void want(Pass pass, const KernelKey& key, Urgency urgency);
  // What is wanted and not begun is wanted no more.
  void want_nothing();
  // Takes over what has arrived.
  void collect();

 private:
  struct Kernel {
    gpu::ComputePipeline pipeline;
    bool wanted = false;
  };
  using Which = std::pair<Pass, KernelKey>;
  gpu::PipelineDesc describe(const Which& which) const;
  const Kernel* find(const Which& which) const;

  gpu::Device* device_;
  std::span<const uint32_t> shade_;
  bool generic_alone_ = false;
  std::map<Which, Kernel> kernels_;
  std::vector<Which> asked_;                              // by number
  std::unique_ptr<gpu::BackgroundPipelines> background_;  // goes first: makes kernels of the device
};

}  // namespace vamp
