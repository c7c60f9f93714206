#include "app/commands/command.h"
#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/log.h"
#include "engine/core/progress.h"
#include "engine/gpu/device.h"
#include "engine/image/metadata.h"
#include "engine/project/job_options.h"
#include "engine/project/project_file.h"
#include "engine/render/snapshot.h"
#include "engine/render/still.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace vamp {
namespace {

struct RenderOptions {
  std::string scene, output, size = "1280x960", camera, ambient, background, environment, layers, from;
  std::vector<std::string> lights, materials, mirrors;
  uint32_t samples = 64;
  double seconds = 0;
  std::optional<uint32_t> seed;
  std::optional<float> exposure, ao_radius, environment_rotation, environment_intensity;
  std::string tap;
  bool size_given = false, samples_given = false;
  bool pixel_centres = false, hide_environment = false;
  SnapshotFormat format;
};

Result<Project> load(RenderOptions& options) {
  if (options.from.empty()) {
    if (!options.scene.empty()) return open_scene(options.scene);
    return open_scene(shipped_dir("scenes") / "derby.glb");
  }
  VAMP_TRY(const Metadata metadata, read_metadata(fs::path(options.from)));
  const auto text = metadata.find(std::string(kJobKey));
  if (text == metadata.end())
    return fail(ErrorKind::bad_input, options.from, std::string(kJobKey), "a snapshot made by vamp", "no job");
  VAMP_TRY(Job job, job_from_text(text->second, fs::path(options.from).parent_path(), options.from));
  if (!options.size_given) options.size = fmt::format("{}x{}", job.width, job.height);
  if (!options.samples_given) options.samples = job.samples;
  return std::move(job.project);
}

// What the command line says stands over the scene's own.
Status apply(const RenderOptions& options, Project& project) {
  if (!options.camera.empty()) {
    VAMP_TRY(project.camera, parse_camera(options.camera, "--camera"));
  }
  const bool lights_given = !options.lights.empty() || !options.ambient.empty() || !options.environment.empty();
  if (lights_given) {
    project.lights.clear();
    project.ambient = vec3(0);
    project.background = vec3(0);
    project.environment = {};
  }
  for (const std::string& text : options.lights) {
    VAMP_TRY(Light light, parse_light(text, "--light"));
    project.lights.push_back(std::move(light));
  }
  if (!options.ambient.empty()) {
    VAMP_TRY(project.ambient, parse_color(options.ambient, "--ambient"));
  }
  if (!options.background.empty()) {
    VAMP_TRY(project.background, parse_color(options.background, "--background"));
  }
  if (!options.environment.empty()) {
    VAMP_TRY(project.environment.map, load_environment(options.environment));
    project.environment.path = options.environment;
  }
  if (options.environment_rotation) project.environment.rotation = *options.environment_rotation * 0.017453292519943295f;
  if (options.environment_intensity) project.environment.intensity = *options.environment_intensity;
  if (options.hide_environment) project.environment.visible = false;

  const auto part_and_value = [&](const std::string& text, std::string_view option) -> Result<std::pair<int, std::string>> {
    const size_t equals = text.find('=');
    if (equals == std::string::npos) return fail(ErrorKind::usage, "", option, "PART=VALUE", text);
    const int part = find_part(project, text.substr(0, equals));
    if (part < 0) {
      std::string names;
      for (const PartState& each : project.parts) names += (names.empty() ? "" : ", ") + each.name;
      return fail(ErrorKind::usage, "", option, "one of the parts " + names, text.substr(0, equals));
    }
    return std::pair(part, text.substr(equals + 1));
  };
  for (const std::string& text : options.materials) {
    VAMP_TRY(const auto assignment, part_and_value(text, "--material"));
    // A name without a folder is a preset that comes with the program.
    fs::path path = assignment.second;
    std::error_code code;
    if (!fs::exists(path, code) && !path.has_parent_path()) {
      const fs::path shipped = shipped_dir("presets") / (path.has_extension() ? path : fs::path(path.string() + ".vamp"));
      if (fs::exists(shipped, code)) path = shipped;
    }
    VAMP_TRY(const Preset preset, load_preset(path));
    assign_preset(project, assignment.first, preset, path.string());
  }
  for (const std::string& text : options.mirrors) {
    VAMP_TRY(const auto assignment, part_and_value(text, "--mirror"));
    char* end = nullptr;
    const float f0 = std::strtof(assignment.second.c_str(), &end);
    if (assignment.second.empty() || *end != '\0' || !(f0 >= 0 && f0 <= 1))
      return fail(ErrorKind::usage, "", "--mirror", "F0 from 0 to 1", assignment.second);
    project.parts[static_cast<size_t>(assignment.first)].mirror_f0 = f0;
  }
  if (options.seed) project.settings.seed = *options.seed;
  if (options.exposure) project.display.exposure = *options.exposure;
  if (options.ao_radius) project.settings.ao_radius = *options.ao_radius;
  if (options.pixel_centres) project.settings.pixel_centres = true;
  if (!options.tap.empty()) project.settings.tap = options.tap == "four" ? TexelTap::four : TexelTap::stochastic;
  return {};
}

Result<std::vector<Layer>> parse_layers(const std::string& text) {
  std::vector<Layer> layers;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    size_t found = 0;
    while (found < std::size(kLayerNames) && name != kLayerNames[found]) ++found;
    if (found == std::size(kLayerNames))
      return fail(ErrorKind::usage, "", "--aov", "depth, normal, uv, part, cluster or ao", name);
    if (std::find(layers.begin(), layers.end(), static_cast<Layer>(found)) == layers.end())
      layers.push_back(static_cast<Layer>(found));
    begin = end + 1;
  }
  return layers;
}

