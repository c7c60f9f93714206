#include "bench/edits.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <thread>

#include "bench/changes.h"
#include "bench/temporary_folder.h"
#include "engine/acquire/acquire.h"
#include "engine/acquire/structure.h"
#include "engine/core/hash.h"
#include "engine/core/jobs.h"
#include "engine/fit/fit.h"
#include "engine/fit/measurement.h"
#include "engine/fit/parallel.h"
#include "engine/fit/represent.h"

namespace vamp {
namespace {

// Facets across a texel: as vamp acquire has it.
constexpr int kDetail = 6;

Result<std::unique_ptr<acquire::Structure>> structure_of(const Change& change, const MesoSettings& settings) {
  VAMP_TRY(std::unique_ptr<acquire::Structure> structure, acquire::make_structure(change.meso));
  for (const auto& [name, value] : settings)
    VAMP_CHECK_STATUS(
        std::visit([&, &setting = name](const auto& each) { return acquire::set(*structure, setting, each); }, value));
  return structure;
}

// Measurements of materials, kept in a folder.
class Acquisitions {
 public:
  Acquisitions(const EditsBench& bench, fs::path folder) : bench_(bench), folder_(std::move(folder)) {}

  Result<Btf> get(const Change& change, const MesoSettings& settings, uint64_t seed, Progress& progress) const {
    VAMP_TRY(const auto structure, structure_of(change, settings));
    acquire::Options options;
    options.size = bench_.size;
    options.samples = bench_.samples;
    options.seed = seed;
    options.directions = ubo81();
    options.job = {{"meso", change.meso}, {"size", bench_.size}, {"samples", bench_.samples}, {"seed", seed}};
    for (const acquire::Setting& setting : structure->settings()) {
      const std::string name(setting.name);
      if (float* const* number = std::get_if<float*>(&setting.value))
        options.job[name] = **number;
      else if (const vec3* const colour = std::get<vec3*>(setting.value))
        options.job[name] = {colour->x, colour->y, colour->z};
    }
    const std::string job = options.job.dump();
    const fs::path file = folder_ / fmt::format("{}-{:016x}.btf", change.meso, hash64(std::as_bytes(std::span(job))));
    std::error_code code;
    if (!fs::exists(file, code)) {
      progress.stage("Measuring " + change.meso);
      VAMP_CHECK_STATUS(acquire::measure(structure->build(bench_.size * kDetail), options, file, progress));
    }
    return Btf::open(file);
  }

