#pragma once
// JSON from files that may be damaged or hostile, read strictly; and written so that it diffs well.
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace vamp {

using Json = nlohmann::ordered_json;

// Parses `text`; `file` is for the message. Refuses nesting deeper than 32, duplicate keys and strings over
// `string_limit` bytes (glTF may hold whole buffers as data: URIs; keys stay at 4 KiB).
Result<Json> parse_json(std::string_view text, std::string_view file, size_t string_limit = 4096);

// Two-space indentation, keys in the order of insertion, shortest digits that read back as the same number.
// CHECKs that every number is finite (nlohmann would write null).
std::string print_json(const Json& json);

// A float as the shortest decimal that reads back as the same float.
Json json_number(float value);

// A place in a parsed file: reads members with type, range and finiteness checked, and knows its path for messages.
// The first error stays; readers go on with defaults and the caller looks at status() once at the end.
class JsonReader {
 public:
  JsonReader(const Json& root, std::string_view file);

  // Children share the first error with their parents. A missing member is an error unless has() said otherwise.
  bool has(std::string_view key) const;
  JsonReader member(std::string_view key) const;
  JsonReader element(size_t index) const;
  size_t size(size_t limit) const;  // of an array or object; an error when larger than `limit`
  std::vector<std::string> keys(size_t limit) const;

  float number(float low, float high) const;
  double real(double low, double high) const;  // where a float's digits do not do: units that are converted
  int64_t integer(int64_t low, int64_t high) const;
  bool boolean() const;
  std::string text(size_t limit = 4096) const;

  // Says that something about this place is wrong.
  void refuse(std::string_view expected, std::string_view found) const;
  Status status() const;
  const std::string& path() const { return path_; }

 private:
  struct Shared;
  JsonReader(const Json* value, std::shared_ptr<Shared> shared, std::string path);
  const Json* value_;
  std::shared_ptr<Shared> shared_;
  std::string path_;
};

}  // namespace vamp