Status render(RenderOptions options, const CommonOptions& common) {
  VAMP_TRY(const uvec2 first_size, parse_size(options.size, "--size"));
  static_cast<void>(first_size);
  StillOptions still_options;
  VAMP_TRY(still_options.layers, parse_layers(options.layers));
  VAMP_CHECK_STATUS(check_snapshot(options.output, still_options));
  VAMP_TRY(Project project, load(options));
  VAMP_CHECK_STATUS(apply(options, project));
  VAMP_CHECK_STATUS(validate(project, project.model.string()));
  VAMP_TRY(const uvec2 size, parse_size(options.size, "--size"));
  still_options.width = static_cast<int>(size.x);
  still_options.height = static_cast<int>(size.y);
  // A time alone sets no number of samples.
  still_options.samples = options.seconds > 0 && !options.samples_given ? project.settings.max_samples : options.samples;
  still_options.seconds = options.seconds;

  VAMP_TRY(const std::unique_ptr<gpu::Device> device, open_device(common));
  const auto shared = std::make_shared<const Project>(std::move(project));
  Progress progress;
  Result<Still> still;
  run_with_progress("rendering", progress,
                    [&] { still = render_still(*device, shared, still_options, &progress); });
  if (!still) return tl::unexpected(still.error());

  Job job{.project = *shared,
          .width = size.x,
          .height = size.y,
          .samples = still->samples,
          .complete = still->complete,
          .device = device->info().name,
          .driver = device->info().driver};
  VAMP_CHECK_STATUS(save_snapshot(*still, job, options.output, options.format));
  const double mrays = still->seconds > 0 ? still->rays / still->seconds * 1e-6 : 0;
  if (common.json) {
    Json json;
    json["file"] = options.output;
    json["width"] = size.x;
    json["height"] = size.y;
    json["samples"] = still->samples;
    json["seconds"] = still->seconds;
    json["ms_per_sample"] = still->ms_per_sample;
    json["rays"] = std::round(still->rays);
    json["mrays_per_s"] = mrays;
    json["device"] = device->info().name;
    json["driver"] = device->info().driver;
    json["gpu_bytes"] = still->gpu_bytes;
    json["triangles"] = shared->scene->triangles.size();
    json["seed"] = shared->settings.seed;
    json["complete"] = still->complete;
    fmt::print("{}", print_json(json));
  } else {
    fmt::print("{}: {} x {}, {} samples in {:.1f} s ({:.1f} ms a sample, {:.2f} Mrays/s)\n", options.output, size.x, size.y,
               still->samples, still->seconds, still->ms_per_sample, mrays);
  }
  if (interrupted()) return fail(ErrorKind::interrupted, options.output, "", "stopped; the file holds what there was");
  return {};
}

}  // namespace

