// What a hand does in a panel becomes one named step of the document.
#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/fit_figures.h"
#include "editor/panels/lengths.h"
#include "editor/panels/part_menu.h"
#include "editor/panels/part_place.h"
#include "tests/panels/panel_test.h"

namespace vamp::ui {
namespace {

using testing::HasSubstr;

constexpr int kWard = 3;      // the function's place in the test material
constexpr float kRow = 25;    // height of a row
constexpr float kFirst = 39;  // top of the section's first row: padding, header, gap

class BasisRows : public PanelTest {
 protected:
  BasisRows() { select("Vamp", 0, kWard); }
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      frame([&] {
        columns_ = next_row();
        section_.draw(context_, scope_);
      });
      abandoned_ = take_abandoned_edit() || abandoned_;
    }
  }
  // 0 weight, 1 model, 2 variant, 3 and 4 roughness, 5 tangent angle, then the normal.
  static float row_y(int row) { return kFirst + kRow * (static_cast<float>(row) + 0.5f); }
  float bar_x(float t) const { return columns_.control + t * (columns_.control_end - columns_.control); }
  void grab(int row, float t) {
    step(2);
    move(bar_x(t), row_y(row));
    step();
    press(true);
    step();
  }
  void drag_to(int row, float t) {
    move(bar_x(t), row_y(row));
    step();
  }
  void let_go() {
    press(false);
    step(2);
  }
  void click(float x, float y) {
    move(x, y);
    step(2);
    press(true);
    step();
    press(false);
    step(2);
  }
  Lobe lobe(int cluster = 0) const {
    const MaterialInstance& material = *find_material(*document_.project(), selection_.material);
    return effective_basis(*material.fit, material.edits, {cluster, kWard}).lobe;
  }
  BasisSection section_;
  EditScope scope_ = EditScope::this_cluster;
  RowColumns columns_{};
  bool abandoned_ = false;
};

TEST_F(BasisRows, ADragIsOneNamedStepAndUndoTakesItBack) {
  const Project before = *document_.project();
  grab(3, 0.5f);
  for (const float t : {0.55f, 0.6f, 0.7f}) drag_to(3, t);
  EXPECT_TRUE(document_.in_gesture());
  EXPECT_NE(lobe().params[1], 0.2f);  // the picture follows the hand
  let_go();
  EXPECT_FALSE(document_.in_gesture());
  ASSERT_EQ(document_.step_names().size(), 1u);
  EXPECT_THAT(document_.undo_name(), HasSubstr("Roughness U"));
  EXPECT_GT(lobe().params[1], 0.3f);
  EXPECT_EQ(lobe().params[2], 0.2f);
  EXPECT_TRUE(document_.undo());
  EXPECT_TRUE(*document_.project() == before);
}

TEST_F(BasisRows, EscInADragRestoresAndLeavesNoStep) {
  const Project before = *document_.project();
  grab(3, 0.5f);
  drag_to(3, 0.8f);
  ASSERT_FALSE(*document_.project() == before);
  key(kEscape, true);
  step();
  key(kEscape, false);
  step();
  EXPECT_TRUE(*document_.project() == before);
  let_go();
  EXPECT_TRUE(*document_.project() == before);
  EXPECT_TRUE(document_.step_names().empty());
}

TEST_F(BasisRows, ResetTakesTheEditAwayCompletely) {
  grab(3, 0.5f);
  drag_to(3, 0.8f);
  let_go();
  const int material = selection_.material;
  ASSERT_FALSE(find_material(*document_.project(), material)->edits == EditLayer{});
  click(columns_.centre_of_reset().x, row_y(3));
  EXPECT_TRUE(find_material(*document_.project(), material)->edits == EditLayer{});
  EXPECT_THAT(document_.undo_name(), HasSubstr("Reset Roughness U"));
}

TEST_F(BasisRows, TypingIsOneStep) {
  step(2);
  const float x = (columns_.number + columns_.number_end) / 2;
  for (int i = 0; i < 2; ++i) {
    move(x, row_y(3));
    step();
    press(true);
    step();
    press(false);
    step();
  }
  step();
  type("0.31");
  step();
  key(kEnter, true);
  step();
  key(kEnter, false);
  step(2);
  EXPECT_FLOAT_EQ(lobe().params[1], 0.31f);
  EXPECT_EQ(document_.step_names().size(), 1u);
}

