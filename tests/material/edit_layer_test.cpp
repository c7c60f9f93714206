#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/material/tables.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

bool same_bits(const EditedTables& a, const EditedTables& b) {
  return a.bases.size() == b.bases.size() && a.clusters.size() == b.clusters.size() &&
         std::memcmp(a.bases.data(), b.bases.data(), a.bases.size() * sizeof(a.bases[0])) == 0 &&
         std::memcmp(a.clusters.data(), b.clusters.data(), a.clusters.size() * sizeof(a.clusters[0])) == 0;
}

TEST(EditLayer, ARowThatEqualsTheFitIsErased) {
  EditLayer edits;
  BasisEdit edit;
  edit.gain = {2, 1, 1};
  edits.set({1, 2}, edit);
  EXPECT_EQ(edits.bases.size(), 1u);
  EXPECT_EQ(edits.edit_of({1, 2}), edit);
  EXPECT_EQ(edits.edit_of({1, 3}), BasisEdit{});
  edits.set({1, 2}, {});
  EXPECT_EQ(edits, EditLayer{});
}

TEST(EditLayer, MembersThatAreNotSetKeepTheFit) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit edit;
  edit.psi = 0.25f;
  edits.set({1, 2}, edit);
  const Basis basis = effective_basis(spmm, edits, {1, 2});
  EXPECT_EQ(basis.psi, 0.25f);
  EXPECT_EQ(basis.lobe, spmm.dictionary[2].lobe);
  EXPECT_EQ(basis.normal, spmm.dictionary[2].normal);
  EXPECT_EQ(effective_basis(spmm, edits, {0, 2}), spmm.dictionary[2]);
}

TEST(EditedTables, AnUneditedResidualIsScaledByExactlyOne) {
  const Spmm spmm = test::small_spmm();
  for (const auto& row : edited_tables(spmm, {}).clusters) {
    EXPECT_EQ(row.residual_red, 1.f);
    EXPECT_EQ(row.residual_green, 1.f);
    EXPECT_EQ(row.residual_blue, 1.f);
  }
}

TEST(EditedTables, ALockChangesNothing) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit edit;
  edit.lock = true;
  edits.set({1, 2}, edit);
  EXPECT_TRUE(same_bits(edited_tables(spmm, edits), edited_tables(spmm, {})));
}

TEST(EditedTables, AnEditAndItsUndoGiveTheSameBits) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit edit;
  edit.gain = {0.3f, 2, 1.7f};
  edit.lobe = default_lobe(Model::cook_torrance);
  edits.set({0, 1}, edit);
  EXPECT_FALSE(same_bits(edited_tables(spmm, edits), edited_tables(spmm, {})));
  edits.set({0, 1}, {});
  EXPECT_TRUE(same_bits(edited_tables(spmm, edits), edited_tables(spmm, {})));
}

TEST(EditedTables, AnEditTouchesItsRowAndItsClusterOnly) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit edit;
  edit.gain = {2, 2, 2};
  edits.set({1, 3}, edit);
  const EditedTables before = edited_tables(spmm, {}), after = edited_tables(spmm, edits);
  for (size_t i = 0; i < before.bases.size(); ++i)
    EXPECT_EQ(std::memcmp(&before.bases[i], &after.bases[i], sizeof(tables::BasisRow)) == 0, i != 1 * 5 + 3) << i;
  for (size_t i = 0; i < before.clusters.size(); ++i)
    EXPECT_EQ(before.clusters[i].residual_red == after.clusters[i].residual_red, i != 1) << i;
}

TEST(EditedTables, MuteSilencesOneSoloSilencesTheOthersOfTheCluster) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit mute, solo;
  mute.mute = true, solo.solo = true;
  edits.set({0, 1}, mute);
  edits.set({2, 0}, solo);
  const EditedTables tables = edited_tables(spmm, edits);
  for (int c = 0; c < 3; ++c)
    for (int j = 0; j < 5; ++j) {
      const bool silent = (c == 0 && j == 1) || (c == 2 && j != 0);
      EXPECT_EQ(tables.bases[static_cast<size_t>(c * 5 + j)].green == 0, silent) << c << " " << j;
    }
}

