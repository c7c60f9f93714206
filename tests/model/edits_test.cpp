#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "editor/model/selection.h"
#include "engine/brdf/registry.h"
#include "engine/project/limits.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Edits : public testing::Test {
 protected:
  const Project& project() const { return *document_.project(); }
  int calf() const { return project().parts[0].material; }
  const MaterialInstance& material() const { return project().materials[static_cast<size_t>(calf())]; }
  BasisEdit row(BasisKey key) const { return material().edits.edit_of(key); }

  Document document_{test::small_project()};
};

TEST_F(Edits, AreNamedAfterWhatTheyAreDoneTo) {
  EXPECT_EQ(set_parameter(project(), one_row(calf(), {0, 1}), "m", 0.3f).name,
            std::string(find_parameter(Model::cook_torrance, default_lobe(Model::cook_torrance).variant, "m")->label) +
                " of finish in grain");
  EXPECT_EQ(set_gain(project(), rows_of_basis(project(), calf(), 0), vec3(1)).name, "Weight of 2 functions of calf");
  EXPECT_EQ(set_mirror(project(), 1, 0.1f).name, "Mirror of sole");
}

TEST_F(Edits, AMaterialThatWasSavedAsAPresetBearsItsNameAndFollowsIt) {
  document_.edit(set_gain(project(), one_row(calf(), {0, 1}), vec3(2)));
  const MaterialInstance before = material();
  Preset saved = test::small_preset("lace");  // as another material of the document is called
  saved.edits = before.edits;
  EXPECT_TRUE(document_.edit(become_preset(project(), calf(), saved, "library:lace.vamp")));
  EXPECT_EQ(material().name, "lace 2");
  EXPECT_EQ(material().preset, "library:lace.vamp");
  EXPECT_EQ(material().edits, before.edits);
  EXPECT_EQ(material().fit, before.fit);  // the same tables, which stay where they are
  EXPECT_TRUE(validate(project(), ""));
  document_.undo();
  EXPECT_EQ(material(), before);
}

TEST_F(Edits, OfOneRowTouchThatRowAlone) {
  EXPECT_TRUE(document_.edit(set_gain(project(), one_row(calf(), {1, 2}), {2, 1, 0.5f})));
  EXPECT_EQ(material().edits.bases.size(), 1u);
  EXPECT_EQ(row({1, 2}).gain, vec3(2, 1, 0.5f));
}

TEST_F(Edits, OfAParameterSkipRowsWhoseModelHasNone) {
  EXPECT_TRUE(document_.edit(set_parameter(project(), rows_of_material(project(), calf()), "m", 0.3f)));
  EXPECT_EQ(material().edits.bases.size(), 2u);
  EXPECT_FALSE(row({0, 0}).lobe);
  EXPECT_TRUE(row({0, 1}).lobe && row({1, 1}).lobe);
}

TEST_F(Edits, ClampToTheRegistrysRangeAndLeaveOutWhatIsNotFinite) {
  document_.edit(set_parameter(project(), one_row(calf(), {0, 1}), "m", 1e9f));
  const ParameterRow* m = find_parameter(Model::cook_torrance, material().fit->dictionary[1].lobe.variant, "m");
  ASSERT_NE(m, nullptr);
  EXPECT_EQ(row({0, 1}).lobe->params[m->slot], m->max);
  EXPECT_FALSE(document_.edit(set_parameter(project(), one_row(calf(), {0, 1}), "m", kNan)));
  EXPECT_FALSE(document_.edit(set_gain(project(), one_row(calf(), {0, 1}), {1, kNan, 1})));
  document_.edit(set_gain(project(), one_row(calf(), {0, 1}), {-1, 1e30f, 1}));
  EXPECT_EQ(row({0, 1}).gain, vec3(0, kMaxGain, 1));
  EXPECT_FALSE(document_.edit(set_exposure(project(), kNan)));
  EXPECT_TRUE(validate(project(), ""));
}

TEST_F(Edits, OfAPlaceAreClampedNamedAndTakenBackWhole) {
  EXPECT_EQ(move_part(project(), 1, vec3(1)).name, "Place of sole");
  document_.edit(move_part(project(), 1, {0.5f, -1e9f, kNan}));
  EXPECT_EQ(project().parts[1].place.offset, vec3(0.5f, -kMaxCoordinate, 0));
  document_.edit(turn_part(project(), 1, {1, 1e9f, -kNan}));
  EXPECT_EQ(project().parts[1].place.turn, vec3(1, kMaxTurn, 0));
  EXPECT_TRUE(validate(project(), ""));
  document_.edit(move_part(project(), 2, vec3(1)));
  document_.edit(put_back(project(), 1));
  EXPECT_EQ(document_.undo_name(), "Put back sole");
  EXPECT_EQ(project().parts[1].place, Placement{});
  EXPECT_NE(project().parts[2].place, Placement{});
  EXPECT_FALSE(document_.edit(put_back(project(), 1)));
  document_.undo();
  EXPECT_EQ(project().parts[1].place.turn.x, 1);
  document_.edit(put_back(project(), -1));
  for (const PartState& part : project().parts) EXPECT_EQ(part.place, Placement{});
  EXPECT_FALSE(document_.edit(move_part(project(), 99, vec3(1))));
  EXPECT_FALSE(document_.edit(put_back(project(), 99)));
}

