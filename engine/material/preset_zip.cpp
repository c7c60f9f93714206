#include "engine/material/preset_zip.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <memory>

namespace vamp {
namespace {

constexpr zip_int64_t kMaxMembers = 64;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* member) const { zip_fclose(member); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Member = std::unique_ptr<zip_file_t, Discard>;

std::string take_message(zip_error_t& error) {
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

Result<Archive> open(std::span<const std::byte> bytes, std::string_view file) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
  if (archive == nullptr) {
    if (source != nullptr) zip_source_free(source);
    return fail(ErrorKind::bad_input, file, "", "a whole zip file", take_message(error));
  }
  return Archive(archive);
}

Result<std::vector<std::byte>> read_member(zip_t* archive, zip_uint64_t index, std::string_view file,
                                           const ZipWant& want) {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat_index(archive, index, 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0)
    return fail(ErrorKind::bad_input, file, want.name, "a member with a size", zip_strerror(archive));
  if (stat.size > want.limit)
    return fail(ErrorKind::bad_input, file, want.name, fmt::format("at most {} bytes", want.limit),
                std::to_string(stat.size));
  const Member member(zip_fopen_index(archive, index, 0));
  if (!member) return fail(ErrorKind::bad_input, file, want.name, "a member that can be read", zip_strerror(archive));
  // Memory grows with what really comes, not with what the header says.
  std::vector<std::byte> bytes;
  std::vector<std::byte> piece(1 << 18);
  for (;;) {
    const zip_int64_t count = zip_fread(member.get(), piece.data(), piece.size());
    if (count < 0) {
      const std::string why = zip_error_strerror(zip_file_get_error(member.get()));
      return fail(ErrorKind::bad_input, file, want.name, "an undamaged member", why);
    }
    if (count == 0) break;
    if (bytes.size() + static_cast<size_t>(count) > stat.size)
      return fail(ErrorKind::bad_input, file, want.name, fmt::format("{} bytes", stat.size), "more");
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + count);
  }
  if (bytes.size() != stat.size)
    return fail(ErrorKind::bad_input, file, want.name, fmt::format("{} bytes", stat.size),
                std::to_string(bytes.size()));
  return bytes;
}

}  // namespace

Result<std::vector<ZipMember>> read_zip(std::span<const std::byte> bytes, std::string_view file,
                                        std::span<const ZipWant> wants) {
  VAMP_TRY(const Archive archive, open(bytes, file));
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  if (count > kMaxMembers)
    return fail(ErrorKind::bad_input, file, "", fmt::format("at most {} members", kMaxMembers), std::to_string(count));
  std::vector<zip_int64_t> found(wants.size(), -1);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* raw = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_RAW);
    const std::string_view name = raw == nullptr ? "" : raw;
    if (name.empty() || name == ".." || name.find_first_of("/\\:") != std::string_view::npos)
      return fail(ErrorKind::bad_input, file, "member names", "plain file names", fmt::format("\"{}\"", name));
    for (size_t w = 0; w < wants.size(); ++w)
      if (wants[w].name == name) {
        if (found[w] >= 0) return fail(ErrorKind::bad_input, file, name, "once", "twice");
        found[w] = i;
      }
  }
  std::vector<ZipMember> members;
  for (size_t w = 0; w < wants.size(); ++w) {
    if (found[w] < 0) {
      if (wants[w].required) return fail(ErrorKind::bad_input, file, wants[w].name, "a member of this name", "nothing");
      continue;
    }
    VAMP_TRY(auto content, read_member(archive.get(), static_cast<zip_uint64_t>(found[w]), file, wants[w]));
    members.push_back({std::string(wants[w].name), std::move(content)});
  }
  return members;
}

Result<std::vector<std::byte>> write_zip(std::span<const ZipMember> members, std::string_view file) {
  zip_error_t error;
  zip_error_init(&error);
  const auto give_up = [&](const std::string& why) { return fail(ErrorKind::failed, file, "", "a zip file", why); };
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (target == nullptr) return give_up(take_message(error));
  // One reference for the archive, one to read the result from.
  zip_source_keep(target);
  const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> result(target, zip_source_free);
  zip_t* opened = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  if (opened == nullptr) {
    zip_source_free(target);
    return give_up(take_message(error));
  }
  Archive archive(opened);
  for (const ZipMember& member : members) {
    zip_source_t* source = zip_source_buffer(archive.get(), member.bytes.data(), member.bytes.size(), 0);
    const zip_int64_t index =
        source == nullptr ? -1 : zip_file_add(archive.get(), member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
      if (source != nullptr) zip_source_free(source);
      return give_up(zip_strerror(archive.get()));
    }
    constexpr zip_uint16_t kMidnight = 0, kFirstOf1980 = 1 << 5 | 1;
    const auto i = static_cast<zip_uint64_t>(index);
    if (zip_set_file_compression(archive.get(), i, ZIP_CM_DEFLATE, 9) != 0 ||
        zip_file_set_dostime(archive.get(), i, kMidnight, kFirstOf1980, 0) != 0)
      return give_up(zip_strerror(archive.get()));
  }
  if (zip_close(archive.get()) != 0) return give_up(zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closed

  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_source_stat(target, &stat) != 0 || zip_source_open(target) != 0)
    return give_up(zip_error_strerror(zip_source_error(target)));
  std::vector<std::byte> bytes(stat.size);
  const zip_int64_t count = zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  if (count != static_cast<zip_int64_t>(bytes.size())) return give_up("its bytes could not be read back");
  return bytes;
}

}  // namespace vamp
