#include "engine/fit/residual.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace vamp::fit {
namespace {

constexpr size_t kPiece = 256;  // texels of one cluster that are summed together

// Texels of one cluster.
struct Piece {
  size_t cluster = 0, first = 0, end = 0;  // in the cluster's list
};

std::vector<Piece> pieces_of(const std::vector<std::vector<size_t>>& members) {
  std::vector<Piece> pieces;
  for (size_t c = 0; c < members.size(); ++c)
    for (size_t first = 0; first < members[c].size(); first += kPiece)
      pieces.push_back({c, first, std::min(members[c].size(), first + kPiece)});
  return pieces;
}

double dot(const float* a, const float* b, size_t n) {
  double product = 0;
  dot_rows(a, 1, b, 1, n, &product);
  return product;
}

void add_scaled(float factor, const float* x, size_t n, float* out) { add_combinations(&factor, 1, x, 1, n, out); }

// Coefficients of each texel along its cluster's principal axes in the coordinates.
std::vector<std::array<float, kMaxTerms>> principal_coefficients(const Rows& coordinates, size_t terms,
                                                                 const std::vector<std::vector<size_t>>& members,
                                                                 const Worker& worker) {
  std::vector<std::array<float, kMaxTerms>> coefficients(coordinates.count);
  const auto n = static_cast<Eigen::Index>(coordinates.length);
  worker.each(members.size(), [&](size_t c) {
    const auto point = [&](size_t t) {
      return Eigen::Map<const Eigen::VectorXf>(coordinates.row(t), n).cast<double>();
    };
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
    for (const size_t t : members[c]) mean += point(t);
    mean /= static_cast<double>(members[c].size());
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(n, n);
    for (const size_t t : members[c]) scatter.selfadjointView<Eigen::Lower>().rankUpdate(point(t) - mean);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scatter);
    // A cluster of n texels has no more than n - 1 directions about its mean.
    const size_t useful = std::min({terms, coordinates.length, members[c].size() - 1});
    for (const size_t t : members[c])
      for (size_t k = 0; k < useful; ++k)
        coefficients[t][k] =
            static_cast<float>(solver.eigenvectors().col(n - 1 - static_cast<Eigen::Index>(k)).dot(point(t) - mean));
  });
  return coefficients;
}

// Makes a cluster's terms orthonormal; those that are nothing but rounding become 0.
void orthonormalise(Rows& terms, size_t cluster) {
  double strongest = 0;
  for (size_t k = 0; k < kMaxTerms; ++k) {
    float* row = terms.row(cluster * kMaxTerms + k);
    const double before = dot(row, row, terms.length);
    for (int again = 0; again < 2; ++again)
      for (size_t j = 0; j < k; ++j) {
        const float* other = terms.row(cluster * kMaxTerms + j);
        add_scaled(-static_cast<float>(dot(row, other, terms.length)), other, terms.length, row);
      }
    const double square = dot(row, row, terms.length);
    strongest = std::max(strongest, before);
    const bool real = square > 1e-8 * before && before > 1e-12 * strongest && square > 0;
    const float scale = real ? static_cast<float>(1 / std::sqrt(square)) : 0.f;
    for (size_t i = 0; i < terms.length; ++i) row[i] = real ? row[i] * scale : 0.f;
  }
}

}  // namespace

Rows residual_coordinates(const Coordinates& found, const Design& design, const std::vector<TexelWeights>& weights) {
  const size_t rank = found.directions.count, p = design.columns.count, pairs = design.columns.length;
  // Where each function in each channel lies.
  std::vector<double> products(rank * kChannels * p);
  dot_rows(found.directions.row(0), rank * kChannels, design.columns.row(0), p, pairs, products.data());
  Rows out = found.coordinates;
  for (size_t t = 0; t < out.count; ++t) {
    float* row = out.row(t);
    const TexelWeights& texel = weights[t];
    for (size_t i = 0; i < texel.bases.size(); ++i)
      for (size_t c = 0; c < kChannels; ++c) {
        const float weight = texel.weights[i * kChannels + c];
        for (size_t k = 0; k < rank; ++k)
          row[k] -= weight * static_cast<float>(products[(k * kChannels + c) * p + texel.bases[i]]);
      }
  }
  return out;
}

void read_residual(const Measurement& measurement, const Design& design, const TexelWeights& weights, size_t texel,
                   float* out) {
  measurement.read(texel, out);
  std::array<float, kChannels> minus;
  for (size_t i = 0; i < weights.bases.size(); ++i) {
    for (size_t c = 0; c < kChannels; ++c) minus[c] = -weights.weights[i * kChannels + c];
    add_combinations(minus.data(), kChannels, design.columns.row(weights.bases[i]), 1, design.columns.length, out);
  }
}

