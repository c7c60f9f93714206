#include "tests/btf/tiny_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/btf/cursor.h"
#include "engine/btf/image_names.h"
#include "engine/btf/light_list.h"
#include "engine/btf/ptm.h"
#include "engine/image/save.h"
#include "tests/btf/bonn_files.h"

namespace vamp::test {

BtfInfo tiny_info() {
  BtfInfo info;
  info.width = info.height = 2;
  info.views = named_direction_set({direction_of({0, 0}), direction_of({0.9, 2})});
  info.lights = named_direction_set({direction_of({0, 0}), direction_of({0.5, 1}), direction_of({1.1, 4})});
  info.name = "tiny";
  info.provenance = "a test";
  info.mm_per_texel = 0.5f;
  info.synthetic = true;
  return info;
}

FactoredBtf tiny_factors(bool decorrelated, ColourModel model, int scalar_bytes) {
  FactoredBtf btf;
  btf.info = tiny_info();
  btf.decorrelated = decorrelated;
  btf.colour.model = model;
  for (size_t set = 0; set < (decorrelated ? 3u : 1u); ++set) {
    Factors f;
    f.rows = decorrelated ? 6 : 18;
    f.columns = 4;
    f.components = 2;
    f.scalar_bytes = scalar_bytes;
    f.s = {2, 1};
    for (size_t i = 0; i < size_t{f.rows} * 2; ++i) f.u.push_back(0.25f + static_cast<float>(i % 5) / 8);
    for (size_t i = 0; i < size_t{f.columns} * 2; ++i) f.sxv.push_back(0.5f + static_cast<float>(i % 3) / 4);
    btf.factors.push_back(std::move(f));
  }
  return btf;
}

void write_tiny_bdi(const fs::path& folder) {
  Btf btf = Btf::create(folder / "a.btf", tiny_info()).value();
  for (size_t t = 0; t < 4; ++t)
    for (Half& value : btf.writable_texel(t)) value = half_from_float(0.25f * static_cast<float>(t + 1));
}
void write_tiny_dfmf(const fs::path& folder) {
  EXPECT_TRUE(write_factored_btf(folder / "a.btf", tiny_factors(true, ColourModel::log_y_uv_by_y, 2)));
}
void write_tiny_fmf(const fs::path& folder) {
  EXPECT_TRUE(write_factored_btf(folder / "a.btf", tiny_factors(false, ColourModel::log_rgb, 4)));
}
void write_tiny_pictures(const fs::path& folder) {
  Image picture(4, 4, {"R", "G", "B"});
  std::ranges::fill(picture.pixels, 0.5f);
  const BtfInfo info = tiny_info();
  for (const dvec3& view : info.views.directions)
    for (const dvec3& light : info.lights.directions)
      EXPECT_TRUE(save_png(folder / (image_name(light, view) + ".png"), picture));
}
void write_tiny_lights(const fs::path& folder) {
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) names.push_back("p" + std::to_string(i) + ".png");
  for (const std::string& name : names) EXPECT_TRUE(save_png(folder / name, Image(4, 4, {"R", "G", "B"})));
  EXPECT_TRUE(write_light_list(folder / "a.lp", names, tiny_info().lights));
}
void write_tiny_foreign_bdi(const fs::path& folder) { write_foreign_bdi(folder / "a.btf"); }
void write_tiny_foreign_dfmf(const fs::path& folder) { write_foreign_dfmf(folder / "a.btf"); }
void write_tiny_map(const fs::path& folder) {
  Ptm ptm;
  ptm.width = ptm.height = 3;
  ptm.scale.fill(1.5f);
  ptm.bias.fill(100);
  ptm.coefficients.assign(54, 140);
  ptm.colours.assign(27, 200);
  EXPECT_TRUE(write_ptm(folder / "a.ptm", ptm));
}

void write_tiny_rgb_map(const fs::path& folder) {
  Ptm ptm;
  ptm.has_luminance = false;
  ptm.width = ptm.height = 3;
  ptm.scale.fill(1.5f);
  ptm.bias.fill(100);
  ptm.coefficients.assign(162, 140);
  EXPECT_TRUE(write_ptm(folder / "a.ptm", ptm));
}
void write_tiny_alta(const fs::path& folder) {
  std::string text = "#DIM 3 1\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("0.5 {} {} {}\n", -0.9 + 0.09 * i, 0.02 * i, 0.1 * i);
  EXPECT_TRUE(write_text_atomically(folder / "a.dat", text));
}
void write_tiny_sparse(const fs::path& folder) {
  constexpr size_t kPatches = 1600, kAtoms = 2;
  ByteWriter file;
  for (const int size : {10, 10, 151, 151}) file.number(static_cast<uint16_t>(size));
  for (size_t p = 0; p < kPatches; ++p)
    for (size_t a = 0; a < kAtoms; ++a)
      for (const size_t index : {3 + a, p % 10, p % 151, 150 - p % 151}) file.number(static_cast<uint16_t>(index));
  for (size_t p = 0; p < kPatches; ++p) file.number(uint16_t{0});                                // dictionary
  for (size_t p = 0; p < kPatches; ++p) file.number(static_cast<uint16_t>(p % 2 == 0 ? 2 : 1));  // atoms in use
  for (size_t p = 0; p < kPatches; ++p)
    for (size_t a = 0; a < kAtoms; ++a) file.number(half_from_float(0.25f * static_cast<float>(1 + a + p % 7)));
  EXPECT_TRUE(write_file_atomically(folder / "Coeffs_BTF_cloth01_1e-05_U.bin", file.bytes()));
  ByteWriter dictionary;
  for (const size_t size : {size_t{10}, size_t{10}, size_t{151}, size_t{151}})
    for (size_t i = 0; i < size * size; ++i) dictionary.number(half_from_float(i % (size + 1) == 0 ? 1 : 0));
  EXPECT_TRUE(write_file_atomically(folder / "DictEnsOrth4DU.bin", dictionary.bytes()));
  ByteWriter normalisation;
  for (size_t i = 0; i < 22801; ++i) normalisation.number(0.5);
  for (size_t i = 0; i < 22801; ++i) normalisation.number(2.0);
  EXPECT_TRUE(write_file_atomically(folder / "cloth01_mean_std.bin", normalisation.bytes()));
}

}  // namespace vamp::test
