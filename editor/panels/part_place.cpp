#include "editor/panels/part_place.h"

#include <cmath>
#include <glm/trigonometric.hpp>

#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/lengths.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"

namespace vamp::ui {

void draw_part_place(PanelContext& context, int part) {
  Document& document = context.document;
  const ProjectPtr project = document.project(), start = document.gesture_start();
  const Placement& place = project->parts[static_cast<size_t>(part)].place;
  const Placement& before = start->parts[static_cast<size_t>(part)].place;
  const float mm = project->mm_per_unit;

  constexpr const char* kMoves[3] = {"Move X", "Move Y", "Move Z"};
  constexpr const char* kMoveWords[3] = {"Moves the part to its right or left, from where the model has it.",
                                         "Moves the part up or down, from where the model has it.",
                                         "Moves the part forth or back, from where the model has it."};
  for (int axis = 0; axis < 3; ++axis) {
    // The range stays while the hand moves, though the model grows with its part.
    const Parameter row = shift_row(*start, kMoves[axis], kMoveWords[axis], before.offset[axis] * mm);
    number_row(document, row, place.offset[axis] * mm, [&](float value) {
      vec3 offset = place.offset;
      offset[axis] = value / mm;
      return move_part(*project, part, offset);
    });
  }
  constexpr const char* kTurns[3] = {"Turn X", "Turn Y", "Turn Z"};
  constexpr const char* kTurnWords[3] = {"Turns the part about its middle, tipping it forth or back.",
                                         "Turns the part about its middle, around the vertical.",
                                         "Turns the part about its middle, tipping it to its sides."};
  for (int axis = 0; axis < 3; ++axis) {
    Parameter row = angle_row(kTurns[axis], kTurnWords[axis], -180, 180, 0);
    row.wraps = true;
    number_row(document, row, std::remainder(glm::degrees(place.turn[axis]), 360.0f), [&](float value) {
      vec3 turn = place.turn;
      turn[axis] = glm::radians(value);
      return turn_part(*project, part, turn);
    });
  }
  gap(2);
  ImGui::BeginDisabled(place == Placement{});
  if (ImGui::Button("Put back")) document.edit(put_back(*project, part));
  ImGui::EndDisabled();
  hover_text("The part stands where the model has it");
}

}  // namespace vamp::ui
