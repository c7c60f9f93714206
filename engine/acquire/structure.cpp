#include "engine/acquire/structure.h"

#include <fmt/format.h>

#include <algorithm>

namespace vamp::acquire {
namespace {

Result<Setting> find(Structure& structure, std::string_view name) {
  std::string names;
  for (const Setting& setting : structure.settings()) {
    if (setting.name == name) return setting;
    names += (names.empty() ? "" : ", ") + std::string(setting.name);
  }
  return fail(ErrorKind::usage, "", "--set", "one of " + names, "\"" + std::string(name) + "\"");
}

bool within(const Setting& setting, float value) { return value >= setting.low && value <= setting.high; }

std::string range_of(const Setting& setting) { return fmt::format("{} to {}", setting.low, setting.high); }

}  // namespace

Result<std::unique_ptr<Structure>> make_structure(std::string_view name) {
  std::string names;
  for (const StructureRow& row : structures()) {
    if (row.name == name) return row.make();
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  }
  return fail(ErrorKind::usage, "", "--meso", "a .png file or one of " + names, "\"" + std::string(name) + "\"");
}

Status set(Structure& structure, std::string_view name, float value) {
  VAMP_TRY(const Setting setting, find(structure, name));
  const std::string place = "--set " + std::string(name);
  float* const* number = std::get_if<float*>(&setting.value);
  if (number == nullptr)
    return fail(ErrorKind::usage, "", place, "a colour: r,g,b or #rrggbb", fmt::format("{}", value));
  if (!within(setting, value)) return fail(ErrorKind::usage, "", place, range_of(setting), fmt::format("{}", value));
  **number = value;
  return {};
}

Status set(Structure& structure, std::string_view name, vec3 colour) {
  VAMP_TRY(const Setting setting, find(structure, name));
  const std::string place = "--set " + std::string(name);
  const std::string found = fmt::format("{},{},{}", colour.x, colour.y, colour.z);
  vec3* const* value = std::get_if<vec3*>(&setting.value);
  if (value == nullptr) return fail(ErrorKind::usage, "", place, "a number", found);
  for (int c = 0; c < 3; ++c)
    if (!within(setting, colour[c]))
      return fail(ErrorKind::usage, "", place, "channels from " + range_of(setting), found);
  **value = colour;
  return {};
}

}  // namespace vamp::acquire
