#pragma once
// Any measured BTF, whatever its format.
#include <optional>
#include <string>

#include "engine/btf/btf.h"
#include "engine/btf/image_folder.h"
#include "engine/core/progress.h"

namespace vamp {

enum class BtfFormat {
  bdi,         // Bonn's unfactored .btf, also ours
  fmf,         // Bonn's factorised .btf
  dfmf,        // the same with a colour model
  images,      // a folder of pictures named after their angles
  light_list,  // .lp: photographs under known lights
  ptm,         // .ptm: a polynomial texture map
  sparse,      // SparseBTF: Coeffs_BTF_NAME_TOLERANCE_U.bin and its neighbours
};
// "Bonn BDI", "photographs under known lights".
std::string name_of(BtfFormat format);

// By the first bytes of a file, of .lp and SparseBTF by its name; a folder is taken for one of pictures. bad_input for
// anything else.
Result<BtfFormat> btf_format(const fs::path& path);

struct LoadBtfOptions {
  PictureCurve curve = PictureCurve::srgb;  // of JPEG and PNG pictures and of polynomial texture maps
  std::optional<TexelRect> part;            // of the texture; bad_input when it does not lie inside
  std::optional<float> mm_per_texel;        // over what the file says, if it says anything
  fs::path output;  // where values go that cannot be used where they lie; empty: memory, from 1 GiB on a file without
                    // a name in the folder for temporary files
};

// A BDI file that can be mapped is mapped unless there is an output, whatever else there is is decoded. Polynomial
// texture maps are shown under the lights of ubo81. bad_input: damaged (file, place, expected, found), or values that
// are not finite.
Result<Btf> load_btf(const fs::path& path, const LoadBtfOptions& options = {}, Progress* progress = nullptr);

// An empty BTF for `info` in the output, memory or a temporary file, as above.
Result<Btf> make_btf(BtfInfo info, const LoadBtfOptions& options);

// Looks at every value: bad_input with the place of the first that is not finite.
Status check_finite(const Btf& btf, std::string_view file, Progress* progress = nullptr);

}  // namespace vamp
