#include "editor/model/document.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

using test::small_project;

Edit exposure(const Document& document, float ev) { return set_exposure(*document.project(), ev); }

// Any of the edits that a designer can make, with any numbers.
Edit random_edit(const Project& project) {
  const auto number = [](float low, float high) {
    return low + (high - low) * static_cast<float>(*rc::gen::inRange(0, 1000)) / 1000.0f;
  };
  const auto color = [&] { return vec3(number(0, 2), number(0, 2), number(0, 2)); };
  const int part = *rc::gen::inRange(-1, 4), material = *rc::gen::inRange(-1, 4);
  const BasisKey key{*rc::gen::inRange(-1, 3), *rc::gen::inRange(-1, 4)};
  const Rows rows = *rc::gen::arbitrary<bool>() ? one_row(material, key) : rows_of_basis(project, material, key.basis);
  switch (*rc::gen::inRange(0, 27)) {
    case 0:
      return set_gain(project, rows, color());
    case 1:
      return set_parameter(project, rows, "m", number(0, 1));
    case 2:
      return set_normal(project, rows, vec3(number(-1, 1), number(-1, 1), number(-1, 1)));
    case 3:
      return set_psi(project, rows, number(-4, 4));
    case 4:
      return set_model(project, rows, static_cast<Model>(*rc::gen::inRange(0, kModelCount)), 0);
    case 5:
      return set_mute(project, rows, *rc::gen::arbitrary<bool>());
    case 6:
      return set_solo(project, rows, *rc::gen::arbitrary<bool>());
    case 7:
      return set_lock(project, rows, *rc::gen::arbitrary<bool>());
    case 8:
      return reset_rows(project, rows);
    case 9:
      return reset_material(project, material);
    case 10:
      return rename_cluster(project, material, key.cluster, *rc::gen::element<std::string>("", "crease", "pore"));
    case 11:
      return set_residual_strength(project, material, number(0, 2));
    case 12:
      return put_preset(project, part, std::make_shared<const Preset>(test::small_preset("twill", 0.25f)),
                        "twill.vamp");
    case 13:
      return use_own_material(project, part);
    case 14:
      return use_material_of(project, part, material);
    case 15:
      return make_material_unique(project, part);
    case 16:
      return show_part(project, part, *rc::gen::arbitrary<bool>());
    case 17:
      return set_mirror(project, part, number(-1, 2));
    case 18:
      return add_light(project, Light{});
    case 19:
      return remove_light(project, *rc::gen::inRange(-1, 4));
    case 20: {
      Light light;
      light.power = number(-1, 100);
      return change_light(project, *rc::gen::inRange(-1, 4), light, "Power");
    }
    case 21:
      return set_ambient(project, color());
    case 22:
      return keep_view(project, "toe");
    case 23:
      return remove_view(project, *rc::gen::inRange(-1, 3));
    case 24:
      return set_environment_rotation(project, number(-10, 10));
    case 25:
      return set_texture_scale(project, part, number(-1, 30));
    default:
      return set_exposure(project, number(-20, 20));
  }
}

TEST(Document, UndoOfAnyEditsGivesTheProjectBeforeAndRedoTheOneAfter) {
  EXPECT_TRUE(rc::check([] {
    Document document(small_project());
    std::vector<ProjectPtr> states = {document.project()};
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) {
      if (document.edit(random_edit(*document.project()))) states.push_back(document.project());
      RC_ASSERT(validate(*document.project(), "").has_value());
    }
    RC_ASSERT(document.steps_done() + 1 == states.size());
    for (size_t i = states.size() - 1; i > 0; --i) {
      RC_ASSERT(*document.project() == *states[i]);
      RC_ASSERT(document.undo());
    }
    RC_ASSERT(*document.project() == *states[0]);
    RC_ASSERT(!document.undo());
    RC_ASSERT(!document.dirty());
    for (size_t i = 1; i < states.size(); ++i) {
      RC_ASSERT(document.redo());
      RC_ASSERT(*document.project() == *states[i]);
    }
    RC_ASSERT(!document.redo());
  }));
}

TEST(Document, AnEditThatChangesNothingIsNoStepAndTellsNobody) {
  Document document(small_project());
  int told = 0;
  document.listen([&](const ProjectPtr&, const std::string&) { ++told; });
  const uint64_t revision = document.revision();
  EXPECT_FALSE(document.edit(exposure(document, document.project()->display.exposure)));
  EXPECT_FALSE(document.can_undo());
  EXPECT_EQ(document.revision(), revision);
  EXPECT_EQ(told, 0);
}

TEST(Document, ADragIsOneStepHoweverManyEditsItTakes) {
  Document document(small_project());
  const ProjectPtr before = document.project();
  document.begin_gesture();
  for (int i = 1; i <= 100; ++i) EXPECT_TRUE(document.edit(exposure(document, 0.01f * static_cast<float>(i))));
  EXPECT_EQ(document.gesture_start(), before);
  EXPECT_TRUE(document.commit_gesture());
  EXPECT_EQ(document.step_names(), std::vector<std::string>{"Exposure"});
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(*document.project(), *before);
}

TEST(Document, ACancelledDragRestoresWhatWasThere) {
  Document document(small_project());
  document.edit(exposure(document, 1));
  const ProjectPtr before = document.project();
  document.begin_gesture();
  document.edit(exposure(document, 2));
  document.cancel_gesture();
  EXPECT_EQ(*document.project(), *before);
  EXPECT_EQ(document.steps_done(), 1u);
  EXPECT_FALSE(document.in_gesture());
}

