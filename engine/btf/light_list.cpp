#include "engine/btf/light_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/btf/text_lines.h"
#include "engine/core/check.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxBytes = uint64_t{16} << 20;
// A light in the plane of the object lights nothing.
constexpr double kLowestZ = 1e-6;

// Cuts the last word off the line.
std::string_view take_last_word(std::string_view& line) {
  line = trimmed(line);
  const size_t blank = line.find_last_of(" \t");
  const size_t start = blank == std::string_view::npos ? 0 : blank + 1;
  const std::string_view word = line.substr(start);
  line = line.substr(0, start);
  return word;
}

// Most lists hold unit vectors. There a vector of another length is a damaged number, which nothing else would tell.
Status check_lengths(std::span<const double> lengths, std::span<const size_t> lines, std::string_view file) {
  const auto is_unit = [](double length) { return std::abs(length - 1) < 2e-3; };
  if (std::ranges::count_if(lengths, is_unit) * 2 < std::ssize(lengths)) return {};
  for (size_t i = 0; i < lengths.size(); ++i)
    if (!is_unit(lengths[i]))
      return fail(ErrorKind::bad_input, file, fmt::format("line {}", lines[i]), "a unit vector, as in the other lines",
                  fmt::format("one of length {:.4f}", lengths[i]));
  return {};
}

// Lists are written on one machine and read on another: "C:\dome\a.jpg" and "/home/me/a.jpg" become "a.jpg", unless the
// file stands under the list's folder as it is written.
Result<fs::path> file_beside(const fs::path& list, const std::string& name, std::string_view place) {
  std::string plain = name;
  std::ranges::replace(plain, '\\', '/');
  const fs::path folder = list.parent_path();
  std::error_code code;
  if (const auto inside = resolve_inside(folder, plain, list.string(), place); inside && fs::exists(*inside, code))
    return *inside;
  VAMP_TRY(const fs::path last, resolve_inside(folder, plain.substr(plain.rfind('/') + 1), list.string(), place));
  if (!fs::exists(last, code))
    return fail(ErrorKind::bad_input, list.string(), place, "a picture beside the list", "\"" + name + "\", not there");
  return last;
}

}  // namespace

Result<ImageSet> parse_light_list(std::string_view text, std::string_view file) {
  ImageSet images;
  images.source = file;
  std::vector<dvec3> lights;
  std::vector<double> lengths;
  std::vector<size_t> lines;
  std::optional<size_t> count;
  size_t line_number = 0;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    ++line_number;
    if (line.empty()) continue;
    const std::string place = fmt::format("line {}", line_number);
    if (!count) {
      const auto value = number_of(line);
      if (!value || *value < 1 || *value > static_cast<double>(kMaxBtfDirections) || *value != std::floor(*value))
        return fail(ErrorKind::bad_input, file, place,
                    fmt::format("how many pictures follow, 1 to {}", kMaxBtfDirections),
                    fmt::format("\"{}\"", line.substr(0, 40)));
      count = static_cast<size_t>(*value);
      continue;
    }
    const std::string_view whole = line.substr(0, 80);
    const auto z = number_of(take_last_word(line)), y = number_of(take_last_word(line)),
               x = number_of(take_last_word(line));
    const std::string_view name = trimmed(line);
    if (!x || !y || !z || name.empty())
      return fail(ErrorKind::bad_input, file, place, "a file and three numbers", fmt::format("\"{}\"", whole));
    const double length = std::hypot(*x, *y, *z);
    if (!(*z > kLowestZ * length) || !std::isfinite(length))
      return fail(ErrorKind::bad_input, file, place, "a light in front of the object (z > 0)",
                  fmt::format("{} {} {}", *x, *y, *z));
    if (lights.size() == *count)
      return fail(ErrorKind::bad_input, file, place, fmt::format("the end after {} pictures", *count), "more");
    lights.emplace_back(*x / length, *y / length, *z / length);
    images.files.emplace_back(std::string(name));
    lengths.push_back(length);
    lines.push_back(line_number);
  }
  if (lights.size() != count.value_or(0) || lights.empty())
    return fail(ErrorKind::bad_input, file, "end", fmt::format("{} pictures", count.value_or(1)),
                std::to_string(lights.size()));
  VAMP_CHECK_STATUS(check_lengths(lengths, lines, file));
  images.views = named_direction_set({{0, 0, 1}});
  images.lights = named_direction_set(std::move(lights));
  return images;
}

Result<ImageSet> read_light_list(const fs::path& path) {
  VAMP_TRY(const std::string text, read_text(path, kMaxBytes));
  VAMP_TRY(ImageSet images, parse_light_list(text, path.string()));
  for (size_t i = 0; i < images.files.size(); ++i) {
    VAMP_TRY(images.files[i], file_beside(path, images.files[i].string(), fmt::format("picture {}", i + 1)));
  }
  return images;
}

Status write_light_list(const fs::path& path, std::span<const std::string> files, const DirectionSet& lights) {
  CHECK(files.size() == lights.size());
  std::string text = fmt::format("{}\n", files.size());
  for (size_t i = 0; i < files.size(); ++i) {
    CHECK(files[i].find('\n') == std::string::npos);
    text += fmt::format("{} {} {} {}\n", files[i], lights[i].x, lights[i].y, lights[i].z);
  }
  return write_text_atomically(path, text);
}

}  // namespace vamp
