#pragma once
// Reads the layout of structs out of compiled kernels, so that tests can compare it with the C++ side.
#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "engine/core/error.h"

namespace vamp::test {

struct SpirvStruct {
  std::map<std::string, uint32_t> offsets;  // bytes, by member name
  uint32_t stride = 0;                      // bytes between elements of arrays of it; 0: there is no such array
};

// The struct of this name as it lies in a buffer or in push constants. Fails when the words are not SPIR-V, no such
// struct with offsets is there, or two of the name are laid out differently.
Result<SpirvStruct> reflect_struct(std::span<const uint32_t> spirv, const std::string& name);

}  // namespace vamp::test
