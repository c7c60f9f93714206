#pragma once
// A mesostructure that is made to measure: its settings, and the facets that come of them. Each kind has a file.
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/acquire/facet.h"
#include "engine/core/error.h"

namespace vamp::acquire {

// A number or a colour (linear Rec.709, each channel in the range) that makes one material out of another.
struct Setting {
  std::string_view name;
  std::variant<float*, vec3*> value;
  float low, high;
  std::string_view what;
};

class Structure {
 public:
  virtual ~Structure() = default;

  // Where the settings lie; writing there changes what build() makes.
  virtual std::vector<Setting> settings() = 0;

  // Fine enough for `cells` samples across the period. The same settings and cells give the same facets.
  virtual Mesostructure build(int cells) const = 0;
};

// The mesostructures that the program knows by name: kinds, and materials, which are kinds with settings of their own.
struct StructureRow {
  std::string_view name;
  std::string_view what;  // in a line
  std::unique_ptr<Structure> (*make)();
};
std::span<const StructureRow> structures();

// usage with the names there are, when there is none of this name.
Result<std::unique_ptr<Structure>> make_structure(std::string_view name);

// usage when there is no such setting, it is of the other kind, or out of range.
Status set(Structure& structure, std::string_view name, float value);
Status set(Structure& structure, std::string_view name, vec3 colour);

}  // namespace vamp::acquire
