#include "engine/fit/dictionary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/fit/elimination.h"

namespace vamp::fit {
namespace {

// Directions at every 3 degrees of the polar angle, some 1000 of them as views and a quarter of them as lights.
Pairs dense_pairs() {
  Pairs pairs;
  for (int i = 0; i < 29; ++i) {
    const double theta = (1.5 + 3 * i) * std::numbers::pi / 180;
    const int around = std::max(6, static_cast<int>(std::lround(72 * std::sin(theta))));
    for (int j = 0; j < around; ++j) {
      const double phi = 2 * std::numbers::pi * (j + 0.37 * i) / around;
      const vec3 w(static_cast<float>(std::sin(theta) * std::cos(phi)),
                   static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)));
      if (i % 2 == 0 && j % 2 == 0) pairs.views.push_back(w);
      if (i % 2 == 1 && j % 2 == 0) pairs.lights.push_back(w);
    }
  }
  return pairs;
}

double mean_square(const Basis& basis, const Pairs& pairs) {
  std::vector<float> column(pairs.count());
  evaluate_column(basis, pairs, nullptr, column.data());
  double sum = 0, weights = 0;
  size_t at = 0;
  for (const vec3& view : pairs.views)
    for (const vec3& light : pairs.lights) {
      const double weight = double{view.z} * double{light.z}, value = double{column[at++]};
      sum += weight * value * value;
      weights += weight;
    }
  return sum / weights;
}

// Products of candidates with themselves and with the exemplars' channels.
struct Products {
  size_t bases = 0;
  std::vector<double> gram;          // bases x bases
  std::vector<double> correlations;  // [texel][channel][basis]
  std::vector<double> squares;       // [texel]
};

Rows columns_of(const std::vector<Basis>& bases, const Exemplars& exemplars) {
  Rows columns(bases.size(), exemplars.pairs->count());
  for (size_t j = 0; j < bases.size(); ++j)
    evaluate_column(bases[j], *exemplars.pairs, exemplars.roots->data(), columns.row(j));
  return columns;
}

Products products_of(const std::vector<Basis>& bases, const Exemplars& exemplars, const Worker& worker) {
  const Rows columns = columns_of(bases, exemplars);
  Products products;
  const size_t p = products.bases = bases.size(), texels = exemplars.rows.count, length = columns.length;
  products.gram.resize(p * p);
  products.correlations.resize(texels * kChannels * p);
  products.squares.resize(texels);
  constexpr size_t kStrip = 32;
  worker.each((p + kStrip - 1) / kStrip, [&](size_t strip) {
    const size_t first = strip * kStrip, rows = std::min(kStrip, p - first);
    dot_rows(columns.row(first), rows, columns.row(0), p, length, products.gram.data() + first * p);
  });
  worker.each(texels, [&](size_t t) {
    const float* row = exemplars.rows.row(t);
    dot_rows(row, kChannels, columns.row(0), p, length, products.correlations.data() + t * kChannels * p);
    dot_rows(row, 1, row, 1, kChannels * length, &products.squares[t]);
  });
  return products;
}

// The functions that each exemplar uses when it may use `most`.
std::vector<std::vector<int>> supports_of(const Products& products, size_t most, const Worker& worker) {
  std::vector<std::vector<int>> supports(products.squares.size());
  worker.each(supports.size(), [&](size_t t) {
    Elimination elimination(products.gram.data(), products.bases);
    const TexelTarget target{products.correlations.data() + t * kChannels * products.bases, products.squares[t]};
    const SparsePath path = elimination.path(target, most);
    supports[t].assign(path.order.begin(), path.order.end());
  });
  return supports;
}

// Greedy choice: each round adds the candidate whose non-negative weights would take most from what is left of all
// exemplars together, and solves all weights again.
std::vector<size_t> choose_greedily(const Products& products, size_t count, const Worker& worker) {
  const size_t p = products.bases, texels = products.squares.size(), rows = texels * kChannels;
  std::vector<double> left = products.correlations;  // of the residual with every candidate
  std::vector<size_t> chosen;
  std::vector<bool> taken(p);
  std::vector<double> weights(rows * p);
  while (chosen.size() < std::min(count, p) && !worker.cancelled()) {
    std::vector<double> gains(p);
    for (size_t r = 0; r < rows; ++r)
      for (size_t j = 0; j < p; ++j) gains[j] += std::pow(std::max(left[r * p + j], 0.0), 2);
    for (size_t j = 0; j < p; ++j) gains[j] = taken[j] ? 0 : gains[j] / products.gram[j * p + j];
    const auto best = static_cast<size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
    if (!(gains[best] > 0)) break;
    taken[best] = true;
    chosen.push_back(best);
    std::vector<int> support(chosen.begin(), chosen.end());
    worker.each(texels, [&](size_t t) {
      Nnls nnls(products.gram.data(), p);
      for (size_t r = t * kChannels; r < (t + 1) * kChannels; ++r) {
        double* a = weights.data() + r * p;
        nnls.solve(support, products.correlations.data() + r * p, a);
        std::copy_n(products.correlations.data() + r * p, p, left.data() + r * p);
        for (const int i : nnls.passive())
          for (size_t j = 0; j < p; ++j) left[r * p + j] -= a[i] * products.gram[static_cast<size_t>(i) * p + j];
      }
    });
  }
  return chosen;
}

}  // namespace

