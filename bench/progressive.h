#pragma once
// How a progressive picture's error falls with the time that is spent on it.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/image/image.h"
#include "engine/project/project.h"
#include "engine/render/renderer.h"

namespace vamp {

struct ErrorPoint {
  uint32_t samples = 0;
  double ms = 0;  // processor time over processors, since the picture began
  double rel_mse = 0, mssim = 0;
};
using ErrorCurve = std::vector<ErrorPoint>;

class Progressive {
 public:
  struct Way {
    int side = 128;  // pixels; enlarged to the reference's
    // Each sample is a picture of its own, begun again with another seed, and what is shown their mean: numbers that
    // know nothing of one another, and a primary ray for each sample. Else as the program refines.
    bool independent = false;
  };
  // Compiles the kernels. Throws MachineError.
  static Result<std::unique_ptr<Progressive>> make(gpu::Device& device, Project project, Way way);

  // The errors at 1, 2, 4 .. `most` samples, or until relMSE is `enough`. Different seeds are different pictures. Only
  // the device's work is timed.
  Result<ErrorCurve> run(uint32_t seed, uint32_t most, const Image& reference, double enough = 0);

  // The picture itself: linear R, G, B.
  Result<Image> picture(uint32_t seed, uint32_t samples);

 private:
  Progressive(gpu::Device& device, Project project, Way way)
      : device_(device), project_(std::move(project)), way_(way), renderer_(device) {}
  Status begin(uint32_t seed);
  // Adds samples up to `samples`; the time in ms.
  Result<double> refine(uint32_t seed, uint32_t samples);
  Image mean(int side);

  gpu::Device& device_;
  Project project_;
  Way way_;
  Renderer renderer_;
  uint32_t samples_ = 0;
  uint64_t done_ = 0;
  std::vector<double> sum_;  // of independent pictures, RGBA
};

// The mean errors and median times of several runs, as far as all of them went.
ErrorCurve mean_of(const std::vector<ErrorCurve>& runs);

// The time at which a curve comes down to `rel_mse`, between its points as powers; -1: it does not.
double time_to(const ErrorCurve& curve, double rel_mse);

}  // namespace vamp
