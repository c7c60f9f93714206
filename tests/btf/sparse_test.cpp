// SparseBTF from files that are made here: dictionaries of unit vectors, so that every value is known.
#include <gmock/gmock.h>

#include <cstring>
#include <random>

#include "engine/btf/alta.h"
#include "engine/btf/cursor.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/sparse_btf.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

constexpr size_t kPatches = 1600, kAtoms = 2;

// Atom a of patch p: row 3 + a of the first dictionary, row p % 10 of the second, light p % 151, view 150 - p % 151.
float weight_of(size_t patch, size_t atom) {
  return 0.25f * static_cast<float>(1 + atom) + static_cast<float>(patch % 7);
}

void write_material(const fs::path& folder, char channel) {
  ByteWriter file;
  for (const int size : {10, 10, 151, 151}) file.number(static_cast<uint16_t>(size));
  for (size_t p = 0; p < kPatches; ++p)
    for (size_t a = 0; a < kAtoms; ++a)
      for (const size_t index : {3 + a, p % 10, p % 151, 150 - p % 151}) file.number(static_cast<uint16_t>(index));
  for (size_t p = 0; p < kPatches; ++p) file.number(uint16_t{0});                                // dictionary
  for (size_t p = 0; p < kPatches; ++p) file.number(static_cast<uint16_t>(p % 2 == 0 ? 2 : 1));  // atoms in use
  for (size_t p = 0; p < kPatches; ++p)
    for (size_t a = 0; a < kAtoms; ++a) file.number(half_from_float(weight_of(p, a)));
  EXPECT_TRUE(
      write_file_atomically(folder / (std::string("Coeffs_BTF_cloth01_1e-05_") + channel + ".bin"), file.bytes()));
  ByteWriter dictionary;
  for (const size_t size : {size_t{10}, size_t{10}, size_t{151}, size_t{151}})
    for (size_t i = 0; i < size * size; ++i) dictionary.number(half_from_float(i % (size + 1) == 0 ? 1 : 0));
  EXPECT_TRUE(write_file_atomically(folder / (std::string("DictEnsOrth4D") + channel + ".bin"), dictionary.bytes()));
  ByteWriter normalisation;
  for (size_t i = 0; i < 22801; ++i) normalisation.number(0.5);
  for (size_t i = 0; i < 22801; ++i) normalisation.number(2.0);
  EXPECT_TRUE(write_file_atomically(folder / "cloth01_mean_std.bin", normalisation.bytes()));
}

class Sparse : public ::testing::Test {
 protected:
  Sparse() {
    write_material(folder_.path(), 'U');
    write_material(folder_.path(), 'V');
  }
  test::TemporaryFolder folder_;
  fs::path coefficients_ = folder_ / "Coeffs_BTF_cloth01_1e-05_U.bin";
};

TEST_F(Sparse, EveryValueIsTheSumOfItsAtoms) {
  // Patches 43 and 44: (30 .. 49, 10 .. 19).
  const TexelRect part{30, 10, 20, 10};
  const auto btf = load_btf(coefficients_, {.part = part, .output = {}});
  ASSERT_TRUE(btf) << btf.error().message();
  EXPECT_EQ(btf->info().name, "cloth01");
  EXPECT_EQ(btf->info().colour, BtfColour::log_yuv);
  size_t set = 0;
  for (size_t t = 0; t < btf->texel_count(); ++t) {
    const size_t x = t % 20, y = t / 20, patch = 43 + x / 10;
    for (size_t v = 0; v < 151; ++v)
      for (size_t l = 0; l < 151; ++l) {
        float expected = 0.5f;
        for (size_t a = 0; a < (patch % 2 == 0 ? 2u : 1u); ++a)
          if (x % 10 == 3 + a && y == patch % 10 && l == patch % 151 && v == 150 - patch % 151)
            expected += 2 * weight_of(patch, a);
        set += expected != 0.5f;
        ASSERT_EQ(btf->at(t, v, l, 0), 0);
        ASSERT_EQ(btf->at(t, v, l, 1), expected) << t << " " << v << " " << l;
        ASSERT_EQ(btf->at(t, v, l, 2), expected);
      }
  }
  EXPECT_EQ(set, 3u);
}

TEST_F(Sparse, FactorsSayTheSame) {
  const auto sparse = read_sparse_btf(coefficients_);
  ASSERT_TRUE(sparse) << sparse.error().message();
  const TexelRect part{30, 10, 20, 10};
  Btf direct = Btf::in_memory(info_of(*sparse, part)).value(), product = Btf::in_memory(info_of(*sparse, part)).value();
  ASSERT_TRUE(decode(*sparse, part, direct));
  ASSERT_TRUE(decode(factored(*sparse, part), product, "test"));
  for (size_t t = 0; t < direct.texel_count(); ++t)
    ASSERT_TRUE(std::ranges::equal(direct.texel(t), product.texel(t))) << t;
}

TEST_F(Sparse, FilesThatBelongToItMustBeThere) {
  fs::remove(folder_ / "DictEnsOrth4DV.bin");
  EXPECT_THAT(read_sparse_btf(coefficients_).error().message(),
              ::testing::HasSubstr("DictEnsOrth4DV.bin: expected a file"));
  fs::remove(folder_ / "Coeffs_BTF_cloth01_1e-05_V.bin");
  const auto sparse = read_sparse_btf(coefficients_);
  ASSERT_TRUE(sparse);
  EXPECT_THAT(sparse->info.provenance, ::testing::HasSubstr("channel Y, V absent"));
}

TEST_F(Sparse, DamageEndsInAnErrorOrInFiniteValues) {
  const auto sound = read_file(coefficients_, 1 << 20).value();
  std::mt19937 random(23);
  for (int i = 0; i < 150; ++i) {
    auto bytes = sound;
    // The sizes and the small numbers are where damage may do harm.
    const size_t reach = i % 3 == 0 ? 8 : bytes.size();
    for (int k = 0; k < 1 + i % 40; ++k) bytes[random() % reach] = static_cast<std::byte>(random());
    if (i % 10 == 0) bytes.resize(random() % bytes.size());
    ASSERT_TRUE(write_file_atomically(coefficients_, bytes));
    const auto btf = load_btf(coefficients_, {.part = TexelRect{395, 395, 5, 5}, .output = {}});
    if (btf) {
      EXPECT_TRUE(check_finite(*btf, "values"));
    } else {
      EXPECT_EQ(btf.error().kind, ErrorKind::bad_input) << btf.error().message();
      EXPECT_EQ(btf.error().message().find('\n'), std::string::npos);
    }
  }
}

TEST(AltaHostile, DamageEndsInAnErrorOrInFiniteSamples) {
  std::string sound = "#DIM 3 1\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n";
  for (int i = 0; i < 20; ++i) sound += fmt::format("0.5 {} {} {}\n", -0.9 + 0.09 * i, 0.02 * i, 0.1 * i);
  std::mt19937 random(29);
  for (int i = 0; i < 3000; ++i) {
    std::string text = sound;
    for (int k = 0; k < 1 + i % 4; ++k) text[random() % text.size()] = static_cast<char>(random());
    if (i % 10 == 0) text.resize(random() % text.size());
    const auto samples = parse_alta(text, "a.dat");
    if (!samples) {
      EXPECT_EQ(samples.error().message().find('\n'), std::string::npos);
      continue;
    }
    for (const BrdfSample& sample : samples->samples)
      EXPECT_TRUE(std::isfinite(sample.value[0]) && sample.wi.z > 0 && sample.wo.z > 0);
  }
}

}  // namespace
}  // namespace vamp
