#include "engine/fit/lobe_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/brdf/registry.h"

namespace vamp::fit {
namespace {

// Frames: the normal and rings of tilted ones.
std::vector<vec3> coarse_normals() {
  constexpr std::array<double, 5> kTilts = {0, 12, 25, 38, 52};
  constexpr std::array<int, 5> kAzimuths = {1, 6, 10, 12, 14};
  std::vector<vec3> normals;
  for (size_t ring = 0; ring < kTilts.size(); ++ring)
    for (int i = 0; i < kAzimuths[ring]; ++i) {
      const double tilt = kTilts[ring] * std::numbers::pi / 180, phi = 2 * std::numbers::pi * i / kAzimuths[ring];
      normals.emplace_back(static_cast<float>(std::sin(tilt) * std::cos(phi)),
                           static_cast<float>(std::sin(tilt) * std::sin(phi)), static_cast<float>(std::cos(tilt)));
    }
  return normals;
}

// Shapes: each model in a few widths, the directed ones at four tangents.
std::vector<Basis> coarse_shapes(const LobeLimits& limits) {
  std::vector<Basis> shapes;
  const auto add = [&](Model model, std::initializer_list<std::pair<size_t, double>> values, int tangents = 1) {
    Basis basis;
    basis.lobe = default_lobe(model);
    for (const auto& [slot, value] : values) basis.lobe.params[slot] = static_cast<float>(value);
    for (int i = 0; i < tangents; ++i) {
      basis.psi = static_cast<float>(std::numbers::pi * i / 4);
      shapes.push_back(basis);
    }
  };
  const double n = 0.9 * limits.max_exponent, w = 1.2 * limits.min_width;
  add(Model::lambert, {});
  add(Model::oren_nayar, {{1, 0.4}});
  add(Model::oren_nayar, {{1, 0.9}});
  for (const double exponent : {3.0, 10.0, std::sqrt(10 * n), n}) add(Model::blinn_phong, {{1, exponent}});
  for (const double width : {w, std::sqrt(0.6 * w), 0.6}) add(Model::ward, {{1, width}, {2, width}});
  add(Model::ward, {{1, w}, {2, 0.4}}, 4);
  add(Model::ward, {{1, 0.3}, {2, 0.8}}, 4);
  for (const double width : {w, std::sqrt(0.55 * w), 0.55, 0.9})
    for (const double f0 : {0.04, 0.4}) add(Model::cook_torrance, {{1, width}, {2, f0}});
  for (const double exponent : {3.0, 10.0, n}) add(Model::lafortune, {{4, exponent}});
  for (const double exponent : {3.0, 10.0}) {
    add(Model::lafortune, {{1, 1}, {2, 1}, {4, exponent}});
    add(Model::lafortune, {{1, 0}, {2, 0}, {4, exponent}});
  }
  add(Model::lafortune, {{1, -1}, {2, 0}, {4, 10}}, 4);
  for (const double f0 : {0.05, 0.5}) {
    for (const double exponent : {10.0, n}) add(Model::ashikhmin_shirley, {{0, f0}, {2, exponent}, {3, exponent}});
    add(Model::ashikhmin_shirley, {{0, f0}, {2, n}, {3, 5}}, 4);
  }
  return shapes;
}

// What the bases leave of a texel at these weights.
Rows leftover(const Pairs& pairs, const float* roots, const std::vector<Basis>& bases,
              const std::vector<double>& weights, const float* texel) {
  Rows rest(3, pairs.count()), column(1, pairs.count());
  std::copy(texel, texel + rest.data.size(), rest.data.begin());
  std::array<float, 3> minus;
  for (size_t j = 0; j < bases.size(); ++j) {
    for (size_t c = 0; c < 3; ++c) minus[c] = -static_cast<float>(weights[c * bases.size() + j]);
    evaluate_column(bases[j], pairs, roots, column.row(0));
    add_combinations(minus.data(), 3, column.row(0), 1, pairs.count(), rest.row(0));
  }
  return rest;
}

// The library's best atom of each model, the models in the order of what a non-negative weight of theirs gains.
std::vector<size_t> best_atoms(const LobeLibrary& library, const Rows& rest) {
  std::vector<double> products(library.bases.size() * 3);
  dot_rows(library.columns.row(0), library.bases.size(), rest.row(0), 3, rest.length, products.data());
  std::array<double, kModelCount> gain{};
  std::array<size_t, kModelCount> best{};
  for (size_t i = 0; i < library.bases.size(); ++i) {
    double sum = 0;
    for (size_t c = 0; c < 3; ++c) sum += std::pow(std::max(products[i * 3 + c], 0.0), 2);
    const auto model = static_cast<size_t>(library.bases[i].lobe.model);
    if (sum > gain[model]) gain[model] = sum, best[model] = i;
  }
  std::vector<size_t> models;
  for (size_t m = 0; m < gain.size(); ++m)
    if (gain[m] > 0) models.push_back(m);
  std::stable_sort(models.begin(), models.end(), [&](size_t a, size_t b) { return gain[a] > gain[b]; });
  std::vector<size_t> atoms;
  for (const size_t m : models) atoms.push_back(best[m]);
  return atoms;
}

// A lobe without weight has no gradient and would stay for ever.
void drop_dead(std::vector<Basis>& bases, const std::vector<double>& weights) {
  const size_t n = bases.size();
  std::vector<Basis> alive;
  for (size_t j = 0; j < n; ++j)
    if (weights[j] > 0 || weights[n + j] > 0 || weights[2 * n + j] > 0) alive.push_back(bases[j]);
  bases = std::move(alive);
}

}  // namespace

LobeLibrary make_lobe_library(const Pairs& pairs, const std::vector<float>& roots, const LobeLimits& limits) {
  LobeLibrary library;
  for (const vec3& normal : coarse_normals())
    for (Basis basis : coarse_shapes(limits)) {
      basis.normal = normal;
      library.bases.push_back(basis);
    }
  library.columns = Rows(library.bases.size(), pairs.count());
  for (size_t i = 0; i < library.bases.size(); ++i) {
    float* row = library.columns.row(i);
    evaluate_column(library.bases[i], pairs, roots.data(), row);
    double square = 0;
    dot_rows(row, 1, row, 1, pairs.count(), &square);
    const auto scale = square > 0 ? static_cast<float>(1 / std::sqrt(square)) : 0.f;
    for (size_t k = 0; k < pairs.count(); ++k) row[k] *= scale;
  }
  return library;
}

LobeFit fit_lobes(const Pairs& pairs, const std::vector<float>& roots, const LobeLibrary& library,
                  const LobeLimits& limits, const float* texel, const LobeFitOptions& options,
                  std::vector<Basis> bases) {
  VariableProjection projection({&pairs, roots.data(), {texel}, 3}, limits);
  double error = projection.evaluate(bases);
  if (!bases.empty()) {
    error = projection.improve(bases, 0, 8);
    drop_dead(bases, projection.weights());
    error = projection.evaluate(bases);
  }
  while (bases.size() < options.max_lobes && error > 1e-10 * projection.square()) {
    const Rows rest = leftover(pairs, roots.data(), bases, projection.weights(), texel);
    std::vector<size_t> atoms = best_atoms(library, rest);
    if (atoms.size() > options.candidates) atoms.resize(options.candidates);
    std::vector<Basis> best;
    double least = error;
    for (const size_t atom : atoms) {
      std::vector<Basis> tried = bases;
      tried.push_back(library.bases[atom]);
      const double now = projection.improve(tried, bases.size(), 5);
      if (now < least) least = now, best = std::move(tried);
    }
    if (best.empty()) break;
    const double before = error;
    error = projection.improve(best, 0, 8);
    bases = std::move(best);
    drop_dead(bases, projection.weights());
    error = projection.evaluate(bases);
    if (std::sqrt(error) > (1 - options.min_gain) * std::sqrt(before)) break;
  }
  error = projection.improve(bases, 0, 25);
  drop_dead(bases, projection.weights());
  return {std::move(bases), projection.square() > 0 ? std::sqrt(error / projection.square()) : 0};
}

}  // namespace vamp::fit
