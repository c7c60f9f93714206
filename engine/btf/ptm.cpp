#include "engine/btf/ptm.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "engine/btf/cursor.h"
#include "engine/btf/picture_curve.h"
#include "engine/btf/ptm_basis.h"

namespace vamp {
namespace {

constexpr size_t kTerms = 6;
// Bytes less a bias stay inside an int.
constexpr int kMaxBias = 1'000'000'000;

// The words of the header; the numbers stand in any arrangement of lines.
class HeaderWords {
 public:
  explicit HeaderWords(Cursor& cursor) : cursor_(cursor) {}

  std::string word(std::string_view what) {
    std::string text;
    while (cursor_.status()) {
      if (cursor_.left() == 0 && !text.empty()) break;
      last_ = std::to_integer<char>(cursor_.number<std::byte>(what));
      const bool blank = last_ == ' ' || last_ == '\n' || last_ == '\r' || last_ == '\t';
      if (blank && !text.empty()) break;
      if (!blank) text += last_;
      if (text.size() > 40) cursor_.refuse(cursor_.at(), what, "a short word", "\"" + text + "\"");
    }
    return text;
  }

  template <class T>
  T number(std::string_view what) {
    const uint64_t place = cursor_.at();
    const std::string text = word(what);
    T value{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (cursor_.status() && (code != std::errc() || end != text.data() + text.size()))
      cursor_.refuse(place, what, "a number", "\"" + text + "\"");
    return value;
  }

  uint32_t side(std::string_view what) {
    const uint64_t place = cursor_.at();
    const auto value = number<uint32_t>(what);
    if (value < 1 || value > kMaxBtfSide)
      cursor_.refuse(place, what, fmt::format("1 to {}", kMaxBtfSide), std::to_string(value));
    return value;
  }

  // The pixels begin behind the line of the last word.
  void end_of_line() {
    while (cursor_.status() && last_ != '\n') last_ = std::to_integer<char>(cursor_.number<std::byte>("end of a line"));
  }

 private:
  Cursor& cursor_;
  char last_ = 0;
};

// Rows of `bytes` in the opposite order.
std::vector<uint8_t> turned(std::span<const std::byte> bytes, size_t row) {
  std::vector<uint8_t> result;
  result.reserve(bytes.size());
  for (size_t end = bytes.size(); end >= row && row > 0; end -= row)
    for (const std::byte b : bytes.subspan(end - row, row)) result.push_back(std::to_integer<uint8_t>(b));
  return result;
}

}  // namespace

double Ptm::value(size_t texel, size_t channel, const dvec3& light) const {
  const std::array<double, 6> basis = ptm_basis(light);
  const size_t plane = has_luminance ? 0 : channel * texel_count();
  double sum = 0;
  for (size_t k = 0; k < kTerms; ++k)
    sum += basis[k] * (coefficients[(plane + texel) * kTerms + k] - bias[k]) * double{scale[k]};
  return has_luminance ? sum * colours[texel * 3 + channel] / 255 : sum;
}

Result<Ptm> read_ptm(std::span<const std::byte> bytes, std::string_view file) {
  Cursor cursor(bytes, file);
  HeaderWords words(cursor);
  if (const std::string version = words.word("version"); cursor.status() && version != "PTM_1.2")
    return fail(ErrorKind::bad_input, file, "byte 0, version", "PTM_1.2", "\"" + version + "\"");
  const uint64_t place = cursor.at();
  const std::string format = words.word("format");
  if (cursor.status() && format != "PTM_FORMAT_LRGB" && format != "PTM_FORMAT_RGB")
    cursor.refuse(place, "format", "PTM_FORMAT_LRGB or PTM_FORMAT_RGB", "\"" + format + "\"");
  Ptm ptm;
  ptm.has_luminance = format == "PTM_FORMAT_LRGB";
  ptm.width = words.side("width");
  ptm.height = words.side("height");
  for (float& scale : ptm.scale) {
    const uint64_t at = cursor.at();
    scale = words.number<float>("scale");
    if (!std::isfinite(scale)) cursor.refuse(at, "scale", "a finite number", fmt::format("{}", scale));
  }
  for (int& bias : ptm.bias) {
    const uint64_t at = cursor.at();
    bias = words.number<int>("bias");
    if (std::abs(int64_t{bias}) > kMaxBias)
      cursor.refuse(at, "bias", fmt::format("at most {}", kMaxBias), std::to_string(bias));
  }
  words.end_of_line();
  VAMP_CHECK_STATUS(cursor.status());

  const size_t row = size_t{ptm.width} * kTerms, plane = row * ptm.height;
  for (size_t i = 0; i < (ptm.has_luminance ? 1u : 3u); ++i) {
    const auto rows = turned(cursor.take(plane, "coefficients"), row);
    ptm.coefficients.insert(ptm.coefficients.end(), rows.begin(), rows.end());
  }
  if (ptm.has_luminance) ptm.colours = turned(cursor.take(plane / 2, "colours"), row / 2);
  if (cursor.left() > 0)
    cursor.refuse(cursor.at(), "end", "the end of the file", fmt::format("{} bytes", cursor.left()));
  VAMP_CHECK_STATUS(cursor.status());
  return ptm;
}

Result<Ptm> read_ptm(const fs::path& path) {
  VAMP_TRY(const MemoryMap map, MemoryMap::open(path, MapAccess::read));
  return read_ptm(map.bytes(), path.string());
}

Status write_ptm(const fs::path& path, const Ptm& ptm) {
  ByteWriter writer;
  writer.text(fmt::format("PTM_1.2\nPTM_FORMAT_{}\n{}\n{}\n{}\n{}\n", ptm.has_luminance ? "LRGB" : "RGB", ptm.width,
                          ptm.height, fmt::join(ptm.scale, " "), fmt::join(ptm.bias, " ")));
  const size_t row = size_t{ptm.width} * kTerms, plane = row * ptm.height;
  const auto coefficients = std::as_bytes(std::span(ptm.coefficients));
  for (size_t at = 0; at < coefficients.size(); at += plane)
    writer.raw(std::as_bytes(std::span<const uint8_t>(turned(coefficients.subspan(at, plane), row))));
  writer.raw(std::as_bytes(std::span<const uint8_t>(turned(std::as_bytes(std::span(ptm.colours)), row / 2))));
  return write_file_atomically(path, writer.bytes());
}

BtfInfo info_of(const Ptm& ptm, DirectionSet lights) {
  BtfInfo info;
  info.width = ptm.width;
  info.height = ptm.height;
  info.views = named_direction_set({{0, 0, 1}});
  info.lights = std::move(lights);
  info.provenance = "a polynomial texture map";
  return info;
}

void decode(const Ptm& ptm, Btf& out, PictureCurve curve) {
  std::vector<float> values(out.values_per_texel());
  for (size_t t = 0; t < ptm.texel_count(); ++t) {
    for (size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<float>(light_of(ptm.value(t, i % 3, out.info().lights[i / 3]) / 255, curve));
    out.write_texel(t, values);
  }
}

}  // namespace vamp
