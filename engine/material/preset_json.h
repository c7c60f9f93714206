#pragma once
// material.json: everything of a preset but its tables and picture. Lengths in mm, angles in degrees.
#include <string>
#include <string_view>

#include "engine/core/json.h"
#include "engine/material/preset.h"

namespace vamp {

// What material.json says of tables.bin.
struct TablesNote {
  std::string uri = "tables.bin";
  uint64_t bytes = 0;
  std::string checksum;  // 32 hexadecimal digits
  size_t entries = 0, directions = 0;
};

Json preset_to_json(const Preset& preset, const TablesNote& tables);

// The preset with the light part of its fit (sizes, dictionary, clusters, residual terms) filled into `fit`.
Result<Preset> preset_from_json(std::string_view text, std::string_view file, Spmm& fit, TablesNote& tables);

// Name, tags and size alone.
Result<PresetInfo> info_from_json(std::string_view text, std::string_view file);

// The edit layer alone, as presets and project files store it; read with its ranges checked, but not against a fit.
Json edit_layer_to_json(const EditLayer& edits);
EditLayer edit_layer_from_json(const JsonReader& reader);

// What must hold of an edit layer over this fit: rows that exist, lobes and normals in range, finite gains.
Status validate(const EditLayer& edits, const Spmm& fit, std::string_view file);

}  // namespace vamp
