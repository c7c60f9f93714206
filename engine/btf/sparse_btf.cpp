#include "engine/btf/sparse_btf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/btf/cursor.h"

namespace vamp {
namespace {

// The files do not say how large the texture is: all of UBO2014 is.
constexpr uint32_t kSide = 400;
constexpr uint32_t kDirections = 151;
constexpr double kLargestDeviation = 1e6;
constexpr uint64_t kMaxBytes = uint64_t{1} << 30;
constexpr std::string_view kPrefix = "Coeffs_BTF_";
constexpr char kChannels[] = {'Y', 'U', 'V'};

std::vector<float> read_halfs(Cursor& cursor, uint64_t count, std::string_view what) {
  const uint64_t start = cursor.at();
  const auto bytes = cursor.take(count * sizeof(Half), what);
  std::vector<float> values(bytes.size() / sizeof(Half));
  for (size_t i = 0; i < values.size(); ++i) {
    Half half;
    std::memcpy(&half, bytes.data() + i * sizeof(half), sizeof(half));
    values[i] = float_from_half(half);
    if (!std::isfinite(values[i]))
      cursor.refuse(start + i * sizeof(half), what, "finite numbers", fmt::format("{}", values[i]));
  }
  return values;
}

// A number for each patch, below `limit`.
std::vector<uint16_t> read_per_patch(Cursor& cursor, size_t patches, uint32_t limit, std::string_view what) {
  std::vector<uint16_t> values(patches);
  for (uint16_t& value : values) {
    const uint64_t place = cursor.at();
    value = cursor.number<uint16_t>(what);
    if (value >= limit) cursor.refuse(place, what, fmt::format("below {}", limit), std::to_string(value));
  }
  return values;
}

Status read_dictionaries(const fs::path& path, SparseChannel& channel) {
  VAMP_TRY(const auto bytes, read_file(path, kMaxBytes));
  Cursor cursor(bytes, path.string());
  uint64_t each = 0;
  for (const uint32_t size : channel.size) each += uint64_t{size} * size;
  const uint64_t count = bytes.size() / (each * sizeof(Half));
  if (count < 1 || bytes.size() != count * each * sizeof(Half))
    return fail(ErrorKind::bad_input, path.string(), "size", fmt::format("a multiple of {} bytes", each * sizeof(Half)),
                std::to_string(bytes.size()));
  channel.rows.resize(count);
  for (size_t axis = 0; axis < 4; ++axis)
    for (auto& dictionary : channel.rows)
      dictionary[axis] = read_halfs(cursor, uint64_t{channel.size[axis]} * channel.size[axis], "dictionary");
  return cursor.status();
}

Result<SparseChannel> read_channel(const fs::path& path, const fs::path& dictionary) {
  VAMP_TRY(const auto bytes, read_file(path, kMaxBytes));
  Cursor cursor(bytes, path.string());
  SparseChannel channel;
  for (uint32_t& size : channel.size) size = cursor.number<uint16_t>("size");
  const auto& [width, height, lights, views] = channel.size;
  VAMP_CHECK_STATUS(cursor.status());
  if (width == 0 || height == 0 || kSide % width != 0 || kSide % height != 0 || lights != kDirections ||
      views != kDirections)
    return fail(ErrorKind::bad_input, path.string(), "byte 0, sizes",
                fmt::format("patches that divide {0} x {0} texels, {1} lights, {1} views", kSide, kDirections),
                fmt::format("{}", fmt::join(channel.size, " ")));
  VAMP_CHECK_STATUS(read_dictionaries(dictionary, channel));

  // Per patch: two counts, and for each atom four indices and a weight.
  const size_t patches = size_t{kSide / width} * (kSide / height);
  const uint64_t per_patch = cursor.left() / sizeof(uint16_t) / patches;
  channel.atoms_per_patch = static_cast<uint32_t>(per_patch < 2 ? 0 : (per_patch - 2) / 5);
  if (channel.atoms_per_patch == 0 || cursor.left() != patches * (2 + 5 * uint64_t{channel.atoms_per_patch}) * 2)
    return fail(ErrorKind::bad_input, path.string(), "size",
                fmt::format("{} patches of a whole number of atoms", patches), fmt::format("{} bytes", bytes.size()));
  channel.atoms.resize(patches * channel.atoms_per_patch);
  for (auto& atom : channel.atoms)
    for (size_t axis = 0; axis < 4; ++axis) {
      const uint64_t place = cursor.at();
      atom.index[axis] = cursor.number<uint16_t>("index of an atom");
      if (atom.index[axis] >= channel.size[axis])
        cursor.refuse(place, "index of an atom", fmt::format("below {}", channel.size[axis]),
                      std::to_string(atom.index[axis]));
    }
  channel.dictionary =
      read_per_patch(cursor, patches, static_cast<uint32_t>(channel.rows.size()), "number of the dictionary");
  channel.atom_count = read_per_patch(cursor, patches, channel.atoms_per_patch + 1, "number of atoms");
  const auto weights = read_halfs(cursor, channel.atoms.size(), "weight");
  for (size_t i = 0; i < weights.size(); ++i) channel.atoms[i].weight = weights[i];
  VAMP_CHECK_STATUS(cursor.status());
  return channel;
}

Result<std::vector<float>> read_mean_deviation(const fs::path& path) {
  VAMP_TRY(const auto bytes, read_file(path, kMaxBytes));
  Cursor cursor(bytes, path.string());
  const size_t count = size_t{2} * kDirections * kDirections;
  if (bytes.size() != count * sizeof(double))
    return fail(ErrorKind::bad_input, path.string(), "size", fmt::format("{} bytes", count * sizeof(double)),
                std::to_string(bytes.size()));
  std::vector<float> values(count);
  for (float& value : values) {
    const uint64_t place = cursor.at();
    const auto exact = cursor.number<double>("mean or deviation");
    if (!(std::abs(exact) <= kLargestDeviation))
      cursor.refuse(place, "mean or deviation", "a finite number", fmt::format("{}", exact));
    value = static_cast<float>(exact);
  }
  VAMP_CHECK_STATUS(cursor.status());
  return values;
}

}  // namespace

bool is_sparse_btf_name(const fs::path& path) {
  const std::string stem = path.stem().string();
  return path.extension() == ".bin" && stem.starts_with(kPrefix) && stem.size() > kPrefix.size() + 3 &&
         std::ranges::find(kChannels, stem.back()) != std::end(kChannels);
}

Result<SparseBtf> read_sparse_btf(const fs::path& path) {
  if (!is_sparse_btf_name(path))
    return fail(ErrorKind::bad_input, path.string(), "name", "Coeffs_BTF_NAME_TOLERANCE_U.bin (or Y, V)", "another");
  const std::string stem = path.stem().string();
  const std::string shared = stem.substr(0, stem.size() - 1);  // with the underline
  const std::string tail = shared.substr(kPrefix.size());      // NAME_TOLERANCE_
  const std::string name = tail.substr(0, tail.find('_'));
  const fs::path folder = path.parent_path();

  SparseBtf sparse;
  std::string missing;
  for (size_t i = 0; i < 3; ++i) {
    const fs::path coefficients = folder / (shared + kChannels[i] + ".bin");
    std::error_code code;
    if (!fs::exists(coefficients, code)) {
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", kChannels[i]);
      continue;
    }
    VAMP_TRY(sparse.channels[i], read_channel(coefficients, folder / fmt::format("DictEnsOrth4D{}.bin", kChannels[i])));
    for (const auto& other : sparse.channels)
      if (other && other->size != sparse.channels[i]->size)
        return fail(ErrorKind::bad_input, coefficients.string(), "byte 0, sizes",
                    fmt::format("{}, as in the other channels", fmt::join(other->size, " ")),
                    fmt::format("{}", fmt::join(sparse.channels[i]->size, " ")));
  }
  VAMP_TRY(sparse.mean, read_mean_deviation(folder / (name + "_mean_std.bin")));
  const auto half = sparse.mean.begin() + kDirections * kDirections;
  sparse.deviation.assign(half, sparse.mean.end());
  sparse.mean.erase(half, sparse.mean.end());

  sparse.info.width = sparse.info.height = kSide;
  sparse.info.views = sparse.info.lights = dome151();
  sparse.info.colour = BtfColour::log_yuv;
  sparse.info.name = name;
  sparse.info.provenance = "UBO2014, University of Bonn, sparse-coded (SparseBTF)";
  if (!missing.empty()) sparse.info.provenance += "; channel " + missing + " absent, filled with zeros";
  return sparse;
}

BtfInfo info_of(const SparseBtf& sparse, const TexelRect& part) {
  BtfInfo info = sparse.info;
  info.width = part.width;
  info.height = part.height;
  return info;
}

}  // namespace vamp
