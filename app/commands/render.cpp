#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/commands/command.h"
#include "app/commands/interrupt.h"
#include "app/commands/render_options.h"
#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/log.h"
#include "engine/core/progress.h"
#include "engine/gpu/device.h"
#include "engine/image/metadata.h"
#include "engine/project/default_project.h"
#include "engine/project/project_file.h"

namespace vamp {
namespace {

constexpr uvec2 kDefaultSize(1280, 960);
constexpr uint32_t kDefaultSamples = 64;

// Why the picture could not be written, before time is spent on it.
Status check_output(const fs::path& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) return fail(ErrorKind::io, path.string(), "", "a file", "a folder");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (::access(folder.c_str(), W_OK | X_OK) != 0 || (fs::exists(path, code) && ::access(path.c_str(), W_OK) != 0))
    return fail(ErrorKind::io, path.string(), "", "a place that may be written to", "no permission");
  return {};
}

// The scene that is asked for, with what its job says where it comes from a snapshot.
Result<Project> load(const RenderText& text, RenderOptions& options) {
  if (!text.scene.empty()) return open_scene(text.scene);
  if (text.from.empty()) return default_project();
  VAMP_TRY(const Metadata metadata, read_metadata(fs::path(text.from)));
  const auto found = metadata.find(std::string(kJobKey));
  if (found == metadata.end())
    return fail(ErrorKind::bad_input, text.from, "metadata", "a snapshot made by vamp", "no " + std::string(kJobKey));
  VAMP_TRY(Job job, job_from_text(found->second, fs::absolute(text.from).parent_path(), text.from));
  if (!options.size) options.size = uvec2(job.width, job.height);
  if (!options.samples) options.samples = job.samples;
  if (!options.noise_goal && job.noise_goal > 0) options.noise_goal = job.noise_goal;
  return std::move(job.project);
}

Json figures(const Still& still, const Job& job, const std::string& file) {
  Json json;
  json["file"] = file;
  json["width"] = job.width;
  json["height"] = job.height;
  json["samples"] = still.samples;
  json["mean_samples"] = still.mean_samples;
  if (still.noise >= 0) json["noise"] = still.noise;
  json["complete"] = job.complete;
  json["seconds"] = still.seconds;
  json["ms_per_sample"] = still.ms_per_sample;
  json["rays"] = std::llround(still.rays);
  json["mrays_per_s"] = still.seconds > 0 ? still.rays / still.seconds * 1e-6 : 0.0;
  json["device"] = job.device;
  json["driver"] = job.driver;
  json["gpu_bytes"] = still.gpu_bytes;
  json["triangles"] = job.project.scene->triangles.size();
  json["seed"] = job.project.settings.seed;
  return json;
}

Status render(const RenderText& text, const CommonOptions& common) {
  // Everything that can be found wrong before the scene is read.
  VAMP_TRY(RenderOptions options, read_render_options(text));
  StillOptions still_options{.layers = options.layers};
  VAMP_CHECK_STATUS(check_snapshot(text.output, still_options));
  VAMP_CHECK_STATUS(check_output(text.output));

  catch_interrupts();
  VAMP_TRY(Project project, load(text, options));
  VAMP_CHECK_STATUS(apply_render_options(text, options, project));
  VAMP_CHECK_STATUS(validate(project, project.model.string()));
  const uvec2 size = options.size.value_or(kDefaultSize);
  still_options.width = static_cast<int>(size.x);
  still_options.height = static_cast<int>(size.y);
  still_options.seconds = static_cast<double>(options.seconds.value_or(0.0f));
  still_options.noise_goal = options.noise_goal.value_or(0.0f);
  const uint32_t most = project.settings.max_samples;
  still_options.samples =
      options.seconds ? most : options.samples.value_or(options.noise_goal ? most : kDefaultSamples);

  VAMP_TRY(const std::unique_ptr<gpu::Device> device, open_device(common));
  const auto shared = std::make_shared<const Project>(std::move(project));
  spdlog::debug("rendering {} x {} on {}", size.x, size.y, device->info().name);
  Progress progress;
  Result<Still> still;
  run_with_progress("rendering", progress, [&] { still = render_still(*device, shared, still_options, &progress); });
  if (!still) return tl::unexpected(still.error());

  const Job job{.project = *shared,
                .width = size.x,
                .height = size.y,
                .samples = options.noise_goal ? still_options.samples : still->samples,
                .noise_goal = still_options.noise_goal,
                // A picture that was asked for by its time alone is whole when the time is over.
                .complete = still->complete || (options.seconds && !interrupted()),
                .device = device->info().name,
                .driver = device->info().driver};
  VAMP_CHECK_STATUS(save_snapshot(*still, job, text.output, text.format));
  const Json json = figures(*still, job, text.output);
  if (common.json) {
    fmt::print("{}", print_json(json));
  } else {
    // With a goal, tiles have different numbers.
    const std::string samples = options.noise_goal
                                    ? fmt::format("{:.0f} samples a pixel and {:.2g} % noise", still->mean_samples,
                                                  100 * static_cast<double>(still->noise))
                                    : fmt::format("{} samples", still->samples);
    fmt::print("{}: {} x {}, {} in {:.1f} s ({:.1f} ms a sample, {:.2f} Mrays/s)\n", text.output, size.x, size.y,
               samples, still->seconds, still->ms_per_sample, json["mrays_per_s"].get<double>());
  }
  if (interrupted()) return fail(ErrorKind::interrupted, text.output, "", "stopped; the file holds what there was");
  return {};
}

}  // namespace

void add_render(CLI::App& app, CommonOptions& common, Action& action) {
  auto text = std::make_shared<RenderText>();
  CLI::App* verb = app.add_subcommand("render", "Render a picture to a .png or .exr file");
  add_render_options(*verb, *text);
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([text, &common, &action] { action = [text, &common] { return render(*text, common); }; });
}

}  // namespace vamp
