#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

TEST(ValidateSpmm, AcceptsTheSmallMaterialAndOneWithoutAResidual) {
  Spmm spmm = test::small_spmm();
  EXPECT_TRUE(validate(spmm, "f"));
  spmm.residual = {};
  EXPECT_TRUE(validate(spmm, "f"));
}

struct Damage {
  const char* what;
  std::function<void(Spmm&)> apply;
  const char* place;  // a part of the place that the error names
};

TEST(ValidateSpmm, RefusesEverythingAKernelMustNotMeet) {
  constexpr uint32_t kNan = 0x7e00, kInfinity = 0x7c00;
  const std::vector<Damage> damages = {
      {"no texels", [](Spmm& s) { s.width = 0; }, "texels"},
      {"a huge side", [](Spmm& s) { s.width = 1 << 20; }, "texels"},
      {"too few texels", [](Spmm& s) { s.texels.pop_back(); }, "texel count"},
      {"no size", [](Spmm& s) { s.mm_per_texel = 0; }, "mm per texel"},
      {"a NaN size", [](Spmm& s) { s.mm_per_texel = std::nanf(""); }, "mm per texel"},
      {"no clusters", [](Spmm& s) { s.clusters.clear(); }, "clusters"},
      {"no functions", [](Spmm& s) { s.dictionary.clear(); }, "basis"},
      {"a cluster that is not there", [](Spmm& s) { s.texels[7].cluster_count |= 200; }, "texel (1, 1).cluster"},
      {"entries past the end", [](Spmm& s) { s.texels[5].first_entry = 1u << 30; }, "texel (5, 0).entries"},
      {"entries that wrap", [](Spmm& s) { s.texels[5].first_entry = ~0u; }, "texel (5, 0).entries"},
      {"bits above the count", [](Spmm& s) { s.texels[5].cluster_count |= 1u << 20; }, "texel (5, 0)"},
      {"a NaN coefficient", [](Spmm& s) { s.texels[2].coefficients23 |= kNan << 16; }, "texel (2, 0).coefficients"},
      {"a function that is not there", [](Spmm& s) { s.entries[3].basis_red |= 0xffff; }, "entry[3].basis"},
      {"an infinite weight", [](Spmm& s) { s.entries[3].green_blue = kInfinity; }, "entry[3].weight"},
      {"a NaN residual", [](Spmm& s) { s.residual.records[82].halves[3] = kNan; }, "cluster 0, view 1, light 1"},
      {"too few records", [](Spmm& s) { s.residual.records.pop_back(); }, "residual"},
      {"five terms", [](Spmm& s) { s.residual.terms = 5; }, "residual.terms"},
      {"a direction below",
       [](Spmm& s) {
         s.residual.directions[4] = {0, 0.6f, -0.8f};
       },
       "directions[4]"},
      {"a direction too long", [](Spmm& s) { s.residual.directions[4] *= 1.1f; }, "directions[4]"},
      {"a normal that looks down",
       [](Spmm& s) {
         s.dictionary[1].normal = {0, 0, -1};
       },
       "basis[1].normal"},
      {"a normal that is short",
       [](Spmm& s) {
         s.dictionary[1].normal = {0, 0, 0.5f};
       },
       "basis[1].normal"},
      {"a NaN angle", [](Spmm& s) { s.dictionary[1].psi = std::nanf(""); }, "basis[1].psi"},
      {"a roughness out of range", [](Spmm& s) { s.dictionary[2].lobe.params[1] = 4; }, "basis[2]"},
      {"a NaN parameter", [](Spmm& s) { s.dictionary[2].lobe.params[1] = std::nanf(""); }, "basis[2]"},
      {"a model that is not there", [](Spmm& s) { s.dictionary[2].lobe.model = static_cast<Model>(99); }, "basis[2]"},
  };
  for (const Damage& damage : damages) {
    Spmm spmm = test::small_spmm();
    damage.apply(spmm);
    const Status status = validate(spmm, "shoe.vamp");
    ASSERT_FALSE(status) << damage.what;
    EXPECT_EQ(status.error().kind, ErrorKind::bad_input) << damage.what;
    EXPECT_EQ(status.error().file, "shoe.vamp") << damage.what;
    EXPECT_NE(status.error().place.find(damage.place), std::string::npos)
        << damage.what << ": " << status.error().message();
    EXPECT_EQ(status.error().message().find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace vamp
