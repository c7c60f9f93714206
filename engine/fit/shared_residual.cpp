#include "engine/fit/shared_residual.h"

#include <Eigen/Eigenvalues>

#include "engine/core/half.h"
#include "engine/fit/residual.h"

namespace vamp::fit {
namespace {

float half(uint32_t bits) { return float_from_half(static_cast<uint16_t>(bits & 0xffffu)); }

std::vector<TexelWeights> weights_of(const Spmm& spmm) {
  std::vector<TexelWeights> weights(spmm.texels.size());
  for (size_t t = 0; t < weights.size(); ++t)
    for (uint32_t i = 0; i < (spmm.texels[t].cluster_count >> 8 & 0xffu); ++i) {
      const tables::Entry& entry = spmm.entries[spmm.texels[t].first_entry + i];
      weights[t].bases.push_back(static_cast<uint16_t>(entry.basis_red & 0xffffu));
      for (const uint32_t bits : {entry.basis_red >> 16, entry.green_blue, entry.green_blue >> 16})
        weights[t].weights.push_back(half(bits));
    }
  return weights;
}

}  // namespace

SharedResidual::SharedResidual(const Coordinates& svd, const Measurement& source, const Spmm& spmm) {
  const Rows left = residual_coordinates(svd, make_design(spmm.dictionary, source), weights_of(spmm));
  const auto rank = static_cast<Eigen::Index>(left.length);
  using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> points(left.row(0), static_cast<Eigen::Index>(left.count), rank);
  const Eigen::MatrixXd gram = (points.transpose() * points).cast<double>();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  const RowMajor axes = solver.eigenvectors().rowwise().reverse().transpose().cast<float>();
  axes_.assign(axes.data(), axes.data() + axes.size());
  coordinates_ = Rows(left.count, left.length);
  Eigen::Map<RowMajor>(coordinates_.row(0), static_cast<Eigen::Index>(left.count), rank) = points * axes.transpose();
}

Rows SharedResidual::rotated(const Rows& directions) const {
  Rows out(directions.count, directions.length);
  add_combinations(axes_.data(), directions.count, directions.row(0), directions.count, directions.length, out.row(0));
  return out;
}

}  // namespace vamp::fit
