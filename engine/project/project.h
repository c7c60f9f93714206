#pragma once
// What is rendered: model, material per part, lights, camera, settings. Plain values with equality; heavy data are
// shared and immutable, so that copying a project costs little and the renderer finds what changed by comparing two of
// them.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/material/edit_layer.h"
#include "engine/material/preset.h"
#include "engine/scene/camera.h"
#include "engine/scene/environment.h"
#include "engine/scene/light.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene.h"

namespace vamp {

// A preset (or a part's own glTF material) with this project's edits over it. Parts that share one change together.
struct MaterialInstance {
  std::string name;
  std::string preset;      // reference of the preset (file_reference.h); empty: the model's own material
  std::string model_part;  // where preset is empty: the part of the model whose own material it is
  std::string checksum;    // of the preset's fit (fit_checksum.h), so that a changed preset is noticed
  SpmmPtr fit;             // never null
  EditLayer edits;
  bool operator==(const MaterialInstance&) const = default;  // fit by identity
};

// What a part shows and where it stands. How a preset lies on it: its texture is scaled, turned from u towards v, and
// moved. The model's own material lies as its texture's transform says.
struct PartState {
  std::string name;  // as in the scene, same order
  int material = 0;  // index into Project::materials
  bool visible = true;
  float mirror_f0 = 0;         // 0 to 1; 0: no mirror reflection
  float texture_scale = 1;     // 0.05 to 20: over the physical size
  float texture_rotation = 0;  // radians
  vec2 texture_offset{0, 0};   // mm
  Placement place;
  bool operator==(const PartState&) const = default;
};

struct EnvironmentState {
  std::string path;                        // reference of the file (file_reference.h); empty: none
  std::string checksum;                    // of the file
  std::shared_ptr<const Environment> map;  // null: none
  float intensity = 1;
  float rotation = 0;   // radians about +Y
  bool visible = true;  // seen behind the model
  bool operator==(const EnvironmentState&) const = default;
};

enum class TexelTap { stochastic, four };
enum class ToneMap { pbr_neutral, none };

struct RenderSettings {
  uint32_t seed = 0;
  float ao_radius = 0;  // scene units; 0: unbounded
  bool pixel_centres = false;
  TexelTap tap = TexelTap::stochastic;
  uint32_t max_samples = 1u << 20;  // the picture stops refining there
  float noise_goal = 0;             // and each of its tiles where its relative noise falls below; 0: never
  bool operator==(const RenderSettings&) const = default;
};

// How the linear picture is shown; never restarts it.
struct DisplaySettings {
  float exposure = 0;  // EV, -16 to 16
  ToneMap tone_map = ToneMap::pbr_neutral;
  bool operator==(const DisplaySettings&) const = default;
};

struct NamedCamera {
  std::string name;
  Camera camera;
  bool operator==(const NamedCamera&) const = default;
};

struct Project {
  std::filesystem::path model;         // the glTF file, absolute; empty: the scene was made in memory
  std::string model_checksum;          // of that file
  std::shared_ptr<const Scene> scene;  // never null
  float mm_per_unit = 1000;
  std::vector<MaterialInstance> materials;
  std::vector<PartState> parts;  // one for each of the scene's
  std::vector<Light> lights;
  vec3 ambient{0, 0, 0};     // constant radiance through the occlusion, linear Rec.709
  vec3 background{0, 0, 0};  // radiance behind everything where no environment is shown
  EnvironmentState environment;
  Camera camera;
  std::vector<NamedCamera> cameras;  // kept views
  RenderSettings settings;
  DisplaySettings display;
  bool operator==(const Project&) const = default;
};

inline constexpr size_t kMaxLights = 32;  // that the renderer keeps apart (MAX_LIGHTS)

// The project that a freshly opened model makes: its own materials (parts that share a material name are one part),
// lights, cameras and extras; where it has no light at all, a neutral studio (two soft rectangle lights fitted to its
// bounds, ambient 0.15, background 0.18), said in the log; where it has no camera, a three-quarter view that fits it.
Project make_project(std::shared_ptr<const Scene> scene, const std::filesystem::path& model);

// Puts a preset on a part as it was saved: reuses the instance that holds it with just the preset's edits, else adds
// one; drops instances no part uses. `path`: a file or a reference.
void assign_preset(Project& project, int part, const Preset& preset, const std::string& path);

// Takes the preset off a part: the model's own material shows again, unedited.
void assign_own_material(Project& project, int part);

// Another instance of the project on a part, shared with the parts that already show it.
void share_material(Project& project, int part, int material);

// Puts an environment map around the model; `path`: a file or a reference. Intensity and rotation stay.
Status assign_environment(Project& project, const std::string& path);

// Removes the instances that no part shows; the others keep their order.
void drop_unused_materials(Project& project);

// Gives a part a material instance of its own, a copy of the one it shared. Returns the instance's index.
int make_unique_material(Project& project, int part);

// What the part's place does to its points and directions: it turns about the middle of its bounds.
RigidMotion motion_of(const Project& project, size_t part);

// Index of the part whose name is `name` (exact, else case-insensitive), or -1.
int find_part(const Project& project, std::string_view name);

// The renderer's own limits: light count, finite numbers, ranges, indices. Everything from files and the command line
// passes through here.
Status validate(const Project& project, std::string_view file);

}  // namespace vamp
