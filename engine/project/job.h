#pragma once
// What a picture was made of: embedded in snapshots under "vamp:job", so that `vamp render --from` makes it again.
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/project/project.h"

namespace vamp {

inline constexpr std::string_view kJobKey = "vamp:job";  // of the picture's metadata

struct Job {
  Project project;  // seed, tap and AO radius are in its settings, exposure and tone map in its display
  uint32_t width = 0, height = 0;
  uint32_t samples = 0;  // of every pixel; with a noise goal, at most
  float noise_goal = 0;  // tiles stopped earlier where their noise was below; 0: none did
  bool complete = true;  // false: it was interrupted before its samples were done
  std::string device;    // the same bits are promised on the same device only
  std::string driver;
};

// One document, for a snapshot in `folder`. Files that lie elsewhere are named by their name and checksum alone: no
// folder of this machine is told.
Result<std::string> job_to_text(const Job& job, const std::filesystem::path& folder);

// Back from a snapshot that lies in `folder`. Files are looked for there and among those that this user's program has
// had open; a file that has changed since is an error, because the picture would not be the same.
Result<Job> job_from_text(std::string_view text, const std::filesystem::path& folder, std::string_view file);

}  // namespace vamp
