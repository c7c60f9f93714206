#pragma once
// Keeping a material of the document as a preset of the user's library.
#include <filesystem>
#include <functional>
#include <string>

#include "editor/model/document.h"
#include "editor/model/preset_library.h"
#include "engine/core/jobs.h"

namespace vamp {

namespace gpu {
class Device;
}

// A material that is a preset now.
struct SavedPreset {
  std::filesystem::path path;
  Preset preset;         // as it is on disk
  std::string material;  // the name that it had in the document
  SpmmPtr fit;           // that it had there
};

class PresetDialog {
 public:
  PresetDialog(gpu::Device& device, PresetLibrary& library, JobQueue& jobs);

  void open(const Project& project, int material);
  void draw();
  // Presets that are on their way to the library.
  int saving() const { return saving_; }

  // Told after the library has it.
  std::function<void(const SavedPreset&)> saved;

 private:
  const LibraryEntry* own_of_this_name() const;
  void start(const std::filesystem::path& over);
  void finish(Preset preset, const std::filesystem::path& over, const std::string& material);

  gpu::Device& device_;
  PresetLibrary& library_;
  JobQueue& jobs_;
  Preset preset_;
  std::string origin_;    // reference of the preset that it began as; may be empty
  std::string material_;  // its name in the document
  std::string name_, tags_;
  bool open_ = false;
  int saving_ = 0;
};

// "leather, calf  ,brown" as tags: trimmed, without empty and repeated ones.
std::vector<std::string> split_tags(std::string_view text);

}  // namespace vamp
