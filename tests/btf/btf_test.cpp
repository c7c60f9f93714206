#include "engine/btf/btf.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "engine/btf/load_btf.h"
#include "tests/btf/bonn_files.h"
#include "tests/btf/small_btf.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

TEST(Btf, AFileReadsBackAsItWasWritten) {
  const test::TemporaryFolder folder;
  BtfInfo info = test::small_info();
  info.name = "felt \"05\" & <co>\n";
  info.provenance = "a goniometer";
  info.licence = "CC0";
  info.mm_per_texel = 0.3f;
  info.synthetic = true;
  {
    auto btf = Btf::create(folder / "a.btf", info);
    ASSERT_TRUE(btf) << btf.error().message();
    test::fill(*btf);
  }
  const auto btf = Btf::open(folder / "a.btf");
  ASSERT_TRUE(btf) << btf.error().message();
  EXPECT_EQ(btf->info().name, info.name);
  EXPECT_EQ(btf->info().provenance, info.provenance);
  EXPECT_EQ(btf->info().licence, info.licence);
  EXPECT_EQ(btf->info().mm_per_texel, info.mm_per_texel);
  EXPECT_TRUE(btf->info().synthetic);
  EXPECT_EQ(btf->info().views.name, "ubo81");
  EXPECT_EQ(btf->info().lights.name, "own");
  for (size_t i = 0; i < info.lights.size(); ++i)
    EXPECT_LT(glm::length(btf->info().lights[i] - info.lights[i]), 1e-6) << i;
  ASSERT_EQ(btf->texel_count(), info.texel_count());
  for (size_t t = 0; t < btf->texel_count(); ++t)
    for (size_t v = 0; v < btf->view_count(); ++v)
      for (size_t l = 0; l < btf->light_count(); ++l)
        for (size_t c = 0; c < 3; ++c) ASSERT_EQ(btf->at(t, v, l, c), test::value_at(t, v, l, c));
}

TEST(Btf, FilesOfOthersAreConvertedToTheCosineAndMissingTexelsAreBlack) {
  const test::TemporaryFolder folder;
  test::write_foreign_bdi(folder / "bdi.btf");
  test::write_foreign_dfmf(folder / "dfmf.btf");
  EXPECT_FALSE(Btf::open(folder / "bdi.btf"));
  const Btf bdi = load_btf(folder / "bdi.btf").value(), dfmf = load_btf(folder / "dfmf.btf").value();
  for (size_t t = 0; t < 4; ++t)
    for (size_t v = 0; v < 2; ++v)
      for (size_t l = 0; l < 3; ++l)
        for (size_t c = 0; c < 3; ++c) {
          const float number = static_cast<float>(t) + 0.5f * static_cast<float>(v) + 0.25f * static_cast<float>(l) +
                               0.125f * static_cast<float>(c);
          const float cosine = std::cos(0.5f * static_cast<float>(l));
          EXPECT_NEAR(bdi.at(t, v, l, c), t == 1 ? 0 : number * cosine, 2e-3);
          EXPECT_NEAR(dfmf.at(t, v, l, c), (1.0f + static_cast<float>(t)) * (1 + static_cast<float>(l) / 8) * cosine,
                      3e-3);
        }
}

TEST(Btf, LargeOnesAreFilesWhosePagesCanBeLetGo) {
  const test::TemporaryFolder folder;
  BtfInfo info = test::small_info();
  info.width = info.height = 96;  // 17.9 MB
  auto btf = Btf::create(folder / "a.btf", info);
  ASSERT_TRUE(btf) << btf.error().message();
  for (size_t t = 0; t < btf->texel_count(); ++t) btf->writable_texel(t)[0] = static_cast<Half>(t);
  btf->forget(0, btf->texel_count());
  for (size_t t = 0; t < btf->texel_count(); ++t) ASSERT_EQ(btf->texel(t)[0], static_cast<Half>(t));
}

TEST(Btf, WritingRoundsToHalfsAndCutsOffAtTheirLargest) {
  BtfInfo info = test::small_info();
  Btf btf = Btf::in_memory(info).value();
  std::vector<float> values(btf.values_per_texel(), 1e6f);
  values[1] = -1e6f;
  values[2] = 0.1f;
  btf.write_texel(2, values);
  std::vector<float> read(values.size());
  btf.read_texel(2, read);
  EXPECT_EQ(read[0], 65504);
  EXPECT_EQ(read[1], -65504);
  EXPECT_NEAR(read[2], 0.1f, 4e-5f);
  EXPECT_EQ(btf.at(1, 0, 0, 0), 0);
}

TEST(Btf, APartIsCopiedFromItsPlace) {
  const test::TemporaryFolder folder;
  {
    Btf btf = Btf::create(folder / "a.btf", test::small_info()).value();
    test::fill(btf);
  }
  const auto part = load_btf(folder / "a.btf", {.part = TexelRect{2, 1, 3, 2}, .mm_per_texel = 0.1f, .output = {}});
  ASSERT_TRUE(part) << part.error().message();
  EXPECT_EQ(part->info().mm_per_texel, 0.1f);
  for (size_t y = 0; y < 2; ++y)
    for (size_t x = 0; x < 3; ++x)
      EXPECT_EQ(part->at(y * 3 + x, 40, 2, 1), test::value_at((y + 1) * 5 + x + 2, 40, 2, 1));
  const auto outside = load_btf(folder / "a.btf", {.part = TexelRect{3, 1, 3, 2}, .output = {}});
  ASSERT_FALSE(outside);
  EXPECT_THAT(outside.error().message(), ::testing::HasSubstr("expected a part of 5 x 3, found 3 x 2 from (3, 1)"));
}

}  // namespace
}  // namespace vamp
