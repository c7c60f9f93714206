#include "engine/btf/alta.h"

#include <fmt/format.h>

#include <numbers>

#include "engine/btf/text_lines.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxBytes = uint64_t{256} << 20;
constexpr double kLowestCosine = 0.02;
constexpr double kLargestValue = 1e6;

// What the lines that begin with # say.
struct Header {
  size_t channels = 0;
  bool has_input = false, has_output = false, has_viewer_cosine = false;
};

Status read_header_line(std::string_view line, std::string_view file, std::string_view place, Header& header,
                        std::string& name) {
  const auto words = words_of(line);
  const auto wrong = [&](std::string_view expected) {
    return fail(ErrorKind::bad_input, file, place, expected, fmt::format("\"{}\"", line.substr(0, 80)));
  };
  if (words[0] == "#DIM") {
    const bool known = words.size() == 3 && words[1] == "3" && (words[2] == "1" || words[2] == "3");
    if (!known) return wrong("#DIM 3 1 or 3 3: three angles, one or three channels");
    header.channels = words[2] == "1" ? 1 : 3;
  } else if (words[0] == "#PARAM_IN") {
    header.has_input = words.size() == 2 && words[1] == "ISOTROPIC_TL_TV_PROJ_DPHI";
    if (!header.has_input) return wrong("#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI");
  } else if (words[0] == "#PARAM_OUT") {
    header.has_viewer_cosine = words.size() == 2 && words[1] == "INV_STERADIAN_COSINE_FACTOR";
    header.has_output = header.has_viewer_cosine || (words.size() == 2 && words[1] == "INV_STERADIAN");
    if (!header.has_output) return wrong("#PARAM_OUT INV_STERADIAN or INV_STERADIAN_COSINE_FACTOR");
  } else if (words[0] == "#SAMPLE" && line.size() > words[0].size()) {
    name = trimmed(line.substr(words[0].size()));
    std::erase(name, '"');
  }
  return {};
}

// Adds the line's sample, or counts it where it says nothing.
void add_sample(std::span<const double> numbers, const Header& header, BrdfSamples& result) {
  const double theta_view = std::hypot(numbers[1], numbers[2]);
  BrdfSample sample;
  sample.wi = direction_of({numbers[0], 0});
  sample.wo = direction_of({theta_view, std::atan2(numbers[2], numbers[1])});
  if (sample.wi.z < kLowestCosine || sample.wo.z < kLowestCosine) {
    ++result.left_out;
    return;
  }
  const double factor = sample.wi.z / (header.has_viewer_cosine ? sample.wo.z : 1);
  for (size_t c = 0; c < 3; ++c)
    sample.value[c] = static_cast<float>(numbers[header.channels == 1 ? 3 : 3 + c] * factor);
  result.samples.push_back(sample);
}

}  // namespace

Result<BrdfSamples> parse_alta(std::string_view text, std::string_view file) {
  BrdfSamples result;
  Header header;
  std::vector<double> numbers;
  for (size_t line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    const std::string place = fmt::format("line {}", line_number);
    if (line.empty()) continue;
    if (line.front() == '#') {
      VAMP_CHECK_STATUS(read_header_line(line, file, place, header, result.name));
      continue;
    }
    if (header.channels == 0 || !header.has_input || !header.has_output)
      return fail(ErrorKind::bad_input, file, place, "#DIM, #PARAM_IN and #PARAM_OUT before the samples", "a sample");
    numbers.clear();
    for (const std::string_view word : words_of(line))
      if (const auto value = number_of(word)) numbers.push_back(*value);
    const bool sound = numbers.size() == 3 + header.channels && words_of(line).size() == numbers.size();
    if (!sound || numbers[0] < 0 || numbers[0] > std::numbers::pi / 2 + 1e-6 ||
        std::hypot(numbers[1], numbers[2]) > std::numbers::pi)
      return fail(ErrorKind::bad_input, file, place,
                  fmt::format("three angles in radians and {} values", header.channels),
                  fmt::format("\"{}\"", line.substr(0, 80)));
    for (size_t i = 3; i < numbers.size(); ++i)
      if (std::abs(numbers[i]) > kLargestValue)
        return fail(ErrorKind::bad_input, file, place, fmt::format("values up to {}", kLargestValue),
                    fmt::format("{}", numbers[i]));
    add_sample(numbers, header, result);
  }
  if (result.samples.empty()) return fail(ErrorKind::bad_input, file, "", "samples above the horizon", "none");
  return result;
}

Result<BrdfSamples> read_alta(const fs::path& path) {
  VAMP_TRY(const std::string text, read_text(path, kMaxBytes));
  return parse_alta(text, path.string());
}

}  // namespace vamp