void add_render(CLI::App& app, CommonOptions& common, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* verb = app.add_subcommand("render", "Render a picture to a .png or .exr file");
  verb->add_option("scene", options->scene, "Model (.glb, .gltf) or project (.vampproj); the shipped derby by default");
  verb->add_option("-o,--output", options->output, "Picture to write: .png, or .exr for linear light and layers")->required();
  auto* size = verb->add_option("--size", options->size, "Width x height in pixels")->capture_default_str();
  auto* samples = verb->add_option("--samples", options->samples, "Samples of every pixel")
                      ->check(CLI::Range(1u, 1u << 24))
                      ->capture_default_str();
  verb->add_option("--time", options->seconds, "Stop after this many seconds")->check(CLI::Range(0.0, 1e7));
  verb->add_option("--seed", options->seed, "Seed of the random numbers");
  verb->add_option("--camera", options->camera, "eye=x,y,z,target=x,y,z,fov=degrees[,up=x,y,z], in scene units");
  verb->add_option("--light", options->lights,
                   "rect|disk|sphere|point|spot|directional,center=x,y,z,target=x,y,z,size=AxB|radius=R,power=W[,color=r,g,b]; "
                   "may be repeated. With --ambient and --environment it replaces the scene's own lighting");
  verb->add_option("--ambient", options->ambient, "Constant ambient radiance r,g,b, seen through the occlusion");
  verb->add_option("--ao-radius", options->ao_radius, "How far ambient light is occluded, scene units; 0: without limit")
      ->check(CLI::Range(0.0f, 1e30f));
  verb->add_option("--background", options->background, "Radiance behind everything, r,g,b or #rrggbb");
  verb->add_option("--environment", options->environment, "HDR lat-long map (.hdr, .exr) that lights the scene");
  verb->add_option("--environment-rotation", options->environment_rotation, "Degrees about +Y");
  verb->add_option("--environment-intensity", options->environment_intensity, "Factor")->check(CLI::Range(0.0f, 1e6f));
  verb->add_flag("--hide-environment", options->hide_environment, "The map lights, but is not seen behind the model");
  verb->add_option("--material", options->materials, "PART=PRESET: puts a preset on a part; may be repeated");
  verb->add_option("--mirror", options->mirrors, "PART=F0: mirror reflection of a part, 0 to 1; may be repeated");
  verb->add_option("--exposure", options->exposure, "Stops, for .png")->check(CLI::Range(-16.0f, 16.0f));
  verb->add_option("--aov", options->layers, "Layers of an .exr: depth,normal,uv,part,cluster,ao");
  verb->add_option("--tap", options->tap, "Texels: one drawn at random, or four blended")
      ->check(CLI::IsMember({"stochastic", "four"}));
  verb->add_flag("--pixel-centres", options->pixel_centres, "Rays through the middle of each pixel, no antialiasing");
  verb->add_option("--bits", options->format.png_bits, "Bits of a .png")->check(CLI::IsMember({8, 16}));
  verb->add_flag("--half", options->format.exr_half, "Half floats in an .exr");
  verb->add_flag("--transparent", options->format.transparent, "Alpha in a .png instead of the background");
  verb->add_option("--from", options->from, "A snapshot whose job is rendered again; other options stand over it");
  verb->add_flag("--json", common.json, "Print figures as JSON");
  verb->callback([=, &common, &action] {
    options->size_given = size->count() > 0;
    options->samples_given = samples->count() > 0;
    action = [=, &common] { return render(*options, common); };
  });
}

}  // namespace vamp
