#include "editor/model/recent.h"

#include <algorithm>

#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/log.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxBytes = 1 << 20;

fs::path absolute_path(const fs::path& path) {
  std::error_code code;
  const fs::path whole = fs::absolute(path, code).lexically_normal();
  return code ? path : whole;
}

Result<std::vector<fs::path>> read_list(const fs::path& file) {
  VAMP_TRY(const std::string text, read_text(file, kMaxBytes));
  VAMP_TRY(const Json json, parse_json(text, file.string()));
  const JsonReader files = JsonReader(json, file.string()).member("files");
  std::vector<fs::path> list;
  for (size_t i = 0, count = files.size(RecentFiles::kMost); i < count; ++i) list.emplace_back(files.element(i).text());
  VAMP_CHECK_STATUS(files.status());
  return list;
}

}  // namespace

RecentFiles::RecentFiles(fs::path file) : file_(file.empty() ? state_dir() / "recent.json" : std::move(file)) {
  std::error_code code;
  if (!fs::exists(file_, code)) return;
  if (auto list = read_list(file_))
    list_ = std::move(*list);
  else
    spdlog::warn("the list of recent files is started anew: {}", list.error().message());
}

bool RecentFiles::exists(const fs::path& path) {
  std::error_code code;
  return fs::exists(path, code);
}

Status RecentFiles::add(const fs::path& path) {
  const fs::path whole = absolute_path(path);
  std::erase(list_, whole);
  list_.insert(list_.begin(), whole);
  if (list_.size() > kMost) list_.resize(kMost);
  return save();
}

Status RecentFiles::remove(const fs::path& path) {
  std::erase(list_, absolute_path(path));
  return save();
}

Status RecentFiles::clear() {
  list_.clear();
  return save();
}

Status RecentFiles::save() const {
  Json json;
  Json files = Json::array();
  for (const fs::path& path : list_) files.push_back(path.string());
  json["files"] = files;
  std::error_code code;
  fs::create_directories(file_.parent_path(), code);
  return write_text_atomically(file_, print_json(json));
}

}  // namespace vamp
