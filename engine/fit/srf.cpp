#include "engine/fit/srf.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include "engine/brdf/registry.h"
#include "engine/core/jobs.h"
#include "engine/fit/bake.h"
#include "engine/fit/names.h"
#include "engine/fit/represent.h"
#include "engine/fit/simple.h"
#include "engine/material/reflectance.h"

namespace vamp::fit {
namespace {

constexpr size_t kShape = 9;  // numbers of s(P): [channel][x, y, z]
using Shape = Eigen::Matrix<double, kShape, 1>;
using Square = Eigen::Matrix<double, kShape, kShape>;

// s(P) in coordinates whose distances are those of what it adds, and back.
class Metric {
 public:
  explicit Metric(const Eigen::Matrix3d& gram) : root_(Eigen::LLT<Eigen::Matrix3d>(gram).matrixL()) {}

  Shape to(const float* shape) const {
    Shape out;
    for (int c = 0; c < 3; ++c)
      out.segment<3>(3 * c) = root_.transpose() * Eigen::Map<const Eigen::Vector3f>(shape + 3 * c).cast<double>();
    return out;
  }
  Shape from(const Shape& point) const {
    Shape out;
    for (int c = 0; c < 3; ++c)
      out.segment<3>(3 * c) = root_.transpose().triangularView<Eigen::Upper>().solve(point.segment<3>(3 * c));
    return out;
  }

