#pragma once
// SparseBTF (Kavoosighafi, Frisvad, Hajisharif, Unger, Miandji 2023): UBO2014 materials as sparse sums of products of
// four dictionaries, in Y, U and V of the logarithm of the reflectance. A material is a few files in one folder:
// Coeffs_BTF_NAME_TOLERANCE_U.bin, DictEnsOrth4DU.bin, the same for Y and V, and NAME_mean_std.bin.
#include <array>
#include <optional>
#include <vector>

#include "engine/btf/factored_btf.h"

namespace vamp {

// value(x, y, light, view) = sum over atoms of a patch: weight * d[0][i][x] d[1][j][y] d[2][k][light] d[3][m][view].
struct SparseChannel {
  struct Atom {
    std::array<uint16_t, 4> index;  // row of each dictionary
    float weight;
  };
  std::array<uint32_t, 4> size{};                       // patch width, patch height, lights, views
  uint32_t atoms_per_patch = 0;                         // room in `atoms`
  std::vector<Atom> atoms;                              // [patch][atom]
  std::vector<uint16_t> atom_count;                     // per patch: those in use
  std::vector<uint16_t> dictionary;                     // per patch: which one
  std::vector<std::array<std::vector<float>, 4>> rows;  // [dictionary][axis]: size x size, a row an atom

  const float* row(size_t dict, size_t axis, size_t atom) const { return rows[dict][axis].data() + atom * size[axis]; }
};

struct SparseBtf {
  BtfInfo info;                                          // 400 x 400 texels, dome151, colour log_yuv
  std::array<std::optional<SparseChannel>, 3> channels;  // Y, U, V; what is missing is 0
  std::vector<float> mean, deviation;                    // [view][light], shared by the channels
};

// `path` is the coefficient file of any channel; the others are looked for beside it. bad_input when one of the files
// that belong together is missing or damaged.
Result<SparseBtf> read_sparse_btf(const fs::path& path);
bool is_sparse_btf_name(const fs::path& path);

// What decode() fills and factored() says: of a part of the texture, which must lie inside it.
BtfInfo info_of(const SparseBtf& sparse, const TexelRect& part);
Status decode(const SparseBtf& sparse, const TexelRect& part, Btf& out, Progress* progress = nullptr);

// The same values as DFMF factors, exact but for the rounding of floats: a component for each pair of light and view
// atoms in use and one for the mean, so that small parts give hundreds. A channel that is missing is one component of
// zeros.
FactoredBtf factored(const SparseBtf& sparse, const TexelRect& part);

}  // namespace vamp
