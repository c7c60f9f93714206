#include "engine/fit/lasso.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vamp::fit {
namespace {

using Group = std::array<double, kChannels>;

double length(const Group& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Group positive(const Group& v) { return {std::max(v[0], 0.0), std::max(v[1], 0.0), std::max(v[2], 0.0)}; }

// What is left of the correlations at weights a.
std::vector<double> gradient_at(const double* gram, size_t p, const double* correlations,
                                const std::vector<double>& a) {
  std::vector<double> g(correlations, correlations + kChannels * p);
  for (size_t c = 0; c < kChannels; ++c)
    for (size_t j = 0; j < p; ++j)
      if (const double w = a[c * p + j]; w != 0)
        for (size_t k = 0; k < p; ++k) g[c * p + k] -= w * gram[j * p + k];
  return g;
}

Group group_of(const std::vector<double>& v, size_t p, size_t j) { return {v[j], v[p + j], v[2 * p + j]}; }

// Sets function j's weights and keeps the gradient true.
void set_group(const double* gram, size_t p, size_t j, const Group& to, std::vector<double>& a,
               std::vector<double>& g) {
  for (size_t c = 0; c < kChannels; ++c) {
    const double change = to[c] - a[c * p + j];
    if (change == 0) continue;
    a[c * p + j] = to[c];
    for (size_t k = 0; k < p; ++k) g[c * p + k] -= change * gram[j * p + k];
  }
}

double largest(const double* correlations, size_t p) {
  double most = 0;
  for (size_t j = 0; j < p; ++j)
    most = std::max(most, length(positive({correlations[j], correlations[p + j], correlations[2 * p + j]})));
  return most;
}

std::vector<int> support_of(const std::vector<double>& a, size_t p) {
  std::vector<int> support;
  for (size_t j = 0; j < p; ++j)
    if (a[j] > 0 || a[p + j] > 0 || a[2 * p + j] > 0) support.push_back(static_cast<int>(j));
  return support;
}

// The best debiased support of each size; the path's order is made by elimination within the largest of them.
class BestSupports {
 public:
  BestSupports(const double* gram, size_t p, const TexelTarget& target, size_t most)
      : gram_(gram), p_(p), target_(target), elimination_(gram, p), best_(most + 1) {}

  // Whether the path may go on.
  bool see(const std::vector<double>& a) {
    const std::vector<int> support = support_of(a, p_);
    if (support.size() >= best_.size()) return false;
    if (support.empty() || support == last_) return true;
    last_ = support;
    const double error = elimination_.weights(target_, support, weights_);
    Found& found = best_[support.size()];
    if (found.support.empty() || error < found.error) found = {support, error};
    return true;
  }

  // Nested supports: the largest one found, its functions in the order in which smaller ones hold them.
  SparsePath path() {
    SparsePath path;
    path.errors.push_back(static_cast<float>(target_.square));
    std::vector<int> order;
    for (const Found& found : best_)
      for (const int j : found.support)
        if (std::find(order.begin(), order.end(), j) == order.end() && order.size() + 1 < best_.size())
          order.push_back(j);
    for (size_t m = 1; m <= order.size(); ++m) {
      const std::vector<int> support(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(m));
      path.order.push_back(static_cast<uint16_t>(order[m - 1]));
      path.errors.push_back(static_cast<float>(elimination_.weights(target_, support, weights_)));
    }
    return path;
  }

 private:
  struct Found {
    std::vector<int> support;
    double error = 0;
  };
  const double* gram_;
  size_t p_;
  TexelTarget target_;
  Elimination elimination_;
  std::vector<Found> best_;
  std::vector<int> last_;
  std::vector<double> weights_;
};

}  // namespace

void group_lasso(const double* gram, size_t p, const double* correlations, double lambda, std::vector<double>& a) {
  std::vector<double> g = gradient_at(gram, p, correlations, a);
  const double tolerance = 1e-6 * largest(correlations, p);
  for (int sweep = 0; sweep < 5000; ++sweep) {
    double moved = 0;
    for (size_t j = 0; j < p; ++j) {
      const double diagonal = gram[j * p + j];
      if (!(diagonal > 0)) continue;
      const Group before = group_of(a, p, j), pull = group_of(g, p, j);
      // What this function would take if the others stayed, shrunk as a whole.
      Group v =
          positive({pull[0] + diagonal * before[0], pull[1] + diagonal * before[1], pull[2] + diagonal * before[2]});
      const double size = length(v), shrink = size > lambda ? (1 - lambda / size) / diagonal : 0;
      for (double& each : v) each *= shrink;
      const Group change = {v[0] - before[0], v[1] - before[1], v[2] - before[2]};
      moved = std::max(moved, length(change) * diagonal);
      set_group(gram, p, j, v, a, g);
    }
    if (moved < tolerance) break;
  }
}

SparsePath group_lasso_path(const double* gram, size_t p, const TexelTarget& target, size_t most) {
  BestSupports best(gram, p, target, most == 0 ? p : most);
  std::vector<double> a(kChannels * p);
  double lambda = largest(target.correlations, p);
  for (int i = 0; i < 60 && lambda > 0; ++i) {
    lambda *= 0.8;
    group_lasso(gram, p, target.correlations, lambda, a);
    if (!best.see(a)) break;
  }
  return best.path();
}

std::vector<LassoPoint> stagewise_lasso(const double* gram, size_t p, const double* correlations, double step,
                                        double least) {
  std::vector<double> a(kChannels * p), g(correlations, correlations + kChannels * p);
  // The step is a length in the space of a function's channels.
  double scale = 0;
  for (size_t j = 0; j < p; ++j)
    if (gram[j * p + j] > 0) scale = std::max(scale, length(positive(group_of(g, p, j))) / gram[j * p + j]);
  const double epsilon = step * scale, slack = 1e-3 * epsilon * largest(correlations, p) * step;
  std::vector<LassoPoint> path;
  if (!(epsilon > 0)) return path;
  // Change of half the squared error when function j moves by v.
  const auto change = [&](size_t j, const Group& v) {
    const Group pull = group_of(g, p, j);
    return -(v[0] * pull[0] + v[1] * pull[1] + v[2] * pull[2]) +
           0.5 * gram[j * p + j] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  };
  double lambda = -1, start = 0;
  for (int i = 0; i < 200000; ++i) {
    // Backwards where the penalised error falls.
    size_t back = p;
    double back_gain = slack;
    Group back_to{};
    for (size_t j = 0; j < p && lambda > 0; ++j) {
      const Group w = group_of(a, p, j);
      const double size = length(w);
      if (!(size > 0)) continue;
      const double keep = std::max(0.0, 1 - epsilon / size);
      const Group to = {w[0] * keep, w[1] * keep, w[2] * keep};
      const double gain = lambda * (size - length(to)) - change(j, {to[0] - w[0], to[1] - w[1], to[2] - w[2]});
      if (gain > back_gain) back = j, back_gain = gain, back_to = to;
    }
    if (back < p) {
      set_group(gram, p, back, back_to, a, g);
      continue;
    }
    // Forwards along the steepest fall.
    size_t best = p;
    double most = 0;
    Group move{};
    for (size_t j = 0; j < p; ++j) {
      Group along = group_of(g, p, j);
      const Group w = group_of(a, p, j);
      for (size_t c = 0; c < kChannels; ++c)
        if (along[c] < 0 && w[c] <= 0) along[c] = 0;
      const double size = length(along);
      if (!(size > 0)) continue;
      Group v;
      for (size_t c = 0; c < kChannels; ++c) v[c] = std::max(along[c] * epsilon / size, -w[c]);
      const double gain = -change(j, v);
      if (gain > most) best = j, most = gain, move = v;
    }
    if (best == p) break;
    const Group w = group_of(a, p, best);
    set_group(gram, p, best, {w[0] + move[0], w[1] + move[1], w[2] + move[2]}, a, g);
    const double now = (most - slack) / epsilon;
    if (lambda < 0) lambda = start = now;
    if (now < lambda) {
      path.push_back({lambda, a});
      lambda = now;
    }
    if (lambda <= least * start) break;
  }
  path.push_back({std::max(lambda, 0.0), a});
  return path;
}

SparsePath stagewise_lasso_path(const double* gram, size_t p, const TexelTarget& target, size_t most) {
  BestSupports best(gram, p, target, most == 0 ? p : most);
  for (const LassoPoint& point : stagewise_lasso(gram, p, target.correlations, 0.01, 1e-4))
    if (!best.see(point.a)) break;
  return best.path();
}

}  // namespace vamp::fit
