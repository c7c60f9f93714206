#include "engine/fit/fit.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "app/commands/preset_output.h"
#include "engine/brdf/registry.h"
#include "engine/btf/load_btf.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/fit/srf.h"
#include "engine/fit/swatch.h"
#include "engine/image/save.h"
#include "engine/material/preset.h"
#include "engine/material/reflectance.h"
#include "engine/material/tables.h"

namespace vamp {
namespace {

constexpr int kThumbnailSide = 256;

// The command line's words; empty where an option is not given.
struct FitText {
  std::string btf, output, name, tags;
  std::string clusters, representatives, functions, terms, bases, error, seed, threads, left_out;
  std::string weights = "elimination", kind = "spmm";
  bool per_cluster = false, curve = false;
};

Result<fit::FitOptions> read_options(const FitText& text) {
  fit::FitOptions options;
  const auto count = [](const std::string& word, const char* option, uint32_t low, uint32_t high,
                        int& value) -> Status {
    if (word.empty()) return {};
    VAMP_TRY(const uint32_t number, count_option(word, option, low, high));
    value = static_cast<int>(number);
    return {};
  };
  VAMP_CHECK_STATUS(count(text.clusters, "--clusters", 1, kMaxClusters, options.clusters));
  VAMP_CHECK_STATUS(count(text.representatives, "--representatives", 1, 64, options.representatives));
  VAMP_CHECK_STATUS(count(text.functions, "--functions", 1, 64, options.functions));
  if (text.terms == "none") {
    options.terms = -1;
  } else {
    VAMP_CHECK_STATUS(count(text.terms, "--pca", 0, kMaxResidualTerms, options.terms));
  }
  VAMP_CHECK_STATUS(count(text.bases, "--bases", 1, 1024, options.bases));
  VAMP_CHECK_STATUS(count(text.threads, "--threads", 1, 256, options.threads));
  if (!text.seed.empty()) {
    VAMP_TRY(options.seed, count_option(text.seed, "--seed", 0, UINT32_MAX));
  }
  if (!text.error.empty()) {
    VAMP_TRY(options.error, number_option(text.error, "--error", 1e-4f, 1));
  }
  for (const std::string_view ring : list_option(text.left_out)) {
    VAMP_TRY(const float degrees, number_option(ring, "--leave-out", 0, 90));
    options.left_out.push_back(double{degrees});
  }
  options.per_cluster = text.per_cluster;
  options.curve = text.curve;
  options.weights = text.weights == "lasso"       ? fit::Weights::group_lasso
                    : text.weights == "stagewise" ? fit::Weights::stagewise_lasso
                                                  : fit::Weights::elimination;
  return options;
}

// What a designer meets: each function, what it looks like, and its share of the light of each cluster.
Json functions_json(const Spmm& spmm, const fit::FitReport& report) {
  const FitSums sums = fit_sums(spmm);
  std::vector<std::vector<float>> shares;
  for (size_t c = 0; c < spmm.clusters.size(); ++c)
    shares.push_back(contributions(spmm, {}, static_cast<int>(c), sums));
  Json functions = Json::array();
  for (size_t j = 0; j < spmm.dictionary.size(); ++j) {
    Json row;
    row["name"] = spmm.dictionary[j].name;
    row["model"] = model_row(spmm.dictionary[j].lobe.model).name;
    row["filler"] = static_cast<bool>(report.filler[j]);
    double mean = 0;
    Json by_cluster = Json::array();
    for (size_t c = 0; c < shares.size(); ++c) {
      mean += double{shares[c][j]} * sums.texels[c] / static_cast<double>(spmm.texels.size());
      by_cluster.push_back(json_number(shares[c][j]));
    }
    row["share"] = json_number(static_cast<float>(mean));
    row["share_by_cluster"] = std::move(by_cluster);
    functions.push_back(std::move(row));
  }
  return functions;
}

Json figures(const fit::FitResult& result, const FitText& text, double seconds) {
  const Spmm& spmm = result.spmm;
  const fit::FitReport& report = result.report;
  const auto number = [](double value) { return json_number(static_cast<float>(value)); };
  Json json;
  json["file"] = text.output;
  json["btf"] = text.btf;
  json["texels"] = {spmm.width, spmm.height};
  json["clusters"] = spmm.clusters.size();
  json["representatives"] = report.representatives;
  json["candidates"] = report.candidates;
  json["bases"] = spmm.dictionary.size();
  json["functions_per_texel"] = number(report.functions_per_texel);
  json["texels_by_functions"] = report.histogram;
  Json errors;
  errors["representatives"] = number(report.representative_error);
  errors["all_functions"] = number(report.all_functions_error);
  errors["functions"] = number(report.errors.front());
  if (report.errors.size() > 1) errors["with_mean"] = number(report.errors[1]);
  for (size_t k = 2; k < report.errors.size(); ++k)
    errors[fmt::format("with_{}_terms", k - 1)] = number(report.errors[k]);
  json["relative_rmse"] = std::move(errors);
  json["bytes_on_gpu"] = bytes_on_gpu(spmm);
  json["seconds"] = number(seconds);
  for (const auto& [stage, took] : report.seconds) json["seconds_by_stage"][stage] = number(took);
  json["functions"] = functions_json(spmm, report);
  for (const fit::CurvePoint& point : report.curve)
    json["curve"].push_back({{"bases", point.bases},
                             {"functions_per_texel", number(point.functions)},
                             {"relative_rmse", number(point.error)}});
  return json;
}

std::string percent(double value) { return fmt::format("{:.2f} %", 100 * value); }

// What a designer will find in the basis table: the functions by their share of the light, fillers in one line.
void print_functions(const Spmm& spmm, const fit::FitReport& report) {
  const Json functions = functions_json(spmm, report);
  std::vector<size_t> order(functions.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto share = [&](size_t j) { return functions[j]["share"].get<double>(); };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return share(a) > share(b); });
  double fillers = 0;
  int count = 0;
  for (const size_t j : order) {
    if (report.filler[j]) {
      fillers += share(j);
      ++count;
    } else {
      fmt::print("{:6.1f} %  {:<20} {}\n", 100 * share(j), functions[j]["model"].get<std::string>(),
                 functions[j]["name"].get<std::string>());
    }
  }
  if (count > 0)
    fmt::print("{:6.1f} %  {} of the functions stand for no layer of the material (\"filler\")\n", 100 * fillers,
               count);
}

// Rows: functions of the material; columns: functions a texel.
void print_curve(const std::vector<fit::CurvePoint>& curve) {
  if (!curve.empty())
    fmt::print("relative RMSE of the functions alone, by functions of the material and of a texel:\n");
  for (size_t i = 0; i < curve.size(); ++i) {
    if (i == 0 || curve[i].bases != curve[i - 1].bases) fmt::print("{}{:5}:", i == 0 ? "" : "\n", curve[i].bases);
    fmt::print("  {:.1f} {}", curve[i].functions, percent(curve[i].error));
  }
  if (!curve.empty()) fmt::print("\n");
}

void print_text(const fit::FitResult& result, const FitText& text, double seconds) {
  const Spmm& spmm = result.spmm;
  const fit::FitReport& report = result.report;
  fmt::print("{}: {} x {} texels, {} clusters, {} functions, {:.2f} a texel, in {:.1f} s\n", text.output, spmm.width,
             spmm.height, spmm.clusters.size(), spmm.dictionary.size(), report.functions_per_texel, seconds);
  fmt::print("relative RMSE: functions {}", percent(report.errors.front()));
  if (report.errors.size() > 1) fmt::print(", with the residual's mean {}", percent(report.errors[1]));
  for (size_t k = 2; k < report.errors.size(); ++k)
    fmt::print(", {} term{} {}", k - 1, k == 2 ? "" : "s", percent(report.errors[k]));
  fmt::print("\n");
  print_functions(spmm, report);
  print_curve(report.curve);
}

// Where it came from, in a sentence that stays with the preset.
std::string provenance(const BtfInfo& info, const std::string& how_good) {
  std::string text = info.provenance;
  if (!text.empty() && text.back() != '.') text += '.';
  if (info.synthetic) text += text.empty() ? "Computed, not measured." : " Computed, not measured.";
  if (!text.empty()) text += ' ';
  return text + fmt::format("Fitted by vamp fit: {}.", how_good);
}

// A fitted material as a preset: what it is called, where it came from, how it looks.
Status save(const FitText& text, const BtfInfo& info, Spmm spmm, std::string how_good, const Image& thumbnail) {
  Preset preset;
  preset.name = !text.name.empty() ? text.name : !info.name.empty() ? info.name : fs::path(text.output).stem().string();
  preset.tags = {info.synthetic ? "synthetic" : "measured"};
  for (const std::string_view tag : list_option(text.tags)) preset.tags.emplace_back(tag);
  preset.provenance = provenance(info, how_good);
  preset.licence = info.licence;
  preset.fit = std::make_shared<const Spmm>(std::move(spmm));
  VAMP_TRY(preset.thumbnail_png, encode_png(thumbnail));
  return save_preset(preset, text.output);
}

// Reads the measurement and fits by fit(btf, progress) with a line of progress, then draws the material.
template <class Fit>
auto fitted(const FitText& text, std::optional<Result<Btf>>& btf, Image& thumbnail, const Fit& fit)
    -> std::decay_t<decltype(fit(**btf, nullptr))> {
  using Result = std::decay_t<decltype(fit(**btf, nullptr))>;
  catch_interrupts();
  Progress progress;
  std::optional<Result> result;
  run_with_progress("Fit", progress, [&] {
    progress.stage("Reading the measurement");
    btf = load_btf(text.btf, {}, &progress);
    if (!*btf) return;
    result = fit(**btf, &progress);
    if (!*result) return;
    progress.stage("Drawing the thumbnail");
    thumbnail = fit::material_swatch((*result)->spmm, kThumbnailSide, 2);
  });
  if (!*btf) return tl::unexpected(btf->error());
  return std::move(*result);
}

Status run_srf(const FitText& text, const fit::FitOptions& options, const CommonOptions& common) {
  std::optional<Result<Btf>> btf;
  Image thumbnail;
  VAMP_TRY(fit::SrfResult result, fitted(text, btf, thumbnail, [&](const Btf& from, Progress* progress) {
             const int clusters = text.clusters.empty() ? fit::SrfOptions().clusters : options.clusters;
             return fit::fit_srf(from, {clusters, options.seed, options.threads}, progress);
           }));
  const std::string how_good =
      fmt::format("as a spatial reflectance field (Ma et al. 2004): relative RMSE {}, {} as it is stored",
                  percent(result.report.exact_error), percent(result.report.stored_error));
  const uint64_t bytes = bytes_on_gpu(result.spmm);
  VAMP_CHECK_STATUS(save(text, (*btf)->info(), std::move(result.spmm), how_good, thumbnail));
  if (common.json) {
    Json json{{"file", text.output}, {"btf", text.btf}, {"kind", "srf"}, {"bytes_on_gpu", bytes}};
    json["relative_rmse"] = {{"exact", json_number(static_cast<float>(result.report.exact_error))},
                             {"stored", json_number(static_cast<float>(result.report.stored_error))}};
    fmt::print("{}", print_json(json));
  } else {
    fmt::print("{}: {}\n", text.output, how_good);
  }
  return {};
}

Status run_fit(const FitText& text, const CommonOptions& common) {
  VAMP_TRY(const fit::FitOptions options, read_options(text));
  VAMP_CHECK_STATUS(check_preset_output(text.output, text.name));
  if (text.kind == "srf") return run_srf(text, options, common);
  std::optional<Result<Btf>> btf;
  Image thumbnail;
  const auto start = std::chrono::steady_clock::now();
  VAMP_TRY(const fit::FitResult result, fitted(text, btf, thumbnail, [&](const Btf& from, Progress* progress) {
             return fit::fit_spmm(from, options, progress);
           }));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::string how_good = fmt::format("relative RMSE {} with the functions alone, {} with the residual",
                                           percent(result.report.errors.front()), percent(result.report.errors.back()));
  VAMP_CHECK_STATUS(save(text, (*btf)->info(), result.spmm, how_good, thumbnail));
  if (common.json) {
    fmt::print("{}", print_json(figures(result, text, seconds)));
  } else {
    print_text(result, text, seconds);
  }
  return {};
}

}  // namespace

