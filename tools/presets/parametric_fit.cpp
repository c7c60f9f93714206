#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/material/directions.h"
#include "engine/material/tables.h"
#include "tools/presets/fit.h"

namespace vamp::presets {
namespace {

// Value of each function alone, through the same rows and the same oracle as any material.
Eigen::MatrixXf shapes_of(const std::vector<Basis>& dictionary) {
  const std::vector<vec3> directions = ubo2003_directions();
  Spmm probe;
  probe.width = static_cast<int>(dictionary.size()), probe.height = 1;
  probe.dictionary = dictionary;
  probe.clusters = {{"probe"}};
  constexpr uint32_t kOne = 0x3c00;  // half
  for (uint32_t j = 0; j < dictionary.size(); ++j) {
    probe.texels.push_back({j, 1u << 8, 0, 0});
    probe.entries.push_back({j | kOne << 16, kOne | kOne << 16});
  }
  const EditedTables rows = edited_tables(probe, {});
  const DirectionTables none;
  Eigen::MatrixXf shapes(probe.width, kPairs);
  parallel(kDirections, [&](int v) {
    for (int l = 0; l < kDirections; ++l)
      for (int j = 0; j < probe.width; ++j)
        shapes(j, v * kDirections + l) =
            static_cast<float>(evaluate(probe, rows, 0, none, j, 0, dvec3(directions[static_cast<size_t>(l)]),
                                        dvec3(directions[static_cast<size_t>(v)]))
                                   .x);
  });
  return shapes;
}

// Coordinate descent for min |X a - d|^2, a >= 0, in Gram space; rows that are not allowed stay 0.
void descend(const Eigen::MatrixXf& gram, const Eigen::MatrixX3f& target, const std::vector<int>& allowed, int sweeps,
             Eigen::MatrixX3f& a) {
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const int j : allowed) {
      Eigen::RowVector3f rest = target.row(j);
      for (const int k : allowed)
        if (k != j) rest -= gram(j, k) * a.row(k);
      a.row(j) = (rest / gram(j, j)).cwiseMax(0.f);
    }
}

// Non-negative weights, then backward elimination: the function whose loss costs least goes first.
Eigen::MatrixX3f sparse_weights(const Eigen::MatrixXf& gram, const Eigen::MatrixX3f& target, int max_entries) {
  std::vector<int> active(static_cast<size_t>(gram.rows()));
  for (size_t j = 0; j < active.size(); ++j) active[j] = static_cast<int>(j);
  Eigen::MatrixX3f a = Eigen::MatrixX3f::Zero(gram.rows(), 3);
  descend(gram, target, active, 40, a);
  const auto cost = [&](int j) { return a.row(j).squaredNorm() * gram(j, j); };
  while (!active.empty()) {
    const auto least = std::min_element(active.begin(), active.end(), [&](int i, int j) { return cost(i) < cost(j); });
    float total = 0;
    for (const int j : active) total += cost(j);
    if (static_cast<int>(active.size()) <= max_entries && cost(*least) > 2e-4f * total) break;
    a.row(*least).setZero();
    active.erase(least);
    if (static_cast<int>(active.size()) < 2 * max_entries) descend(gram, target, active, 6, a);
  }
  descend(gram, target, active, 60, a);
  return a;
}

}  // namespace

Eigen::RowVectorXf pair_weights() {
  const auto w = direction_weights();
  Eigen::RowVectorXf weights(kPairs);
  for (int v = 0; v < kDirections; ++v)
    for (int l = 0; l < kDirections; ++l) {
      const double projected = w[static_cast<size_t>(v)] * w[static_cast<size_t>(l)] *
                               (kDirections / std::numbers::pi) * (kDirections / std::numbers::pi);
      weights[v * kDirections + l] = static_cast<float>(std::sqrt(0.5 * projected + 0.5));
    }
  return weights;
}

ParametricFit fit_parametric(const Surface& surface, const Goniometer& goniometer, int max_entries) {
  ParametricFit fit;
  fit.shapes = shapes_of(surface.dictionary);
  const Eigen::RowVectorXf w = pair_weights();
  const Eigen::MatrixXf weighted = fit.shapes * w.cwiseAbs2().asDiagonal();
  Eigen::MatrixXf gram = weighted * fit.shapes.transpose();
  gram.diagonal() *= 1.001f;  // nearly equal functions share rather than fight

  const auto clusters = surface.clusters.size();
  fit.weights.resize(kTexels);
  fit.mean.assign(clusters, Eigen::Matrix3Xf::Zero(3, kPairs));
  fit.texels.assign(clusters, 0);
  // Sums over texels run per row and are added in order, so that threads do not change them.
  std::vector<double> squares(kSide), errors(kSide);
  parallel(kSide, [&](int y) {
    Eigen::Matrix3Xf data(3, kPairs);
    for (int x = 0; x < kSide; ++x) {
      const int t = y * kSide + x;
      for (int v = 0; v < kDirections; ++v) goniometer.measure(t, v, data.data() + 3 * kDirections * v);
      const Eigen::MatrixX3f target = weighted * data.transpose();
      fit.weights[static_cast<size_t>(t)] = sparse_weights(gram, target, max_entries);
      const auto& a = fit.weights[static_cast<size_t>(t)];
      const float square = (data * w.asDiagonal()).squaredNorm();
      squares[static_cast<size_t>(y)] += static_cast<double>(square);
      errors[static_cast<size_t>(y)] +=
          static_cast<double>(square - 2 * a.cwiseProduct(target).sum() + a.cwiseProduct(gram * a).sum());
    }
  });
  double square = 0, error = 0;
  for (size_t y = 0; y < kSide; ++y) square += squares[y], error += errors[y];
  fit.error = std::sqrt(std::max(error, 0.0) / square);

  parallel(static_cast<int>(clusters), [&](int c) {
    Eigen::Matrix3Xf data(3, kPairs);
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, kPairs);
    const auto members = std::count(surface.cluster.begin(), surface.cluster.end(), static_cast<uint8_t>(c));
    const int stride = std::max(1, static_cast<int>(members / 800));  // means need no more texels than this
    int seen = 0;
    for (int t = 0; t < kTexels; ++t) {
      if (surface.cluster[static_cast<size_t>(t)] != c || seen++ % stride != 0) continue;
      for (int v = 0; v < kDirections; ++v) goniometer.measure(t, v, data.data() + 3 * kDirections * v);
      sum += (data - fit.weights[static_cast<size_t>(t)].transpose() * fit.shapes).cast<double>();
      fit.texels[static_cast<size_t>(c)] += 1;
    }
    if (fit.texels[static_cast<size_t>(c)] > 0)
      fit.mean[static_cast<size_t>(c)] = (sum / fit.texels[static_cast<size_t>(c)]).cast<float>();
  });
  return fit;
}

}  // namespace vamp::presets
