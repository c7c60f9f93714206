#pragma once
// What the parts of a model are called.
#include <set>
#include <string>
#include <vector>

namespace vamp {

// Names of parts: those of the materials; "Part 1", "Part 2" for materials without one, "Default" without a material
// ("Default 2" where a material has taken that). Materials with the same name share their part.
class PartNames {
 public:
  explicit PartNames(const std::vector<std::string>& material_names);
  // material < 0: without one.
  const std::string& of(int material) const { return material < 0 ? default_ : names_[static_cast<size_t>(material)]; }

 private:
  std::set<std::string> taken_;
  std::vector<std::string> names_;
  std::string default_ = "Default";
};

}  // namespace vamp
