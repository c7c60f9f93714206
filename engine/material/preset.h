#pragma once
// Preset files: a folder or one .vamp zip with material.json (schema, name, tags, size, edit layer, provenance,
// licence), tables.bin (the fit, checksummed, little-endian) and thumbnail.png. Saving is atomic.
#include <filesystem>
#include <string>
#include <vector>

#include "engine/material/edit_layer.h"

namespace vamp {

inline constexpr size_t kMaxPresetName = 256;  // bytes

struct Preset {
  std::string name;
  std::vector<std::string> tags;
  std::string provenance, licence;
  SpmmPtr fit;
  EditLayer edits;
  std::vector<std::byte> thumbnail_png;  // may be empty
  // Members of material.json that this version does not know, as one JSON object; they are kept when it is saved.
  std::string unknown_json;
};

// What a library shows without reading the tables.
struct PresetInfo {
  std::filesystem::path path;
  std::string name;
  std::vector<std::string> tags;
  vec2 size_mm{0, 0};
  EditLayer edits;
  std::vector<std::byte> thumbnail_png;
};

Result<Preset> load_preset(const std::filesystem::path& path);
Result<PresetInfo> load_preset_info(const std::filesystem::path& path);

// `path` ends in .vamp: one zip; else a folder. The old preset stays whole until the new one is complete. A folder that
// holds anything but a preset is refused, and so is what load_preset would refuse: the fit, the edit layer and all texts
// are looked at first.
Status save_preset(const Preset& preset, const std::filesystem::path& path);

}  // namespace vamp