ResidualFit find_tables(const Measurement& measurement, const Design& design, const std::vector<TexelWeights>& weights,
                        const Rows& coordinates, const Clustering& clustering, size_t terms, const Worker& worker) {
  const auto members = clustering.members();
  const std::vector<Piece> pieces = pieces_of(members);
  const size_t values = measurement.values();
  terms = std::min(terms, kMaxTerms);
  ResidualFit fit;
  worker.stage("Finding what the functions leave");
  fit.coefficients = principal_coefficients(coordinates, terms, members, worker);

  // Means and terms: sums of leftovers, and of leftovers times coefficients, piece by piece.
  fit.means = Rows(clustering.count, values);
  fit.terms = Rows(clustering.count * kMaxTerms, values);
  constexpr size_t kTogether = 64;  // pieces whose sums are held at a time
  const size_t sums = 1 + terms;
  for (size_t from = 0; from < pieces.size() && !worker.cancelled(); from += kTogether) {
    const size_t count = std::min(kTogether, pieces.size() - from);
    std::vector<Rows> parts(count);
    worker.each(count, [&](size_t i) {
      const Piece& piece = pieces[from + i];
      parts[i] = Rows(sums, values);
      std::vector<float> row(values), factors(sums, 1.f);
      for (size_t m = piece.first; m < piece.end && !worker.cancelled(); ++m) {
        const size_t t = members[piece.cluster][m];
        read_residual(measurement, design, weights[t], t, row.data());
        measurement.btf().forget(t, 1);
        std::copy_n(fit.coefficients[t].begin(), terms, factors.begin() + 1);
        add_combinations(factors.data(), sums, row.data(), 1, values, parts[i].row(0));
      }
    });
    for (size_t i = 0; i < count && !worker.cancelled(); ++i) {
      const size_t c = pieces[from + i].cluster;
      add_scaled(1, parts[i].row(0), values, fit.means.row(c));
      for (size_t k = 0; k < terms; ++k) add_scaled(1, parts[i].row(1 + k), values, fit.terms.row(c * kMaxTerms + k));
    }
  }
  worker.each(clustering.count, [&](size_t c) {
    const auto scale = 1 / static_cast<float>(members[c].size());
    for (size_t i = 0; i < values; ++i) fit.means.row(c)[i] *= scale;
    orthonormalise(fit.terms, c);
  });
  return fit;
}

void fit_coefficients(const Measurement& measurement, const Design& design, const std::vector<TexelWeights>& weights,
                      const Clustering& clustering, const Worker& worker, ResidualFit& fit) {
  const auto members = clustering.members();
  const std::vector<Piece> pieces = pieces_of(members);
  const size_t values = measurement.values(), texels = measurement.texels();
  worker.stage("Measuring what is left");
  std::vector<std::array<double, kMaxTerms + 2>> errors(pieces.size());
  worker.each(pieces.size(), [&](size_t p) {
    const Piece& piece = pieces[p];
    std::vector<float> row(values);
    std::array<double, kMaxTerms> products{};
    for (size_t m = piece.first; m < piece.end && !worker.cancelled(); ++m) {
      const size_t t = members[piece.cluster][m];
      read_residual(measurement, design, weights[t], t, row.data());
      measurement.btf().forget(t, 1);
      errors[p][0] += dot(row.data(), row.data(), values);
      add_scaled(-1, fit.means.row(piece.cluster), values, row.data());
      double left = dot(row.data(), row.data(), values);
      errors[p][1] += left;
      dot_rows(row.data(), 1, fit.terms.row(piece.cluster * kMaxTerms), kMaxTerms, values, products.data());
      for (size_t k = 0; k < kMaxTerms; ++k) {
        left -= products[k] * products[k];
        errors[p][2 + k] += left;
        fit.coefficients[t][k] = static_cast<float>(products[k]);
      }
    }
  });
  for (const auto& part : errors)
    for (size_t i = 0; i < part.size(); ++i) fit.errors[i] += part[i];

  // Coefficients about 1, terms of the size of what they add: neither leaves the range of halves.
  std::vector<double> squares(clustering.count * kMaxTerms);
  for (size_t t = 0; t < texels; ++t)
    for (size_t k = 0; k < kMaxTerms; ++k)
      squares[clustering.of[t] * kMaxTerms + k] += std::pow(double{fit.coefficients[t][k]}, 2);
  for (size_t c = 0; c < clustering.count; ++c)
    for (size_t k = 0; k < kMaxTerms; ++k) {
      const auto scale =
          static_cast<float>(std::sqrt(squares[c * kMaxTerms + k] / static_cast<double>(members[c].size())));
      squares[c * kMaxTerms + k] = double{scale};
      float* row = fit.terms.row(c * kMaxTerms + k);
      for (size_t i = 0; i < values; ++i) row[i] *= scale;
    }
  for (size_t t = 0; t < texels; ++t)
    for (size_t k = 0; k < kMaxTerms; ++k) {
      const auto scale = static_cast<float>(squares[clustering.of[t] * kMaxTerms + k]);
      fit.coefficients[t][k] = scale > 0 ? fit.coefficients[t][k] / scale : 0;
    }
}

}  // namespace vamp::fit
