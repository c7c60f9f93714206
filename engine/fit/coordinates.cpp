#include "engine/fit/coordinates.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

namespace vamp::fit {
namespace {

constexpr size_t kBlock = 64;  // texels read at a time
constexpr size_t kParts = 8;   // partial sums, whatever the number of threads

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Calls work(first texel's place in the list, count, rows) for blocks of a part of `texels`.
template <class Work>
void read_part(const Measurement& measurement, const std::vector<size_t>& texels, size_t part, const Worker& worker,
               const Work& work) {
  const size_t first = texels.size() * part / kParts, end = texels.size() * (part + 1) / kParts;
  Rows rows(std::min(kBlock, end - first), measurement.values());
  for (size_t at = first; at < end && !worker.cancelled(); at += kBlock) {
    const size_t count = std::min(kBlock, end - at);
    for (size_t i = 0; i < count; ++i) {
      measurement.read(texels[at + i], rows.row(i));
      measurement.btf().forget(texels[at + i], 1);
    }
    work(at, count, rows);
  }
}

// Sum over the parts of what `work` adds to its rows.
template <class Work>
Rows summed(size_t count, size_t length, const Worker& worker, const Work& work) {
  std::vector<Rows> parts(kParts);
  worker.each(kParts, [&](size_t part) {
    parts[part] = Rows(count, length);
    work(part, parts[part]);
  });
  for (size_t part = 1; part < kParts && !worker.cancelled(); ++part)
    for (size_t i = 0; i < parts[0].data.size(); ++i) parts[0].data[i] += parts[part].data[i];
  return std::move(parts[0]);
}

// Replaces rows by an orthonormal basis of their span; directions below rounding are left out.
Rows orthonormal(const Rows& rows) {
  if (rows.count == 0) return rows;
  const auto n = static_cast<Eigen::Index>(rows.count);
  Matrix gram(n, n);
  gram_rows(rows.row(0), rows.count, rows.length, gram.data());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  const double floor = 1e-10 * std::max(solver.eigenvalues()[n - 1], 0.0) + 1e-30;
  std::vector<float> mix;
  size_t count = 0;
  for (Eigen::Index k = n; k-- > 0;) {
    if (!(solver.eigenvalues()[k] > floor)) break;
    const double scale = 1 / std::sqrt(solver.eigenvalues()[k]);
    for (Eigen::Index i = 0; i < n; ++i) mix.push_back(static_cast<float>(solver.eigenvectors()(i, k) * scale));
    ++count;
  }
  Rows out(count, rows.length);
  add_combinations(mix.data(), count, rows.row(0), rows.count, rows.length, out.row(0));
  return out;
}

std::vector<float> transposed(const std::vector<double>& m, size_t rows, size_t columns) {
  std::vector<float> out(m.size());
  for (size_t i = 0; i < rows; ++i)
    for (size_t j = 0; j < columns; ++j) out[j * rows + i] = static_cast<float>(m[i * columns + j]);
  return out;
}

// A random combination of the texels for each row: the first guess of their span.
Rows random_combinations(const Measurement& measurement, const std::vector<size_t>& texels, size_t count, uint64_t seed,
                         const Worker& worker) {
  return summed(count, measurement.values(), worker, [&](size_t part, Rows& sum) {
    std::mt19937_64 random(seed * kParts + part);
    std::normal_distribution<float> normal;
    std::vector<float> mix;
    read_part(measurement, texels, part, worker, [&](size_t, size_t n, const Rows& rows) {
      mix.resize(count * n);
      for (float& value : mix) value = normal(random);
      add_combinations(mix.data(), count, rows.row(0), n, rows.length, sum.row(0));
    });
  });
}

// One power iteration: X'X times the directions.
Rows iterated(const Measurement& measurement, const std::vector<size_t>& texels, const Rows& directions,
              const Worker& worker) {
  return summed(directions.count, measurement.values(), worker, [&](size_t part, Rows& sum) {
    std::vector<double> products;
    read_part(measurement, texels, part, worker, [&](size_t, size_t n, const Rows& rows) {
      products.resize(n * directions.count);
      dot_rows(rows.row(0), n, directions.row(0), directions.count, rows.length, products.data());
      const std::vector<float> mix = transposed(products, n, directions.count);
      add_combinations(mix.data(), directions.count, rows.row(0), n, rows.length, sum.row(0));
    });
  });
}

// Turns directions and coordinates to the principal axes of all texels, and keeps the `rank` strongest.
void principal(Coordinates& found, size_t rank) {
  const size_t n = found.directions.count, texels = found.coordinates.count;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  for (size_t t = 0; t < texels; ++t) {
    const Eigen::Map<const Eigen::VectorXf> row(found.coordinates.row(t), static_cast<Eigen::Index>(n));
    gram.selfadjointView<Eigen::Lower>().rankUpdate(row.cast<double>());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
  const size_t kept = std::min(rank, n);
  std::vector<float> mix(kept * n), back(n * kept);
  for (size_t k = 0; k < kept; ++k)
    for (size_t i = 0; i < n; ++i)
      mix[k * n + i] = back[i * kept + k] =
          static_cast<float>(solver.eigenvectors()(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(n - 1 - k)));
  Rows directions(kept, found.directions.length), coordinates(texels, kept);
  add_combinations(mix.data(), kept, found.directions.row(0), n, found.directions.length, directions.row(0));
  add_combinations(found.coordinates.row(0), texels, back.data(), n, kept, coordinates.row(0));
  found.directions = std::move(directions);
  found.coordinates = std::move(coordinates);
}

}  // namespace

Coordinates find_coordinates(const Measurement& measurement, const CoordinateOptions& options, const Worker& worker) {
  const size_t texels = measurement.texels(), sample = std::min(options.sample, texels);
  const size_t wanted = std::min({options.rank + options.oversampling, sample, measurement.values()});
  std::vector<size_t> some(sample), all(texels);
  for (size_t i = 0; i < sample; ++i) some[i] = i * texels / sample;
  for (size_t i = 0; i < texels; ++i) all[i] = i;

  Coordinates found;
  worker.stage("Looking for what texels have in common");
  found.directions = orthonormal(random_combinations(measurement, some, wanted, options.seed, worker));
  for (int i = 0; i < options.power_iterations && found.directions.count > 0 && !worker.cancelled(); ++i)
    found.directions = orthonormal(iterated(measurement, some, found.directions, worker));
  if (worker.cancelled()) return found;

  worker.stage("Placing the texels");
  const size_t n = found.directions.count;
  found.coordinates = Rows(texels, n);
  std::vector<double> squares(kParts);
  worker.each(kParts, [&](size_t part) {
    std::vector<double> products(kBlock * n);
    read_part(measurement, all, part, worker, [&](size_t at, size_t count, const Rows& rows) {
      dot_rows(rows.row(0), count, found.directions.row(0), n, rows.length, products.data());
      for (size_t i = 0; i < count * n; ++i) found.coordinates.data[at * n + i] = static_cast<float>(products[i]);
      for (size_t i = 0; i < count; ++i) {
        double square = 0;
        dot_rows(rows.row(i), 1, rows.row(i), 1, rows.length, &square);
        squares[part] += square;
      }
    });
  });
  for (const double square : squares) found.square += square;
  if (n > 0 && !worker.cancelled()) principal(found, options.rank);
  return found;
}

}  // namespace vamp::fit
