#pragma once
// A fitted material's sharp highlight, from which shadow rays are drawn besides from lights (shaders/lib/mixture.glsl).
#include "engine/material/reflectance.h"

namespace vamp {

// Functions with slopes wider than this are met well enough by points on lights (docs/accuracy.md).
inline constexpr float kSharpSlopes = 0.06f;

// Width of slopes of the half vector, as Ward's alpha, that a function's highlight spreads over in its own frame: the
// larger of the two axes. Nothing of functions without a highlight about the mirror direction.
std::optional<float> highlight_slopes(const Lobe& lobe);

// Width of slopes about the texel's normal that the sharp functions of a fit spread over, the broadest of those that
// send back at least a hundredth of its light; 0 where there is none. The edit layer has no part in it.
float highlight_width(const Spmm& spmm, const FitSums& sums);

}  // namespace vamp
