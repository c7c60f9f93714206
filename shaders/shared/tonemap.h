// From scene-linear radiance to what a display shows: exposure, Khronos PBR Neutral, the sRGB transfer curve.
// Read by GLSL and C++, so that the window, the snapshots and the measurements show the same picture.
#ifdef __cplusplus
#pragma once
#include <glm/exponential.hpp>
#include <glm/vec3.hpp>
namespace vamp {
using glm::exp2;
using glm::pow;
using glm::vec3;
#define TONE_FUNCTION inline
#else
#define TONE_FUNCTION
#endif

// Display curves; the numbers stand in files and push constants.
#define TONE_CURVE_LINEAR 0   // no curve: values over 1 are cut off
#define TONE_CURVE_NEUTRAL 1  // Khronos PBR Neutral

// Displays have no negative light, a NaN shows as black, and no later product of values below 1e18 overflows.
TONE_FUNCTION float tone_displayable(float value) { return value > 0.0f ? (value < 1e18f ? value : 1e18f) : 0.0f; }

// Linear radiance times 2^ev; ev in stops.
TONE_FUNCTION vec3 tone_exposed(vec3 radiance, float ev) { return radiance * exp2(ev); }

// Khronos PBR Neutral tone mapper, specification of 2024 (github.com/KhronosGroup/ToneMapping, PBR_Neutral/README.md),
// with its F90 = 0.04, Ks = 0.8 - F90, Kd = 0.15. Linear Rec.709 in, linear Rec.709 in [0, 1] out; base colours up to
// 0.76 + 0.04 keep their value less the 4 % that a dielectric's mirror adds, so that a product's colour holds.
TONE_FUNCTION vec3 tone_neutral(vec3 colour) {
  float r = tone_displayable(colour.x);
  float g = tone_displayable(colour.y);
  float b = tone_displayable(colour.z);
  float f90 = 0.04f;
  float ks = 0.8f - f90;
  float kd = 0.15f;
  float x = r < g ? (r < b ? r : b) : (g < b ? g : b);
  float f = x <= 2.0f * f90 ? x - x * x / (4.0f * f90) : f90;
  r = r - f;
  g = g - f;
  b = b - f;
  float p = r > g ? (r > b ? r : b) : (g > b ? g : b);
  if (p <= ks) return vec3(r, g, b);
  float d = 1.0f - ks;
  float peak = 1.0f - d * d / (p + 1.0f - 2.0f * ks);
  float keep = 1.0f / (kd * (p - peak) + 1.0f);
  float scale = peak / p * keep;
  float white = peak * (1.0f - keep);
  return vec3(r * scale + white, g * scale + white, b * scale + white);
}

// The sRGB transfer curve (IEC 61966-2-1): linear light in [0, 1] to the encoded value; cut off outside.
TONE_FUNCTION float srgb_encode(float linear) {
  float v = linear > 0.0f ? (linear < 1.0f ? linear : 1.0f) : 0.0f;
  return v <= 0.0031308f ? 12.92f * v : 1.055f * pow(v, 1.0f / 2.4f) - 0.055f;
}

// Its inverse: the encoded value in [0, 1] to linear light; cut off outside.
TONE_FUNCTION float srgb_decode(float encoded) {
  float v = encoded > 0.0f ? (encoded < 1.0f ? encoded : 1.0f) : 0.0f;
  return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f);
}

TONE_FUNCTION vec3 srgb_encoded(vec3 linear) {
  return vec3(srgb_encode(linear.x), srgb_encode(linear.y), srgb_encode(linear.z));
}

// Radiance to linear light of the display, in [0, 1] once srgb_encoded has cut it off. curve: TONE_CURVE_*.
TONE_FUNCTION vec3 tone_display(vec3 radiance, float ev, int curve) {
  vec3 colour = tone_exposed(radiance, ev);
  if (curve == TONE_CURVE_NEUTRAL) return tone_neutral(colour);
  return vec3(tone_displayable(colour.x), tone_displayable(colour.y), tone_displayable(colour.z));
}

#ifdef __cplusplus
}  // namespace vamp
#endif
#undef TONE_FUNCTION
