#pragma once
// What is in a model file, flattened: one vertex pool in world space, triangles sorted by part. Plain data, never
// edited after loading; lights and cameras are where a new project starts from.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/vec.h"
#include "engine/scene/bounds.h"
#include "engine/scene/camera.h"
#include "engine/scene/light.h"

namespace vamp {

class Progress;
struct Image;

enum class Wrap : uint32_t { repeat, mirror, clamp };

// A decoded picture of the file, shared by the slots that use it.
struct Texture {
  std::string name;
  std::shared_ptr<const Image> image;
};

// Use of a texture. The texel is read at R(rotation) * (uv * scale) + offset as in KHR_texture_transform.
struct TextureSlot {
  int32_t texture = -1;  // index into Scene::textures, -1: none
  vec2 offset{0, 0};
  vec2 scale{1, 1};
  float rotation = 0;  // radians, counter-clockwise
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;

  bool operator==(const TextureSlot&) const = default;
};

enum class AlphaMode : uint32_t { opaque, mask, blend };

// glTF metallic-roughness, what a part without a preset is shown with. Colours are linear RGB.
struct SurfaceMaterial {
  std::string name;
  vec4 base_color{1, 1, 1, 1};
  TextureSlot base_color_texture;  // sRGB, alpha in A
  float metallic = 1;
  float roughness = 1;
  TextureSlot metallic_roughness_texture;  // linear, G roughness, B metallic
  TextureSlot normal_texture;              // linear
  float normal_scale = 1;
  float specular = 1;            // KHR_materials_specular
  vec3 specular_color{1, 1, 1};  // KHR_materials_specular
  float ior = 1.5f;              // KHR_materials_ior
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  vec3 emissive{0, 0, 0};  // noted, not rendered
};

// The primitives that share a material name.
struct Part {
  std::string name;  // unique in the scene, never empty
  SurfaceMaterial material;
  uint32_t first_triangle = 0;
  uint32_t triangle_count = 0;
  Bounds bounds;
  double area = 0;            // square scene units
  double uv_area = 0;         // sum of |area in uv|
  float mm_per_uv = 1000;     // mm_per_unit * sqrt(area / uv_area)
  bool uv_generated = false;  // the file had no UVs (at least for some of it): box projection, 100 mm per UV
};

struct Scene {
  std::string file;  // as it was asked for
  std::string name;
  std::string generator;

  // Vertices, world space. All four arrays have the same length.
  std::vector<vec3> positions;
  std::vector<vec3> normals;   // unit
  std::vector<vec4> tangents;  // unit along +dP/du, w = +1 or -1: bitangent = w * cross(normal, tangent)
  std::vector<vec2> uvs;       // row 0 of a texture at v = 0

  std::vector<uvec3> triangles;         // counter-clockwise seen from the front
  std::vector<uint32_t> triangle_part;  // non-decreasing

  std::vector<Part> parts;
  std::vector<Texture> textures;
  std::vector<Camera> cameras;
  std::vector<Light> lights;

  Bounds bounds;
  float mm_per_unit = 1000;
  std::optional<vec3> ambient;     // scenes[].extras.vamp_ambient: constant radiance
  std::optional<float> ao_radius;  // scenes[].extras.vamp_ao_radius, scene units
  std::vector<std::string> notes;  // what was said in the log while loading: fallbacks, things left out

  // -1 when there is no such part.
  int find_part(std::string_view part_name) const;
};

// Reads .gltf or .glb. Every rule that the file breaks ends in bad_input with the place in the file; files it names are
// read only inside its own folder. `progress` may be null; when it is cancelled: ErrorKind::interrupted.
Result<std::shared_ptr<const Scene>> load_scene(const std::filesystem::path& path, Progress* progress = nullptr);

// Fills what follows from the arrays: part ranges, bounds, areas, mm_per_uv. For scenes made by programs: triangle_part
// must be non-decreasing and below parts.size(), all arrays consistent (CHECKed).
void finish_scene(Scene& scene);

}  // namespace vamp
