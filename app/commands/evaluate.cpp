#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "engine/btf/load_btf.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/fit/quality.h"
#include "engine/material/preset.h"
#include "engine/material/tables.h"

namespace vamp {
namespace {

struct EvaluateText {
  std::string preset, btf, against, ranks, threads;
};

Json number(double value) { return json_number(static_cast<float>(value)); }

Json quality_json(const fit::Quality& quality, const Spmm& spmm, const EvaluateText& text) {
  Json json;
  json["preset"] = text.preset;
  json["btf"] = text.btf;
  if (!text.against.empty()) json["against"] = text.against;
  json["bases"] = spmm.dictionary.size();
  json["clusters"] = spmm.clusters.size();
  json["functions_per_texel"] = number(quality.functions_per_texel);
  json["ns_per_evaluation"] = number(quality.nanoseconds);
  json["bytes_on_gpu"] = bytes_on_gpu(spmm);
  json["pictures"] = quality.pictures;
  json["view_rings_degrees"] = quality.ring_angles;
  json["representations"] = Json::array();
  for (const fit::Representation& r : quality.representations) {
    Json row;
    row["name"] = r.name;
    row["bytes"] = r.bytes;
    row["relative_rmse"] = number(r.uniform);
    row["relative_rmse_weighted"] = number(r.weighted);
    if (r.held_out) row["relative_rmse_held_out"] = number(*r.held_out);
    row["relative_rmse_by_view_ring"] = Json::array();
    for (const double ring : r.rings) row["relative_rmse_by_view_ring"].push_back(number(ring));
    row["negative_share"] = number(r.negative);
    if (quality.pictures > 0) {
      row["psnr"] = number(r.psnr);
      row["mssim"] = number(r.mssim);
      row["psnr_two_texels"] = number(r.half_psnr);
      row["mssim_two_texels"] = number(r.half_mssim);
    }
    json["representations"].push_back(std::move(row));
  }
  return json;
}

void print_text(const fit::Quality& quality, const Spmm& spmm) {
  fmt::print("{} functions, {:.2f} a texel; {:.0f} ns for an evaluation on this computer\n", spmm.dictionary.size(),
             quality.functions_per_texel, quality.nanoseconds);
  fmt::print("{:<14}{:>10}{:>9}{:>9}{:>9}{:>8}{:>8}{:>8}{:>8}{:>10}\n", "", "KiB", "RMSE %", "wtd. %", "held %", "PSNR",
             "MSSIM", "PSNR/2", "MSSIM/2", "below 0 %");
  for (const fit::Representation& r : quality.representations)
    fmt::print("{:<14}{:>10}{:>9.2f}{:>9.2f}{:>9}{:>8.2f}{:>8.3f}{:>8.2f}{:>8.3f}{:>10.2f}\n", r.name, r.bytes / 1024,
               100 * r.uniform, 100 * r.weighted, r.held_out ? fmt::format("{:.2f}", 100 * *r.held_out) : "-", r.psnr,
               r.mssim, r.half_psnr, r.half_mssim, 100 * r.negative);
  if (quality.pictures == 0) fmt::print("The texture is too small for pictures.\n");
}

Status run_evaluate(const EvaluateText& text, const CommonOptions& common) {
  fit::QualityOptions options;
  if (!text.ranks.empty()) {
    options.ranks.clear();
    for (const std::string_view rank : list_option(text.ranks)) {
      VAMP_TRY(const uint32_t value, count_option(rank, "--ranks", 1, 512));
      options.ranks.push_back(value);
    }
  }
  if (!text.threads.empty()) {
    VAMP_TRY(const uint32_t threads, count_option(text.threads, "--threads", 1, 256));
    options.threads = static_cast<int>(threads);
  }
  VAMP_TRY(const Preset preset, load_preset(text.preset));
  catch_interrupts();
  Progress progress;
  std::optional<Result<Btf>> btf, against;
  std::optional<Result<fit::Quality>> quality;
  run_with_progress("Evaluation", progress, [&] {
    btf = load_btf(text.btf, {}, &progress);
    if (!*btf) return;
    if (!text.against.empty()) {
      against = load_btf(text.against, {}, &progress);
      if (!*against) return;
    }
    quality = fit::measure_quality(*preset.fit, **btf, against ? &**against : nullptr, options, &progress);
  });
  if (!*btf) return tl::unexpected(btf->error());
  if (against && !*against) return tl::unexpected(against->error());
  if (!*quality) return tl::unexpected(quality->error());
  if (common.json) {
    fmt::print("{}", print_json(quality_json(**quality, *preset.fit, text)));
  } else {
    print_text(**quality, *preset.fit);
  }
  return {};
}

}  // namespace

void add_evaluate(CLI::App& app, CommonOptions& common, Action& action) {
  auto text = std::make_shared<EvaluateText>();
  CLI::App* verb = app.add_subcommand("evaluate", "Say how far a fitted material is from the BTF it was fitted to");
  verb->add_option("preset", text->preset, "The material: a .vamp file, or a folder")->type_name("PRESET")->required();
  verb->add_option("btf", text->btf, "What it was fitted to")->type_name("BTF")->required();
  verb->add_option("--against", text->against,
                   "Compare with this measurement of the same texels under other directions")
      ->type_name("BTF");
  verb->add_option("--ranks", text->ranks, "Of truncated SVDs beside that of equal bytes; 8,10")->type_name("N,N");
  verb->add_option("--threads", text->threads, "As many as the machine has by default")->type_name("N");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([text, &common, &action] { action = [text, &common] { return run_evaluate(*text, common); }; });
}

}  // namespace vamp