 private:
  Eigen::Matrix3d root_;
};

// A shape's product with the half vector, and where `phong` is given the highlight, as a row of the residual.
void write_row(const SimpleModels& simple, const Rows& columns, const Shape& shape, bool highlight,
               const std::vector<float>& roots, float* out) {
  const size_t pairs = roots.size();
  for (size_t c = 0; c < 3; ++c) {
    const float* s = columns.row(SimpleModels::kHalf);
    for (size_t p = 0; p < pairs; ++p) {
      double value = 0;
      for (size_t i = 0; i < 3; ++i)
        value += shape[static_cast<Eigen::Index>(3 * c + i)] * double{s[i * columns.length + p]};
      if (highlight) value += double{simple.mean().highlight[c]} * double{simple.highlight_column(columns)[p]};
      out[c * pairs + p] = static_cast<float>(value) * roots[p];
    }
  }
}

// Means, axes and coefficients of the shapes of each cluster.
ResidualFit residual_of(const Measurement& measurement, const SimpleModels& simple, const Metric& metric,
                        const Rows& points, const Clustering& clustering, const Worker& worker) {
  const Rows columns = simple.columns_at(measurement.pairs());
  const auto members = clustering.members();
  ResidualFit fit;
  fit.means = Rows(clustering.count, measurement.values());
  fit.terms = Rows(clustering.count * kMaxTerms, measurement.values());
  fit.coefficients.resize(points.count);
  worker.each(clustering.count, [&](size_t c) {
    const auto point = [&](size_t t) {
      return Eigen::Map<const Eigen::Matrix<float, kShape, 1>>(points.row(t)).cast<double>();
    };
    const auto count = static_cast<double>(members[c].size());
    Shape mean = Shape::Zero();
    for (const size_t t : members[c]) mean += point(t) / count;
    Square scatter = Square::Zero();
    for (const size_t t : members[c]) {
      const Shape from_mean = point(t) - mean;
      scatter += from_mean * from_mean.transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Square> solver(scatter);
    write_row(simple, columns, metric.from(mean), true, measurement.roots(), fit.means.row(c));
    for (size_t k = 0; k < kMaxTerms; ++k) {
      const auto column = static_cast<Eigen::Index>(kShape - 1 - k);
      const Shape axis = solver.eigenvectors().col(column);
      const double size = std::sqrt(std::max(solver.eigenvalues()[column], 0.0));
      write_row(simple, columns, metric.from(axis * size), false, measurement.roots(),
                fit.terms.row(c * kMaxTerms + k));
      for (const size_t t : members[c])
        fit.coefficients[t][k] = size > 0 ? static_cast<float>(axis.dot(point(t) - mean) / size) : 0.f;
    }
  });
  return fit;
}

// Relative RMSE of the field itself and of what is stored of it.
SrfReport errors_of(const Measurement& measurement, const SimpleModels& simple, const SpmmValues& stored,
                    const Worker& worker) {
  const Rows columns = simple.columns_at(measurement.pairs());
  constexpr size_t kGroups = 16;
  std::array<std::array<double, 3>, kGroups> sums{};  // truth, exact, stored
  worker.each(kGroups, [&](size_t group) {
    const size_t values = measurement.values(), texels = measurement.texels();
    std::vector<float> data(values), row(values);
    const auto difference = [&] {
      double sum = 0;
      for (size_t i = 0; i < values; ++i)
        sum += std::pow(double{data[i] - std::max(row[i], 0.f) * measurement.roots()[i % measurement.pair_count()]}, 2);
      return sum;
    };
    for (size_t t = texels * group / kGroups; t < texels * (group + 1) / kGroups && !worker.cancelled(); ++t) {
      measurement.read(t, data.data());
      measurement.btf().forget(t, 1);
      for (const float value : data) sums[group][0] += double{value} * double{value};
      simple.srf(t, columns, row.data());
      sums[group][1] += difference();
      stored.functions(t, row.data());
      for (int k = 0; k <= stored.terms(); ++k) stored.add_residual(t, k, row.data());
      sums[group][2] += difference();
    }
  });
  std::array<double, 3> sum{};
  for (const auto& part : sums)
    for (size_t i = 0; i < 3; ++i) sum[i] += part[i];
  return {std::sqrt(sum[1] / sum[0]), std::sqrt(sum[2] / sum[0])};
}

}  // namespace

Result<SrfResult> fit_srf(const Btf& btf, const SrfOptions& options, Progress* progress) {
  VAMP_CHECK_STATUS(check_measurement(btf));
  Worker worker{options.threads, progress};
  if (worker.threads <= 0) worker.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const Measurement measurement(btf);
  if (!can_have_residual(measurement))
    return fail(ErrorKind::bad_input, btf.info().name, "directions", "the same for views and lights", "others");
  const SimpleModels simple(measurement, worker);
  if (worker.cancelled()) return JobQueue::cancelled_error();

  const Metric metric(simple.half_gram());
  Rows points(measurement.texels(), kShape);
  for (size_t t = 0; t < points.count; ++t)
    Eigen::Map<Eigen::Matrix<float, kShape, 1>>(points.row(t)) = metric.to(simple.shape(t)).cast<float>();
  Clustering clustering = k_means(points, static_cast<size_t>(options.clusters), options.seed, worker);
  fit_subspaces(points, kMaxTerms, 15, worker, clustering);
  if (worker.cancelled()) return JobQueue::cancelled_error();

  // Lambert's column is cos / pi.
  const std::vector<Basis> dictionary = {{"matte", default_lobe(Model::lambert), {0, 0, 1}, 0}};
  TexelWeights weights{{0}, {}};
  for (const float kd : simple.mean().diffuse) weights.weights.push_back(kd * std::numbers::pi_v<float>);
  const ResidualFit residual = residual_of(measurement, simple, metric, points, clustering, worker);
  SrfResult result;
  result.spmm = bake(measurement, dictionary, std::vector<TexelWeights>(points.count, weights), clustering, &residual,
                     kMaxTerms, 0);
  result.spmm.clusters = name_clusters(cluster_colours(result.spmm));
  VAMP_CHECK_STATUS(validate(result.spmm, btf.info().name));
  VAMP_TRY(const SpmmValues stored, SpmmValues::make(result.spmm, measurement.pairs()));
  result.report = errors_of(measurement, simple, stored, worker);
  if (worker.cancelled()) return JobQueue::cancelled_error();
  return result;
}

}  // namespace vamp::fit
