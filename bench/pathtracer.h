#pragma once
// A sample beside a frame of Embree's own path tracer (Debian's embree-tools) of the same triangles.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct PathtracerBench {
  std::string name = "pathtracer";  // of the report
  std::string scene_words;
  int rounds = 5;
  int side = 512;  // pixels
};

// Embree's paths have two vertices, and one point light shines: a primary ray, one on from its hit, a shadow ray from
// each of the two, and white Lambertian surfaces. Ours: a primary, a shadow and an ambient ray, and the materials of
// the project. Errors: failed, where `pathtracer` does not run. Throws MachineError.
Result<Report> bench_pathtracer(gpu::Device& device, Project project, const PathtracerBench& options);

}  // namespace vamp
