#include "engine/fit/elimination.h"

#include <algorithm>
#include <numeric>

namespace vamp::fit {

Elimination::Elimination(const double* gram, size_t p) : gram_(gram), p_(p), solvers_(kChannels, Nnls(gram, p)) {}

double Elimination::weights(const TexelTarget& target, const std::vector<int>& support, std::vector<double>& a) {
  a.resize(kChannels * p_);
  double error = target.square;
  for (size_t c = 0; c < kChannels; ++c) {
    double* channel = a.data() + c * p_;
    const double* correlations = target.correlations + c * p_;
    solvers_[c].solve(support, correlations, channel);
    // At the solution a'Ga = a'c over the positive weights.
    for (const int j : solvers_[c].passive()) error -= channel[j] * correlations[j];
  }
  return std::max(error, 0.0);
}

SparsePath Elimination::path(const TexelTarget& target, size_t most) {
  std::vector<int> support(p_);
  std::iota(support.begin(), support.end(), 0);
  a_.assign(kChannels * p_, 0);
  SparsePath path;
  std::vector<uint16_t> removed;
  std::vector<float> errors;
  std::vector<double> cost(p_), costs;
  const auto note = [&](int basis, double error) {
    removed.push_back(static_cast<uint16_t>(basis));
    errors.push_back(static_cast<float>(error));
  };
  while (!support.empty()) {
    const double error = weights(target, support, a_);
    // Functions that lose their weight with the one before: a support with them is as good as one without.
    std::erase_if(support, [&](int j) {
      for (size_t c = 0; c < kChannels; ++c)
        if (a_[c * p_ + static_cast<size_t>(j)] > 0) return false;
      if (!removed.empty()) note(j, error);
      return true;
    });
    if (support.empty()) break;
    std::fill(cost.begin(), cost.end(), 0);
    for (size_t c = 0; c < kChannels; ++c) {
      solvers_[c].elimination_costs(costs);
      const auto passive = solvers_[c].passive();
      for (size_t i = 0; i < passive.size(); ++i) {
        const auto j = static_cast<size_t>(passive[i]);
        cost[j] += a_[c * p_ + j] * a_[c * p_ + j] * costs[i];
      }
    }
    const auto least = std::min_element(support.begin(), support.end(), [&](int i, int j) {
      return cost[static_cast<size_t>(i)] < cost[static_cast<size_t>(j)];
    });
    if (most == 0 || support.size() <= most) note(*least, error);
    support.erase(least);
  }
  path.order.assign(removed.rbegin(), removed.rend());
  path.errors.assign(1, static_cast<float>(target.square));
  path.errors.insert(path.errors.end(), errors.rbegin(), errors.rend());
  return path;
}

}  // namespace vamp::fit
