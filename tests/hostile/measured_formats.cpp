#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/btf/alta.h"
#include "engine/btf/btf_summary.h"
#include "engine/btf/cursor.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/ptm.h"
#include "engine/core/hash.h"
#include "tests/btf/tiny_files.h"
#include "tests/hostile/format.h"

namespace vamp::test {
namespace {

std::string text_of(const BtfInfo& info) {
  std::string text = fmt::format("{} {} {} {} {} {}", info.width, info.height, info.mm_per_texel, info.synthetic,
                                 info.name, info.provenance);
  for (const DirectionSet* set : {&info.views, &info.lights})
    for (const dvec3& w : set->directions) text += fmt::format(" {} {} {}", w.x, w.y, w.z);
  return text;
}

std::string unsound(const Btf& btf) {
  const BtfInfo& info = btf.info();
  if (!info.in_range()) return "sizes out of range";
  for (const DirectionSet* set : {&info.views, &info.lights})
    for (const dvec3& w : set->directions)
      if (!(std::abs(glm::length(w) - 1) < 1e-6 && w.z >= 0)) return "a direction below the plane";
  const Status finite = check_finite(btf, "values");
  return finite ? "" : finite.error().message();
}

// Sealed: a checksum covers all that is not a value.
template <bool kSealed>
Result<Loaded> load(const fs::path& file, const LoadBtfOptions& options = {}) {
  VAMP_TRY(const Btf btf, load_btf(file, options));
  Loaded loaded{unsound(btf), kSealed ? text_of(btf.info()) : ""};
  if (!summary_of(file)) loaded.unsound = "it can be loaded but not described";
  return loaded;
}

Result<Loaded> load_sealed(const fs::path& folder) { return load<true>(folder / "a.btf"); }
Result<Loaded> load_unsealed(const fs::path& folder) { return load<false>(folder / "a.btf"); }

// Of factors the values are covered too.
Result<Loaded> load_factors(const fs::path& folder) {
  VAMP_TRY(Loaded loaded, load_sealed(folder));
  VAMP_TRY(const Btf btf, load_btf(folder / "a.btf"));
  for (size_t t = 0; t < btf.texel_count(); ++t)
    loaded.fingerprint += fmt::format(" {:x}", hash64(std::as_bytes(btf.texel(t))));
  return loaded;
}

Result<Loaded> load_map(const fs::path& folder) {
  VAMP_TRY(Loaded loaded, load<false>(folder / "a.ptm"));
  VAMP_TRY(const Ptm ptm, read_ptm(folder / "a.ptm"));
  if (ptm.coefficients.size() % (6 * ptm.texel_count()) != 0) loaded.unsound = "other coefficients than texels";
  return loaded;
}

Result<Loaded> load_sparse(const fs::path& folder) {
  LoadBtfOptions options;
  options.part = TexelRect{397, 398, 2, 2};
  return load<false>(folder / "Coeffs_BTF_cloth01_1e-05_U.bin", options);
}

Result<Loaded> load_alta(const fs::path& folder) {
  VAMP_TRY(const BrdfSamples samples, read_alta(folder / "a.dat"));
  for (const BrdfSample& sample : samples.samples)
    if (!(std::isfinite(sample.value[0]) && sample.wi.z > 0 && sample.wo.z > 0)) return Loaded{"a wild sample", ""};
  return Loaded{};
}

}  // namespace

std::vector<Format> measured_formats() {
  return {
      {"Bdi", "a.btf", write_tiny_bdi, load_sealed},
      {"Dfmf", "a.btf", write_tiny_dfmf, load_factors},
      {"Fmf", "a.btf", write_tiny_fmf, load_factors},
      {"ForeignBdi", "a.btf", write_tiny_foreign_bdi, load_unsealed},
      {"ForeignDfmf", "a.btf", write_tiny_foreign_dfmf, load_unsealed},
      {"PictureFolder", "tl000_pl000_tv000_pv000.png", write_tiny_pictures,
       [](const fs::path& folder) { return load<false>(folder); }},
      {"LightList", "a.lp", write_tiny_lights, [](const fs::path& folder) { return load<false>(folder / "a.lp"); }},
      {"PtmLrgb", "a.ptm", write_tiny_map, load_map},
      {"PtmRgb", "a.ptm", write_tiny_rgb_map, load_map},
      {"SparseCoefficients", "Coeffs_BTF_cloth01_1e-05_U.bin", write_tiny_sparse, load_sparse},
      {"SparseDictionary", "DictEnsOrth4DU.bin", write_tiny_sparse, load_sparse},
      {"SparseNormalisation", "cloth01_mean_std.bin", write_tiny_sparse, load_sparse},
      {"Alta", "a.dat", write_tiny_alta, load_alta},
  };
}

}  // namespace vamp::test