 private:
  const EditsBench& bench_;
  fs::path folder_;
};

Result<SpmmPtr> fit_of(const Btf& btf, const EditsBench& bench, Progress& progress) {
  fit::FitOptions options;
  options.clusters = bench.clusters;
  VAMP_TRY(fit::FitResult result, fit::fit_spmm(btf, options, &progress));
  return std::make_shared<const Spmm>(std::move(result.spmm));
}

// What is compared with the truth: a material under an edit layer, with or without residual.
struct Candidate {
  const Spmm* spmm;
  EditLayer edits;
  bool residual = true;
};

// Relative RMSE of each over all texels and pairs, models clamped at 0.
Result<std::vector<double>> errors_of(const std::vector<Candidate>& candidates, const Btf& truth, Progress& progress) {
  const fit::Measurement measurement(truth, 0);
  std::vector<fit::SpmmValues> models;
  for (const Candidate& each : candidates) {
    VAMP_TRY(fit::SpmmValues values, fit::SpmmValues::make(*each.spmm, measurement.pairs(), each.edits));
    models.push_back(std::move(values));
  }
  constexpr size_t kGroups = 16;
  const size_t values = measurement.values(), texels = measurement.texels();
  std::vector<std::vector<double>> sums(kGroups, std::vector<double>(models.size() + 1));
  progress.stage("Comparing");
  const fit::Worker worker{static_cast<int>(std::max(1u, std::thread::hardware_concurrency())), &progress};
  worker.each(kGroups, [&](size_t group) {
    std::vector<float> data(values), row(values);
    for (size_t t = texels * group / kGroups; t < texels * (group + 1) / kGroups; ++t) {
      measurement.read(t, data.data());
      for (const float value : data) sums[group].back() += double{value * value};
      for (size_t i = 0; i < models.size(); ++i) {
        models[i].functions(t, row.data());
        for (int k = 0; candidates[i].residual && k <= models[i].terms(); ++k) models[i].add_residual(t, k, row.data());
        for (size_t v = 0; v < values; ++v) {
          const float difference = std::max(row[v], 0.f) - data[v];
          sums[group][i] += double{difference * difference};
        }
      }
    }
  });
  std::vector<double> errors(models.size());
  double square = 0;
  for (const auto& sum : sums) square += sum.back();
  for (size_t i = 0; i < models.size(); ++i) {
    for (const auto& sum : sums) errors[i] += sum[i];
    errors[i] = std::sqrt(errors[i] / square);
  }
  return errors;
}

// Relative standard error of one of two acquisitions of the same material.
double noise_of(const Btf& one, const Btf& two) {
  double difference = 0, square = 0;
  std::vector<float> a(one.values_per_texel()), b(a);
  for (size_t t = 0; t < one.texel_count(); ++t) {
    one.read_texel(t, a), two.read_texel(t, b);
    for (size_t i = 0; i < a.size(); ++i) {
      difference += std::pow(double{a[i]} - double{b[i]}, 2);
      square += double{a[i]} * double{b[i]};
    }
  }
  return std::sqrt(0.5 * difference / square);
}

EditLayer keeping(EditLayer edits) {
  edits.residual_policy = ResidualPolicy::keep;
  return edits;
}

std::string percent(double error) { return fmt::format("{:.1f}", 100 * error); }

}  // namespace

Result<Report> bench_edits(const EditsBench& bench, Progress& progress) {
  std::optional<TemporaryFolder> temporary;
  fs::path folder = bench.cache;
  if (folder.empty()) {
    VAMP_TRY(temporary, TemporaryFolder::make());
    folder = temporary->path();
  }
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return fail(ErrorKind::io, folder.string(), "", "a folder for acquisitions", code.message());
  const Acquisitions acquisitions(bench, folder);
  Report report("edits",
                fmt::format("{} x {} texels, 81 x 81 directions, {} paths a texel and view, fits with {} clusters; "
                            "relative RMSE in % against an acquisition of the changed material that no fit has seen, "
                            "the noise of its paths included.",
                            bench.size, bench.size, bench.samples, bench.clusters));
  report.table({"what changes", "no edit", "gains alone", "functions, edited", "residual kept", "residual follows",
                "fresh fit", "times fresh", "noise", "times fresh, noise taken off"});
  std::map<std::string, SpmmPtr> fits;  // of the materials as they were, by what they were made of
  int within = 0, of = 0;
  report.data()["edits"] = Json::array();
  for (const Change& change : changes()) {
    VAMP_TRY(const Btf before, acquisitions.get(change, change.before, 1, progress));
    VAMP_TRY(const Btf after, acquisitions.get(change, change.after, 2, progress));
    VAMP_TRY(const Btf truth, acquisitions.get(change, change.after, 3, progress));
    SpmmPtr& fitted = fits[before.info().provenance];
    if (fitted == nullptr) {
      VAMP_TRY(fitted, fit_of(before, bench, progress));
    }
    VAMP_TRY(const SpmmPtr fresh, fit_of(after, bench, progress));
    if (progress.cancelled()) return JobQueue::cancelled_error();
    const EditLayer sliders = change.make(*fitted), edits = change.pigment ? EditLayer() : sliders;
    const Spmm edited = change.pigment ? with_pigment(*fitted, *change.pigment) : *fitted;
    Spmm kept = edited;
    kept.residual = fitted->residual;
    const std::vector<Candidate> candidates = {{fitted.get(), {}}, {&edited, edits, false}, {&kept, keeping(edits)},
                                               {&edited, edits},   {fresh.get(), {}},       {fitted.get(), sliders}};
    VAMP_TRY(const std::vector<double> errors, errors_of(candidates, truth, progress));
    if (progress.cancelled()) return JobQueue::cancelled_error();
    const double ratio = errors[3] / errors[4], noise = noise_of(after, truth);
    // Neither has seen the truth's noise, so that it adds to both as squares do.
    const double clean = std::sqrt((errors[3] * errors[3] - noise * noise) / (errors[4] * errors[4] - noise * noise));
    report.row({change.name, percent(errors[0]), change.pigment ? percent(errors[5]) : "-", percent(errors[1]),
                percent(errors[2]), percent(errors[3]), percent(errors[4]), fmt::format("{:.2f}", ratio),
                percent(noise), fmt::format("{:.2f}", clean)});
    ++of;
    if (ratio <= 1.5 && errors[3] < errors[2]) ++within;
    const auto number = [](double value) { return json_number(static_cast<float>(value)); };
    report.data()["edits"].push_back({{"change", change.name},
                                      {"edit", change.edit},
                                      {"unedited", number(errors[0])},
                                      {"gains_alone", number(errors[5])},
                                      {"functions", number(errors[1])},
                                      {"residual_kept", number(errors[2])},
                                      {"residual_follows", number(errors[3])},
                                      {"fresh_fit", number(errors[4])},
                                      {"noise", number(noise)},
                                      {"times_fresh_without_noise", number(clean)}});
  }
  report.remark(
      fmt::format("{} of {} edits are at most 1.5 times as far off as a fresh fit and nearer than with the residual "
                  "left alone.",
                  within, of));
  report.data()["within"] = within;
  return report;
}

}  // namespace vamp
