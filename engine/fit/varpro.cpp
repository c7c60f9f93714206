#include "engine/fit/varpro.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/fit/nnls.h"
#include "engine/fit/rows.h"

namespace vamp::fit {
namespace {

// Forward differences: far above the rounding of floats, far below the curvature of any lobe.
constexpr double kStep = 2e-3;
constexpr int kTries = 6;  // dampings tried before an iteration gives up

struct Parameter {
  size_t basis, index;
};

}  // namespace

struct VariableProjection::State {
  LobeTargets targets;
  LobeLimits limits;
  std::vector<std::vector<int>> supports;  // a texel; empty: all bases
  size_t pairs = 0, rows = 0;
  std::vector<float> y;  // all rows, one after another
  double square = 0;

  // Of the bases last evaluated: columns, products with themselves and with the targets, weights.
  std::vector<float> columns;
  std::vector<double> gram, cross, weights;

  // Products of columns and derivatives: `side` = bases + free parameters.
  std::vector<double> wide_gram, wide_cross;

  double solve(size_t bases);
  double look_at(const std::vector<Basis>& bases, size_t kept);
  void differentiate(const std::vector<Basis>& bases, const std::vector<Parameter>& free,
                     const std::vector<ParameterVector>& at);
  void normal_equations(size_t bases, const std::vector<Parameter>& free, Eigen::MatrixXd& hessian,
                        Eigen::VectorXd& gradient) const;
};

// Weights of all rows from the products; the squared error.
double VariableProjection::State::solve(size_t bases) {
  weights.resize(rows * bases);
  std::vector<int> all(bases);
  std::iota(all.begin(), all.end(), 0);
  Nnls nnls(gram.data(), bases);
  double error = square;
  for (size_t r = 0; r < rows; ++r) {
    const size_t texel = r / targets.channels;
    const std::vector<int>& support = supports.empty() ? all : supports[texel];
    double* a = weights.data() + r * bases;
    nnls.solve(support, cross.data() + r * bases, a);
    for (const int j : nnls.passive()) error -= a[j] * cross[r * bases + static_cast<size_t>(j)];
  }
  return std::max(error, 0.0);
}

// Columns before `kept` are those of the last look.
double VariableProjection::State::look_at(const std::vector<Basis>& bases, size_t kept) {
  const size_t n = bases.size();
  columns.resize(n * pairs);
  for (size_t j = kept; j < n; ++j)
    evaluate_column(bases[j], *targets.pairs, targets.roots, columns.data() + j * pairs);
  gram.resize(n * n);
  gram_rows(columns.data(), n, pairs, gram.data());
  cross.resize(rows * n);
  dot_rows(y.data(), rows, columns.data(), n, pairs, cross.data());
  weights.assign(rows * n, 0);
  return solve(n);
}

void VariableProjection::State::differentiate(const std::vector<Basis>& bases, const std::vector<Parameter>& free,
                                              const std::vector<ParameterVector>& at) {
  const size_t n = bases.size(), side = n + free.size();
  columns.resize(side * pairs);
  for (size_t k = 0; k < free.size(); ++k) {
    const ParameterVector& here = at[free[k].basis];
    std::array<double, kMaxParameters> moved = here.value;
    // Inwards where a step outwards would leave the range.
    const bool inwards = moved[free[k].index] > 0.5 * (here.low[free[k].index] + here.high[free[k].index]);
    const double h = inwards ? -kStep : kStep;
    moved[free[k].index] += h;
    float* out = columns.data() + (n + k) * pairs;
    const float* from = columns.data() + free[k].basis * pairs;
    evaluate_column(basis_of(bases[free[k].basis].lobe.model, moved.data(), limits), *targets.pairs, targets.roots,
                    out);
    const auto scale = static_cast<float>(1 / h);
    for (size_t i = 0; i < pairs; ++i) out[i] = (out[i] - from[i]) * scale;
  }
  wide_gram.resize(side * side);
  gram_rows(columns.data(), side, pairs, wide_gram.data());
  wide_cross.resize(rows * side);
  dot_rows(y.data(), rows, columns.data(), side, pairs, wide_cross.data());
}

// Gauss-Newton's matrix and the gradient of half the squared error, summed over rows. With z = L^-1 Phi' d for the
// derivative d of a lobe and L L' the Gram matrix of the row's active lobes, Kaufman's Jacobian has the products
// a_k a_l (d_k . d_l - z_k . z_l).
void VariableProjection::State::normal_equations(size_t bases, const std::vector<Parameter>& free,
                                                 Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
  const size_t side = bases + free.size();
  const auto g = [&](size_t i, size_t j) { return wide_gram[i * side + j]; };
  hessian.setZero(), gradient.setZero();
  std::vector<int> active;
  std::vector<Eigen::Index> moving;
  for (size_t r = 0; r < rows; ++r) {
    const double* a = weights.data() + r * bases;
    active.clear(), moving.clear();
    for (size_t j = 0; j < bases; ++j)
      if (a[j] > 0) active.push_back(static_cast<int>(j));
    for (size_t k = 0; k < free.size(); ++k)
      if (a[free[k].basis] > 0) moving.push_back(static_cast<Eigen::Index>(k));
    if (moving.empty()) continue;
    const auto n = static_cast<Eigen::Index>(active.size()), m = static_cast<Eigen::Index>(moving.size());
    Eigen::MatrixXd phi(n, n), z(n, m);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto row = static_cast<size_t>(active[static_cast<size_t>(i)]);
      for (Eigen::Index j = 0; j < n; ++j) phi(i, j) = g(row, static_cast<size_t>(active[static_cast<size_t>(j)]));
      phi(i, i) *= 1 + 1e-9;
      for (Eigen::Index k = 0; k < m; ++k)
        z(i, k) = g(row, bases + static_cast<size_t>(moving[static_cast<size_t>(k)]));
    }
    const Eigen::MatrixXd u = z;
    phi.llt().matrixL().solveInPlace(z);
    const Eigen::MatrixXd projected = z.transpose() * z;
    for (Eigen::Index k = 0; k < m; ++k) {
      const Eigen::Index p = moving[static_cast<size_t>(k)];
      const double ak = a[free[static_cast<size_t>(p)].basis];
      double along = wide_cross[r * side + bases + static_cast<size_t>(p)];
      for (Eigen::Index i = 0; i < n; ++i) along -= a[active[static_cast<size_t>(i)]] * u(i, k);
      gradient[p] -= ak * along;
      for (Eigen::Index l = 0; l <= k; ++l) {
        const Eigen::Index q = moving[static_cast<size_t>(l)];
        const double product = g(bases + static_cast<size_t>(p), bases + static_cast<size_t>(q)) - projected(k, l);
        const double term = ak * a[free[static_cast<size_t>(q)].basis] * product;
        hessian(p, q) += term;
        if (l != k) hessian(q, p) += term;
      }
    }
  }
}

