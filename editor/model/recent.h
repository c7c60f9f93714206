#pragma once
// The files that were open last, for the menu and the next start. Kept in state_dir()/recent.json.
#include <filesystem>
#include <vector>

#include "engine/core/error.h"

namespace vamp {

class RecentFiles {
 public:
  static constexpr size_t kMost = 20;

  // `file`: empty for state_dir()/recent.json. A damaged list is an empty one; the log says so.
  explicit RecentFiles(std::filesystem::path file = {});

  // Latest first; files that are gone are left in, so that a disk that comes back finds them (see exists()).
  const std::vector<std::filesystem::path>& list() const { return list_; }
  static bool exists(const std::filesystem::path& path);

  // Puts a file on top and writes the list.
  Status add(const std::filesystem::path& path);
  Status remove(const std::filesystem::path& path);
  Status clear();

 private:
  Status save() const;
  std::filesystem::path file_;
  std::vector<std::filesystem::path> list_;
};

}  // namespace vamp
