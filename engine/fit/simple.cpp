#include "engine/fit/simple.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/fit/nnls.h"

namespace vamp::fit {
namespace {

// Columns: the light's cosine, powers of the half vector's, the half vector itself.
constexpr std::array<float, 12> kExponents = {1, 2, 4, 7, 12, 20, 35, 60, 100, 200, 400, 800};
constexpr size_t kPowers = 1, kHalfColumns = kPowers + kExponents.size(), kColumns = kHalfColumns + 3, kRgb = 3;

Rows make_columns(const Pairs& pairs, const std::vector<float>* roots) {
  Rows columns(kColumns, pairs.count());
  size_t at = 0;
  for (const vec3& view : pairs.views)
    for (const vec3& light : pairs.lights) {
      const vec3 sum = view + light;
      const vec3 h = sum / std::max(std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z), 1e-6f);
      const float root = roots != nullptr ? (*roots)[at] : 1.f;
      columns.row(0)[at] = light.z * root;
      for (size_t k = 0; k < kExponents.size(); ++k)
        columns.row(kPowers + k)[at] = std::pow(std::max(h.z, 0.f), kExponents[k]) * root;
      for (int i = 0; i < 3; ++i) columns.row(kHalfColumns + static_cast<size_t>(i))[at] = h[i] * root;
      ++at;
    }
  return columns;
}

}  // namespace

const size_t SimpleModels::kHalf = kHalfColumns;

SimpleModels::Phong SimpleModels::best_phong(const std::vector<double>& gram, const double* correlations) {
  Phong best;
  double most = -std::numeric_limits<double>::max();
  for (size_t k = 0; k < kExponents.size(); ++k) {
    const size_t p = kPowers + k;
    const std::vector<double> part = {gram[0], gram[p], gram[p * kColumns], gram[p * kColumns + p]};
    const std::vector<int> both = {0, 1};
    Nnls nnls(part.data(), 2);
    Phong tried;
    tried.exponent = k;
    double gain = 0;
    for (size_t c = 0; c < kRgb; ++c) {
      const std::array<double, 2> target = {correlations[c * kColumns], correlations[c * kColumns + p]};
      std::array<double, 2> a{};
      nnls.solve(both, target.data(), a.data());
      tried.diffuse[c] = static_cast<float>(a[0]), tried.highlight[c] = static_cast<float>(a[1]);
      gain += a[0] * target[0] + a[1] * target[1];
    }
    if (gain > most) most = gain, best = tried;
  }
  return best;
}

SimpleModels::SimpleModels(const Measurement& measurement, const Worker& worker)
    : texels_(measurement.texels()), shapes_(measurement.texels()) {
  worker.stage("Fitting simpler models");
  const Rows columns = make_columns(measurement.pairs(), &measurement.roots());
  std::vector<double> gram(kColumns * kColumns);
  gram_rows(columns.row(0), kColumns, columns.length, gram.data());
  std::vector<std::array<double, kRgb * kColumns>> all(texels_.size());
  constexpr size_t kBlock = 64;
  worker.each((texels_.size() + kBlock - 1) / kBlock, [&](size_t block) {
    std::vector<float> row(measurement.values());
    for (size_t t = block * kBlock; t < std::min(texels_.size(), (block + 1) * kBlock); ++t) {
      measurement.read(t, row.data());
      measurement.btf().forget(t, 1);
      dot_rows(row.data(), kRgb, columns.row(0), kColumns, columns.length, all[t].data());
      texels_[t] = best_phong(gram, all[t].data());
    }
  });
  // The correlations of the mean texel are the mean of the correlations.
  std::array<double, kRgb * kColumns> mean{};
  for (const auto& each : all)
    for (size_t i = 0; i < mean.size(); ++i) mean[i] += each[i] / static_cast<double>(all.size());
  mean_ = best_phong(gram, mean.data());

  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      half_gram_(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = gram[(kHalf + i) * kColumns + kHalf + j];
  const Eigen::Matrix3d inverse = half_gram_.inverse();
  for (size_t t = 0; t < texels_.size(); ++t)
    for (size_t c = 0; c < kRgb; ++c) {
      Eigen::Vector3d left;
      for (size_t i = 0; i < 3; ++i)
        left[static_cast<Eigen::Index>(i)] =
            all[t][c * kColumns + kHalf + i] - double{mean_.diffuse[c]} * gram[kHalf + i] -
            double{mean_.highlight[c]} * gram[(kPowers + mean_.exponent) * kColumns + kHalf + i];
      const Eigen::Vector3d s = inverse * left;
      for (size_t i = 0; i < 3; ++i) shapes_[t][c * 3 + i] = static_cast<float>(s[static_cast<Eigen::Index>(i)]);
    }
}

const float* SimpleModels::highlight_column(const Rows& columns) const { return columns.row(kPowers + mean_.exponent); }

Rows SimpleModels::columns_at(const Pairs& pairs) const { return make_columns(pairs, nullptr); }

void SimpleModels::blinn_phong(size_t texel, const Rows& columns, float* out) const {
  const Phong& phong = texels_[texel];
  std::fill(out, out + kRgb * columns.length, 0.f);
  add_combinations(phong.diffuse.data(), kRgb, columns.row(0), 1, columns.length, out);
  add_combinations(phong.highlight.data(), kRgb, columns.row(kPowers + phong.exponent), 1, columns.length, out);
}

void SimpleModels::srf(size_t texel, const Rows& columns, float* out) const {
  std::fill(out, out + kRgb * columns.length, 0.f);
  add_combinations(mean_.diffuse.data(), kRgb, columns.row(0), 1, columns.length, out);
  add_combinations(mean_.highlight.data(), kRgb, columns.row(kPowers + mean_.exponent), 1, columns.length, out);
  add_combinations(shapes_[texel].data(), kRgb, columns.row(kHalf), 3, columns.length, out);
}

}  // namespace vamp::fit