// Two functions at every texel, matte and gloss, and a residual of the gloss alone: a tenth of it everywhere.
Spmm gloss_misplaced() {
  Spmm spmm = test::small_spmm();
  spmm.dictionary = {{"matte", default_lobe(Model::lambert), {0, 0, 1}, 0},
                     {"gloss", default_lobe(Model::cook_torrance), {0, 0, 1}, 0}};
  spmm.entries.clear();
  const uint32_t one = half_from_float(1);
  for (tables::Texel& texel : spmm.texels) {
    texel.first_entry = static_cast<uint32_t>(spmm.entries.size());
    texel.cluster_count = (texel.cluster_count & 0xffu) | 2u << 8;
    for (uint32_t basis = 0; basis < 2; ++basis) spmm.entries.push_back({basis | one << 16, one | one << 16});
  }
  const PackedLobe gloss = pack_lobe(spmm.dictionary[1].lobe);
  const size_t n = spmm.residual.directions.size();
  for (size_t i = 0; i < spmm.residual.records.size(); ++i) {
    const vec3 wo = spmm.residual.directions[i / n % n], wi = spmm.residual.directions[i % n];
    const uint32_t value = half_from_float(0.1f * lobe_value(gloss, wi, wo));
    spmm.residual.records[i] = {{value | value << 16, value}};
  }
  return spmm;
}

float residual_after(const Spmm& spmm, int basis, const BasisEdit& edit) {
  EditLayer edits;
  edits.set({1, basis}, edit);
  return edited_tables(spmm, edits).clusters[1].residual_green;
}

TEST(EditedTables, TheResidualGoesWithTheFunctionThatItLiesUnder) {
  const Spmm spmm = gloss_misplaced();
  BasisEdit mute;
  mute.mute = true;
  EXPECT_LT(residual_after(spmm, 1, mute), 0.3f);
  EXPECT_GT(residual_after(spmm, 0, mute), 0.7f);
  EXPECT_NEAR(residual_after(spmm, 0, mute) + residual_after(spmm, 1, mute), 1, 1e-5);
  BasisEdit brighter;
  brighter.gain = vec3(3);
  EXPECT_NEAR(residual_after(spmm, 1, brighter), 1 + 2 * residual_after(spmm, 0, mute), 1e-4);
}

TEST(EditedTables, TheResidualTakesAThirdOfADye) {
  const Spmm spmm = gloss_misplaced();
  EditLayer edits;
  BasisEdit dyed;
  dyed.gain = {0.5f, 2, 0.5f};
  for (int j = 0; j < 2; ++j) edits.set({1, j}, dyed);
  const tables::ClusterRow row = edited_tables(spmm, edits).clusters[1];
  EXPECT_NEAR(row.residual_red, 1 - 0.5 / 3, 1e-3);  // all channels have a third of the energy: grey is 1
  EXPECT_NEAR(row.residual_green, 1 + 1.0 / 3, 1e-3);
  EXPECT_EQ(row.residual_red, row.residual_blue);
}

TEST(EditedTables, TheResidualOfAWidenedHighlightFades) {
  const Spmm spmm = gloss_misplaced();
  const auto widened = [&](float factor) {
    BasisEdit edit;
    edit.lobe = spmm.dictionary[1].lobe;
    edit.lobe->params[1] *= factor;
    return residual_after(spmm, 1, edit);
  };
  EXPECT_NEAR(widened(1), 1, 1e-5);
  EXPECT_LT(widened(1.5f), 0.9f);
  EXPECT_LT(widened(2), widened(1.5f));
}

TEST(EditedTables, TheResidualGoesWithTheRelief) {
  Spmm spmm = gloss_misplaced();
  for (Basis& basis : spmm.dictionary) basis.normal = test::tilted(40, 70);
  EditLayer edits;
  const auto tilt = [&](double degrees) {
    BasisEdit edit;
    edit.normal = test::tilted(degrees, 70);
    edits.set({1, 0}, edit);
    edits.set({1, 1}, edit);
    return edited_tables(spmm, edits).clusters[1].residual_green;
  };
  EXPECT_NEAR(tilt(40), 1, 1e-5);
  const double half = std::atan(0.5 * std::tan(40 * 0.017453292519943295)) / 0.017453292519943295;
  EXPECT_NEAR(tilt(half), 0.5, 0.06);  // a flat material's residual stays a little
  EXPECT_LT(tilt(0), 0.15f);
}

TEST(EditedTables, TheResidualIsLinearInGains) {
  const Spmm spmm = test::small_spmm();
  const auto scale = [&](float gain, bool everything) {
    EditLayer edits;
    BasisEdit edit;
    edit.gain = vec3(gain);
    for (int j = 0; j < (everything ? 5 : 1); ++j) edits.set({1, j}, edit);
    return static_cast<double>(edited_tables(spmm, edits).clusters[1].residual_red);
  };
  EXPECT_NEAR(scale(2.5f, true), 2.5, 1e-6);
  EXPECT_NEAR(scale(0, true), 0, 1e-6);
  EXPECT_NEAR(scale(3, false) - scale(2, false), scale(2, false) - 1, 1e-5);
}

