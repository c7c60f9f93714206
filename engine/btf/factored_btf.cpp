#include "engine/btf/factored_btf.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/btf/bonn_header.h"
#include "engine/btf/btf_checksum.h"

namespace vamp {
namespace {

// What the header leaves open: how many rows and columns the factors of a channel must have.
struct Shape {
  uint64_t rows = 0, columns = 0;
};
struct Shapes {
  Shape normal, transposed;
};

Shapes shapes_of(const BonnHeader& header) {
  const uint64_t directions = uint64_t{header.lights.size()} * header.views.size();
  const uint64_t texels = uint64_t{header.width} * header.height;
  const uint64_t channels = header.kind == BonnKind::fmf ? header.channels.size() : 1;
  return {{channels * directions, texels}, {channels * texels, directions}};
}

std::vector<float> read_scalars(Cursor& cursor, uint64_t count, int scalar_bytes, std::string_view what) {
  const uint64_t start = cursor.at();
  const auto bytes = cursor.take(count * static_cast<uint64_t>(scalar_bytes), what);
  std::vector<float> values(bytes.size() / static_cast<uint64_t>(scalar_bytes));
  for (size_t i = 0; i < values.size(); ++i) {
    const std::byte* at = bytes.data() + i * static_cast<size_t>(scalar_bytes);
    const auto scalar = [at](auto value) {
      std::memcpy(&value, at, sizeof(value));
      return value;
    };
    values[i] = scalar_bytes == 2   ? float_from_half(scalar(Half{}))
                : scalar_bytes == 4 ? scalar(float{})
                                    : static_cast<float>(scalar(double{}));
    if (!std::isfinite(values[i])) {
      const uint64_t place = start + i * static_cast<uint64_t>(scalar_bytes);
      cursor.refuse(place, what, "finite numbers", fmt::format("{}", values[i]));
      return {};
    }
  }
  return values;
}

int read_scalar_bytes(Cursor& cursor) {
  const uint64_t place = cursor.at();
  const int bytes = cursor.number<uint8_t>("bytes of a scalar");
  if (bytes == 2 || bytes == 4 || bytes == 8) return bytes;
  cursor.refuse(place, "bytes of a scalar", "2, 4 or 8", std::to_string(bytes));
  return 4;
}

Factors read_factors(Cursor& cursor, const BonnHeader& header) {
  Factors factors;
  factors.scalar_bytes = read_scalar_bytes(cursor);
  const uint64_t place = cursor.at();
  factors.components = cursor.number<uint32_t>("number of components");
  factors.rows = cursor.number<uint32_t>("rows");
  factors.columns = cursor.number<uint32_t>("columns");
  if (!cursor.status()) return {};
  const auto [normal, transposed] = shapes_of(header);
  const auto has = [&factors](const Shape& shape) {
    return factors.rows == shape.rows && factors.columns == shape.columns;
  };
  if (!has(normal) && !has(transposed)) {
    cursor.refuse(
        place + 4, "rows and columns",
        fmt::format("{} and {}, or {} and {}", normal.rows, normal.columns, transposed.rows, transposed.columns),
        fmt::format("{} and {}", factors.rows, factors.columns));
    return {};
  }
  // In this order nothing overflows: the first two are bounded by the header, the quotient by the file.
  const uint64_t per_component =
      (uint64_t{factors.rows} + factors.columns + 1) * static_cast<uint64_t>(factors.scalar_bytes);
  const uint64_t room = cursor.left() / per_component;
  if (factors.components < 1 || factors.components > room) {
    cursor.refuse(place, "number of components", fmt::format("1 to the {} that the file has room for", room),
                  std::to_string(factors.components));
    return {};
  }
  const uint64_t k = factors.components;
  factors.s = read_scalars(cursor, k, factors.scalar_bytes, "S");
  factors.u = read_scalars(cursor, k * factors.rows, factors.scalar_bytes, "U");
  factors.sxv = read_scalars(cursor, k * factors.columns, factors.scalar_bytes, "SxV");
  factors.scalar_bytes = std::min(factors.scalar_bytes, 4);
  return factors;
}

// What stands between the header and the factors of an FMF file of the newer kind.
void read_fmf_extra(Cursor& cursor, FactoredBtf& btf) {
  const uint64_t place = cursor.at();
  const int version = cursor.number<uint8_t>("version of the FMF header");
  if (version > 2) cursor.refuse(place, "version of the FMF header", "0 to 2", std::to_string(version));
  if (version >= 1 && cursor.number<uint32_t>("dynamic range reduction") != 0) btf.colour.model = ColourModel::log_rgb;
  if (version < 2) return;
  const auto width = cursor.number<uint32_t>("width of the height map");
  const auto height = cursor.number<uint32_t>("height of the height map");
  // At most 2^64 - 2^33: no overflow, but twice of it would.
  const uint64_t texels = uint64_t{width} * height;
  if (texels > cursor.left())
    cursor.refuse(cursor.at(), "height map", fmt::format("{} x {} halfs", width, height), "the end of the file");
  cursor.take(2 * texels, "height map");
}

void read_colour(Cursor& cursor, const BonnHeader& header, FactoredBtf& btf) {
  const uint64_t place = cursor.at();
  const int number = cursor.number<int32_t>("colour model");
  const auto model = colour_model(number);
  if (!model) cursor.refuse(place, "colour model", "0, 1, 3, 4, 5 or 9 to 12", std::to_string(number));
  btf.colour.model = model.value_or(ColourModel::rgb);
  const bool any_count = btf.colour.model == ColourModel::rgb || btf.colour.model == ColourModel::log_rgb ||
                         btf.colour.model == ColourModel::spectral;
  if (!any_count && header.channels.size() != 3)
    cursor.refuse(place, "colour model", fmt::format("one for {} channels", header.channels.size()),
                  name_of(btf.colour.model));
  for (float& mean : btf.colour.mean) mean = cursor.number<float>("mean colour");
  for (float& element : btf.colour.matrix) element = cursor.number<float>("colour matrix");
  const auto finite = [](float value) { return std::isfinite(value); };
  if (!std::ranges::all_of(btf.colour.mean, finite) || !std::ranges::all_of(btf.colour.matrix, finite))
    cursor.refuse(place, "mean colour and matrix", "finite numbers", "others");
}

void write_scalars(ByteWriter& writer, const std::vector<float>& values, int scalar_bytes) {
  if (scalar_bytes == 4) return writer.raw(std::as_bytes(std::span(values)));
  for (const float value : values) writer.number(half_from_float(value));
}

}  // namespace

Result<FactoredBtf> read_factored_btf(std::span<const std::byte> bytes, std::string_view file) {
  Cursor cursor(bytes, file);
  VAMP_TRY(const BonnHeader header, read_bonn_header(cursor));
  if (header.kind != BonnKind::fmf && header.kind != BonnKind::dfmf)
    return fail(ErrorKind::bad_input, file, "byte 0, signature", "an FMF or DFMF file", header.signature);
  FactoredBtf btf;
  btf.info = info_of(header);
  btf.decorrelated = header.kind == BonnKind::dfmf;
  btf.channels = header.channels;
  btf.has_cosine = header.has_cosine;
  if (header.has_rotations) {
    btf.rotation_count = cursor.number<uint32_t>("number of rotations");
    cursor.take(btf.rotation_count * 9 * sizeof(float), "rotations");
  }
  if (header.has_extra) read_fmf_extra(cursor, btf);
  // Each set of factors says its number of components itself; this one is the largest of them.
  cursor.number<uint32_t>("largest number of components");
  if (btf.decorrelated) read_colour(cursor, header, btf);
  const size_t sets = btf.decorrelated ? header.channels.size() : 1;
  for (size_t i = 0; i < sets && cursor.status(); ++i) btf.factors.push_back(read_factors(cursor, header));
  if (cursor.left() > 0)
    cursor.refuse(cursor.at(), "end", "the end of the file", fmt::format("{} bytes", cursor.left()));
  VAMP_CHECK_STATUS(cursor.status());
  VAMP_CHECK_STATUS(check_checksum(bytes, header, file));
  return btf;
}

Result<FactoredBtf> read_factored_btf(const fs::path& path) {
  VAMP_TRY(const MemoryMap map, MemoryMap::open(path, MapAccess::read));
  return read_factored_btf(map.bytes(), path.string());
}

Status write_factored_btf(const fs::path& path, const FactoredBtf& btf) {
  // FMF without a colour model has a field for the logarithm in the newer header only.
  const bool log_fmf = !btf.decorrelated && btf.colour.model == ColourModel::log_rgb;
  BonnHeader header = bonn_header_of(btf.info, btf.decorrelated ? BonnKind::dfmf : BonnKind::fmf);
  if (log_fmf) header.signature = "!FMF12FCER";
  header.channels = btf.channels;
  header.has_cosine = btf.has_cosine;
  ByteWriter writer;
  write_bonn_header(writer, header);
  if (btf.decorrelated || log_fmf) writer.number(uint32_t{0});  // rotations
  if (log_fmf) {
    writer.number(uint8_t{1});
    writer.number(uint32_t{1});
  }
  uint32_t largest = 0;
  for (const Factors& factors : btf.factors) largest = std::max(largest, factors.components);
  writer.number(largest);
  if (btf.decorrelated) {
    writer.number(static_cast<int32_t>(btf.colour.model));
    for (const float mean : btf.colour.mean) writer.number(mean);
    for (const float element : btf.colour.matrix) writer.number(element);
  }
  for (const Factors& factors : btf.factors) {
    writer.number(static_cast<uint8_t>(factors.scalar_bytes));
    writer.number(factors.components);
    writer.number(factors.rows);
    writer.number(factors.columns);
    for (const auto* values : {&factors.s, &factors.u, &factors.sxv})
      write_scalars(writer, *values, factors.scalar_bytes);
  }
  write_checksum(writer.bytes(), header);
  return write_file_atomically(path, writer.bytes());
}

}  // namespace vamp
