#include "engine/fit/joint_weights.h"

#include <algorithm>
#include <numeric>

namespace vamp::fit {
namespace {

constexpr size_t kBlock = 64;  // texels read at a time

// Products of a cluster's mean and terms with every function, [row][channel][basis]: the mean is row 0.
std::vector<double> table_products(const ResidualFit& residual, size_t cluster, const Design& design) {
  const size_t p = design.columns.count, pairs = design.columns.length;
  std::vector<double> products((1 + kMaxTerms) * kChannels * p);
  dot_rows(residual.means.row(cluster), kChannels, design.columns.row(0), p, pairs, products.data());
  dot_rows(residual.terms.row(cluster * kMaxTerms), kMaxTerms * kChannels, design.columns.row(0), p, pairs,
           products.data() + kChannels * p);
  return products;
}

// The normal equations of one texel's weights, [place][channel], with the terms' coefficients eliminated: the terms
// are orthonormal, so that what they take away is a product of projections.
class JointWeights {
 public:
  JointWeights(const Design& design, double pull) : design_(design), pull_(pull) {}

  // `along`: products of the texel less the mean with each term.
  void solve(const TexelCode& code, const std::vector<double>& tables, const std::array<double, kMaxTerms>& along,
             TexelWeights& texel) {
    const size_t m = texel.bases.size(), n = m * kChannels, p = design_.columns.count, path = code.path.order.size();
    gram_.assign(n * n, 0);
    target_.assign(n, 0);
    const auto product = [&](size_t row, size_t channel, size_t place) {
      return tables[(row * kChannels + channel) * p + texel.bases[place]];
    };
    for (size_t i = 0; i < m; ++i)
      for (size_t c = 0; c < kChannels; ++c) {
        const size_t at = i * kChannels + c;
        target_[at] = double{code.correlations[c * path + i]} - product(0, c, i);
        for (size_t k = 0; k < kMaxTerms; ++k) target_[at] -= product(1 + k, c, i) * along[k];
        for (size_t j = 0; j < m; ++j) {
          const double both = design_.gram[texel.bases[i] * p + texel.bases[j]];
          target_[at] += pull_ * both * double{texel.weights[j * kChannels + c]};
          gram_[at * n + j * kChannels + c] += (1 + pull_) * both;
          for (size_t d = 0; d < kChannels; ++d)
            for (size_t k = 0; k < kMaxTerms; ++k)
              gram_[at * n + j * kChannels + d] -= product(1 + k, c, i) * product(1 + k, d, j);
        }
      }
    all_.resize(n);
    std::iota(all_.begin(), all_.end(), 0);
    a_.assign(texel.weights.begin(), texel.weights.end());
    Nnls(gram_.data(), n).solve(all_, target_.data(), a_.data());
    std::transform(a_.begin(), a_.end(), texel.weights.begin(),
                   [](double weight) { return static_cast<float>(weight); });
  }

 private:
  const Design& design_;
  double pull_;
  std::vector<double> gram_, target_, a_;
  std::vector<int> all_;
};

}  // namespace

void refit_weights(const Measurement& measurement, const Design& design, const std::vector<TexelCode>& codes,
                   const Clustering& clustering, const ResidualFit& residual, double pull, const Worker& worker,
                   std::vector<TexelWeights>& weights) {
  worker.stage("Weighing the functions beside the residual");
  const size_t values = measurement.values(), texels = measurement.texels();
  std::vector<std::vector<double>> tables(clustering.count);
  std::vector<std::array<double, kMaxTerms>> means(clustering.count);  // products of mean and terms
  worker.each(clustering.count, [&](size_t c) {
    tables[c] = table_products(residual, c, design);
    dot_rows(residual.means.row(c), 1, residual.terms.row(c * kMaxTerms), kMaxTerms, values, means[c].data());
  });
  worker.each((texels + kBlock - 1) / kBlock, [&](size_t block) {
    JointWeights joint(design, pull);
    std::vector<float> row(values);
    std::array<double, kMaxTerms> along{};
    for (size_t t = block * kBlock; t < std::min(texels, (block + 1) * kBlock) && !worker.cancelled(); ++t) {
      if (weights[t].bases.empty()) continue;
      const size_t c = clustering.of[t];
      measurement.read(t, row.data());
      dot_rows(row.data(), 1, residual.terms.row(c * kMaxTerms), kMaxTerms, values, along.data());
      for (size_t k = 0; k < kMaxTerms; ++k) along[k] -= means[c][k];
      joint.solve(codes[t], tables[c], along, weights[t]);
    }
    measurement.btf().forget(block * kBlock, std::min(kBlock, texels - std::min(texels, block * kBlock)));
  });
}

}  // namespace vamp::fit
