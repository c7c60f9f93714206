#pragma once
// Whether an edit of a fitted material shows what the material would look like if it really were so (bench/changes.h).
#include <filesystem>

#include "bench/report.h"

namespace vamp {

class Progress;

struct EditsBench {
  int size = 64;                // texels across
  int samples = 16;             // of the goniometer
  int clusters = 32;            // of a fit, as vamp fit has it
  std::filesystem::path cache;  // where acquisitions are kept; empty: they are made anew and go when it ends
};

// Acquires each material as it is and as it really becomes, fits both, edits the first fit, and compares with a second
// acquisition of the changed material, which no fit has seen. interrupted when `progress` was cancelled.
Result<Report> bench_edits(const EditsBench& bench, Progress& progress);

}  // namespace vamp
