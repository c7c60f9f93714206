#pragma once
// What an edit costs from the moment it is handed to the renderer's thread to the first picture that shows it, and
// until the picture is as clean as before, beside the same edit answered by starting again. 640 x 480, as in the
// window, but without the window's share (events, drawing, presenting).
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct EditBench {
  std::string scene_words;
  uint32_t samples = 64;
  int rounds = 9;
};

// Edits the material of the part "Vamp", else of the first part. Throws MachineError.
Result<Report> bench_edit(gpu::Device& device, Project project, const EditBench& options);

}  // namespace vamp