TEST_F(BasisRows, TheWeightsDragScalesTheGain) {
  grab(0, 0.3f);
  drag_to(0, 0.5f);
  let_go();
  const vec3 gain = find_material(*document_.project(), selection_.material)->edits.edit_of({0, kWard}).gain;
  EXPECT_NE(gain.x, 1);
  EXPECT_EQ(gain.x, gain.y);
  EXPECT_EQ(document_.step_names().size(), 1u);
}

TEST_F(BasisRows, ALockedRowCannotBeDragged) {
  document_.edit(set_lock(*document_.project(), one_row(selection_.material, {0, kWard}), true));
  const ProjectPtr before = document_.project();
  grab(3, 0.5f);
  drag_to(3, 0.9f);
  let_go();
  EXPECT_EQ(document_.project(), before);
}

TEST_F(BasisRows, TheScopeTakesOtherClustersAlongButNotLockedRows) {
  scope_ = EditScope::all_clusters;
  grab(3, 0.5f);
  drag_to(3, 0.8f);
  let_go();
  EXPECT_NE(lobe(0).params[1], 0.2f);
  EXPECT_EQ(lobe(0), lobe(1));
  EXPECT_EQ(document_.step_names().size(), 1u);
  document_.undo();
  document_.edit(set_lock(*document_.project(), one_row(selection_.material, {1, kWard}), true));
  grab(3, 0.5f);
  drag_to(3, 0.8f);
  let_go();
  EXPECT_NE(lobe(0).params[1], 0.2f);
  EXPECT_EQ(lobe(1).params[1], 0.2f);
}

TEST_F(BasisRows, TheNormalsDiskDrags) {
  step(2);
  const float top = kFirst + 6 * kRow;
  const vec3 before = find_material(*document_.project(), selection_.material)->fit->dictionary[kWard].normal;
  move(columns_.left + 40, top + 54);
  step();
  press(true);
  step();
  move(columns_.left + 60, top + 40);
  step();
  move(columns_.left + 70, top + 40);
  step();
  let_go();
  const MaterialInstance& material = *find_material(*document_.project(), selection_.material);
  const vec3 after = effective_basis(*material.fit, material.edits, {0, kWard}).normal;
  EXPECT_NE(after, before);
  EXPECT_GT(after.z, 0);
  EXPECT_THAT(document_.undo_name(), HasSubstr("Normal"));
  EXPECT_EQ(document_.step_names().size(), 1u);
}

class PartPlace : public PanelTest {
 protected:
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      frame([&] {
        columns_ = next_row();
        draw_part_place(context_, part_);
      });
      take_abandoned_edit();
    }
  }
  // 0 to 2: moves along the axes, 3 to 5: turns.
  void drag(int row, float from, float to) {
    const float y = columns_.top + kRow * (static_cast<float>(row) + 0.5f);
    const auto x = [&](float t) { return columns_.control + t * (columns_.control_end - columns_.control); };
    move(x(from), y);
    step(2);
    press(true);
    step();
    for (int i = 1; i <= 8; ++i) {
      move(x(from + (to - from) * static_cast<float>(i) / 8), y);
      step();
    }
    press(false);
    step(2);
  }
  const Placement& place() const { return document_.project()->parts[static_cast<size_t>(part_)].place; }
  int part_ = find_part(*document_.project(), "Vamp");
  RowColumns columns_{};
};

TEST_F(PartPlace, ADragOfAMoveIsOneStepInMillimetres) {
  const Project before = *document_.project();
  step(2);
  drag(1, 0.5f, 0.75f);
  ASSERT_EQ(document_.step_names(), std::vector<std::string>{"Place of Vamp"});
  EXPECT_EQ(place().offset.x, 0);
  EXPECT_EQ(place().offset.z, 0);
  EXPECT_EQ(place().turn, vec3(0));
  // A quarter of the slider beyond its middle is a quarter of the range, which is 1,000 mm for a model of this size.
  EXPECT_NEAR(place().offset.y, 0.25f, 0.05f);
  EXPECT_TRUE(document_.undo());
  EXPECT_TRUE(*document_.project() == before);
}

