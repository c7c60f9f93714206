#include "editor/model/preset_library.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/project/file_reference.h"

namespace vamp {
namespace {

constexpr size_t kMaxEntries = 10000;
constexpr size_t kMaxFileStem = 64;

bool is_preset(const fs::path& path) {
  std::error_code code;
  return path.extension() == ".vamp" || fs::is_regular_file(path / "material.json", code);
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> list;
  std::string word;
  for (const char c : lower(text) + " ") {
    if (c != ' ') {
      word.push_back(c);
    } else if (!word.empty()) {
      list.push_back(std::exchange(word, {}));
    }
  }
  return list;
}

// "Calf, cognac" -> "calf-cognac": letters and digits that every file system takes; UTF-8 stays.
std::string file_stem(const std::string& name) {
  std::string stem;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || byte >= 0x80)
      stem.push_back(static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte));
    else if (!stem.empty() && stem.back() != '-')
      stem.push_back('-');
  }
  if (stem.size() > kMaxFileStem) {
    size_t end = kMaxFileStem;
    while (end > 0 && (static_cast<unsigned char>(stem[end]) & 0xc0u) == 0x80u) --end;
    stem.resize(end);
  }
  while (!stem.empty() && stem.back() == '-') stem.pop_back();
  return stem.empty() ? "preset" : stem;
}

fs::path free_place(const fs::path& folder, const std::string& stem, const std::string& extension) {
  std::error_code code;
  fs::path place = folder / (stem + extension);
  for (int i = 2; fs::exists(fs::symlink_status(place, code)); ++i)
    place = folder / (stem + "-" + std::to_string(i) + extension);
  return place;
}

Result<fs::path> move_into(const fs::path& path, const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  const fs::path place = free_place(folder, path.stem().string(), path.extension().string());
  fs::rename(path, place, code);
  if (code)
    return fail(ErrorKind::io, path.string(), "", "cannot be moved to " + place.string() + ": " + code.message());
  return place;
}

}  // namespace

PresetLibrary::PresetLibrary(Folders folders) : folders_(std::move(folders)) {
  if (folders_.shipped.empty()) folders_.shipped = shipped_dir("presets");
  if (folders_.own.empty()) folders_.own = preset_library_dir();
  rescan();
}

void PresetLibrary::rescan() {
  entries_.clear();
  scan(folders_.own, true);
  scan(folders_.shipped, false);
  for (const fs::path& folder : folders_.others) scan(folder, false);
}

void PresetLibrary::scan(const fs::path& folder, bool writable) {
  std::vector<LibraryEntry> found;
  std::error_code code;
  if (folder.empty()) return;
  for (const auto& item : fs::directory_iterator(folder, code)) {
    const fs::path& path = item.path();
    if (path.filename().string().starts_with(".") || !is_preset(path)) continue;
    if (entries_.size() + found.size() >= kMaxEntries) break;
    LibraryEntry entry;
    entry.reference = make_reference(path);
    entry.writable = writable;
    if (auto info = load_preset_info(path)) {
      entry.info = std::move(*info);
    } else {
      entry.info.name = path.stem().string();
      entry.problem = info.error().message();
    }
    entry.info.path = path;
    found.push_back(std::move(entry));
  }
  std::sort(found.begin(), found.end(), [](const LibraryEntry& a, const LibraryEntry& b) {
    return std::pair(lower(a.info.name), a.reference) < std::pair(lower(b.info.name), b.reference);
  });
  std::move(found.begin(), found.end(), std::back_inserter(entries_));
}

std::vector<const LibraryEntry*> PresetLibrary::search(std::string_view query) const {
  const std::vector<std::string> wanted = words(query);
  std::vector<const LibraryEntry*> found;
  for (const LibraryEntry& entry : entries_) {
    std::string text = lower(entry.info.name);
    for (const std::string& tag : entry.info.tags) text += "\n" + lower(tag);
    const bool all = std::all_of(wanted.begin(), wanted.end(),
                                 [&](const std::string& word) { return text.find(word) != std::string::npos; });
    if (all) found.push_back(&entry);
  }
  return found;
}

Result<fs::path> PresetLibrary::save_new(const Preset& preset) {
  std::error_code code;
  fs::create_directories(folders_.own, code);
  if (code) return fail(ErrorKind::io, folders_.own.string(), "", "cannot be made: " + code.message());
  const fs::path place = free_place(folders_.own, file_stem(preset.name), ".vamp");
  VAMP_CHECK_STATUS(save_preset(preset, place));
  rescan();
  return place;
}

Result<fs::path> PresetLibrary::duplicate(const fs::path& path) {
  VAMP_TRY(Preset preset, load_preset(path));
  preset.name += " copy";
  return save_new(preset);
}

Status PresetLibrary::overwrite(const fs::path& path, const Preset& preset) {
  VAMP_CHECK_STATUS(check_own(path, "be changed"));
  VAMP_CHECK_STATUS(save_preset(preset, path));
  rescan();
  return {};
}

Status PresetLibrary::rename(const fs::path& path, const std::string& name) {
  VAMP_CHECK_STATUS(check_own(path, "be renamed"));
  if (name.empty()) return fail(ErrorKind::usage, path.string(), "name", "a name", "nothing");
  VAMP_TRY(Preset preset, load_preset(path));
  preset.name = name;
  return overwrite(path, preset);
}

Result<fs::path> PresetLibrary::remove(const fs::path& path) {
  VAMP_CHECK_STATUS(check_own(path, "be deleted"));
  VAMP_TRY(fs::path trashed, move_into(path, folders_.own / ".trash"));
  rescan();
  return trashed;
}

Result<fs::path> PresetLibrary::restore(const fs::path& trashed) {
  VAMP_TRY(fs::path place, move_into(trashed, folders_.own));
  rescan();
  return place;
}

// Only what lies in the user's own folder may be written.
Status PresetLibrary::check_own(const fs::path& path, std::string_view what) const {
  std::error_code code;
  const fs::path own = fs::weakly_canonical(folders_.own, code),
                 folder = fs::weakly_canonical(path, code).parent_path();
  if (!code && folder == own) return {};
  return fail(ErrorKind::failed, path.string(), "",
              "cannot " + std::string(what) + ": only presets in " + folders_.own.string() +
                  " can; save it there under a name of its own");
}

}  // namespace vamp
