#pragma once
// What the program shows when nothing else is asked for.
#include "engine/project/project.h"

namespace vamp {

// The shipped shoe, with the shipped leather and cloth on the parts that are made of them; parts show their own
// material where a preset is missing (said in the log). In code rather than in a project file, because a project
// warns of presets that have changed, and these are built anew whenever their maker is.
Result<Project> default_project();

}  // namespace vamp
