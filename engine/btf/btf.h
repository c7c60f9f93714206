#pragma once
// A measured Bidirectional Texture Function: ReflectedCos of every (texel, view, light), out of core where it is larger
// than memory. The one type that all formats are read into and that the goniometer writes (docs/btf.md).
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "engine/core/direction_set.h"
#include "engine/core/half.h"
#include "engine/core/memory_map.h"

namespace vamp {

// What the three values of a sample are.
enum class BtfColour {
  rec709,   // ReflectedCos in linear Rec.709 / D65: f cos(theta_light), the cosine included
  log_yuv,  // Y, U and V of the logarithm of ReflectedCos: signed, no light, so that no lobe fits it
};

inline constexpr uint32_t kMaxBtfSide = 16384;
inline constexpr uint32_t kMaxBtfDirections = 16384;

struct BtfInfo {
  uint32_t width = 0, height = 0;  // texels, 1 to kMaxBtfSide
  DirectionSet views,
      lights;  // 1 to kMaxBtfDirections each; one view is a fixed-view measurement (photographs of a RTI dome)
  float mm_per_texel = 0;  // 0: not known
  BtfColour colour = BtfColour::rec709;
  bool synthetic = false;  // computed, not measured
  std::string name;        // "felt05"
  std::string provenance;  // who measured it, where, with what; or how it was computed
  std::string licence;

  bool in_range() const;
  bool fixed_view() const { return views.size() == 1; }
  size_t texel_count() const { return size_t{width} * height; }
  size_t values_per_texel() const { return views.size() * lights.size() * 3; }
};

// A part of a texture.
struct TexelRect {
  uint32_t x = 0, y = 0, width = 0, height = 0;

  bool inside(const BtfInfo& info) const {
    return width > 0 && height > 0 && uint64_t{x} + width <= info.width && uint64_t{y} + height <= info.height;
  }
};

// "texel (3, 4), view 5, light 6" for messages; direction = view * lights + light.
std::string place_of(const BtfInfo& info, size_t texel, size_t direction);

// Texel-major: the whole ABRDF of a texel is contiguous, a sample is
//   half[((texel * views + view) * lights + light) * 3 + channel],  texel = y * width + x, row 0 at v = 0.
// Lies in a memory map of a Bonn BDI file, or in memory. Move-only. Texels may be read from many threads at once, and
// written from many as long as no two write the same one.
class Btf {
 public:
  // All zero. `info` must be in range (programming error otherwise); failed or io when there is no room.
  static Result<Btf> in_memory(BtfInfo info);
  // A new .btf file of zeros, or an old one replaced, to be filled through writable_texel. It is a whole file from the
  // start: who fills it for long gives it another name until it is full.
  static Result<Btf> create(const fs::path& path, BtfInfo info);
  // A .btf file as create() makes it. bad_input: damaged, or a BTF of another kind (load_btf reads those).
  static Result<Btf> open(const fs::path& path, MapAccess access = MapAccess::read);

  const BtfInfo& info() const { return info_; }
  size_t texel_count() const { return info_.texel_count(); }
  size_t view_count() const { return info_.views.size(); }
  size_t light_count() const { return info_.lights.size(); }
  size_t values_per_texel() const { return values_per_texel_; }

  // The values of one texel: [view][light][channel].
  std::span<const Half> texel(size_t texel) const {
    return {reinterpret_cast<const Half*>(map_.bytes().data() + offset(texel)), values_per_texel_};
  }
  std::span<Half> writable_texel(size_t texel) {
    return {reinterpret_cast<Half*>(map_.writable().data() + offset(texel)), values_per_texel_};
  }
  // The same as floats; `values` has values_per_texel() elements. Writing rounds to the nearest half and cuts off at
  // +-65504; NaN is a programming error.
  void read_texel(size_t texel, std::span<float> values) const;
  void write_texel(size_t texel, std::span<const float> values);

  float at(size_t texel, size_t view, size_t light, size_t channel) const {
    return float_from_half(this->texel(texel)[(view * light_count() + light) * 3 + channel]);
  }

  // What is known only when all values are: replaces the provenance by another one of the same length (of a file that
  // create() made; a different length is a programming error there).
  void set_provenance(std::string provenance);

  // Lets go of the memory that these texels take, so that a pass over a file stays within it: files only, no data are
  // lost, the next look reads them again.
  void forget(size_t first_texel, size_t count) const;
  // Of a file: waits until the disk has everything.
  Status flush() const;

 private:
  // Where texels lie in the map: chunks of whole texels, each behind its size in 4 bytes.
  struct Layout {
    uint64_t first = 0;             // byte of texel 0
    uint64_t texels_per_chunk = 0;  // 4 bytes more in front of each chunk after the first
  };
  Btf(BtfInfo info, MemoryMap map, Layout layout, fs::path path);
  uint64_t offset(size_t texel) const {
    return layout_.first + texel * values_per_texel_ * sizeof(Half) + texel / layout_.texels_per_chunk * 4;
  }

  BtfInfo info_;
  MemoryMap map_;
  Layout layout_;
  fs::path path_;
  size_t values_per_texel_ = 0;
};

}  // namespace vamp
