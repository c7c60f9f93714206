#include "engine/project/material_json.h"

#include <fmt/format.h>

#include <map>

#include "engine/core/log.h"
#include "engine/material/preset_json.h"
#include "engine/project/fit_checksum.h"
#include "engine/project/limits.h"

namespace vamp {
namespace {

// " (needed by the part "vamp")", or nothing where no part shows it.
std::string needed_by(const std::vector<PartState>& parts, size_t material) {
  for (const PartState& part : parts)
    if (static_cast<size_t>(part.material) == material) return " (needed by the part \"" + part.name + "\")";
  return {};
}

struct LoadedPreset {
  SpmmPtr fit;
  std::string checksum;
};

// Rows that a changed fit has no longer: the model was exported or the preset made anew with fewer functions. Returns
// how many edits went with them.
size_t drop_lost_rows(EditLayer& edits, const Spmm& fit) {
  return std::erase_if(edits.bases,
                       [&](const auto& row) {
                         return static_cast<size_t>(row.first.cluster) >= fit.clusters.size() ||
                                static_cast<size_t>(row.first.basis) >= fit.dictionary.size();
                       }) +
         std::erase_if(edits.cluster_names,
                       [&](const auto& row) { return static_cast<size_t>(row.first) >= fit.clusters.size(); });
}

// The designer's edits outlive a preset that was made anew.
void say_changed(std::string_view file, const std::string& stored, const std::string& needed, size_t lost) {
  spdlog::warn("{}: the preset \"{}\"{} has changed since the project was saved; the edits over it are kept{}", file,
               stored, needed, lost == 0 ? "" : fmt::format(" but for {} of what it has no longer", lost));
}

}  // namespace

Result<Json> material_to_json(const MaterialInstance& material, const std::filesystem::path& folder, PathUse use) {
  Json json;
  json["name"] = material.name;
  if (material.preset.empty()) {
    json["model_part"] = material.model_part;
  } else {
    VAMP_TRY(json["preset"], stored_name(material.preset, material.checksum, folder, use,
                                         fmt::format("the preset of \"{}\"", material.name)));
    json["checksum"] = material.checksum;
  }
  json["edits"] = edit_layer_to_json(material.edits);
  return json;
}

Result<std::vector<MaterialInstance>> materials_from_json(const JsonReader& list, const std::vector<PartState>& parts,
                                                          const Project& model, const std::filesystem::path& folder,
                                                          std::string_view file, PathUse use) {
  std::vector<MaterialInstance> materials;
  std::map<std::string, LoadedPreset> loaded;
  for (size_t i = 0, count = list.size(kMaxParts); i < count; ++i) {
    const JsonReader reader = list.element(i);
    MaterialInstance material;
    material.name = reader.member("name").text(kMaxNameBytes);
    material.edits = edit_layer_from_json(reader.member("edits"));
    if (!reader.has("preset")) {
      material.model_part = reader.member("model_part").text();
      VAMP_CHECK_STATUS(reader.status());
      if (const int part = model.scene->find_part(material.model_part); part >= 0) {
        const int own = model.parts[static_cast<size_t>(part)].material;
        material.fit = model.materials[static_cast<size_t>(own)].fit;
        drop_lost_rows(material.edits, *material.fit);
      }
      materials.push_back(std::move(material));
      continue;
    }

    const std::string stored = reader.member("preset").text();
    material.checksum = reader.member("checksum").text(64);
    VAMP_CHECK_STATUS(reader.status());
    const std::string place = reader.path() + ".preset" + needed_by(parts, i);
    VAMP_TRY(material.preset, reference_from_stored(stored, material.checksum, folder, use, file, place));
    LoadedPreset& preset = loaded[material.preset];
    if (preset.fit == nullptr) {
      VAMP_TRY(const auto path, path_of_reference(material.preset, file, place));
      std::error_code code;
      if (!std::filesystem::exists(path, code))
        return fail(ErrorKind::bad_input, file, place, "the preset \"" + stored + "\"", "nothing there");
      VAMP_TRY(const Preset read, load_preset(path));
      preset = {read.fit, fit_checksum(*read.fit)};
    }
    material.fit = preset.fit;
    if (preset.checksum != material.checksum) {
      if (use == PathUse::job)
        return fail(ErrorKind::bad_input, file, place,
                    fmt::format("\"{}\" as it was when the picture was made ({})", stored, material.checksum),
                    fmt::format("another fit ({})", preset.checksum));
      say_changed(file, stored, needed_by(parts, i), drop_lost_rows(material.edits, *material.fit));
      material.checksum = preset.checksum;
    }
    materials.push_back(std::move(material));
  }
  VAMP_CHECK_STATUS(list.status());
  return materials;
}

}  // namespace vamp