TEST(EditedTables, ABlackChannelKeepsItsResidual) {
  Spmm spmm = test::small_spmm();
  for (auto& entry : spmm.entries) entry.basis_red &= 0xffffu;  // red weights 0
  EditLayer edits;
  BasisEdit edit;
  edit.gain = vec3(5);
  for (int j = 0; j < 5; ++j) edits.set({1, j}, edit);
  const tables::ClusterRow row = edited_tables(spmm, edits).clusters[1];
  EXPECT_EQ(row.residual_red, 1.f);
  EXPECT_NEAR(row.residual_green, 5, 1e-5);
}

TEST(EditedTables, KeepFadeAndStrengthDoAsTheySay) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit rough;
  rough.lobe = spmm.dictionary[2].lobe;
  rough.lobe->params[1] = 0.6f;
  for (int j = 0; j < 5; ++j) {
    BasisEdit edit;
    edit.normal = test::tilted(3, 10);
    edits.set({0, j}, edit);
  }
  edits.set({1, 2}, rough);

  edits.residual_policy = ResidualPolicy::keep;
  for (const auto& row : edited_tables(spmm, edits).clusters) EXPECT_EQ(row.residual_red, 1.f);
  edits.residual_strength = 0.5f;
  for (const auto& row : edited_tables(spmm, edits).clusters) EXPECT_EQ(row.residual_red, 0.5f);
  edits.residual_strength = 1;
  edits.residual_policy = ResidualPolicy::fade;
  const auto faded = edited_tables(spmm, edits).clusters;
  EXPECT_NEAR(faded[0].residual_red, 0, 1e-6);  // every function was reshaped
  EXPECT_GT(faded[1].residual_red, 0);
  EXPECT_LT(faded[1].residual_red, 1);
  EXPECT_EQ(faded[2].residual_red, 1.f);
}

TEST(EditedTables, ModelsInUseAreTheDictionarysAndTheEdits) {
  const Spmm spmm = test::small_spmm();
  const auto bit = [](Model model) { return 1u << static_cast<uint32_t>(model); };
  const uint32_t fitted = bit(Model::lambert) | bit(Model::oren_nayar) | bit(Model::ward) | bit(Model::cook_torrance) |
                          bit(Model::ashikhmin_shirley);
  EXPECT_EQ(models_in_use(spmm, {}), fitted);
  EditLayer edits;
  BasisEdit edit;
  edit.lobe = default_lobe(Model::lafortune);
  edits.set({0, 0}, edit);
  EXPECT_EQ(models_in_use(spmm, edits), fitted | bit(Model::lafortune));
}

TEST(Contributions, SumToOneAndFollowEdits) {
  const Spmm spmm = test::small_spmm();
  for (int c = 0; c < 3; ++c) {
    const auto shares = contributions(spmm, {}, c);
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-5);
    for (const float share : shares) EXPECT_GE(share, 0);
  }
  EditLayer edits;
  BasisEdit solo, mute;
  solo.solo = true, mute.mute = true;
  edits.set({1, 3}, solo);
  EXPECT_EQ(contributions(spmm, edits, 1)[3], 1.f);
  edits = {};
  for (int j = 0; j < 5; ++j) edits.set({1, j}, mute);
  for (const float share : contributions(spmm, edits, 1)) EXPECT_EQ(share, 0.f);
}

TEST(BytesOnGpu, APapersWoolStaysBelow12MiB) {
  Spmm wool;
  wool.width = wool.height = 256;
  wool.texels.resize(256 * 256);
  wool.entries.resize(5 * wool.texels.size());
  wool.clusters.resize(32);
  wool.dictionary.resize(32);
  wool.residual.directions.resize(81);
  wool.residual.records.resize(32 * 81 * 81);
  EXPECT_LT(bytes_on_gpu(wool), uint64_t{12} << 20);
  EXPECT_GT(bytes_on_gpu(wool), uint64_t{9} << 20);
  wool.dictionary.resize(285);  // as many functions as the paper's largest cluster has
  EXPECT_LT(bytes_on_gpu(wool), uint64_t{12} << 20);
}

}  // namespace
}  // namespace vamp
