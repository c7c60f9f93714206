#pragma once
// What the panels show. Not part of the document: choosing something is no edit and undo does not take it back.
#include "engine/material/edit_layer.h"
#include "engine/project/project.h"

namespace vamp {

struct Selection {
  int part = -1;  // -1: nothing
  int material = -1;
  int cluster = -1;
  int basis = -1;
  bool operator==(const Selection&) const = default;
};

// The same selection as far as it still exists after an edit: the material follows the part, lost rows are let go.
Selection valid_selection(const Project& project, Selection selection);

// A part with the material it shows.
Selection select_part(const Project& project, int part);

}  // namespace vamp
