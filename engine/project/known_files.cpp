#include "engine/project/known_files.h"

#include <mutex>
#include <utility>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/hash.h"
#include "engine/core/json.h"
#include "engine/core/log.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t{4} << 30;
constexpr uint64_t kMaxNotesBytes = 8 << 20;
constexpr size_t kMaxNotes = 1000;

using Notes = std::vector<std::pair<std::string, std::string>>;  // checksum, path; the latest last

std::mutex notes_mutex;

fs::path notes_path() { return state_dir() / "known_files.json"; }

// Damaged notes are worth nothing and lose nothing: one starts again.
Notes read_notes() {
  Notes notes;
  const auto text = read_text(notes_path(), kMaxNotesBytes);
  if (!text) return notes;
  const auto json = parse_json(*text, notes_path().string());
  if (!json) return notes;
  const JsonReader reader(*json, notes_path().string());
  for (const std::string& key : reader.keys(kMaxNotes)) notes.emplace_back(key, reader.member(key).text());
  if (!reader.status()) notes.clear();
  return notes;
}

}  // namespace

Result<std::string> file_checksum(const fs::path& path) {
  VAMP_TRY(const auto bytes, read_file(path, kMaxFileBytes));
  return checksum(bytes);
}

void remember_file(std::string_view checksum, const fs::path& path) {
  const std::lock_guard lock(notes_mutex);
  Notes notes = read_notes();
  const std::pair<std::string, std::string> note(checksum, path.string());
  if (!notes.empty() && notes.back() == note) return;
  std::erase_if(notes, [&](const auto& old) { return old.first == checksum; });
  notes.push_back(note);
  if (notes.size() > kMaxNotes) notes.erase(notes.begin());
  Json json = Json::object();
  for (const auto& [key, value] : notes) json[key] = value;
  std::error_code code;
  fs::create_directories(state_dir(), code);
  if (const Status written = write_text_atomically(notes_path(), print_json(json)); !written)
    spdlog::debug("{}", written.error().message());
}

std::optional<fs::path> known_file(std::string_view checksum) {
  const std::lock_guard lock(notes_mutex);
  for (const auto& [key, value] : read_notes()) {
    std::error_code code;
    if (key == checksum && fs::exists(value, code)) return fs::path(value);
  }
  return std::nullopt;
}

}  // namespace vamp
