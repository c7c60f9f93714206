#pragma once
// The models as their papers print them, in long double: normalised half vectors, pow, angles. Slow and independent of
// the shader text; the published value that the robust forms are compared with.
#include "engine/brdf/lobe.h"

namespace vamp::test {
// f * cos for unit directions above the horizon.
double published_fcos(const Lobe& lobe, dvec3 wi, dvec3 wo);
}  // namespace vamp::test
