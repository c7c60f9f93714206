// The virtual goniometer.
#include "engine/acquire/acquire.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>

#include "app/commands/command.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "engine/acquire/height_map.h"
#include "engine/acquire/preview.h"
#include "engine/acquire/structure.h"
#include "engine/btf/image_folder.h"
#include "engine/core/log.h"
#include "engine/core/progress.h"
#include "engine/image/save.h"
#include "engine/project/job_options.h"

namespace vamp {
namespace {

using acquire::Setting;
using acquire::Structure;

struct AcquireText {
  std::string meso, base_colour, output, preview, size = "128", directions = "ubo81", samples = "16", seed = "1",
                                                  detail = "6", threads = "0", shadows = "tabulated";
  std::vector<std::string> settings;
  bool list = false;
};

constexpr uint32_t kMaxSize = 1024;
// Facets of a height field grow with the square of this: 2 * 2048^2 take 0.7 GiB.
constexpr int kMostCells = 2048;
constexpr int kFewestCells = 256;

std::string value_text(const Setting& setting) {
  if (float* const* number = std::get_if<float*>(&setting.value)) return fmt::format("{:g}", **number);
  const vec3 colour = *std::get<vec3*>(setting.value);
  return fmt::format("{:g},{:g},{:g}", colour.x, colour.y, colour.z);
}

Json value_json(const Setting& setting) {
  if (float* const* number = std::get_if<float*>(&setting.value)) return json_number(**number);
  const vec3 colour = *std::get<vec3*>(setting.value);
  return Json::array({json_number(colour.x), json_number(colour.y), json_number(colour.z)});
}

// What there is to measure, or with a name its settings.
Status print_list(const AcquireText& text, bool json) {
  if (text.meso.empty()) {
    Json all = Json::array();
    for (const acquire::StructureRow& row : acquire::structures()) {
      if (!json) fmt::print("{:12} {}\n", row.name, row.what);
      all.push_back({{"name", row.name}, {"what", row.what}});
    }
    if (json) fmt::print("{}", print_json(all));
    return {};
  }
  VAMP_TRY(const std::unique_ptr<Structure> structure, acquire::make_structure(text.meso));
  Json all = Json::array();
  for (const Setting& setting : structure->settings()) {
    const std::string value = value_text(setting), range = fmt::format("{:g} to {:g}", setting.low, setting.high);
    if (!json) fmt::print("{:14} {:22} {:14} {}\n", setting.name, value, range, setting.what);
    all.push_back({{"name", setting.name},
                   {"value", value_json(setting)},
                   {"low", json_number(setting.low)},
                   {"high", json_number(setting.high)},
                   {"what", setting.what}});
  }
  if (json) fmt::print("{}", print_json(all));
  return {};
}

bool is_picture(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".png" || extension == ".PNG" || extension == ".exr" || extension == ".jpg";
}

Result<std::unique_ptr<Structure>> structure_of(const AcquireText& text) {
  if (text.meso.empty())
    return fail(ErrorKind::usage, "", "--meso", "a name (--list shows them) or a height map's .png");
  Result<std::unique_ptr<Structure>> structure = is_picture(text.meso)
                                                     ? acquire::load_height_map(text.meso, text.base_colour)
                                                     : acquire::make_structure(text.meso);
  if (!structure) return structure;
  if (!text.base_colour.empty() && !is_picture(text.meso))
    return fail(ErrorKind::usage, "", "--base-colour", "a height map as --meso", text.meso);
  for (const std::string& each : text.settings) {
    VAMP_TRY(const auto pair, pair_option(each, "--set"));
    const auto& [name, value] = pair;
    // A colour has commas or a number sign.
    if (value.find_first_of(",#") != std::string_view::npos) {
      VAMP_TRY(const vec3 colour, parse_color(value, "--set"));
      VAMP_CHECK_STATUS(acquire::set(**structure, name, colour));
    } else {
      VAMP_TRY(const float number, number_option(value, "--set", -1e6f, 1e6f));
      VAMP_CHECK_STATUS(acquire::set(**structure, name, number));
    }
  }
  return structure;
}

Json job_of(const AcquireText& text, Structure& structure, int cells) {
  Json job;
  job["structure"] = text.meso;
  if (!text.base_colour.empty()) job["base_colour"] = text.base_colour;
  Json settings = Json::object();
  for (const Setting& setting : structure.settings()) settings[std::string(setting.name)] = value_json(setting);
  job["settings"] = std::move(settings);
  job["size"] = std::stoi(text.size);
  job["directions"] = text.directions;
  job["samples"] = std::stoi(text.samples);
  job["seed"] = std::stoul(text.seed);
  job["cells"] = cells;
  job["shadows"] = text.shadows;
  return job;
}

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Status save_preview(const AcquireText& text, const acquire::Mesostructure& structure, int samples, int threads) {
  constexpr int kSide = 384;
  Progress progress;
  Image image;
  run_with_progress("looking", progress,
                    [&] { image = acquire::preview(structure, kSide, samples, threads, progress); });
  if (progress.cancelled()) return fail(ErrorKind::interrupted, text.preview, "", "stopped; nothing was written");
  return save_png(text.preview, image);
}

// Into a folder of pictures by way of a .btf file, which stays if the pictures do not get whole.
Status write_folder(const fs::path& btf_path, const fs::path& folder) {
  VAMP_TRY(const Btf btf, Btf::open(btf_path));
  Progress progress;
  Status written;
  run_with_progress("writing pictures", progress,
                    [&] { written = write_images(btf, folder, PictureFormat::exr, &progress); });
  VAMP_CHECK_STATUS(written);
  std::error_code code;
  fs::remove(btf_path, code);
  return {};
}

Status acquire_verb(const AcquireText& text, const CommonOptions& common) {
  if (text.list) return print_list(text, common.json);
  acquire::Options options;
  VAMP_TRY(const uint32_t size, count_option(text.size, "--size", 1, kMaxSize));
  VAMP_TRY(const uint32_t samples, count_option(text.samples, "--spp", 1, 65536));
  VAMP_TRY(options.seed, count_option(text.seed, "--seed", 0, UINT32_MAX));
  VAMP_TRY(const uint32_t detail, count_option(text.detail, "--detail", 1, 64));
  VAMP_TRY(const uint32_t threads, count_option(text.threads, "--threads", 0, 256));
  options.size = static_cast<int>(size);
  options.samples = static_cast<int>(samples);
  options.threads = static_cast<int>(threads);
  options.directions = text.directions == "dome151" ? dome151() : ubo81();
  options.shadows = text.shadows == "traced" ? acquire::Shadows::traced : acquire::Shadows::tabulated;
  if (text.output.empty() && text.preview.empty())
    return fail(ErrorKind::usage, "", "", "-o FILE.btf, -o FOLDER/ or --preview FILE.png");
  const bool to_folder = text.output.ends_with('/') || fs::is_directory(text.output);
  if (!text.output.empty() && !to_folder && fs::path(text.output).extension() != ".btf")
    return fail(ErrorKind::usage, text.output, "", "a name that ends with .btf, or with / for a folder of pictures");
  if (to_folder && fs::exists(text.output) && !fs::is_empty(text.output))
    return fail(ErrorKind::io, text.output, "", "a new or empty folder", "one with files in it");

  catch_interrupts();
  VAMP_TRY(const std::unique_ptr<Structure> structure, structure_of(text));
  const int cells = std::clamp(options.size * static_cast<int>(detail), kFewestCells, kMostCells);
  options.job = job_of(text, *structure, cells);
  const auto start = std::chrono::steady_clock::now();
  acquire::Mesostructure built = structure->build(cells);
  const size_t facets = built.facets.size();
  const double mm = built.mm;
  if (!text.preview.empty()) {
    VAMP_CHECK_STATUS(save_preview(text, built, options.samples, options.threads));
    if (text.output.empty()) return {};
  }

  const fs::path file =
      to_folder ? fs::path(text.output).lexically_normal().parent_path().string() + ".btf" : text.output;
  Progress progress;
  Result<acquire::Report> report;
  run_with_progress("acquiring", progress,
                    [&] { report = acquire::measure(std::move(built), options, file, progress); });
  if (!report) return tl::unexpected(report.error());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::error_code code;
  const auto bytes = static_cast<uint64_t>(fs::file_size(file, code));
  if (to_folder) VAMP_CHECK_STATUS(write_folder(file, text.output));

  if (common.json) {
    Json json;
    json["file"] = text.output;
    json["synthetic"] = true;
    json["job"] = options.job;
    json["mm_per_texel"] = json_number(static_cast<float>(mm / options.size));
    json["facets"] = facets;
    json["bytes"] = bytes;
    json["paths"] = report->paths;
    json["resumed_rows"] = report->resumed_rows;
    // One sample leaves nothing to tell it from.
    json["relative_standard_error"] = nullptr;
    if (samples > 1)
      json["relative_standard_error"] = {
          {"median", report->median_error}, {"mean", report->mean_error}, {"worst", report->worst_error}};
    json["seconds"] = seconds.count();
    json["cpu_seconds"] = cpu_seconds();
    fmt::print("{}", print_json(json));
  } else {
    fmt::print("{}: {} x {} texels, {}, {} samples, synthetic; {} facets, {:.1f} s ({:.1f} s of CPU)\n", text.output,
               options.size, options.size, text.directions, options.samples, facets, seconds.count(), cpu_seconds());
    if (samples > 1)
      fmt::print("relative standard error of a texel: median {:.2f} %, mean {:.2f} %, worst {:.2f} %\n",
                 100 * report->median_error, 100 * report->mean_error, 100 * report->worst_error);
  }
  return {};
}

}  // namespace

void add_acquire(CLI::App& app, CommonOptions& common, Action& action) {
  auto text = std::make_shared<AcquireText>();
  CLI::App* verb = app.add_subcommand("acquire", "Measure a made-up material with a virtual goniometer");
  verb->add_option("--meso", text->meso, "Material: a name of --list, or a height map")->type_name("NAME|FILE.png");
  verb->add_option("--base-colour", text->base_colour, "Colours of a height map")->type_name("FILE.png");
  verb->add_option("-o,--output", text->output, "A .btf file, or a folder of OpenEXR pictures")
      ->type_name("FILE.btf|FOLDER/");
  verb->add_option("--size", text->size, "Texels across the period")->type_name("N")->capture_default_str();
  verb->add_option("--directions", text->directions, "Of views and lights")
      ->check(CLI::IsMember({"ubo81", "dome151"}))
      ->capture_default_str();
  verb->add_option("--spp", text->samples, "Paths for each texel and view")->type_name("S")->capture_default_str();
  verb->add_option("--seed", text->seed, "Of the random numbers")->type_name("N")->capture_default_str();
  verb->add_option("--set", text->settings, "Change a setting (--list --meso NAME shows them); repeatable")
      ->type_name("NAME=VALUE");
  verb->add_option("--detail", text->detail, "Facets across a texel")->type_name("N")->capture_default_str();
  verb->add_option("--shadows", text->shadows, "One table for all, or a ray for each: exact, and several times slower")
      ->check(CLI::IsMember({"tabulated", "traced"}))
      ->capture_default_str();
  verb->add_option("--threads", text->threads, "0: one for each core; the result is the same")->capture_default_str();
  verb->add_option("--preview", text->preview, "Show the material under two lights")->type_name("FILE.png");
  verb->add_flag("--list", text->list, "List the materials, or with --meso one's settings");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([text, &common, &action] { action = [text, &common] { return acquire_verb(*text, common); }; });
}

}  // namespace vamp