TEST_F(Edits, KeepNormalsUnitAndAboveTheSurface) {
  for (const vec3& wanted : {vec3(1, 2, 3), vec3(5, 0, -3), vec3(0, 0, -1), vec3(1e-3f, 0, 1e-9f), vec3(1, 0, 0)}) {
    document_.edit(set_normal(project(), one_row(calf(), {0, 1}), wanted));
    const vec3 normal = effective_basis(*material().fit, material().edits, {0, 1}).normal;
    EXPECT_NEAR(glm::length(normal), 1, 1e-6);
    EXPECT_GT(normal.z, 0.04f);
    EXPECT_TRUE(validate(project(), ""));
  }
  EXPECT_FALSE(document_.edit(set_normal(project(), one_row(calf(), {0, 2}), vec3(0))));
  EXPECT_FALSE(document_.edit(set_normal(project(), one_row(calf(), {0, 2}), vec3(kNan))));
}

TEST_F(Edits, OfSeveralRowsLeaveLockedOnesAlone) {
  document_.edit(set_lock(project(), one_row(calf(), {0, 0}), true));
  document_.edit(set_gain(project(), rows_of_material(project(), calf()), vec3(2)));
  EXPECT_EQ(row({0, 0}).gain, vec3(1));
  EXPECT_EQ(row({1, 0}).gain, vec3(2));
  document_.edit(set_gain(project(), one_row(calf(), {0, 0}), vec3(3)));
  EXPECT_EQ(row({0, 0}).gain, vec3(3));
  document_.edit(reset_material(project(), calf()));
  EXPECT_EQ(material().edits.bases.size(), 1u);
  document_.edit(set_lock(project(), rows_of_material(project(), calf()), false));
  document_.edit(reset_material(project(), calf()));
  EXPECT_EQ(material().edits, EditLayer{});
}

TEST_F(Edits, ThatGoBackToTheFitAreNotStored) {
  const Lobe fitted = material().fit->dictionary[1].lobe;
  document_.edit(set_parameter(project(), one_row(calf(), {0, 1}), "m", 0.3f));
  document_.edit(set_psi(project(), one_row(calf(), {0, 2}), 1));
  EXPECT_EQ(material().edits.bases.size(), 2u);
  document_.edit(reset_parameter(project(), one_row(calf(), {0, 1}), "m"));
  document_.edit(set_psi(project(), one_row(calf(), {0, 2}), 0.25f));
  EXPECT_TRUE(material().edits.bases.empty());
  document_.edit(set_model(project(), one_row(calf(), {0, 1}), Model::ward, 0));
  document_.edit(set_model(project(), one_row(calf(), {0, 1}), fitted.model, fitted.variant));
  EXPECT_EQ(row({0, 1}).lobe.value_or(fitted).model, fitted.model);
  document_.edit(reset_control(project(), one_row(calf(), {0, 1}), Control::lobe));
  EXPECT_TRUE(material().edits.bases.empty());
}

TEST_F(Edits, OfRowsThatDoNotExistChangeNothing) {
  for (const Rows& rows : {one_row(calf(), {2, 0}), one_row(calf(), {0, 3}), one_row(calf(), {-1, -1}),
                           one_row(-1, {0, 0}), one_row(99, {0, 0}), Rows{calf(), {}}})
    EXPECT_FALSE(document_.edit(set_gain(project(), rows, vec3(2))));
  EXPECT_FALSE(document_.edit(set_mirror(project(), 7, 1)));
  EXPECT_FALSE(document_.edit(remove_light(project(), -1)));
}

TEST_F(Edits, OfClustersNames) {
  document_.edit(rename_cluster(project(), calf(), 1, "crease"));
  EXPECT_EQ(cluster_name(material(), 1), "crease");
  document_.edit(rename_cluster(project(), calf(), 1, ""));
  EXPECT_EQ(cluster_name(material(), 1), "pore");
  EXPECT_EQ(material().edits, EditLayer{});
}

TEST_F(Edits, OfLightsKeepTheirNumberAndNamesApart) {
  while (document_.edit(add_light(project(), Light{}))) {
  }
  EXPECT_EQ(project().lights.size(), kMaxLights);
  for (size_t i = 0; i < project().lights.size(); ++i)
    for (size_t j = 0; j < i; ++j) EXPECT_NE(project().lights[i].name, project().lights[j].name);
  Light dark = project().lights[0];
  dark.size = vec2(0);
  EXPECT_FALSE(document_.edit(change_light(project(), 0, dark, "Size")));
}

TEST_F(Edits, OfOwnMaterialsAreNoStepWhereNothingChanges) {
  EXPECT_FALSE(document_.edit(use_own_material(project(), 1)));
  EXPECT_TRUE(document_.edit(use_own_material(project(), 0)));
}

TEST_F(Edits, LetTheSelectionGoWhereItsRowsAreGone) {
  Selection selection = select_part(project(), 0);
  selection.cluster = 1;
  selection.basis = 2;
  EXPECT_EQ(valid_selection(project(), selection), selection);
  document_.edit(use_own_material(project(), 0));
  const Selection now = valid_selection(project(), selection);
  EXPECT_EQ(now.part, 0);
  EXPECT_EQ(now.material, calf());
  EXPECT_EQ(now.cluster, -1);
  EXPECT_EQ(valid_selection(project(), {9, 9, 9, 9}), (Selection{-1, -1, -1, -1}));
}

}  // namespace
}  // namespace vamp
