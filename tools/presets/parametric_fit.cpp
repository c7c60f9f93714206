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

// Non-negative weights of the `active` functions, then backward elimination: the one whose loss costs least goes first.
void sparse_weights(const Eigen::MatrixXf& gram, const Eigen::MatrixX3f& target, std::vector<int> active,
                    int max_entries, Eigen::MatrixX3f& a) {
  descend(gram, target, active, 40, a);
  const auto cost = [&](int j) { return a.row(j).squaredNorm() * gram(j, j); };
  while (!active.empty()) {
    const auto least = std::min_element(active.begin(), active.end(), [&](int i, int j) { return cost(i) < cost(j); });
    float total = 0;
    for (const int j : active) total += cost(j);
    if (static_cast<int>(active.size()) <= max_entries && cost(*least) > 2e-3f * total) break;
    a.row(*least).setZero();
    active.erase(least);
    if (static_cast<int>(active.size()) < 2 * max_entries) descend(gram, target, active, 6, a);
  }
  descend(gram, target, active, 60, a);
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

Eigen::Matrix3Xf body_leftover(const Goniometer& goniometer, const ParametricFit& fit, int texel) {
  Eigen::Matrix3Xf data(3, kPairs);
  for (int v = 0; v < kDirections; ++v) goniometer.measure(texel, v, data.data() + 3 * kDirections * v, nullptr);
  const Eigen::MatrixX3f& weights = fit.weights[static_cast<size_t>(texel)];
  for (int j = 0; j < weights.rows(); ++j)
    if (!fit.glossy[static_cast<size_t>(j)] && weights.row(j).maxCoeff() > 0)
      data.noalias() -= weights.row(j).transpose() * fit.shapes.row(j);
  return data;
}

ParametricFit fit_parametric(const Surface& surface, const Goniometer& goniometer, int max_entries) {
  ParametricFit fit;
  fit.shapes = shapes_of(surface.dictionary);
  std::vector<int> body, finish;
  for (size_t j = 0; j < surface.dictionary.size(); ++j) {
    const Model model = surface.dictionary[j].lobe.model;
    fit.glossy.push_back(model != Model::lambert && model != Model::oren_nayar && model != Model::lafortune);
    (fit.glossy.back() ? finish : body).push_back(static_cast<int>(j));
  }
  const Eigen::RowVectorXf w = pair_weights();
  const Eigen::MatrixXf weighted = fit.shapes * w.cwiseAbs2().asDiagonal();
  Eigen::MatrixXf gram = weighted * fit.shapes.transpose();
  gram.diagonal() *= 1.001f;  // nearly equal functions share rather than fight

  fit.weights.resize(kTexels);
  // Sums over texels run per row and are added in order, so that threads do not change them.
  std::vector<double> squares(kSide), errors(kSide);
  parallel(kSide, [&](int y) {
    Eigen::Matrix3Xf matte(3, kPairs);
    Eigen::RowVectorXf gloss(kPairs);
    for (int x = 0; x < kSide; ++x) {
      const int t = y * kSide + x;
      for (int v = 0; v < kDirections; ++v)
        goniometer.measure(t, v, matte.data() + 3 * kDirections * v, gloss.data() + kDirections * v);
      Eigen::MatrixX3f& a = fit.weights[static_cast<size_t>(t)];
      a = Eigen::MatrixX3f::Zero(fit.shapes.rows(), 3);
      sparse_weights(gram, weighted * matte.transpose(), body, max_entries, a);
      const Eigen::VectorXf highlights = weighted * gloss.transpose();
      sparse_weights(gram, highlights.replicate(1, 3), finish, max_entries, a);
      matte.rowwise() += gloss;
      const Eigen::MatrixX3f target = weighted * matte.transpose();
      const float square = (matte * w.asDiagonal()).squaredNorm();
      squares[static_cast<size_t>(y)] += static_cast<double>(square);
      errors[static_cast<size_t>(y)] +=
          static_cast<double>(square - 2 * a.cwiseProduct(target).sum() + a.cwiseProduct(gram * a).sum());
    }
  });
  double square = 0, error = 0;
  for (size_t y = 0; y < kSide; ++y) square += squares[y], error += errors[y];
  fit.error = std::sqrt(std::max(error, 0.0) / square);

  fit.mean.assign(surface.clusters.size(), Eigen::Matrix3Xf::Zero(3, kPairs));
  parallel(static_cast<int>(surface.clusters.size()), [&](int c) {
    const auto members = std::count(surface.cluster.begin(), surface.cluster.end(), static_cast<uint8_t>(c));
    const int stride = std::max(1, static_cast<int>(members / 800));  // means need no more texels than this
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, kPairs);
    int seen = 0, used = 0;
    for (int t = 0; t < kTexels; ++t) {
      if (surface.cluster[static_cast<size_t>(t)] != c || seen++ % stride != 0) continue;
      sum += body_leftover(goniometer, fit, t).cast<double>();
      ++used;
    }
    if (used > 0) fit.mean[static_cast<size_t>(c)] = (sum / used).cast<float>();
  });
  return fit;
}

}  // namespace vamp::presets
