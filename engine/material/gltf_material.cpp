#include "engine/material/gltf_material.h"

#include <algorithm>
#include <cmath>

#include "engine/brdf/registry.h"
#include "engine/core/check.h"
#include "engine/core/half.h"
#include "engine/image/image.h"

namespace vamp {
namespace {

constexpr int kMaxSide = 1024;

float clamp01(float value) { return std::clamp(value, 0.f, 1.f); }

// Mean of `image` over the box [x0, x1) x [y0, y1) in pixels, as RGB.
vec3 box_mean(const Image& image, double x0, double x1, double y0, double y1) {
  const bool grey = image.channels.size() < 3;
  double sum[3] = {}, area = 0;
  for (int y = static_cast<int>(y0); y < std::min(static_cast<int>(std::ceil(y1)), image.height); ++y)
    for (int x = static_cast<int>(x0); x < std::min(static_cast<int>(std::ceil(x1)), image.width); ++x) {
      const double covered =
          (std::min(x1, x + 1.0) - std::max(x0, double(x))) * (std::min(y1, y + 1.0) - std::max(y0, double(y)));
      area += covered;
      for (size_t c = 0; c < 3; ++c) sum[c] += covered * double{image.at(x, y, grey ? 0 : c)};
    }
  return vec3(dvec3(sum[0], sum[1], sum[2]) / std::max(area, 1e-12));
}

uint32_t half(float value) { return half_from_float(std::clamp(value, 0.f, kHalfMax)); }

}  // namespace

Spmm spmm_from_gltf(const GltfSurface& surface) {
  const float metallic = clamp01(surface.metallic), roughness = clamp01(surface.roughness);
  const float specular = clamp01(surface.specular);
  const float root = (std::max(surface.ior, 1.f) - 1) / (std::max(surface.ior, 1.f) + 1);
  const float dielectric_f0 = std::min(root * root, 1.f);
  const bool matte = metallic == 0 && (roughness == 1 || specular == 0);

  Spmm spmm;
  spmm.clusters = {{"surface"}};
  spmm.dictionary.push_back({"body", default_lobe(Model::lambert), {0, 0, 1}, 0});
  const auto add_gloss = [&](const char* name, float f0) {
    Lobe lobe = default_lobe(Model::cook_torrance, kCookTorranceModernSchlick);
    const auto set = [&](std::string_view parameter, float value) {
      const ParameterRow* row = find_parameter(lobe.model, lobe.variant, parameter);
      CHECK(row != nullptr);
      lobe.params[row->slot] = std::clamp(value, row->min, row->max);
    };
    set("m", roughness * roughness);
    set("f0", f0);
    spmm.dictionary.push_back({name, lobe, {0, 0, 1}, 0});
  };
  const bool has_finish = !matte && metallic<1, has_metal = metallic> 0;
  if (has_finish) add_gloss("finish", dielectric_f0);
  if (has_metal) add_gloss("metal", 1), add_gloss("metal edge", 0);

  const Image* texture = surface.base_color_texture;
  const int side = texture == nullptr ? 1 : std::min(std::max(texture->width, texture->height), kMaxSide);
  spmm.width = spmm.height = side;
  spmm.mm_per_texel = std::clamp(surface.mm_per_uv, 1e-2f, 1e6f) / static_cast<float>(side);
  spmm.texels.reserve(static_cast<size_t>(side) * static_cast<size_t>(side));
  spmm.entries.reserve(spmm.texels.capacity() * spmm.dictionary.size());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      vec3 base = surface.base_color;
      if (texture != nullptr) {
        const double dx = double(texture->width) / side, dy = double(texture->height) / side;
        base *= box_mean(*texture, x * dx, (x + 1) * dx, y * dy, (y + 1) * dy);
      }
      base = glm::clamp(base, vec3(0), vec3(1));
      const auto first = static_cast<uint32_t>(spmm.entries.size());
      uint32_t basis = 0;
      const auto add = [&](vec3 weight) {
        spmm.entries.push_back({basis | half(weight.x) << 16, half(weight.y) | half(weight.z) << 16});
        ++basis;
      };
      add(matte ? base : base * ((1 - metallic) * (1 - specular * dielectric_f0)));
      if (has_finish) add(vec3(specular * (1 - metallic)));
      if (has_metal) add(base * metallic), add((vec3(1) - base) * metallic);
      spmm.texels.push_back({first, basis << 8, 0, 0});
    }
  return spmm;
}

}  // namespace vamp
