#pragma once
// The pictures of presets as textures: decoded on a worker when they are first asked for.
#include <functional>
#include <string>
#include <unordered_map>

#include "app/window/textures.h"
#include "engine/core/jobs.h"
#include "engine/material/preset.h"

namespace vamp {

class Thumbnails {
 public:
  // `wake` is called from any thread when a picture is ready.
  Thumbnails(window::Textures& textures, std::function<void()> wake);

  // Null until it is decoded, and where the preset has none or a damaged one.
  ImTextureID find(const PresetInfo& preset);

  // Takes what is ready; once a frame.
  void deliver() { jobs_.deliver(); }

 private:
  struct Entry {
    uint64_t checksum = 0;  // of the picture it was made from
    ImTextureID texture = nullptr;
  };
  window::Textures& textures_;
  std::unordered_map<std::string, Entry> entries_;  // by path
  JobQueue jobs_;
};

}  // namespace vamp
