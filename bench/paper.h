#pragma once
// The measurements of N. Silva and L. P. Santos, "Interactive High Fidelity Visualization of Complex Materials on the
// GPU", Computers & Graphics 37(7), 2013, tables 3 and 4, figures 6 and 7, done again with this program's scenes, its
// figures beside ours. Theirs were taken on a GeForce GTX 580 with OptiX and eight materials measured at Bonn: compare
// how they change, not how large they are.
#include "bench/report.h"

namespace vamp {

namespace gpu {
class Device;
}

struct PaperBench {
  int rounds = 5;
  int side = 512;  // pixels, but for table 3: 640 x 481, half of the paper's sides
};

// Errors: shipped materials or the shoe are missing. Throws MachineError.
Result<Report> bench_paper(gpu::Device& device, const PaperBench& options);

// Its parts; each adds a table and data.
Status paper_table3(gpu::Device& device, const PaperBench& options, Report& report);
Status paper_table4(gpu::Device& device, const PaperBench& options, Report& report);
Status paper_figure6(gpu::Device& device, const PaperBench& options, Report& report);
Status paper_figure7(gpu::Device& device, const PaperBench& options, Report& report);

}  // namespace vamp
