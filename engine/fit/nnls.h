#pragma once
// Non-negative least squares in Gram space: min |X a - y|^2, a >= 0, from G = X'X and c = X'y alone.
#include <cstddef>
#include <span>
#include <vector>

namespace vamp::fit {

// Lawson and Hanson 1974, chapter 23, with the Cholesky factor of the passive set grown row by row. One object serves
// many right-hand sides of one Gram matrix; each thread has its own.
class Nnls {
 public:
  // `gram`: p x p, row-major, kept by reference. The diagonal counts 1 + 1e-9 times, so that equal columns share their
  // weight instead of failing.
  Nnls(const double* gram, size_t p) : gram_(gram), p_(p) {}

  // Weights of the `allowed` columns in `a`, which has p elements; all others are 0. `a` is also the start: columns
  // with a positive weight are tried first.
  void solve(std::span<const int> allowed, const double* target, double* a);

  // After solve: the columns with positive weight, and for each of them 1 / (G^-1)_jj over these columns, which times
  // a_j^2 is what the squared error grows by without column j.
  std::span<const int> passive() const { return passive_; }
  void elimination_costs(std::vector<double>& costs) const;

 private:
  double entry(int i, int j) const {
    const double value = gram_[static_cast<size_t>(i) * p_ + static_cast<size_t>(j)];
    return i == j ? value * (1 + 1e-9) : value;
  }
  bool append(int column);
  void refactor();
  void solve_passive(const double* target);
  void step(double* a);

  const double* gram_;
  size_t p_;
  std::vector<int> passive_;
  std::vector<double> factor_;    // rows of L, row i at i * (i + 1) / 2
  std::vector<double> solution_;  // of the passive columns
};

}  // namespace vamp::fit
