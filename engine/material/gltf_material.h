#pragma once
// A glTF metallic-roughness material as an SPMM of one cluster: what a part without a preset is shown with.
#include "engine/core/vec.h"
#include "engine/material/spmm.h"

namespace vamp {

struct Image;

// Colours linear Rec.709 from 0 to 1. Values out of range are clamped.
struct GltfSurface {
  vec3 base_color{1, 1, 1};
  const Image* base_color_texture = nullptr;  // linear; channels Y, YA, RGB or RGBA, alpha ignored; null: none
  float metallic = 1;
  float roughness = 1;
  float specular = 1;  // KHR_materials_specular: strength of a dielectric's reflection, 0 to 1
  float ior = 1.5f;    // KHR_materials_ior, from 1
  float mm_per_uv = 100;
};

// Lambert + Cook-Torrance (Beckmann m = roughness^2, Schlick). With F0 = specular ((ior - 1) / (ior + 1))^2 of the
// dielectric: Lambert's weight is base (1 - metallic) (1 - F0); the dielectric's lobe carries its F0 and has the weight
// specular (1 - metallic); a metal's Schlick curve base + (1 - base) (1 - oh)^5 is linear in the base colour, so that
// two lobes of F0 = 1 and F0 = 0 give it exactly in every channel. A dielectric with roughness 1 or specular 0 is
// exactly Lambert with the base colour as its weight: a white one is a white furnace. Textures become square, at most
// 1024 x 1024 texels, by area averages.
Spmm spmm_from_gltf(const GltfSurface& surface);

}  // namespace vamp
