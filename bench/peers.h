#pragma once
// A sample beside samples of path tracers that others wrote, of the same triangles from the same camera: Embree's own
// (Debian's embree-tools) and Cycles (Debian's blender).
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct PeersBench {
  std::string name = "peers";  // of the report
  std::string scene_words;
  int rounds = 5;
  int side = 512;  // pixels
};

// Theirs: paths of two vertices between white Lambertian surfaces, under one light: a primary ray, one on from its hit,
// a shadow ray from each of the two. Ours: a primary, a shadow and an ambient ray, and the materials of the project. A
// peer that is not installed is told as such. Throws MachineError.
Result<Report> bench_peers(gpu::Device& device, Project project, const PeersBench& options);

}  // namespace vamp
