#include "engine/fit/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include "engine/brdf/registry.h"
#include "engine/core/jobs.h"
#include "engine/fit/bake.h"
#include "engine/fit/dictionary.h"
#include "engine/fit/joint_weights.h"
#include "engine/fit/names.h"
#include "engine/material/reflectance.h"

namespace vamp::fit {
namespace {

// Functions a texel may use while lobes are looked for.
constexpr size_t kLobesOfATexel = 8, kFunctionsWhileRefining = 8;
// Texels that the dictionary is chosen and refined on, at least.
constexpr size_t kExemplars = 512;
// How often weights and residual are fitted to one another, and how strongly weights hold to what they were.
constexpr int kJointRounds = 2;
constexpr double kPull = 0.05;

// The stages of a fit and what they took.
class Stages {
 public:
  explicit Stages(FitReport& report) : report_(report) {}
  void done(const char* name) {
    const auto now = std::chrono::steady_clock::now();
    report_.seconds.emplace_back(name, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  FitReport& report_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Status check(const Btf& btf, const FitOptions& options) {
  VAMP_CHECK_STATUS(check_measurement(btf));
  const auto range = [](std::string_view option, int value, int low, int high) -> Status {
    if (value >= low && value <= high) return {};
    return fail(ErrorKind::usage, "", option, fmt::format("{} to {}", low, high), std::to_string(value));
  };
  VAMP_CHECK_STATUS(range("--clusters", options.clusters, 1, kMaxClusters));
  VAMP_CHECK_STATUS(range("--representatives", options.representatives, 1, 64));
  VAMP_CHECK_STATUS(range("--functions", options.functions, 1, 64));
  VAMP_CHECK_STATUS(range("--pca", options.terms, -1, kMaxResidualTerms));
  return range("--bases", options.bases, 1, 1024);
}

Exemplars exemplars_of(const Measurement& measurement, const std::vector<Representative>& representatives,
                       const LobeLimits& limits) {
  Exemplars exemplars{&measurement.pairs(), &measurement.roots(), limits,
                      Rows(representatives.size(), measurement.values())};
  for (size_t i = 0; i < representatives.size(); ++i) {
    float* row = exemplars.rows.row(i);
    measurement.read(representatives[i].texel, row);
    const auto root = static_cast<float>(std::sqrt(static_cast<double>(representatives[i].stands_for)));
    for (size_t k = 0; k < exemplars.rows.length; ++k) row[k] *= root;
  }
  return exemplars;
}

// Lobes of every representative.
std::vector<std::vector<Basis>> lobes_of(const Exemplars& exemplars, const Worker& worker, FitReport& report) {
  worker.stage("Fitting lobes");
  const LobeLibrary library = make_lobe_library(*exemplars.pairs, *exemplars.roots, exemplars.limits);
  LobeFitOptions options;
  options.max_lobes = kLobesOfATexel;
  std::vector<std::vector<Basis>> found(exemplars.rows.count);
  std::vector<double> errors(found.size());
  worker.each(found.size(), [&](size_t i) {
    const LobeFit fit =
        fit_lobes(*exemplars.pairs, *exemplars.roots, library, exemplars.limits, exemplars.rows.row(i), options);
    found[i] = fit.bases;
    errors[i] = fit.relative_error;
  });
  report.representative_error =
      std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(std::max<size_t>(errors.size(), 1));
  return found;
}

struct Dictionary {
  std::vector<Basis> bases;
  std::vector<std::vector<int>> allowed;  // a cluster; empty: all
};

Exemplars part_of(const Exemplars& exemplars, const std::vector<size_t>& rows) {
  Exemplars part{exemplars.pairs, exemplars.roots, exemplars.limits, Rows(rows.size(), exemplars.rows.length)};
  for (size_t i = 0; i < rows.size(); ++i)
    std::copy_n(exemplars.rows.row(rows[i]), exemplars.rows.length, part.rows.row(i));
  return part;
}

Dictionary make_dictionary(const std::vector<std::vector<Basis>>& lobes,
                           const std::vector<Representative>& representatives, const Exemplars& exemplars,
                           const std::vector<Representative>& judges, size_t clusters, const FitOptions& options,
                           const Worker& worker, FitReport& report) {
  DictionaryOptions choice;
  choice.bases = static_cast<size_t>(options.bases);
  choice.functions = std::min(kFunctionsWhileRefining, static_cast<size_t>(options.functions));
  Dictionary dictionary;
  const auto add = [&](size_t first_cluster, size_t end_cluster) {
    const auto inside = [&](const Representative& each) {
      return each.cluster >= first_cluster && each.cluster < end_cluster;
    };
    std::vector<Basis> candidates = {{"", default_lobe(Model::lambert), {0, 0, 1}, 0}};
    for (size_t i = 0; i < representatives.size(); ++i)
      if (inside(representatives[i])) candidates.insert(candidates.end(), lobes[i].begin(), lobes[i].end());
    std::vector<size_t> rows;
    for (size_t i = 0; i < judges.size(); ++i)
      if (inside(judges[i])) rows.push_back(i);
    const Exemplars part = part_of(exemplars, rows);
    candidates = without_repeats(candidates, part, choice.guard, worker);
    report.candidates += static_cast<int>(candidates.size());
    std::vector<Basis> chosen = choose_dictionary(candidates, part, choice, worker);
    std::vector<int> places(chosen.size());
    std::iota(places.begin(), places.end(), static_cast<int>(dictionary.bases.size()));
    dictionary.allowed.push_back(places);
    dictionary.bases.insert(dictionary.bases.end(), chosen.begin(), chosen.end());
  };
  if (options.per_cluster) {
    for (size_t c = 0; c < clusters; ++c) add(c, c + 1);
  } else {
    add(0, clusters);
    dictionary.allowed.clear();
  }
  return dictionary;
}

std::vector<TexelWeights> weigh(const std::vector<TexelCode>& codes, const Design& design, const FitOptions& options,
                                double square, FitReport& report) {
  const double fullest = error_of(codes, counts_at(codes, 0));
  report.all_functions_error = std::sqrt(fullest / square);
  const double wanted = options.error > 0 ? options.error * options.error * square
                                          : fullest * (1 + options.slack) * (1 + options.slack) + 1e-12 * square;
  const std::vector<size_t> counts = counts_at(codes, price_for(codes, wanted));
  const double left = error_of(codes, counts);
  report.errors = {std::sqrt(left / square)};
  std::vector<TexelWeights> weights(codes.size());
  report.histogram.assign(static_cast<size_t>(options.functions) + 1, 0);
  size_t total = 0;
  for (size_t t = 0; t < codes.size(); ++t) {
    const auto& order = codes[t].path.order;
    weights[t].bases.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(counts[t]));
    weights[t].weights = weights_of(codes[t], counts[t], design.gram, design.columns.count);
    total += counts[t];
    ++report.histogram[counts[t]];
  }
  report.functions_per_texel = static_cast<double>(total) / static_cast<double>(codes.size());
  return weights;
}

}  // namespace

Result<FitResult> fit_spmm(const Btf& btf, const FitOptions& options, Progress* progress) {
  VAMP_CHECK_STATUS(check(btf, options));
  FitResult result;
  FitReport& report = result.report;
  Stages stages(report);
  Worker worker{options.threads, progress};
  if (worker.threads <= 0) worker.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const Measurement measurement(btf, 0.5, options.left_out);
  const LobeLimits limits = LobeLimits::for_spacing(measurement.spacing());
  const auto stopped = [&] { return worker.cancelled(); };

  const Coordinates found = find_coordinates(measurement, {.seed = options.seed}, worker);
  report.square = found.square;
  stages.done("coordinates");
  if (stopped()) return JobQueue::cancelled_error();
  if (!(found.square > 0) || found.coordinates.length == 0)
    return fail(ErrorKind::bad_input, btf.info().name, "", "a material that reflects light", "zeros");

  worker.stage("Grouping texels that look alike");
  Clustering clustering = k_means(found.coordinates, static_cast<size_t>(options.clusters), options.seed, worker);
  const std::vector<Representative> representatives = find_representatives(
      found.coordinates, clustering, static_cast<size_t>(options.representatives), options.seed, worker);
  report.representatives = static_cast<int>(representatives.size());
  stages.done("clusters");
  if (stopped()) return JobQueue::cancelled_error();

  std::vector<std::vector<Basis>> lobes;
  {
    const Exemplars exemplars = exemplars_of(measurement, representatives, limits);
    lobes = lobes_of(exemplars, worker, report);
  }
  stages.done("lobes");
  if (stopped()) return JobQueue::cancelled_error();

  const size_t judges_each = std::max(static_cast<size_t>(options.representatives), kExemplars / clustering.count);
  const std::vector<Representative> judges =
      find_representatives(found.coordinates, clustering, judges_each, options.seed, worker);
  const Dictionary dictionary = make_dictionary(lobes, representatives, exemplars_of(measurement, judges, limits),
                                                judges, clustering.count, options, worker, report);
  stages.done("dictionary");
  if (stopped()) return JobQueue::cancelled_error();

  const Design design = make_design(dictionary.bases, measurement);
  const Coder coder = options.weights == Weights::elimination   ? Coder::elimination
                      : options.weights == Weights::group_lasso ? Coder::group_lasso
                                                                : Coder::stagewise_lasso;
  const std::vector<TexelCode> codes = code_texels(measurement, design, {dictionary.allowed, &clustering.of}, coder,
                                                   static_cast<size_t>(options.functions), worker);
  if (stopped()) return JobQueue::cancelled_error();
  std::vector<TexelWeights> weights = weigh(codes, design, options, found.square, report);
  // What an error of all texels is for one value.
  const double of_a_value = std::sqrt(found.square / static_cast<double>(measurement.texels() * measurement.values()));
  const std::vector<Step> steps = weight_steps(design, report.errors.front() * of_a_value);
  round_weights(steps, weights);
  stages.done("weights");
  if (options.curve) {
    report.curve = sparsity_curve(measurement, design, static_cast<size_t>(options.functions), found.square, worker);
    stages.done("curve");
    if (stopped()) return JobQueue::cancelled_error();
  }

  const bool with_residual = options.terms >= 0 && can_have_residual(measurement);
  const size_t terms = with_residual ? static_cast<size_t>(options.terms) : 0;
  ResidualFit residual;
  if (with_residual) {
    worker.stage(fmt::format("Sorting texels by what the functions leave, {:.1f} %", 100 * report.errors.front()));
    // Weights that reach an error by themselves stay as they are.
    const int rounds = options.error > 0 ? 0 : kJointRounds;
    for (int round = 0; !stopped(); ++round) {
      const Rows left = residual_coordinates(found, design, weights);
      // Clusters share a residual: from those that look alike on to those that leave alike.
      if (!options.per_cluster) fit_subspaces(left, terms, 15, worker, clustering);
      residual = find_tables(measurement, design, weights, left, clustering, terms, worker);
      if (round == rounds) break;
      refit_weights(measurement, design, codes, clustering, residual, kPull, worker, weights);
      round_weights(steps, weights);
    }
    if (stopped()) return JobQueue::cancelled_error();
    fit_coefficients(measurement, design, weights, clustering, worker, residual);
    report.errors.clear();
    for (size_t i = 0; i < terms + 2; ++i)
      report.errors.push_back(std::sqrt(std::max(residual.errors[i], 0.0) / found.square));
    stages.done("residual");
    if (stopped()) return JobQueue::cancelled_error();
  }

  result.spmm = bake(measurement, dictionary.bases, weights, clustering, with_residual ? &residual : nullptr, terms,
                     report.errors.back() * of_a_value);
  for (const Basis& basis : dictionary.bases) report.filler.push_back(is_filler(basis, limits));
  name_functions(result.spmm.dictionary, limits);
  result.spmm.clusters = name_clusters(cluster_colours(result.spmm));
  VAMP_CHECK_STATUS(validate(result.spmm, btf.info().name));
  return result;
}

}  // namespace vamp::fit
