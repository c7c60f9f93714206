#include "engine/btf/btf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/core/check.h"

namespace vamp {

bool BtfInfo::in_range() const {
  const auto inside = [](uint64_t count, uint64_t most) { return count >= 1 && count <= most; };
  return inside(width, kMaxBtfSide) && inside(height, kMaxBtfSide) && inside(views.size(), kMaxBtfDirections) &&
         inside(lights.size(), kMaxBtfDirections);
}

std::string place_of(const BtfInfo& info, size_t texel, size_t direction) {
  const size_t lights = info.lights.size();
  return fmt::format("texel ({}, {}), view {}, light {}", texel % info.width, texel / info.width, direction / lights,
                     direction % lights);
}

Btf::Btf(BtfInfo info, MemoryMap map, Layout layout, fs::path path)
    : info_(std::move(info)),
      map_(std::move(map)),
      layout_(layout),
      path_(std::move(path)),
      values_per_texel_(info_.values_per_texel()) {}

Result<Btf> Btf::in_memory(BtfInfo info) {
  CHECK(info.in_range());
  const uint64_t bytes = uint64_t{info.texel_count()} * info.values_per_texel() * sizeof(Half);
  VAMP_TRY(MemoryMap map, MemoryMap::in_memory(bytes));
  const Layout one_chunk{0, std::numeric_limits<uint64_t>::max()};
  return Btf(std::move(info), std::move(map), one_chunk, {});
}

void Btf::read_texel(size_t texel, std::span<float> values) const {
  const auto halfs = this->texel(texel);
  CHECK(values.size() == halfs.size());
  std::ranges::transform(halfs, values.begin(), float_from_half);
}

void Btf::write_texel(size_t texel, std::span<const float> values) {
  const auto halfs = writable_texel(texel);
  CHECK(values.size() == halfs.size());
  std::ranges::transform(values, halfs.begin(), [](float value) {
    CHECK(!std::isnan(value));
    return half_from_float(std::clamp(value, -kHalfMax, kHalfMax));
  });
}

void Btf::forget(size_t first_texel, size_t count) const {
  const uint64_t first = offset(first_texel);
  map_.forget(first, offset(first_texel + count) - first);
}

Status Btf::flush() const { return map_.flush(path_); }

}  // namespace vamp
