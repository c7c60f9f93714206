#pragma once
// All presets that can be put on a part: those shipped with the program (read-only), the user's own, and further
// folders. A folder of files is the whole database.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/material/preset.h"

namespace vamp {

struct LibraryEntry {
  std::string reference;  // for assign_preset: "shipped:presets/calf.vamp"
  PresetInfo info;        // name, tags, size, thumbnail
  bool writable = false;  // the user's own
  std::string problem;    // not empty: it cannot be read, and why; its name is the file's
};

class PresetLibrary {
 public:
  struct Folders {
    std::filesystem::path shipped;              // empty: shipped_dir("presets")
    std::filesystem::path own;                  // empty: data_dir() / "presets"
    std::vector<std::filesystem::path> others;  // read-only
  };
  PresetLibrary() : PresetLibrary(Folders{}) {}
  explicit PresetLibrary(Folders folders);

  // Reads the folders anew. Reads no tables: a library of hundreds is there at once. Damaged presets are listed with
  // their problem.
  void rescan();

  // Own ones first, then shipped, then others; by name within each.
  const std::vector<LibraryEntry>& entries() const { return entries_; }

  // Those whose name or tags hold every word of `query`, whatever the case; all for an empty one.
  std::vector<const LibraryEntry*> search(std::string_view query) const;

  // Saves under a file name made from the preset's name that no other file has ("calf-cognac.vamp",
  // "calf-cognac-2.vamp"), and rescans. Returns the path.
  Result<std::filesystem::path> save_new(const Preset& preset);
  // A copy of any preset among the user's own: "Calf, cognac copy".
  Result<std::filesystem::path> duplicate(const std::filesystem::path& path);
  // Writes over one of the user's own.
  Status overwrite(const std::filesystem::path& path, const Preset& preset);
  // Another name in the preset; the file keeps its name, so that projects find it.
  Status rename(const std::filesystem::path& path, const std::string& name);
  // Moves one of the user's own to the folder ".trash" of the library. Returns where it is now; restore() undoes it.
  Result<std::filesystem::path> remove(const std::filesystem::path& path);
  Result<std::filesystem::path> restore(const std::filesystem::path& trashed);

  const std::filesystem::path& own_folder() const { return folders_.own; }

 private:
  void scan(const std::filesystem::path& folder, bool writable);
  Status check_own(const std::filesystem::path& path, std::string_view what) const;
  Folders folders_;
  std::vector<LibraryEntry> entries_;
};

}  // namespace vamp
