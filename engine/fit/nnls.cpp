#include "engine/fit/nnls.h"

#include <algorithm>
#include <cmath>

namespace vamp::fit {
namespace {

double* row_of(std::vector<double>& factor, size_t i) { return factor.data() + i * (i + 1) / 2; }
const double* row_of(const std::vector<double>& factor, size_t i) { return factor.data() + i * (i + 1) / 2; }

}  // namespace

// Grows the factor by one column; false where the column is a combination of the others to rounding.
bool Nnls::append(int column) {
  const size_t n = passive_.size();
  factor_.resize((n + 1) * (n + 2) / 2);
  double* last = row_of(factor_, n);
  double rest = entry(column, column);
  for (size_t i = 0; i < n; ++i) {
    const double* row = row_of(factor_, i);
    double value = entry(column, passive_[i]);
    for (size_t k = 0; k < i; ++k) value -= last[k] * row[k];
    last[i] = value / row[i];
    rest -= last[i] * last[i];
  }
  if (!(rest > 1e-12 * entry(column, column))) return false;
  last[n] = std::sqrt(rest);
  passive_.push_back(column);
  return true;
}

void Nnls::refactor() {
  std::vector<int> columns;
  columns.swap(passive_);
  for (const int column : columns) append(column);
}

void Nnls::solve_passive(const double* target) {
  const size_t n = passive_.size();
  solution_.resize(n);
  for (size_t i = 0; i < n; ++i) {
    const double* row = row_of(factor_, i);
    double value = target[passive_[i]];
    for (size_t k = 0; k < i; ++k) value -= row[k] * solution_[k];
    solution_[i] = value / row[i];
  }
  for (size_t i = n; i-- > 0;) {
    solution_[i] /= row_of(factor_, i)[i];
    for (size_t k = 0; k < i; ++k) solution_[k] -= row_of(factor_, i)[k] * solution_[i];
  }
}

// Moves from `a` towards the solution as far as all weights stay positive, and drops the columns that hit 0.
void Nnls::step(double* a) {
  double reach = 1;
  for (size_t i = 0; i < passive_.size(); ++i) {
    const double from = a[passive_[i]];
    if (solution_[i] <= 0) reach = std::min(reach, from / (from - solution_[i]));
  }
  bool dropped = false;
  for (size_t i = 0; i < passive_.size(); ++i) {
    double& weight = a[passive_[i]];
    const bool out = solution_[i] <= 0 && weight <= reach * (weight - solution_[i]) * (1 + 1e-12);
    weight = out ? 0 : std::max(weight + reach * (solution_[i] - weight), 0.0);
    if (weight <= 0) dropped = true;
  }
  if (!dropped) return;
  std::erase_if(passive_, [&](int column) { return a[column] <= 0; });
  refactor();
}

void Nnls::solve(std::span<const int> allowed, const double* target, double* a) {
  passive_.clear();
  double scale = 0;
  std::vector<int> starters;
  for (const int j : allowed) {
    scale = std::max(scale, std::abs(target[j]));
    if (a[j] > 0) starters.push_back(j);
  }
  std::vector<double> start(starters.size());
  for (size_t i = 0; i < starters.size(); ++i) start[i] = a[starters[i]];
  std::fill(a, a + p_, 0.0);
  for (size_t i = 0; i < starters.size(); ++i)
    if (append(starters[i])) a[starters[i]] = start[i];

  const auto settle = [&] {
    while (!passive_.empty()) {
      solve_passive(target);
      if (std::all_of(solution_.begin(), solution_.end(), [](double v) { return v > 0; })) break;
      step(a);
    }
    for (size_t i = 0; i < passive_.size(); ++i) a[passive_[i]] = solution_[i];
  };
  settle();
  std::vector<int> refused;  // columns that rounding keeps out
  const size_t most = 4 * allowed.size() + 16;
  for (size_t round = 0; round < most; ++round) {
    int best = -1;
    double best_gain = 0;
    for (const int j : allowed) {
      if (a[j] > 0 || std::find(refused.begin(), refused.end(), j) != refused.end()) continue;
      double gradient = target[j];
      for (const int i : passive_) gradient -= gram_[static_cast<size_t>(i) * p_ + static_cast<size_t>(j)] * a[i];
      const double gain = gradient / std::sqrt(std::max(entry(j, j), 1e-300));
      if (gradient > 1e-10 * scale && gain > best_gain) best = j, best_gain = gain;
    }
    if (best < 0) break;
    if (!append(best)) {
      refused.push_back(best);
      continue;
    }
    settle();
    if (a[best] <= 0) refused.push_back(best);
  }
}

void Nnls::elimination_costs(std::vector<double>& costs) const {
  // (G^-1)_jj = the squared norm of column j of L^-1.
  const size_t n = passive_.size();
  costs.assign(n, 0);
  std::vector<double> column(n);
  for (size_t j = 0; j < n; ++j) {
    for (size_t i = j; i < n; ++i) {
      const double* row = row_of(factor_, i);
      double value = i == j ? 1 : 0;
      for (size_t k = j; k < i; ++k) value -= row[k] * column[k];
      column[i] = value / row[i];
      costs[j] += column[i] * column[i];
    }
    costs[j] = 1 / costs[j];
  }
}

}  // namespace vamp::fit
