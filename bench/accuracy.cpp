#include "bench/accuracy.h"

#include <fmt/format.h>

#include "engine/gpu/device.h"

namespace vamp {

Result<Accuracy> bench_accuracy(gpu::Device& device, const AccuracyBench& options) {
  Accuracy found{Report("accuracy", fmt::format("Device: {}. {} sets of parameters a variant, {} pairs of directions "
                                                "each; times are the least of {} rounds.",
                                                device.info().name, options.lobes, options.pairs, options.rounds)),
                 {}};
  found.plots.push_back(measure_forms(device, options, found.report));
  measure_weights(device, options, found.report);
  VAMP_TRY(Plot terms, measure_terms(device, options, found.report));
  found.plots.push_back(std::move(terms));
  VAMP_TRY(Plot taps, measure_taps(device, options, found.report));
  found.plots.push_back(std::move(taps));
  found.plots.push_back(measure_directions(found.report));
  return found;
}

}  // namespace vamp
