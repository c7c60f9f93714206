#include "engine/btf/btf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

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

}  // namespace
}  // namespace vamp
