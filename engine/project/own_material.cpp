#include "engine/project/own_material.h"

#include "engine/core/check.h"
#include "engine/image/image.h"
#include "engine/material/gltf_material.h"

namespace vamp {
namespace {

const Image* image_of(const Scene& scene, const TextureSlot& slot) {
  if (slot.texture < 0 || static_cast<size_t>(slot.texture) >= scene.textures.size()) return nullptr;
  return scene.textures[static_cast<size_t>(slot.texture)].image.get();
}

// Mean of one channel; 1 where there is no texture or no such channel.
float mean_of(const Image* image, std::string_view channel) {
  if (image == nullptr) return 1;
  const auto index = image->channel(channel);
  if (!index || image->pixel_count() == 0) return 1;
  double sum = 0;
  for (size_t i = *index; i < image->pixels.size(); i += image->channels.size())
    sum += static_cast<double>(image->pixels[i]);
  return static_cast<float>(sum / static_cast<double>(image->pixel_count()));
}

}  // namespace

MaterialInstance own_material(const Scene& scene, int part) {
  CHECK(part >= 0 && static_cast<size_t>(part) < scene.parts.size());
  const Part& source = scene.parts[static_cast<size_t>(part)];
  const SurfaceMaterial& look = source.material;
  GltfSurface surface;
  surface.base_color = vec3(look.base_color);
  surface.base_color_texture = image_of(scene, look.base_color_texture);
  const Image* metallic_roughness = image_of(scene, look.metallic_roughness_texture);
  surface.metallic = look.metallic * mean_of(metallic_roughness, "B");
  surface.roughness = look.roughness * mean_of(metallic_roughness, "G");
  surface.specular = look.specular;
  surface.ior = look.ior;
  surface.mm_per_uv = source.mm_per_uv;

  MaterialInstance instance;
  instance.name = source.name;
  instance.model_part = source.name;
  instance.fit = std::make_shared<const Spmm>(spmm_from_gltf(surface));
  return instance;
}

}  // namespace vamp
