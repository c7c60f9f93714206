#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "bench/measured.h"
#include "engine/brdf/registry.h"
#include "engine/btf/alta.h"
#include "engine/core/progress.h"
#include "engine/fit/lobe_fit.h"
#include "engine/fit/varpro.h"

namespace vamp {
namespace {

// One sample in so many is fitted to, the others are predicted.
constexpr size_t kOneIn = 4;
// The tape looks the same whatever way it is turned.
constexpr int kTurns = 3;
constexpr double kSpacing = 2 * std::numbers::pi / 180;  // of the samples about the peak

dvec3 turned(const dvec3& w, int turn) {
  const double phi = 2 * std::numbers::pi * turn / kTurns;
  return {w.x * std::cos(phi) - w.y * std::sin(phi), w.x * std::sin(phi) + w.y * std::cos(phi), w.z};
}

// Scattered samples as a table of all their views and lights in which most pairs weigh nothing.
struct Table {
  fit::Pairs pairs;
  std::vector<float> roots;  // 1 where a sample lies
  std::vector<float> row;    // three channels
  double square = 0;
};

Table table_of(const std::vector<BrdfSample>& samples, int turns) {
  Table table;
  std::map<std::pair<long, int>, size_t> lights;
  const auto key = [](const BrdfSample& s, int turn) { return std::pair(std::lround(1e4 * s.wi.z), turn); };
  for (const BrdfSample& sample : samples)
    for (int turn = 0; turn < turns; ++turn)
      if (lights.emplace(key(sample, turn), table.pairs.lights.size()).second)
        table.pairs.lights.emplace_back(turned(sample.wi, turn));
  for (const BrdfSample& sample : samples)
    for (int turn = 0; turn < turns; ++turn) table.pairs.views.emplace_back(turned(sample.wo, turn));
  const size_t count = table.pairs.count();
  table.roots.assign(count, 0);
  table.row.assign(3 * count, 0);
  size_t view = 0;
  for (const BrdfSample& sample : samples)
    for (int turn = 0; turn < turns; ++turn, ++view) {
      const size_t pair = view * table.pairs.lights.size() + lights[key(sample, turn)];
      table.roots[pair] = 1;
      for (size_t c = 0; c < 3; ++c) {
        table.row[c * count + pair] = sample.value[c];
        table.square += double{sample.value[c]} * double{sample.value[c]};
      }
    }
  return table;
}

}  // namespace

Status measure_tape(const std::filesystem::path& file, Report& report, Progress& progress) {
  progress.stage("Fitting the tape");
  VAMP_TRY(const BrdfSamples tape, read_alta(file));
  std::vector<BrdfSample> fitted, others;
  for (size_t i = 0; i < tape.samples.size(); ++i) (i % kOneIn == 0 ? fitted : others).push_back(tape.samples[i]);
  const Table seen = table_of(fitted, kTurns), unseen = table_of(others, 1);
  const fit::LobeLimits limits = fit::LobeLimits::for_spacing(kSpacing);
  const fit::LobeLibrary library = fit::make_lobe_library(seen.pairs, seen.roots, limits);

  report.table({"3M tape, lobes", "models", "error on the samples fitted to", "on the others"});
  report.data()["tape"] = Json::array();
  report.data()["tape_samples"] = tape.samples.size();
  std::vector<Basis> bases;
  for (const size_t lobes : {size_t{1}, size_t{2}, size_t{4}, size_t{8}}) {
    if (progress.cancelled()) return {};
    fit::LobeFitOptions options;
    options.max_lobes = lobes;
    const fit::LobeFit fit = fit::fit_lobes(seen.pairs, seen.roots, library, limits, seen.row.data(), options, bases);
    bases = fit.bases;
    // Weights from the samples fitted to, then the others at those weights.
    fit::LobeTargets targets{&seen.pairs, seen.roots.data(), {seen.row.data()}, 3};
    fit::VariableProjection projection(targets, limits);
    projection.evaluate(bases);
    const std::vector<double> weights = projection.weights();
    const size_t count = unseen.pairs.count();
    std::vector<float> column(count), sum(3 * count);
    std::map<std::string_view, int> models;
    for (size_t j = 0; j < bases.size(); ++j) {
      fit::evaluate_column(bases[j], unseen.pairs, unseen.roots.data(), column.data());
      for (size_t c = 0; c < 3; ++c)
        for (size_t p = 0; p < count; ++p)
          sum[c * count + p] += static_cast<float>(weights[c * bases.size() + j]) * column[p];
      ++models[model_row(bases[j].lobe.model).name];
    }
    std::string words;
    for (const auto& [name, times] : models) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", times, name);
    double error = 0;
    for (size_t i = 0; i < sum.size(); ++i) error += std::pow(double{sum[i]} - double{unseen.row[i]}, 2);
    const double predicted = std::sqrt(error / unseen.square);
    report.row({std::to_string(bases.size()), words, fmt::format("{:.1f} %", 100 * fit.relative_error),
                fmt::format("{:.1f} %", 100 * predicted)});
    report.data()["tape"].push_back({{"lobes", bases.size()}, {"fitted", fit.relative_error}, {"others", predicted}});
  }
  return {};
}

}  // namespace vamp