TEST(Document, ADragThatEndsWhereItBeganIsNoStep) {
  Document document(small_project());
  document.begin_gesture();
  document.edit(exposure(document, 2));
  document.edit(exposure(document, 0));
  EXPECT_FALSE(document.commit_gesture());
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, ADragThatIsCancelledKeepsWhatCouldBeRedone) {
  Document document(small_project());
  document.edit(exposure(document, 1));
  document.undo();
  document.begin_gesture();
  document.edit(exposure(document, 2));
  EXPECT_FALSE(document.can_redo());
  document.cancel_gesture();
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(document.project()->display.exposure, 1);
}

TEST(Document, UndoDuringADragTakesTheDragBack) {
  Document document(small_project());
  document.begin_gesture();
  document.edit(exposure(document, 2));
  EXPECT_EQ(document.undo_name(), "Exposure");
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.project()->display.exposure, 0);
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(document.project()->display.exposure, 2);
}

TEST(Document, KeyPressesOnTheSameControlJoinAndOthersDoNot) {
  Document document(small_project());
  for (int i = 1; i <= 5; ++i) document.edit(exposure(document, static_cast<float>(i)), Merge::with_last);
  EXPECT_EQ(document.steps_done(), 1u);
  document.edit(set_ambient(*document.project(), vec3(1)), Merge::with_last);
  document.edit(exposure(document, 6), Merge::with_last);
  EXPECT_EQ(document.steps_done(), 3u);
  document.undo();
  EXPECT_EQ(document.project()->display.exposure, 5);
  document.undo();
  document.undo();
  EXPECT_EQ(document.project()->display.exposure, 0);
  EXPECT_FALSE(document.can_undo());
}

TEST(Document, JoinedKeyPressesThatComeBackToTheirStartAreNoStep) {
  Document document(small_project());
  document.edit(exposure(document, 1), Merge::with_last);
  document.edit(exposure(document, 0), Merge::with_last);
  EXPECT_FALSE(document.can_undo());
  EXPECT_FALSE(document.dirty());
}

TEST(Document, ANewEditEndsWhatCouldBeRedone) {
  Document document(small_project());
  document.edit(exposure(document, 1));
  document.edit(exposure(document, 2));
  document.undo();
  document.edit(exposure(document, 3));
  EXPECT_FALSE(document.can_redo());
  document.undo();
  EXPECT_EQ(document.project()->display.exposure, 1);
}

TEST(Document, MovingTheCameraIsNoStepAndSurvivesUndo) {
  Document document(small_project());
  document.edit(exposure(document, 1));
  Camera camera = document.project()->camera;
  camera.eye += vec3(1);
  document.set_camera(camera);
  EXPECT_EQ(document.steps_done(), 1u);
  document.undo();
  EXPECT_EQ(document.project()->camera, camera);
  EXPECT_FALSE(document.dirty());
  document.edit("Camera through an edit", "", [](Project& project) { project.camera.eye.x = 9; });
  EXPECT_FALSE(document.can_undo());
  EXPECT_EQ(document.project()->camera.eye.x, 9);
}

TEST(Document, KnowsWhetherItIsSaved) {
  Document document(small_project());
  EXPECT_FALSE(document.dirty());
  document.edit(exposure(document, 1));
  EXPECT_TRUE(document.dirty());
  document.mark_saved("shoe.vampproj");
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.path(), "shoe.vampproj");
  document.undo();
  EXPECT_TRUE(document.dirty());
  document.redo();
  EXPECT_FALSE(document.dirty());
  document.undo();
  document.edit(exposure(document, 1));  // another way to the same values
  EXPECT_FALSE(document.dirty());
  document.mark_unsaved();
  EXPECT_TRUE(document.dirty());
}

TEST(Document, ForgetsTheOldestStepsFirst) {
  Document document(small_project());
  for (size_t i = 1; i <= Document::kMaxSteps + 50; ++i)
    document.edit("Exposure", "", [i](Project& project) { project.display.exposure = 0.001f * static_cast<float>(i); });
  EXPECT_EQ(document.steps_done(), Document::kMaxSteps);
  while (document.undo()) {
  }
  EXPECT_FLOAT_EQ(document.project()->display.exposure, 0.05f);
}

TEST(Document, GoesToAnyStepOfItsHistory) {
  Document document(small_project());
  for (int i = 1; i <= 4; ++i) document.edit(exposure(document, static_cast<float>(i)));
  document.go_to_step(1);
  EXPECT_EQ(document.project()->display.exposure, 1);
  document.go_to_step(4);
  EXPECT_EQ(document.project()->display.exposure, 4);
  document.go_to_step(99);
  EXPECT_EQ(document.steps_done(), 4u);
}

TEST(Document, TellsWhatHappened) {
  Document document(small_project());
  std::vector<std::string> reasons;
  document.listen([&](const ProjectPtr& project, const std::string& reason) {
    EXPECT_EQ(project, document.project());
    reasons.push_back(reason);
  });
  document.edit(exposure(document, 1));
  document.undo();
  document.redo();
  EXPECT_EQ(reasons, (std::vector<std::string>{"Exposure", "Undo Exposure", "Redo Exposure"}));
}

}  // namespace
}  // namespace vamp
