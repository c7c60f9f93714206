#include "bench/sample_cost.h"

#include "engine/gpu/device.h"

namespace vamp {

Result<std::unique_ptr<SampleCost>> SampleCost::make(gpu::Device& device, Project project, int width, int height,
                                                     Rounds rounds) {
  std::unique_ptr<SampleCost> cost(new SampleCost(device, std::move(project)));
  VAMP_CHECK_STATUS(cost->begin());
  cost->renderer_.set_region(width, height, {0, 0, width, height});
  // Kernels are compiled at their first dispatch.
  VAMP_CHECK_STATUS(rounds == Rounds::all ? cost->round() : cost->single_round());
  cost->single = cost->batch = {};
  return cost;
}

Status SampleCost::single_round() {
  VAMP_CHECK_STATUS(begin());
  const Stopwatch watch;
  device_.wait(renderer_.refine_all(1));
  single.add(watch.stop());
  return {};
}

Status SampleCost::round() {
  VAMP_CHECK_STATUS(single_round());
  while (renderer_.samples() < SAMPLES_PER_HIT) device_.wait(renderer_.refine_all(SAMPLES_PER_HIT));
  const Stopwatch watch;
  device_.wait(renderer_.refine_all(2 * SAMPLES_PER_HIT));
  batch.add(watch.stop(), 1.0 / SAMPLES_PER_HIT);
  return {};
}

// Starts again in the same memory: fresh pages would be paid for in the first sample.
Status SampleCost::begin() {
  ++project_.settings.seed;
  const Result<Change> change = renderer_.set_project(std::make_shared<const Project>(project_));
  return change ? Status() : tl::unexpected(change.error());
}

}  // namespace vamp
