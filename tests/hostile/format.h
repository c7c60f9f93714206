#pragma once
// Every kind of file that the program reads, as a small sound one, and how it is read.
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace vamp::test {

// What a reader made of a file that it did not refuse.
struct Loaded {
  std::string unsound;      // not empty: what of it must not be, whatever the file says
  std::string fingerprint;  // of what the format's checksums cover; empty where it has none
};

struct Format {
  const char* name;
  const char* damaged;  // the file in the folder that is mutated
  void (*write)(const std::filesystem::path& folder);
  Result<Loaded> (*load)(const std::filesystem::path& folder);
};

std::vector<Format> measured_formats();  // BTFs, photographs, lists of samples
std::vector<Format> program_formats();   // presets, projects, models, pictures, settings

}  // namespace vamp::test
