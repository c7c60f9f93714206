#pragma once
// Blender's window with Cycles' viewport in it, on a screen: the same triangles and camera, a Principled BSDF for
// each material, an area light in Blender's grey world.
#include "bench/window/drags.h"
#include "engine/project/project.h"

namespace vamp {

struct CyclesAnswers {
  Answers material, light, view;
};

// `material`: whose roughness is set. From the moment at which a script inside of Blender sets a roughness, a light's
// energy or the view, so that no event, slider or panel stands between, to other pixels in the framebuffer; the view of
// width x height pixels has nothing around or over it, few samples, and rests before each edit. Errors: failed, where
// `blender` is missing or shows nothing.
Result<CyclesAnswers> measure_cycles(Screen& screen, const fs::path& folder, const Project& project, int material,
                                     int width, int height, int rounds);

}  // namespace vamp
