#pragma once
// Between the codes of display pictures, 0 to 1, and linear light.
#include <algorithm>
#include <cmath>

#include "engine/btf/image_folder.h"

namespace vamp {

// IEC 61966-2-1. Negative codes are no light.
inline double light_of(double code, PictureCurve curve) {
  code = std::max(code, 0.0);
  switch (curve) {
    case PictureCurve::srgb:
      return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
    case PictureCurve::gamma22:
      return std::pow(code, 2.2);
    case PictureCurve::linear:
      break;
  }
  return code;
}

inline double code_of(double light, PictureCurve curve) {
  light = std::max(light, 0.0);
  switch (curve) {
    case PictureCurve::srgb:
      return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    case PictureCurve::gamma22:
      return std::pow(light, 1 / 2.2);
    case PictureCurve::linear:
      break;
  }
  return light;
}

}  // namespace vamp
