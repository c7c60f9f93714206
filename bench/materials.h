#pragma once
// What a sample costs with more and more materials in view of one scene.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct MaterialsBench {
  std::string name = "materials";  // of the report
  std::string scene_words;
  int rounds = 15;
  int side = 512;  // pixels
};

// 1, 2, 4 and 8 made-up materials (bench/material.h), of the same cost each, on the parts in turn. Errors: no light, or
// fewer than eight parts. Throws MachineError.
Result<Report> bench_materials(gpu::Device& device, Project project, const MaterialsBench& options);

}  // namespace vamp
