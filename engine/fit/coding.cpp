#include "engine/fit/coding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/check.h"
#include "engine/fit/lasso.h"

namespace vamp::fit {
namespace {

constexpr size_t kBlock = 64;  // texels read at a time

// The part of a Gram matrix over some of its columns.
std::vector<double> part_of(const std::vector<double>& gram, size_t p, const std::vector<int>& columns) {
  std::vector<double> part;
  part.reserve(columns.size() * columns.size());
  for (const int i : columns)
    for (const int j : columns) part.push_back(gram[static_cast<size_t>(i) * p + static_cast<size_t>(j)]);
  return part;
}

SparsePath path_by(Coder coder, const std::vector<double>& gram, size_t p, const TexelTarget& target, size_t most) {
  switch (coder) {
    case Coder::elimination:
      break;
    case Coder::group_lasso:
      return group_lasso_path(gram.data(), p, target, most);
    case Coder::stagewise_lasso:
      return stagewise_lasso_path(gram.data(), p, target, most);
  }
  return Elimination(gram.data(), p).path(target, most);
}

// The most functions worth their price: the minimum of error + price * functions.
size_t best_count(const SparsePath& path, double price) {
  size_t best = 0;
  double least = double{path.errors[0]};
  for (size_t m = 1; m < path.errors.size(); ++m)
    if (const double cost = double{path.errors[m]} + price * static_cast<double>(m); cost < least)
      best = m, least = cost;
  return best;
}

}  // namespace

Design make_design(const std::vector<Basis>& dictionary, const Measurement& measurement) {
  Design design{Rows(dictionary.size(), measurement.pair_count()),
                std::vector<double>(dictionary.size() * dictionary.size())};
  for (size_t j = 0; j < dictionary.size(); ++j)
    evaluate_column(dictionary[j], measurement.pairs(), measurement.roots().data(), design.columns.row(j));
  gram_rows(design.columns.row(0), dictionary.size(), design.columns.length, design.gram.data());
  return design;
}

std::vector<TexelCode> code_texels(const Measurement& measurement, const Design& design, const CodingGroups& groups,
                                   Coder coder, size_t most, const Worker& worker) {
  worker.stage("Weighing the functions of every texel");
  const size_t p = design.columns.count, texels = measurement.texels();
  // Gram matrices of the groups, or the one of all.
  std::vector<std::vector<int>> allowed = groups.allowed;
  if (allowed.empty()) {
    allowed.emplace_back(p);
    std::iota(allowed[0].begin(), allowed[0].end(), 0);
  }
  std::vector<std::vector<double>> grams;
  for (const auto& columns : allowed) grams.push_back(part_of(design.gram, p, columns));

  std::vector<TexelCode> codes(texels);
  worker.each((texels + kBlock - 1) / kBlock, [&](size_t block) {
    std::vector<float> row(measurement.values());
    std::vector<double> all(kChannels * p), correlations;
    for (size_t t = block * kBlock; t < std::min(texels, (block + 1) * kBlock); ++t) {
      measurement.read(t, row.data());
      dot_rows(row.data(), kChannels, design.columns.row(0), p, design.columns.length, all.data());
      const size_t group = groups.allowed.empty() ? 0 : (*groups.group_of)[t];
      const std::vector<int>& columns = allowed[group];
      correlations.clear();
      for (size_t c = 0; c < kChannels; ++c)
        for (const int j : columns) correlations.push_back(all[c * p + static_cast<size_t>(j)]);
      TexelTarget target{correlations.data(), 0};
      dot_rows(row.data(), 1, row.data(), 1, row.size(), &target.square);
      TexelCode& code = codes[t];
      code.path = path_by(coder, grams[group], columns.size(), target, most);
      for (uint16_t& basis : code.path.order) basis = static_cast<uint16_t>(columns[basis]);
      for (size_t c = 0; c < kChannels; ++c)
        for (const uint16_t basis : code.path.order)
          code.correlations.push_back(static_cast<float>(all[c * p + basis]));
    }
    measurement.btf().forget(block * kBlock, std::min(kBlock, texels - block * kBlock));
  });
  return codes;
}

std::vector<size_t> counts_at(const std::vector<TexelCode>& codes, double price) {
  std::vector<size_t> counts;
  counts.reserve(codes.size());
  for (const TexelCode& code : codes) counts.push_back(best_count(code.path, price));
  return counts;
}

double error_of(const std::vector<TexelCode>& codes, const std::vector<size_t>& counts) {
  double error = 0;
  for (size_t t = 0; t < codes.size(); ++t) error += double{codes[t].path.errors[counts[t]]};
  return error;
}

double price_for(const std::vector<TexelCode>& codes, double error) {
  double high = 0;
  for (const TexelCode& code : codes) high = std::max(high, double{code.path.errors[0]});
  double low = high * 1e-12;
  if (error_of(codes, counts_at(codes, low)) > error) return 0;
  for (int i = 0; i < 50; ++i) {
    const double middle = std::sqrt(low * high);
    (error_of(codes, counts_at(codes, middle)) <= error ? low : high) = middle;
  }
  return low;
}

std::vector<float> weights_of(const TexelCode& code, size_t count, const std::vector<double>& gram, size_t bases) {
  const size_t path = code.path.order.size();
  CHECK(count <= path);
  std::vector<double> part(count * count), target(count), a(count);
  for (size_t i = 0; i < count; ++i)
    for (size_t j = 0; j < count; ++j) part[i * count + j] = gram[code.path.order[i] * bases + code.path.order[j]];
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  Nnls nnls(part.data(), count);
  std::vector<float> weights(count * kChannels);
  for (size_t c = 0; c < kChannels; ++c) {
    for (size_t i = 0; i < count; ++i) target[i] = double{code.correlations[c * path + i]};
    std::fill(a.begin(), a.end(), 0.0);
    nnls.solve(all, target.data(), a.data());
    for (size_t i = 0; i < count; ++i) weights[i * kChannels + c] = static_cast<float>(a[i]);
  }
  return weights;
}

}  // namespace vamp::fit
