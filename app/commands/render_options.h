#pragma once
// The options of `vamp render`: as they are written, and what they come to.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/project/project.h"
#include "engine/render/snapshot.h"
#include "engine/render/still.h"

namespace CLI {
class App;
}

namespace vamp {

// As written; empty where an option was not given.
struct RenderText {
  std::string scene, from, output, size, samples, time, noise, seed, camera, ambient, background;
  std::string environment, environment_rotation, environment_intensity, ao_radius, exposure, layers, tap;
  std::vector<std::string> lights, materials, mirrors, moves, turns;
  bool pixel_centres = false, hide_environment = false;
  SnapshotFormat format;
};
void add_render_options(CLI::App& verb, RenderText& text);

// Read and found to be in range; what was not given stays unset and leaves the scene's own.
struct RenderOptions {
  std::optional<uvec2> size;
  std::optional<uint32_t> samples, seed;
  std::optional<float> seconds, noise_goal, ao_radius, exposure, environment_rotation, environment_intensity;
  std::optional<Camera> camera;
  std::vector<Light> lights;
  std::optional<vec3> ambient, background;
  std::vector<std::pair<std::string, std::string>> materials;  // part, preset
  std::vector<std::pair<std::string, float>> mirrors;          // part, F0
  std::vector<std::pair<std::string, vec3>> moves, turns;      // part, scene units and radians
  std::vector<Layer> layers;
  std::optional<TexelTap> tap;
};
Result<RenderOptions> read_render_options(const RenderText& text);

// Puts what was given over the project's own. Loads the presets and the environment that are named.
Status apply_render_options(const RenderText& text, const RenderOptions& options, Project& project);

}  // namespace vamp
