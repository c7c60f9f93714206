#pragma once
// A question as kernels read it (shaders/shared/probe.h).
#include "engine/probe/brdf_probe.h"
#include "shaders/shared/probe.h"

namespace vamp::probe {

// `packed`: with what the lobe code takes; else those members are 0.
Question question_row(const BrdfQuestion& question, bool packed);

}  // namespace vamp::probe