void add_fit(CLI::App& app, CommonOptions& common, Action& action) {
  auto text = std::make_shared<FitText>();
  CLI::App* verb = app.add_subcommand("fit", "Make a material that can be edited from a measured BTF");
  verb->add_option("btf", text->btf, "Measured BTF: a file, or a folder of pictures")->type_name("BTF")->required();
  verb->add_option("-o,--output", text->output, "The preset: a .vamp file, or a folder")
      ->type_name("PRESET")
      ->required();
  verb->add_option("--name", text->name, "Name of the preset; the BTF's by default")->type_name("NAME");
  verb->add_option("--tags", text->tags, "Words to find the preset by")->type_name("WORD,WORD");
  verb->add_option("--clusters", text->clusters, "Groups of texels that share a residual; 32")->type_name("N");
  verb->add_option("--representatives", text->representatives, "Texels of each that lobes are fitted to; 8")
      ->type_name("N");
  verb->add_option("--functions", text->functions, "Most functions of a texel; 11")->type_name("N");
  verb->add_option("--pca", text->terms, "Terms of the residual, 0 to 4, or none for no residual; 4")->type_name("N");
  verb->add_option("--bases", text->bases, "Most functions of the material; 32")->type_name("N");
  verb->add_option("--error", text->error, "As few functions a texel as leave this relative RMSE")->type_name("E");
  verb->add_option("--weights", text->weights, "How weights are made sparse")
      ->type_name("WAY")
      ->check(CLI::IsMember({"elimination", "lasso", "stagewise"}))
      ->capture_default_str();
  verb->add_option("--kind", text->kind,
                   "spmm: functions and residual; srf: one Blinn-Phong and a vector a texel (light, hardly editable)")
      ->type_name("KIND")
      ->check(CLI::IsMember({"spmm", "srf"}))
      ->capture_default_str();
  verb->add_flag("--per-cluster", text->per_cluster, "Give each cluster functions of its own, --bases at most");
  verb->add_flag("--curve", text->curve, "Also tell what fewer functions, of a texel and of the material, would cost");
  verb->add_option("--leave-out", text->left_out, "Rings of directions that take no part, for tests: polar angles")
      ->type_name("DEGREES");
  verb->add_option("--seed", text->seed, "Of the random numbers: one seed, one material; 1")->type_name("N");
  verb->add_option("--threads", text->threads, "As many as the machine has by default")->type_name("N");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([text, &common, &action] { action = [text, &common] { return run_fit(*text, common); }; });
}

}  // namespace vamp
