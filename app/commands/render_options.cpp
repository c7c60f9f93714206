#include "app/commands/render_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands/option_values.h"
#include "editor/model/preset_library.h"
#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/project/file_reference.h"
#include "engine/project/job_options.h"
#include "engine/project/limits.h"

namespace vamp {
namespace {

constexpr float kRadiansPerDegree = 0.017453292519943295f;
constexpr float kMaxDegrees = 3600;

Result<std::vector<Layer>> read_layers(const std::string& text) {
  std::vector<Layer> layers;
  for (const std::string_view name : list_option(text)) {
    const auto* const found = std::find(std::begin(kLayerNames), std::end(kLayerNames), name);
    if (found == std::end(kLayerNames))
      return fail(ErrorKind::usage, "", "--aov", fmt::format("layers of {}", fmt::join(kLayerNames, ",")),
                  fmt::format("\"{}\"", name.substr(0, 80)));
    const auto layer = static_cast<Layer>(found - std::begin(kLayerNames));
    if (std::find(layers.begin(), layers.end(), layer) == layers.end()) layers.push_back(layer);
  }
  return layers;
}

// Sets `value` from the text of an option that was given.
template <class T, class Read>
Status read_given(const std::string& text, std::optional<T>& value, Read read) {
  if (text.empty()) return {};
  VAMP_TRY(value, read(text));
  return {};
}

// A preset by its file, or by its name alone: that of its file, else the one that it is shown by. The user's library
// comes before the presets that come with the program.
Result<fs::path> find_preset(const std::string& text) {
  const fs::path path = text;
  std::error_code code;
  const bool there = fs::is_directory(path, code) ? fs::exists(path / "material.json", code) : fs::exists(path, code);
  if (there || path.has_parent_path() || lower_extension(path) == ".vamp") {
    for (const fs::path& folder : {fs::path(), preset_library_dir(), shipped_dir("presets")})
      if (fs::exists(folder / path, code)) return folder / path;
    return path;  // reading it says what is wrong
  }
  PresetLibrary library;
  library.rescan();
  const std::vector<LibraryEntry>& entries = library.entries();
  for (const bool exact : {true, false})
    for (const LibraryEntry& entry : entries) {
      const std::string stem = entry.info.path.stem().string();
      if (exact ? stem == text : lower(stem) == lower(text)) return entry.info.path;
    }
  for (const LibraryEntry& entry : entries)
    if (lower(entry.info.name) == lower(text)) return entry.info.path;
  std::vector<std::string> names;
  for (const LibraryEntry& entry : entries)
    names.push_back(fmt::format("{} (\"{}\")", entry.info.path.stem().string(), entry.info.name));
  return fail(
      ErrorKind::usage, "", "--material",
      names.empty() ? "the file of a preset" : fmt::format("a preset's file or one of {}", fmt::join(names, ", ")),
      fmt::format("\"{}\"", text));
}

Result<int> part_called(const Project& project, const std::string& name, std::string_view option) {
  const int part = find_part(project, name);
  if (part >= 0) return part;
  std::vector<std::string> names;
  for (const PartState& each : project.parts) names.push_back(each.name);
  return fail(ErrorKind::usage, "", option, fmt::format("one of the parts {}", fmt::join(names, ", ")),
              fmt::format("\"{}\"", name));
}

}  // namespace

void add_render_options(CLI::App& verb, RenderText& text) {
  const auto option = [&verb](const char* name, std::string& value, const char* type, const char* help) {
    return verb.add_option(name, value, help)->type_name(type);
  };
  auto* scene =
      option("scene", text.scene, "FILE", "Model (.glb, .gltf) or project (.vampproj); the shipped derby by default");
  option("-o,--output", text.output, "FILE", "Picture to write: .png, or .exr for linear light and layers")->required();
  option("--size", text.size, "WxH", "In pixels, 1280x960 by default");
  auto* samples = option("--samples", text.samples, "N", "Samples of every pixel, 64 by default");
  option("--time", text.time, "SECONDS", "Refine for this many seconds instead")->excludes(samples);
  option("--noise", text.noise, "PERCENT",
         "Refine each tile of the picture until its relative noise is below; --samples and --time limit it");
  option("--seed", text.seed, "N", "Seed of the random numbers");
  option("--camera", text.camera, "KEYS", "eye=x,y,z,target=x,y,z,fov=degrees[,up=x,y,z]; lengths in scene units");
  verb.add_option(
          "--light", text.lights,
          "rect,center=x,y,z,target=x,y,z,size=AxB,power=W[,color=r,g,b]; also disk and sphere (radius=R), point, "
          "spot, directional. May be repeated. --light, --ambient and --environment together replace the "
          "scene's own lighting")
      ->type_name("KEYS")
      ->allow_extra_args(false);
  option("--ambient", text.ambient, "COLOUR", "Constant ambient radiance r,g,b, seen through the occlusion");
  option("--ao-radius", text.ao_radius, "LENGTH",
         "How far away things occlude ambient light, scene units; 0: without limit");
  option("--background", text.background, "COLOUR", "Radiance behind everything: r,g,b or #rrggbb");
  option("--environment", text.environment, "FILE", "Latitude-longitude map that lights the scene: .hdr, .exr");
  option("--environment-rotation", text.environment_rotation, "DEGREES", "Degrees about +Y");
  option("--environment-intensity", text.environment_intensity, "FACTOR", "Factor over the map's radiance");
  verb.add_flag("--hide-environment", text.hide_environment, "The map lights, but is not seen behind the model");
  verb.add_option("--material", text.materials, "Puts a preset (file or name) on a part; may be repeated")
      ->type_name("PART=PRESET")
      ->allow_extra_args(false);
  verb.add_option("--mirror", text.mirrors, "Mirror reflection of a part, 0 to 1; may be repeated")
      ->type_name("PART=F0")
      ->allow_extra_args(false);
  verb.add_option("--move", text.moves, "Moves a part from where the model has it, in scene units; may be repeated")
      ->type_name("PART=X,Y,Z")
      ->allow_extra_args(false);
  verb.add_option("--turn", text.turns,
                  "Turns a part about its middle, in degrees about X, then Y, then Z; may be repeated")
      ->type_name("PART=X,Y,Z")
      ->allow_extra_args(false);
  option("--exposure", text.exposure, "STOPS", "Stops; for .png");
  option("--aov", text.layers, "LAYERS", "Layers of an .exr: depth,normal,uv,part,cluster,ao");
  option("--tap", text.tap, "WORD", "Texels of a sample: stochastic (one, drawn by weight) or four (blended)");
  verb.add_flag("--pixel-centres", text.pixel_centres, "Rays through the middle of each pixel: no antialiasing");
  verb.add_option("--bits", text.format.png_bits, "Bits of a .png: 8 or 16")->check(CLI::IsMember({8, 16}));
  verb.add_flag("--half", text.format.exr_half, "Colours of an .exr as half floats");
  verb.add_flag("--transparent", text.format.transparent, "Alpha in a .png instead of the background");
  option("--from", text.from, "FILE", "Snapshot that is rendered again; other options stand over its job")
      ->excludes(scene);
}

Result<RenderOptions> read_render_options(const RenderText& text) {
  RenderOptions options;
  const auto number = [](std::string_view option, float low, float high) {
    return [=](const std::string& value) { return number_option(value, option, low, high); };
  };
  VAMP_CHECK_STATUS(read_given(text.size, options.size, [](const auto& value) { return parse_size(value, "--size"); }));
  VAMP_CHECK_STATUS(read_given(text.samples, options.samples,
                               [](const auto& value) { return count_option(value, "--samples", 1, kMaxSamples); }));
  VAMP_CHECK_STATUS(read_given(text.time, options.seconds, number("--time", 1e-3f, 1e6f)));
  VAMP_CHECK_STATUS(read_given(text.noise, options.noise_goal, number("--noise", 100 * kLeastNoiseGoal, 100)));
  if (options.noise_goal) *options.noise_goal /= 100;
  VAMP_CHECK_STATUS(read_given(text.seed, options.seed,
                               [](const auto& value) { return count_option(value, "--seed", 0, UINT32_MAX); }));
  VAMP_CHECK_STATUS(
      read_given(text.camera, options.camera, [](const auto& value) { return parse_camera(value, "--camera"); }));
  if (text.lights.size() > kMaxLights)
    return fail(ErrorKind::usage, "", "--light", fmt::format("at most {} lights", kMaxLights),
                std::to_string(text.lights.size()));
  for (const std::string& value : text.lights) {
    VAMP_TRY(Light light, parse_light(value, "--light"));
    options.lights.push_back(std::move(light));
  }
  VAMP_CHECK_STATUS(
      read_given(text.ambient, options.ambient, [](const auto& value) { return parse_color(value, "--ambient"); }));
  VAMP_CHECK_STATUS(read_given(text.background, options.background,
                               [](const auto& value) { return parse_color(value, "--background"); }));
  VAMP_CHECK_STATUS(read_given(text.ao_radius, options.ao_radius, number("--ao-radius", 0, kMaxCoordinate)));
  VAMP_CHECK_STATUS(read_given(text.exposure, options.exposure, number("--exposure", -kMaxExposure, kMaxExposure)));
  VAMP_CHECK_STATUS(read_given(text.environment_rotation, options.environment_rotation,
                               number("--environment-rotation", -kMaxDegrees, kMaxDegrees)));
  VAMP_CHECK_STATUS(read_given(text.environment_intensity, options.environment_intensity,
                               number("--environment-intensity", 0, kMaxEnvironmentIntensity)));
  for (const std::string& value : text.materials) {
    VAMP_TRY(const auto pair, pair_option(value, "--material"));
    options.materials.emplace_back(pair);
  }
  for (const std::string& value : text.mirrors) {
    VAMP_TRY(const auto pair, pair_option(value, "--mirror"));
    VAMP_TRY(const float f0, number_option(pair.second, "--mirror", 0, 1));
    options.mirrors.emplace_back(pair.first, f0);
  }
  for (const std::string& value : text.moves) {
    VAMP_TRY(const auto pair, pair_option(value, "--move"));
    VAMP_TRY(const vec3 offset, vector_option(pair.second, "--move", -kMaxCoordinate, kMaxCoordinate));
    options.moves.emplace_back(pair.first, offset);
  }
  for (const std::string& value : text.turns) {
    VAMP_TRY(const auto pair, pair_option(value, "--turn"));
    VAMP_TRY(const vec3 degrees, vector_option(pair.second, "--turn", -kMaxDegrees, kMaxDegrees));
    options.turns.emplace_back(pair.first, degrees * kRadiansPerDegree);
  }
  VAMP_TRY(options.layers, read_layers(text.layers));
  if (!text.tap.empty() && text.tap != "stochastic" && text.tap != "four")
    return fail(ErrorKind::usage, "", "--tap", "stochastic or four", fmt::format("\"{}\"", text.tap));
  if (!text.tap.empty()) options.tap = text.tap == "four" ? TexelTap::four : TexelTap::stochastic;
  return options;
}

Status apply_render_options(const RenderText& text, const RenderOptions& options, Project& project) {
  if (options.camera) project.camera = *options.camera;
  if (!options.lights.empty() || options.ambient || !text.environment.empty()) {
    project.lights = options.lights;
    project.ambient = options.ambient.value_or(vec3(0));
    project.background = vec3(0);
    project.environment = {};
  }
  if (options.background) project.background = *options.background;
  if (!text.environment.empty()) VAMP_CHECK_STATUS(assign_environment(project, text.environment));
  if (options.environment_rotation) project.environment.rotation = *options.environment_rotation * kRadiansPerDegree;
  if (options.environment_intensity) project.environment.intensity = *options.environment_intensity;
  if (text.hide_environment) project.environment.visible = false;

  for (const auto& [name, preset_name] : options.materials) {
    VAMP_TRY(const int part, part_called(project, name, "--material"));
    VAMP_TRY(const fs::path path, find_preset(preset_name));
    VAMP_TRY(const Preset preset, load_preset(path));
    assign_preset(project, part, preset, path.string());
  }
  for (const auto& [name, f0] : options.mirrors) {
    VAMP_TRY(const int part, part_called(project, name, "--mirror"));
    project.parts[static_cast<size_t>(part)].mirror_f0 = f0;
  }
  for (const auto& [name, offset] : options.moves) {
    VAMP_TRY(const int part, part_called(project, name, "--move"));
    project.parts[static_cast<size_t>(part)].place.offset = offset;
  }
  for (const auto& [name, turn] : options.turns) {
    VAMP_TRY(const int part, part_called(project, name, "--turn"));
    project.parts[static_cast<size_t>(part)].place.turn = turn;
  }

  if (options.seed) project.settings.seed = *options.seed;
  if (options.ao_radius) project.settings.ao_radius = *options.ao_radius;
  if (text.pixel_centres) project.settings.pixel_centres = true;
  if (options.tap) project.settings.tap = *options.tap;
  if (options.exposure) project.display.exposure = *options.exposure;
  return {};
}

}  // namespace vamp
