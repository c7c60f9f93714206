#include "engine/project/schema.h"

#include <fmt/format.h>

#include <charconv>

#include "engine/core/log.h"

namespace vamp {

Json Schema::head() const {
  Json json;
  json["format"] = format;
  json["schema_version"] = fmt::format("{}.{}", major, minor);
  return json;
}

Status Schema::check(const JsonReader& reader, std::string_view file) const {
  const std::string found_format = reader.member("format").text(64);
  if (found_format != format) reader.member("format").refuse(fmt::format("\"{}\"", format), "\"" + found_format + "\"");
  const std::string version = reader.member("schema_version").text(64);
  VAMP_CHECK_STATUS(reader.status());
  int found_major = -1, found_minor = -1;
  const char* const end = version.data() + version.size();
  const auto [dot, major_code] = std::from_chars(version.data(), end, found_major);
  if (major_code == std::errc() && dot != end && *dot == '.') std::from_chars(dot + 1, end, found_minor);
  if (found_major != major || found_minor < 0)
    reader.member("schema_version").refuse(fmt::format("{}.x", major), "\"" + version + "\"");
  else if (found_minor > minor)
    spdlog::warn("{}: made by a later version of the program (schema {}); what is new in it is left out", file,
                 version);
  return reader.status();
}

}  // namespace vamp
