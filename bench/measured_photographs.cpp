#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <thread>

#include "bench/measured.h"
#include "engine/brdf/registry.h"
#include "engine/btf/load_btf.h"
#include "engine/btf/ptm.h"
#include "engine/core/progress.h"
#include "engine/fit/coding.h"
#include "engine/fit/coordinates.h"
#include "engine/fit/dictionary.h"

namespace vamp {
namespace {

// Every fourth photograph is kept back.
bool is_held_out(size_t light) { return light % 4 == 3; }

constexpr size_t kClusters = 16, kRepresentatives = 4, kBases = 32;

double code_of(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  return 255 * (linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

// The photographs under some of the lights.
Result<Btf> some_lights(const Btf& all, const std::vector<size_t>& lights) {
  BtfInfo info = all.info();
  std::vector<dvec3> directions;
  for (const size_t light : lights) directions.push_back(all.info().lights[light]);
  info.lights = {"own", directions};
  VAMP_TRY(Btf some, Btf::in_memory(info));
  for (size_t t = 0; t < all.texel_count(); ++t)
    for (size_t l = 0; l < lights.size(); ++l)
      for (size_t c = 0; c < 3; ++c) some.writable_texel(t)[3 * l + c] = all.texel(t)[3 * lights[l] + c];
  return some;
}

// What a fit of a material does, for a single view: nothing is known of others, so that nothing guards them.
struct SingleViewFit {
  std::vector<Basis> dictionary;
  fit::Design design;
  std::vector<fit::TexelCode> codes;

  SingleViewFit(const fit::Measurement& measurement, size_t functions, const fit::Worker& worker) {
    constexpr double kNoGuard = 1e9;
    const fit::LobeLimits limits = fit::LobeLimits::for_spacing(measurement.spacing());
    const fit::Coordinates found = fit::find_coordinates(measurement, {.rank = 32}, worker);
    const fit::Clustering clusters = fit::k_means(found.coordinates, kClusters, 1, worker);
    const auto chosen = fit::find_representatives(found.coordinates, clusters, kRepresentatives, 1, worker);
    fit::Exemplars exemplars{&measurement.pairs(), &measurement.roots(), limits,
                             fit::Rows(chosen.size(), measurement.values())};
    const fit::LobeLibrary library = fit::make_lobe_library(measurement.pairs(), measurement.roots(), limits);
    std::vector<std::vector<Basis>> lobes(chosen.size());
    worker.each(chosen.size(), [&](size_t i) {
      measurement.read(chosen[i].texel, exemplars.rows.row(i));
      lobes[i] =
          fit::fit_lobes(measurement.pairs(), measurement.roots(), library, limits, exemplars.rows.row(i), {}).bases;
    });
    std::vector<Basis> candidates = {{"", default_lobe(Model::lambert), {0, 0, 1}, 0}};
    for (const auto& each : lobes) candidates.insert(candidates.end(), each.begin(), each.end());
    candidates = fit::without_repeats(candidates, exemplars, kNoGuard, worker);
    dictionary = fit::choose_dictionary(candidates, exemplars,
                                        {.bases = kBases, .functions = functions, .guard = kNoGuard}, worker);
    design = fit::make_design(dictionary, measurement);
    codes = fit::code_texels(measurement, design, {}, fit::Coder::elimination, functions, worker);
  }

  // A texel under some lights, [channel][light].
  void predict(size_t texel, const fit::Rows& columns, std::vector<float>& out) const {
    const fit::TexelCode& code = codes[texel];
    const size_t count = code.path.order.size();
    const std::vector<float> weights = fit::weights_of(code, count, design.gram, dictionary.size());
    std::fill(out.begin(), out.end(), 0.f);
    for (size_t i = 0; i < count; ++i)
      for (size_t c = 0; c < 3; ++c)
        for (size_t l = 0; l < columns.length; ++l)
          out[c * columns.length + l] += weights[3 * i + c] * columns.row(static_cast<size_t>(code.path.order[i]))[l];
  }
};

double psnr(double squares, size_t count) {
  return 10 * std::log10(255.0 * 255.0 * static_cast<double>(count) / squares);
}

}  // namespace

Status measure_photographs(const std::filesystem::path& list, Report& report, Progress& progress) {
  progress.stage("Reading photographs");
  VAMP_TRY(const Btf all, load_btf(list, {}, &progress));
  std::vector<size_t> seen, held_out;
  for (size_t l = 0; l < all.light_count(); ++l) (is_held_out(l) ? held_out : seen).push_back(l);
  VAMP_TRY(const Btf btf, some_lights(all, seen));
  VAMP_TRY(const Ptm ptm, fit_ptm(all, seen, true, PictureCurve::srgb));
  const fit::Worker worker{static_cast<int>(std::max(1u, std::thread::hardware_concurrency())), &progress};
  const fit::Measurement measurement(btf);
  fit::Pairs pairs{measurement.pairs().views, {}};
  for (const size_t light : held_out) pairs.lights.emplace_back(all.info().lights[light]);

  report.table(
      {fmt::format("{} photographs predicted from {}", held_out.size(), seen.size()), "numbers a texel", "PSNR dB"});
  report.data()["photographs"] = Json::array();
  const auto add = [&](const std::string& name, double numbers, double decibels) {
    report.row({name, fmt::format("{:.1f}", numbers), fmt::format("{:.2f}", decibels)});
    report.data()["photographs"].push_back({{"name", name}, {"numbers", numbers}, {"psnr", decibels}});
  };
  // Squared error of codes over all texels, held-out lights and channels.
  const size_t count = all.texel_count() * held_out.size() * 3;
  const auto error_of = [&](const auto& predict) {
    double squares = 0;
    std::vector<float> out(3 * held_out.size());
    for (size_t t = 0; t < all.texel_count(); ++t) {
      predict(t, out);
      for (size_t c = 0; c < 3; ++c)
        for (size_t l = 0; l < held_out.size(); ++l)
          squares += std::pow(double{out[c * held_out.size() + l]} - code_of(double{all.at(t, 0, held_out[l], c)}), 2);
    }
    return psnr(squares, count);
  };
  add("mean of the photographs", 3, error_of([&](size_t t, std::vector<float>& out) {
        for (size_t c = 0; c < 3; ++c) {
          double mean = 0;
          for (const size_t l : seen) mean += code_of(double{all.at(t, 0, l, c)}) / static_cast<double>(seen.size());
          std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(c * held_out.size()), held_out.size(),
                      static_cast<float>(mean));
        }
      }));
  add("polynomial texture map (LRGB)", 9, error_of([&](size_t t, std::vector<float>& out) {
        for (size_t c = 0; c < 3; ++c)
          for (size_t l = 0; l < held_out.size(); ++l)
            out[c * held_out.size() + l] =
                static_cast<float>(std::clamp(ptm.value(t, c, all.info().lights[held_out[l]]), 0.0, 255.0));
      }));
  for (const size_t functions : {size_t{3}, size_t{6}}) {
    const SingleViewFit fitted(measurement, functions, worker);
    if (progress.cancelled()) return {};
    fit::Rows columns(fitted.dictionary.size(), held_out.size());
    for (size_t j = 0; j < columns.count; ++j)
      fit::evaluate_column(fitted.dictionary[j], pairs, nullptr, columns.row(j));
    size_t used = 0;
    for (const fit::TexelCode& code : fitted.codes) used += code.path.order.size();
    const double decibels = error_of([&](size_t t, std::vector<float>& out) {
      fitted.predict(t, columns, out);
      for (float& value : out) value = static_cast<float>(code_of(double{value}));
    });
    add(fmt::format("at most {} of {} functions", functions, fitted.dictionary.size()),
        4.0 * static_cast<double>(used) / static_cast<double>(fitted.codes.size()), decibels);
  }
  return {};
}

}  // namespace vamp
