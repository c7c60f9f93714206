#pragma once
// What a sample of a picture costs, as it is refined for the screen.
#include "bench/series.h"
#include "engine/project/project.h"
#include "engine/render/renderer.h"

namespace vamp {

class SampleCost {
 public:
  // What is to be measured: single_round() alone needs fewer kernels.
  enum class Rounds { all, single };
  // A picture of so many pixels; compiles the kernels. Throws MachineError.
  static Result<std::unique_ptr<SampleCost>> make(gpu::Device& device, Project project, int width, int height,
                                                  Rounds rounds = Rounds::all);

  // Once: a sample with a primary ray of its own, and one of four that share a primary ray and a dispatch.
  Status round();
  // The first of these alone.
  Status single_round();

  Series single, batch;

 private:
  SampleCost(gpu::Device& device, Project project) : device_(device), project_(std::move(project)), renderer_(device) {}
  Status begin();

  gpu::Device& device_;
  Project project_;
  Renderer renderer_;
};

}  // namespace vamp
