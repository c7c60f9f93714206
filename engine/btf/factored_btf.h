#pragma once
// BTFs that are stored as products of two small matrices: Bonn's full matrix factorisation (FMF; Koudelka et al. 2003)
// and decorrelated full matrix factorisation (DFMF; Mueller 2009), in which each channel of a colour model has its own.
#include <span>
#include <string>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/btf/colour_model.h"
#include "engine/core/progress.h"

namespace vamp {

// value(row, column) = sum_k u[row * components + k] * sxv[column * components + k]; s is already inside sxv.
struct Factors {
  uint32_t rows = 0, columns = 0, components = 0;
  std::vector<float> s;    // components
  std::vector<float> u;    // rows x components
  std::vector<float> sxv;  // columns x components
  int scalar_bytes = 4;    // in files: 2 (half) or 4; doubles are read as floats
};

// One set of factors for all channels (FMF) or one a channel (DFMF). Rows are
//   FMF   channel + channels * (light + lights * view)      columns: texels, x fastest
//   DFMF  light + lights * view
// or, transposed, FMF rows are channel + channels * texel, DFMF rows texels, and columns light + lights * view.
struct FactoredBtf {
  BtfInfo info;
  bool decorrelated = true;  // DFMF
  std::vector<Factors> factors;
  std::vector<std::string> channels{"R", "G", "B"};
  ColourTransform colour;     // DFMF; for FMF rgb, or log_rgb where the dynamic range is reduced
  bool has_cosine = true;     // else the values are f, to be multiplied with the cosine of the light
  size_t rotation_count = 0;  // of local frames that the file lists; they are not applied

  size_t direction_count() const { return info.views.size() * info.lights.size(); }
};

// bad_input: no FMF or DFMF file, damaged, values that are not finite, a colour model that is not read.
Result<FactoredBtf> read_factored_btf(const fs::path& path);
Result<FactoredBtf> read_factored_btf(std::span<const std::byte> bytes, std::string_view file);

// The factors as they are: reading the file gives the same bits. Rotations are not written. io when writing fails.
Status write_factored_btf(const fs::path& path, const FactoredBtf& btf);

// Multiplies out into a BTF of the same size and directions, in linear Rec.709 with the cosine; of log_yuv the three
// channels as they are. Works through the texels in blocks and gives their memory back, so that a file may be larger
// than memory. bad_input (`file` names the source) when a value is not finite; cancelled when `progress` says so.
Status decode(const FactoredBtf& factored, Btf& out, std::string_view file, Progress* progress = nullptr);

}  // namespace vamp
