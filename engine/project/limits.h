#pragma once
// How large the numbers of a project may be: one statement for files, the command line, panels and validate().
#include <cstddef>
#include <cstdint>

namespace vamp {

inline constexpr float kMaxCoordinate = 1e7f;  // scene units; beyond it a float's steps are wider than a unit
inline constexpr float kMinLength = 1e-6f;     // scene units: sides and radii of lights
inline constexpr float kMaxRoll = 360;         // degrees, to both sides
inline constexpr float kMaxPower = 1e12f;      // W
inline constexpr float kMaxColor = 1e6f;       // linear RGB of lights, ambient and background
inline constexpr float kMinMmPerUnit = 1e-6f;  // a unit of a nanometre
inline constexpr float kMaxMmPerUnit = 1e9f;   // a unit of 1000 km
inline constexpr float kMinFovDegrees = 1;
inline constexpr float kMaxFovDegrees = 170;
inline constexpr float kMaxExposure = 16;  // EV, to both sides
inline constexpr float kMinTextureScale = 0.05f;
inline constexpr float kMaxTextureScale = 20;
inline constexpr float kMaxTextureOffset = 1e6f;  // mm
inline constexpr float kMaxTurn = 63;             // radians, ten turns to both sides: textures, parts, environments
inline constexpr float kMaxGain = 1e4f;           // per channel, of a basis's weights
inline constexpr float kMaxEnvironmentIntensity = 1e6f;
inline constexpr uint32_t kMaxSamples = 1u << 20;
inline constexpr float kLeastNoiseGoal = 1e-4f;  // of goals above 0
inline constexpr uint32_t kMaxPictureSide = 16384;
inline constexpr size_t kMaxParts = 65535;
inline constexpr size_t kMaxNamedCameras = 256;
inline constexpr size_t kMaxNameBytes = 256;

}  // namespace vamp
