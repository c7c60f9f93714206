#pragma once
// What many lights cost: the time of a sample, its error, and the time to the error that one light has.
#include "bench/report.h"
#include "engine/project/project.h"
#include "engine/render/renderer.h"

namespace vamp {

namespace gpu {
class Device;
}

struct LightsBench {
  std::string name = "lights";  // of the report
  std::string scene_words;
  int rounds = 5;
  int side = 192;             // pixels
  uint32_t samples = 32;      // at which errors are compared
  uint32_t reference = 2048;  // samples of a reference
  LightDraws draws;
  std::vector<size_t> counts = {1, 4, 16, 32};
};

// So many soft rectangles and disks around the model, the sum of their powers the same, and a constant ambient. The
// powers are alike, and with 16 lights also such that one has half of the power, which the draws do not know. The
// errors are relMSE against a picture of `reference` samples with other random numbers. The project's own lights and
// environment are left out. Throws MachineError.
Result<Report> bench_lights(gpu::Device& device, Project project, const LightsBench& options);

}  // namespace vamp
