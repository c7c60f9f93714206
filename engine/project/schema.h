#pragma once
// The head of the program's JSON documents: what they are and of which version.
#include <string_view>

#include "engine/core/json.h"

namespace vamp {

struct Schema {
  std::string_view format;  // "vamp-project"
  int major = 1, minor = 0;

  // {"format": ..., "schema_version": "1.0"}
  Json head() const;
  // Refuses another format or major version; a later minor version is only said in the log.
  Status check(const JsonReader& reader, std::string_view file) const;
};

}  // namespace vamp