VariableProjection::VariableProjection(const LobeTargets& targets, const LobeLimits& limits)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.targets = targets;
  s.limits = limits;
  s.pairs = targets.pairs->count();
  s.rows = targets.texels.size() * targets.channels;
  s.y.reserve(s.rows * s.pairs);
  for (const float* texel : targets.texels) s.y.insert(s.y.end(), texel, texel + targets.channels * s.pairs);
  double square = 0;
  for (size_t r = 0; r < s.rows; ++r) {
    dot_rows(s.y.data() + r * s.pairs, 1, s.y.data() + r * s.pairs, 1, s.pairs, &square);
    s.square += square;
  }
}

VariableProjection::~VariableProjection() = default;

const std::vector<double>& VariableProjection::weights() const { return state_->weights; }
void VariableProjection::restrict_to(std::vector<std::vector<int>> supports) { state_->supports = std::move(supports); }
double VariableProjection::square() const { return state_->square; }
double VariableProjection::evaluate(const std::vector<Basis>& bases) { return state_->look_at(bases, 0); }

double VariableProjection::improve(std::vector<Basis>& bases, size_t first, int iterations) {
  State& s = *state_;
  double error = s.look_at(bases, 0);
  std::vector<Parameter> free;
  std::vector<ParameterVector> at(bases.size());
  for (size_t j = first; j < bases.size(); ++j) {
    at[j] = parameters_of(bases[j], s.limits);
    for (size_t k = 0; k < at[j].count; ++k) free.push_back({j, k});
  }
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd hessian(count, count);
  Eigen::VectorXd gradient(count);
  double damping = 1e-2;
  int idle = 0;
  for (int iteration = 0; iteration < iterations && count > 0; ++iteration) {
    s.differentiate(bases, free, at);
    s.normal_equations(bases.size(), free, hessian, gradient);
    // Parameters at a bound that the gradient pushes outwards stay where they are.
    Eigen::VectorXd diagonal = hessian.diagonal();
    const double floor = 1e-8 * diagonal.maxCoeff() + 1e-30;
    for (Eigen::Index k = 0; k < count; ++k) {
      const ParameterVector& p = at[free[static_cast<size_t>(k)].basis];
      const size_t i = free[static_cast<size_t>(k)].index;
      const bool stuck = (p.value[i] <= p.low[i] && gradient[k] > 0) || (p.value[i] >= p.high[i] && gradient[k] < 0);
      if (!stuck && diagonal[k] > floor) continue;
      hessian.row(k).setZero(), hessian.col(k).setZero();
      gradient[k] = 0;
      hessian(k, k) = diagonal[k] = 1;
    }
    bool better = false;
    double gain = 0;
    for (int attempt = 0; attempt < kTries && !better; ++attempt) {
      Eigen::MatrixXd damped = hessian;
      damped.diagonal() += damping * diagonal;
      const Eigen::VectorXd step = damped.ldlt().solve(-gradient);
      std::vector<Basis> tried = bases;
      std::vector<ParameterVector> there = at;
      for (Eigen::Index k = 0; k < count; ++k) {
        const auto [basis, i] = free[static_cast<size_t>(k)];
        there[basis].value[i] = std::clamp(at[basis].value[i] + step[k], at[basis].low[i], at[basis].high[i]);
      }
      for (size_t j = first; j < bases.size(); ++j) {
        tried[j] = basis_of(bases[j].lobe.model, there[j].value.data(), s.limits);
        tried[j].name = bases[j].name;
      }
      const double now = s.look_at(tried, first);
      if (now < error) {
        better = true;
        gain = (error - now) / error;
        error = now;
        bases = std::move(tried);
        for (size_t j = first; j < bases.size(); ++j) at[j] = parameters_of(bases[j], s.limits);
        damping = std::max(damping / 4, 1e-7);
      } else {
        damping = std::min(damping * 6, 1e6);
      }
    }
    idle = gain < 1e-4 ? idle + 1 : 0;
    if (!better || idle == 2) break;
  }
  // After a step that failed the last look was elsewhere.
  return s.look_at(bases, 0);
}

}  // namespace vamp::fit
