#pragma once
// What designers call the functions and clusters that a fit found.
#include "engine/fit/parameters.h"

namespace vamp::fit {

// A function that stands for no layer of the material: its shape lies at the end of its range, or it is a broad lobe
// tilted far off that fills where shadows are. Its name begins with "filler".
bool is_filler(const Basis& basis, const LobeLimits& limits);

// Names all functions by what they look like, "satin gloss, leaning left"; no two the same.
void name_functions(std::vector<Basis>& dictionary, const LobeLimits& limits);

// Names clusters by their mean colour (linear Rec.709 reflectance), "dark brown 2"; no two the same.
std::vector<Cluster> name_clusters(const std::vector<vec3>& colours);

}  // namespace vamp::fit