TEST_F(PartPlace, TurnsAreInDegreesAndTheButtonPutsThePartBack) {
  step(2);
  drag(4, 0.5f, 0.75f);
  EXPECT_NEAR(place().turn.y, 1.5707963f, 0.1f);
  EXPECT_EQ(document_.undo_name(), "Turn of Vamp");
  drag(0, 0.5f, 0.6f);
  EXPECT_EQ(document_.step_names().size(), 2u);
  move(columns_.left + 10, columns_.top + 6 * kRow + 12);
  step(2);
  press(true);
  step();
  press(false);
  step(2);
  EXPECT_EQ(place(), Placement{});
  EXPECT_EQ(document_.undo_name(), "Put back Vamp");
}

TEST(Coordinates, ReachAsFarAsTheyMustAndMapBothWays) {
  const Project project = shoe_in_a_box();
  for (const float value : {0.0f, 12.5f, -900.0f, 1e6f, -3.3e8f}) {
    const Parameter row = coordinate_row(project, "X", "Where", value, 0);
    EXPECT_EQ(admit(row, value), value);
    EXPECT_LE(row.low, row.initial);
    EXPECT_EQ(row.mapping->from_slider(0, row.low, row.high), row.low);
    EXPECT_EQ(row.mapping->from_slider(1, row.low, row.high), row.high);
    const float t = row.mapping->to_slider(value, row.low, row.high);
    EXPECT_NEAR(row.mapping->from_slider(t, row.low, row.high), value, 1e-3f * row.high);
  }
  const Parameter length = length_row(project, "Radius", "Half the width", 1e-9f, 50);
  EXPECT_GT(length.low, 0);
  EXPECT_LT(length.low, length.high);
}

class PartMenu : public PanelTest {
 protected:
  int part(const char* name) const { return find_part(*document_.project(), name); }
  int material_of(const char* name) const {
    return document_.project()->parts[static_cast<size_t>(part(name))].material;
  }
};

TEST_F(PartMenu, ACopiedMaterialIsSharedByThePartsThatGetIt) {
  EXPECT_FALSE(can_paste_material(context_));
  copy_material(context_, part("Vamp"));
  ASSERT_NE(material_of("Laces"), material_of("Vamp"));
  paste_material_onto(context_, part("Laces"));
  EXPECT_EQ(material_of("Laces"), material_of("Vamp"));
  document_.undo();
  EXPECT_NE(material_of("Laces"), material_of("Vamp"));
}

TEST_F(PartMenu, WhatWasCopiedBeforeAnEditIsPastedAsItWas) {
  copy_material(context_, part("Vamp"));
  document_.edit(set_gain(*document_.project(), rows_of_material(*document_.project(), material_of("Vamp")), vec3(2)));
  paste_material_onto(context_, part("Laces"));
  ASSERT_NE(material_of("Laces"), material_of("Vamp"));
  const auto& materials = document_.project()->materials;
  EXPECT_TRUE(materials[static_cast<size_t>(material_of("Laces"))].edits.bases.empty());
  EXPECT_FALSE(materials[static_cast<size_t>(material_of("Vamp"))].edits.bases.empty());
  EXPECT_NE(materials[static_cast<size_t>(material_of("Laces"))].name,
            materials[static_cast<size_t>(material_of("Vamp"))].name);
}

TEST_F(PartMenu, HidingTheOthersIsOneStep) {
  document_.edit(show_only(*document_.project(), part("Laces")));
  for (const PartState& state : document_.project()->parts) EXPECT_EQ(state.visible, state.name == "Laces");
  EXPECT_EQ(document_.step_names().size(), 1u);
  document_.edit(show_only(*document_.project(), -1));
  for (const PartState& state : document_.project()->parts) EXPECT_TRUE(state.visible);
}

}  // namespace
}  // namespace vamp::ui
