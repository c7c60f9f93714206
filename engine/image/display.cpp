#include "engine/image/display.h"

#include <algorithm>

#include "shaders/shared/tonemap.h"

namespace vamp {

static_assert(static_cast<int>(ToneCurve::linear) == TONE_CURVE_LINEAR);
static_assert(static_cast<int>(ToneCurve::neutral) == TONE_CURVE_NEUTRAL);

Result<Image> displayed(const Image& image, const Display& display) {
  VAMP_TRY(Image shown, colour_of(image, "", ""));
  for (size_t i = 0; i < shown.pixels.size(); i += 3) {
    float* p = shown.pixels.data() + i;
    const vec3 light = tone_display(vec3(p[0], p[1], p[2]), display.exposure, static_cast<int>(display.curve));
    for (int c = 0; c < 3; ++c) p[c] = std::clamp(light[c], 0.0f, 1.0f);
  }
  if (image.channel("A")) {
    const std::string alpha[] = {"A"};
    add_layer(shown, select_channels(image, alpha), "");
  }
  return shown;
}

}  // namespace vamp
