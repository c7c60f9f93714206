#pragma once
// Material instances in project files: which preset or whose own material, and the edits over it.
#include <filesystem>
#include <vector>

#include "engine/core/json.h"
#include "engine/project/file_reference.h"
#include "engine/project/project.h"

namespace vamp {

Result<Json> material_to_json(const MaterialInstance& material, const std::filesystem::path& folder, PathUse use);

// All instances of a document, presets loaded once each. `parts`: the document's, to name the part that needs what is
// missing; `model`: the model's own materials. The own material of a part that the model has no longer has a null fit.
Result<std::vector<MaterialInstance>> materials_from_json(const JsonReader& list, const std::vector<PartState>& parts,
                                                          const Project& model, const std::filesystem::path& folder,
                                                          std::string_view file, PathUse use);

}  // namespace vamp