bool explodes(const Basis& basis, const Pairs& pairs, double guard) {
  static const Pairs dense = dense_pairs();
  return mean_square(basis, dense) > guard * guard * mean_square(basis, pairs);
}

std::vector<Basis> without_repeats(const std::vector<Basis>& bases, const Exemplars& exemplars, double guard,
                                   const Worker& worker) {
  // Candidates come in groups, each of which is multiplied with what was kept before it and with itself.
  constexpr size_t kGroup = 64, kStrip = 4;
  const Worker inside{worker.threads, nullptr};
  worker.stage("Telling the functions apart");
  std::vector<Basis> kept;
  Rows columns(bases.size(), exemplars.pairs->count());
  std::vector<double> lengths;
  for (size_t first = 0; first < bases.size() && !worker.cancelled(); first += kGroup) {
    const size_t count = std::min(kGroup, bases.size() - first), before = kept.size(), known = before + count;
    std::array<bool, kGroup> good{};
    worker.done(static_cast<int>(first), static_cast<int>(bases.size()));
    inside.each(count, [&](size_t i) {
      const Basis& basis = bases[first + i];
      good[i] = !explodes(basis, *exemplars.pairs, guard);
      evaluate_column(basis, *exemplars.pairs, exemplars.roots->data(), columns.row(before + i));
    });
    std::vector<double> products(count * known);
    inside.each((count + kStrip - 1) / kStrip, [&](size_t strip) {
      const size_t row = strip * kStrip;
      dot_rows(columns.row(before + row), std::min(kStrip, count - row), columns.row(0), known, columns.length,
               products.data() + row * known);
    });
    std::vector<size_t> chosen;  // of the group
    for (size_t i = 0; i < count; ++i) {
      const double* product = products.data() + i * known;
      const double length = std::sqrt(product[before + i]);
      if (!good[i] || !(length > 0)) continue;
      const auto repeats = [&](size_t at, double other) { return product[at] > 0.9995 * length * other; };
      bool again = false;
      for (size_t j = 0; j < before && !again; ++j) again = repeats(j, lengths[j]);
      for (size_t k = 0; k < chosen.size() && !again; ++k) again = repeats(before + chosen[k], lengths[before + k]);
      if (again) continue;
      chosen.push_back(i);
      kept.push_back(bases[first + i]);
      lengths.push_back(length);
    }
    for (size_t k = 0; k < chosen.size(); ++k)
      if (chosen[k] != k) std::copy_n(columns.row(before + chosen[k]), columns.length, columns.row(before + k));
  }
  return kept;
}

std::vector<Basis> choose_dictionary(const std::vector<Basis>& candidates, const Exemplars& exemplars,
                                     const DictionaryOptions& options, const Worker& worker) {
  worker.stage("Choosing the functions");
  const Products all = products_of(candidates, exemplars, worker);
  std::vector<Basis> dictionary;
  for (const size_t j : choose_greedily(all, options.bases, worker)) dictionary.push_back(candidates[j]);

  const double square = std::accumulate(all.squares.begin(), all.squares.end(), 0.0);
  LobeTargets targets{exemplars.pairs, exemplars.roots->data(), {}, kChannels};
  for (size_t t = 0; t < exemplars.rows.count; ++t) targets.texels.push_back(exemplars.rows.row(t));
  VariableProjection projection(targets, exemplars.limits);
  for (int round = 0; round < options.rounds && !worker.cancelled(); ++round) {
    const Products products = products_of(dictionary, exemplars, worker);
    projection.restrict_to(supports_of(products, options.functions, worker));
    std::vector<Basis> refined = dictionary;
    const double error = projection.improve(refined, 0, 3);
    worker.stage(fmt::format("Refining the functions, {:.1f} % left", 100 * std::sqrt(error / square)));
    worker.done(round + 1, options.rounds);
    for (size_t j = 0; j < dictionary.size(); ++j)
      if (!explodes(refined[j], *exemplars.pairs, options.guard)) dictionary[j] = refined[j];
  }
  return dictionary;
}

}  // namespace vamp::fit
