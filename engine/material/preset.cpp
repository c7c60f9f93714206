#include "engine/material/preset.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "engine/core/files.h"
#include "engine/core/hash.h"
#include "engine/material/preset_json.h"
#include "engine/material/preset_tables.h"
#include "engine/material/preset_zip.h"

namespace vamp {
namespace {

constexpr std::string_view kJsonName = "material.json", kTablesName = "tables.bin", kThumbnailName = "thumbnail.png";
constexpr uint64_t kMaxJson = uint64_t{64} << 20, kMaxTables = (uint64_t{2} << 30) - 1;
constexpr uint64_t kMaxThumbnail = uint64_t{16} << 20, kMaxZip = kMaxTables;

std::string_view as_text(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The members of a preset as they lie in a zip or folder.
struct Members {
  std::vector<std::byte> json, tables, thumbnail;
};

Result<Members> read_members(const fs::path& path, bool with_tables) {
  Members members;
  std::error_code code;
  if (!fs::is_directory(path, code)) {
    VAMP_TRY(const auto bytes, read_file(path, kMaxZip));
    std::vector<ZipWant> wants = {{kJsonName, kMaxJson}, {kThumbnailName, kMaxThumbnail, false}};
    if (with_tables) wants.push_back({kTablesName, kMaxTables});
    VAMP_TRY(auto found, read_zip(bytes, path.string(), wants));
    for (ZipMember& member : found)
      (member.name == kJsonName     ? members.json
       : member.name == kTablesName ? members.tables
                                    : members.thumbnail) = std::move(member.bytes);
    return members;
  }
  // Links that leave the folder are refused, as names that do.
  const auto read = [&](std::string_view name, uint64_t limit) -> Result<std::vector<std::byte>> {
    VAMP_TRY(const fs::path file, resolve_inside(path, name, path.string(), name));
    return read_file(file, limit);
  };
  VAMP_TRY(members.json, read(kJsonName, kMaxJson));
  if (with_tables) {
    VAMP_TRY(members.tables, read(kTablesName, kMaxTables));
  }
  if (fs::exists(path / kThumbnailName, code)) {
    VAMP_TRY(members.thumbnail, read(kThumbnailName, kMaxThumbnail));
  }
  return members;
}

tl::unexpected<Error> cannot_write(const fs::path& path) {
  return fail(ErrorKind::io, path.string(), "", std::string("cannot be written: ") + std::strerror(errno));
}

// Only a preset may be replaced by a preset: a folder chosen by mistake keeps its files.
Status check_replaceable(const fs::path& folder) {
  std::error_code code;
  if (!fs::exists(folder, code)) return {};
  if (!fs::is_directory(folder, code))
    return fail(ErrorKind::bad_input, folder.string(), "", "a folder, or a name that ends in .vamp", "a file");
  for (const auto& item : fs::directory_iterator(folder, code)) {
    const std::string name = item.path().filename().string();
    if (name != kJsonName && name != kTablesName && name != kThumbnailName)
      return fail(ErrorKind::bad_input, folder.string(), "", "a new folder or a preset",
                  fmt::format("a folder that holds \"{}\"", name));
  }
  if (code) return fail(ErrorKind::io, folder.string(), "", "cannot be read: " + code.message());
  return {};
}

// Puts the complete new folder in the old one's place, and the old one where the new one was.
bool swap_folders(const fs::path& made, const fs::path& target) {
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  // A file system without exchange: the old one steps aside for a moment and comes back if the new one cannot move in.
  const fs::path aside = made.string() + ".old";
  if (::rename(target.c_str(), aside.c_str()) != 0) return false;
  if (::rename(made.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    if (::rename(aside.c_str(), target.c_str()) != 0) return false;
    errno = reason;
    return false;
  }
  return ::rename(aside.c_str(), made.c_str()) == 0;
}

Status save_folder(const Members& members, const fs::path& path) {
  std::error_code code;
  fs::path target = fs::weakly_canonical(path, code);  // follows a link to the real folder, drops a trailing slash
  if (code) target = path;
  if (!target.has_filename()) target = target.parent_path();
  VAMP_CHECK_STATUS(check_replaceable(target));
  std::string made = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
  if (::mkdtemp(made.data()) == nullptr) return cannot_write(path);
  const auto clean_up = [&](Status status) {
    std::error_code ignored;
    fs::remove_all(made, ignored);
    if (!status) {
      Error error = status.error();
      error.file = path.string();
      return Status(tl::unexpected(error));
    }
    return status;
  };
  const std::array<std::pair<std::string_view, const std::vector<std::byte>*>, 3> files = {
      {{kTablesName, &members.tables}, {kThumbnailName, &members.thumbnail}, {kJsonName, &members.json}}};
  for (const auto& [name, bytes] : files) {
    if (bytes->empty()) continue;
    Status status = write_file_atomically(fs::path(made) / name, *bytes);
    if (!status) return clean_up(std::move(status));
  }
  fs::permissions(made, fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read | fs::perms::others_exec,
                  fs::perm_options::add, code);
  const bool replaces = fs::exists(target, code);
  const bool moved = replaces ? swap_folders(made, target) : ::rename(made.c_str(), target.c_str()) == 0;
  return clean_up(moved ? Status() : Status(cannot_write(path)));
}

}  // namespace

Result<PresetInfo> load_preset_info(const fs::path& path) {
  VAMP_TRY(Members members, read_members(path, false));
  VAMP_TRY(PresetInfo info, info_from_json(as_text(members.json), path.string()));
  info.path = path;
  info.thumbnail_png = std::move(members.thumbnail);
  return info;
}

Result<Preset> load_preset(const fs::path& path) {
  const std::string file = path.string();
  VAMP_TRY(Members members, read_members(path, true));
  auto fit = std::make_shared<Spmm>();
  TablesNote note;
  VAMP_TRY(Preset preset, preset_from_json(as_text(members.json), file, *fit, note));
  if (note.uri != kTablesName)
    return fail(ErrorKind::bad_input, file, "tables.uri", fmt::format("\"{}\"", kTablesName), "\"" + note.uri + "\"");
  if (note.bytes != members.tables.size())
    return fail(ErrorKind::bad_input, file, kTablesName, fmt::format("{} bytes", note.bytes),
                std::to_string(members.tables.size()));
  if (note.checksum != checksum(members.tables))
    return fail(ErrorKind::bad_input, file, kTablesName, "checksum " + note.checksum,
                checksum(members.tables) + " (damaged, or of another preset)");
  VAMP_CHECK_STATUS(
      decode_tables(members.tables, file + ": " + std::string(kTablesName), note.entries, note.directions, *fit));
  VAMP_CHECK_STATUS(validate(*fit, file));
  VAMP_CHECK_STATUS(validate(preset.edits, *fit, file));
  preset.fit = std::move(fit);
  preset.thumbnail_png = std::move(members.thumbnail);
  return preset;
}

Status save_preset(const Preset& preset, const fs::path& path) {
  const std::string file = path.string();
  if (!preset.fit) return fail(ErrorKind::failed, file, "", "a material to save", "none");
  VAMP_CHECK_STATUS(validate(*preset.fit, file));
  VAMP_CHECK_STATUS(validate(preset.edits, *preset.fit, file));
  Members members;
  members.tables = encode_tables(*preset.fit);
  const Spmm& fit = *preset.fit;
  TablesNote note;
  note.bytes = members.tables.size();
  note.checksum = checksum(members.tables);
  note.entries = fit.entries.size();
  note.directions = fit.residual.records.empty() ? 0 : fit.residual.directions.size();
  const std::string text = print_json(preset_to_json(preset, note));
  // A text of more bytes than it may have would be noticed when it is too late.
  Spmm read_again;
  if (const auto readable = preset_from_json(text, file, read_again, note); !readable)
    return tl::unexpected(readable.error());
  const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
  members.json.assign(bytes.begin(), bytes.end());
  members.thumbnail = preset.thumbnail_png;
  if (path.extension() != ".vamp") return save_folder(members, path);

  std::vector<ZipMember> list = {{std::string(kJsonName), std::move(members.json)},
                                 {std::string(kTablesName), std::move(members.tables)}};
  if (!members.thumbnail.empty()) list.push_back({std::string(kThumbnailName), std::move(members.thumbnail)});
  VAMP_TRY(const auto zip, write_zip(list, file));
  return write_file_atomically(path, zip);
}

}  // namespace vamp
