#pragma once
// What a sample of a picture costs, in units of what Embree's single-ray calls need for the same rays in the same run.
//
// The picture has one primary, one shadow and one ambient ray a sample and pixel and SPMM shading. Embree traces rays
// drawn the same way from ready arrays in tile order on as many threads as there are processors; drawing the rays,
// surfaces, shading and accumulation are on our side of the balance alone. Rounds of both alternate.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct FrameBench {
  std::string name = "frame";  // of the report
  std::string scene_words;
  int rounds = 9;
  int side = 512;  // pixels
};

// The project needs a light; only its first is kept. Throws MachineError.
Result<Report> bench_frame(gpu::Device& device, Project project, const FrameBench& options);

}  // namespace vamp
