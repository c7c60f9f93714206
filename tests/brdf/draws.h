#pragma once
#include <cstddef>

#include "engine/probe/brdf_probe.h"

namespace vamp::test {

// That the shader's draws for a viewer follow the shader's density (chi_square.h): so many draws, cells integrated by
// `fine` midpoints a side.
void expect_draws_follow_the_density(BrdfProbe& probe, const Lobe& lobe, vec3 wo, uint32_t seed, size_t draws,
                                     int fine);

// The same for every model and variant, mirror-sharp to broad, head-on to grazing.
void expect_all_draws_follow_their_densities(BrdfProbe& probe, size_t draws, int fine);

}  // namespace vamp::test
