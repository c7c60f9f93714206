#include "editor/model/autosave_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "editor/model/autosave.h"
#include "engine/core/files.h"
#include "engine/project/project_file.h"
#include "engine/project/schema.h"

namespace vamp {
namespace {

constexpr Schema kSchema{"vamp-autosave", 1, 0};
constexpr uint64_t kMaxBytes = 64 << 20;

int64_t now_in_seconds() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// Whether the process that made `document` still runs: it holds its lock then. Taking the lock ourselves for a moment
// does no harm, because a session takes its own before it writes its first document.
bool session_runs(const fs::path& document) {
  fs::path lock_path = document;
  lock_path.replace_extension(".lock");
  const int lock = ::open(lock_path.c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return false;
  const bool taken = ::flock(lock, LOCK_EX | LOCK_NB) != 0;
  ::close(lock);
  return taken;
}

Leftover read_leftover(const fs::path& path) {
  Leftover leftover;
  leftover.file = path;
  const auto refuse = [&](const Error& error) {
    leftover.problem = error.message();
    return leftover;
  };
  const auto text = read_text(path, kMaxBytes);
  if (!text) return refuse(text.error());
  const auto json = parse_json(*text, path.string());
  if (!json) return refuse(json.error());
  const JsonReader reader(*json, path.string());
  if (const Status head = kSchema.check(reader, path.string()); !head) return refuse(head.error());
  leftover.document = reader.member("document").text();
  leftover.saved_at = reader.member("saved_at").integer(0, INT64_MAX);
  leftover.model = fs::path(reader.member("project").member("model").member("file").text()).filename().string();
  if (const Status status = reader.status(); !status) return refuse(status.error());
  return leftover;
}

}  // namespace

fs::path default_autosave_folder() { return state_dir() / "autosave"; }

Status write_autosave(const AutosaveContent& content, const fs::path& path) {
  Json json = kSchema.head();
  json["document"] = content.document.string();
  json["saved_at"] = now_in_seconds();
  VAMP_TRY(json["project"], project_to_json(*content.project, path.parent_path(), PathUse::local));
  return write_text_atomically(path, print_json(json));
}

std::vector<Leftover> find_leftovers(const fs::path& folder) {
  std::vector<Leftover> leftovers;
  std::error_code code;
  for (const auto& item : fs::directory_iterator(folder.empty() ? default_autosave_folder() : folder, code)) {
    const fs::path& path = item.path();
    if (path.filename().string().starts_with(".") || session_runs(path)) continue;
    if (path.extension() == ".json") {
      leftovers.push_back(read_leftover(path));
    } else if (path.extension() == ".lock") {
      // A crash with nothing unsaved leaves the lock alone.
      fs::path document = path;
      if (!fs::exists(document.replace_extension(".json"), code)) fs::remove(path, code);
    }
  }
  std::sort(leftovers.begin(), leftovers.end(),
            [](const Leftover& a, const Leftover& b) { return a.saved_at > b.saved_at; });
  return leftovers;
}

Result<Project> recover(const Leftover& leftover) {
  const std::string file = leftover.file.string();
  VAMP_TRY(const std::string text, read_text(leftover.file, kMaxBytes));
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader reader(json, file);
  VAMP_CHECK_STATUS(kSchema.check(reader, file));
  return project_from_json(reader.member("project"), leftover.file.parent_path(), file, PathUse::local);
}

void discard(const Leftover& leftover) {
  std::error_code code;
  fs::remove(leftover.file, code);
  fs::path lock = leftover.file;
  fs::remove(lock.replace_extension(".lock"), code);
}

}  // namespace vamp
