#pragma once
// How fast the program's kernels trace rays, in units of Embree's single-ray calls on the very same rays.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct RaysBench {
  std::string name = "rays";  // of the report
  std::string scene_words;
  int rounds = 15;
  int side = 512;  // pixels, a multiple of 64
};

// The project needs a light. Throws MachineError.
Result<Report> bench_rays(gpu::Device& device, Project project, const RaysBench& options);

// The same and a whole sample for the shapes of these numbers of triangles.
struct TrianglesBench {
  std::vector<int> triangles = {62'500, 250'000, 1'000'000};
  int rounds = 9;
  int side = 512;
};
Result<Report> bench_triangles(gpu::Device& device, const TrianglesBench& options);

}  // namespace vamp
