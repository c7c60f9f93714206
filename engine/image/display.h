#pragma once
// Scene-linear radiance to the light of a display, as the window shows it (shaders/shared/tonemap.h).
#include "engine/image/image.h"

namespace vamp {

enum class ToneCurve : int { linear = 0, neutral = 1 };  // TONE_CURVE_* of shaders/shared/tonemap.h

struct Display {
  float exposure = 0;  // stops
  ToneCurve curve = ToneCurve::neutral;
};

// R, G and B (or Y, taken as grey) of the unnamed layer as linear light in [0, 1], ready for encode_png; A goes along
// unchanged where there is one, other channels do not. Error when there are no colours.
Result<Image> displayed(const Image& image, const Display& display);

// Rec.709 luminance of linear light.
constexpr double luminance(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

}  // namespace vamp
