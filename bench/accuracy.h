#pragma once
// How exact the program is against what it costs: the seven models in their robust forms and as textbooks write them,
// weights by their storage, terms of the residual, texture taps, directions between the measured ones.
#include "bench/plot.h"

namespace vamp {

namespace gpu {
class Device;
}

struct AccuracyBench {
  int lobes = 500, pairs = 600;  // of hard questions, a variant
  int rounds = 7;                // of timings
  int side = 256;                // of pictures, pixels
  uint32_t samples = 256;        // of reference pictures
};

struct Accuracy {
  Report report;
  std::vector<Plot> plots;
};

// Errors: the shipped shoe is missing. Throws MachineError.
Result<Accuracy> bench_accuracy(gpu::Device& device, const AccuracyBench& options);

// Its chapters; each adds its tables and data and returns its plot, if it has one.
// Errors on hard questions against the double build on the same floats (engine/probe/hard_questions.h), and nanoseconds
// for an evaluation, on the device and on the CPU.
Plot measure_forms(gpu::Device& device, const AccuracyBench& options, Report& report);
// Weights as floats, halves and bytes.
void measure_weights(gpu::Device& device, const AccuracyBench& options, Report& report);
// The shipped shoe with 0 to 4 terms of its residuals and without them.
Result<Plot> measure_terms(gpu::Device& device, const AccuracyBench& options, Report& report);
// And near by, with one texture tap at random and with four.
Result<Plot> measure_taps(gpu::Device& device, const AccuracyBench& options, Report& report);
// Values between the measured directions of known reflectances.
Plot measure_directions(Report& report);

}  // namespace vamp
