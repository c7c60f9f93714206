#pragma once
// Keeping a material of the document as a preset of the user's library.
#include <functional>
#include <string>

#include "editor/model/document.h"
#include "editor/model/preset_library.h"
#include "engine/core/jobs.h"

namespace vamp {

namespace gpu {
class Device;
}

class PresetDialog {
 public:
  PresetDialog(gpu::Device& device, PresetLibrary& library, JobQueue& jobs);

  void open(const Project& project, int material);
  void draw();
  // Presets that are on their way to the library.
  int saving() const { return saving_; }

  // Told after the library has a new preset.
  std::function<void()> saved;

 private:
  void start();

  gpu::Device& device_;
  PresetLibrary& library_;
  JobQueue& jobs_;
  Preset preset_;
  std::string origin_;  // reference of the preset that it began as; may be empty
  std::string name_, tags_;
  bool open_ = false;
  int saving_ = 0;
};

// "leather, calf  ,brown" as tags: trimmed, without empty and repeated ones.
std::vector<std::string> split_tags(std::string_view text);

}  // namespace vamp
