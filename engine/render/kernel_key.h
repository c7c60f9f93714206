#pragma once
// What kernels are specialised for, and what of it a project asks for.
#include <compare>
#include <cstddef>
#include <cstdint>

#include "engine/material/known_sums.h"
#include "engine/project/project.h"

namespace vamp {

// How kernels trace a scene; see trace_path.h.
struct TracePath {
  bool storage_fetch = false;  // through storage buffers instead of texel buffers
  bool ray_queries = false;    // asking the device instead of walking the program's tree
  auto operator<=>(const TracePath&) const = default;
};

// Values of the SPEC_* constants (shaders/shared/frame.h).
struct KernelKey {
  uint32_t samples = 1;
  uint32_t light_count = 0;
  uint32_t light_types = 0;
  bool ambient = true;
  bool environment = false;
  bool mirror = false;
  bool alpha_mask = false;
  uint32_t residual = 0;
  uint32_t lobe_models = 0;
  bool four_taps = false;
  TracePath path;
  bool pixel_centres = false;
  bool new_hit = true;
  bool list = false;
  bool highlight = false;
  uint32_t light_slots = 0;
  auto operator<=>(const KernelKey&) const = default;

  // Shadow rays of a sample at one vertex, and accumulator planes.
  uint32_t ray_count() const { return (light_slots > 0 ? light_slots : light_count) + others(); }
  uint32_t planes() const { return 1 + light_count + others(); }

 private:
  uint32_t others() const { return (ambient ? 1u : 0u) + (environment ? 1u : 0u); }
};

// Serves every material, light type and highlight in a scene that is otherwise the same. On drivers that compute as
// they are told it gives the bits of the specialised kernels (tests/render/kernels_test.cpp).
KernelKey generic(KernelKey key);

// Where more lights than `above` are on, a sample traces rays to so many of them, drawn by chance
// (shaders/lib/light_choice.glsl), instead of a ray to each.
struct LightDraws {
  size_t above = 3;
  uint32_t slots = 2;
};

// From the project alone, before anything of it is on the device. samples, new_hit, list and path are left as they
// are by default.
KernelKey kernel_key(const Project& project, const LightDraws& draws, KnownSums& sums);

}  // namespace vamp
