#pragma once
// One number for a whole fit: whether a preset still is what a project was made with.
#include <string>

#include "engine/material/spmm.h"

namespace vamp {

// 16 hexadecimal digits over everything that rendering reads; names do not count.
std::string fit_checksum(const Spmm& spmm);

}  // namespace vamp
