#include "engine/fit/clusters.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <random>

namespace vamp::fit {
namespace {

constexpr size_t kBlock = 512;  // points that one piece of work looks at

double distance2(const float* a, const float* b, size_t n) {
  double sum = 0;
  for (size_t k = 0; k < n; ++k) sum += double{a[k] - b[k]} * double{a[k] - b[k]};
  return sum;
}

double square_of(const float* a, size_t n) {
  double square = 0;
  dot_rows(a, 1, a, 1, n, &square);
  return square;
}

// In [0, 1), the same on every machine.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// Seeds far from one another: each new one is drawn in proportion to its squared distance from those before.
Rows seeds(const Rows& points, size_t clusters, std::mt19937_64& random) {
  Rows centres(clusters, points.length);
  std::vector<double> nearest(points.count, std::numeric_limits<double>::max());
  size_t chosen = static_cast<size_t>(uniform(random) * static_cast<double>(points.count));
  size_t found = 0;
  while (true) {
    std::copy(points.row(chosen), points.row(chosen) + points.length, centres.row(found));
    double total = 0;
    for (size_t i = 0; i < points.count; ++i) {
      nearest[i] = std::min(nearest[i], distance2(points.row(i), centres.row(found), points.length));
      total += nearest[i];
    }
    if (++found == clusters || !(total > 0)) break;
    double left = uniform(random) * total;
    chosen = points.count - 1;
    for (size_t i = 0; i < points.count; ++i) {
      left -= nearest[i];
      if (left < 0) {
        chosen = i;
        break;
      }
    }
  }
  centres.count = found;
  centres.data.resize(found * points.length);
  return centres;
}

Rows means(const Rows& points, const Clustering& clustering) {
  std::vector<double> sums(clustering.count * points.length), counts(clustering.count);
  for (size_t i = 0; i < points.count; ++i) {
    const size_t c = clustering.of[i];
    counts[c] += 1;
    for (size_t k = 0; k < points.length; ++k) sums[c * points.length + k] += double{points.row(i)[k]};
  }
  Rows centres(clustering.count, points.length);
  for (size_t i = 0; i < sums.size(); ++i) centres.data[i] = static_cast<float>(sums[i] / counts[i / points.length]);
  return centres;
}

// A cluster that lost its last point takes the one that lies farthest from its own.
void fill_empty(const std::vector<double>& distances, Clustering& clustering) {
  std::vector<size_t> sizes(clustering.count);
  for (const uint16_t c : clustering.of) ++sizes[c];
  std::vector<double> left = distances;
  for (size_t c = 0; c < clustering.count; ++c) {
    if (sizes[c] > 0) continue;
    size_t farthest = 0;
    double most = -1;
    for (size_t i = 0; i < left.size(); ++i)
      if (left[i] > most && sizes[clustering.of[i]] > 1) farthest = i, most = left[i];
    --sizes[clustering.of[farthest]], ++sizes[c];
    clustering.of[farthest] = static_cast<uint16_t>(c);
    left[farthest] = -2;
  }
}

// Squared distances of a block of points to every cluster: [point * clusters + cluster].
using Distances = std::function<void(size_t first, size_t count, double* out)>;

// Gives every point to the nearest cluster; whether any moved.
bool assign(size_t count, const Worker& worker, const Distances& distances, Clustering& clustering) {
  std::vector<double> least(count);
  const std::vector<uint16_t> before = clustering.of;
  worker.each((count + kBlock - 1) / kBlock, [&](size_t block) {
    const size_t first = block * kBlock, n = std::min(kBlock, count - first), clusters = clustering.count;
    std::vector<double> all(n * clusters);
    distances(first, n, all.data());
    for (size_t i = 0; i < n; ++i) {
      const double* row = all.data() + i * clusters;
      const double* nearest = std::min_element(row, row + clusters);
      least[first + i] = *nearest;
      clustering.of[first + i] = static_cast<uint16_t>(nearest - row);
    }
  });
  fill_empty(least, clustering);
  return clustering.of != before;
}

// |x - c|^2 less |x|^2, which is the same for all clusters, from products of rows.
void distances_to(const Rows& points, const Rows& centres, size_t first, size_t count, double* out) {
  dot_rows(points.row(first), count, centres.row(0), centres.count, points.length, out);
  for (size_t c = 0; c < centres.count; ++c) {
    const double square = square_of(centres.row(c), points.length);
    for (size_t i = 0; i < count; ++i) out[i * centres.count + c] = square - 2 * out[i * centres.count + c];
  }
}

}  // namespace

std::vector<std::vector<size_t>> Clustering::members() const {
  std::vector<std::vector<size_t>> lists(count);
  for (size_t i = 0; i < of.size(); ++i) lists[of[i]].push_back(i);
  return lists;
}

Clustering k_means(const Rows& points, size_t clusters, uint64_t seed, const Worker& worker) {
  std::mt19937_64 random(seed);
  Rows centres = seeds(points, std::min(clusters, points.count), random);
  Clustering clustering{centres.count, std::vector<uint16_t>(points.count)};
  for (int iteration = 0; iteration < 100 && !worker.cancelled(); ++iteration) {
    const bool moved = assign(
        points.count, worker,
        [&](size_t first, size_t n, double* out) { distances_to(points, centres, first, n, out); }, clustering);
    if (!moved && iteration > 0) break;
    centres = means(points, clustering);
  }
  return clustering;
}

void fit_subspaces(const Rows& points, size_t terms, int iterations, const Worker& worker, Clustering& clustering) {
  const auto n = static_cast<Eigen::Index>(points.length);
  const size_t axes_each = std::min(terms, points.length);
  for (int iteration = 0; iteration < iterations && !worker.cancelled(); ++iteration) {
    const Rows centres = means(points, clustering);
    const auto members = clustering.members();
    // Principal axes of all clusters, and where each centre lies on them.
    Rows axes(clustering.count * axes_each, points.length);
    std::vector<double> offsets(axes.count);
    worker.each(clustering.count, [&](size_t c) {
      Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(n, n);
      const Eigen::Map<const Eigen::VectorXf> centre(centres.row(c), n);
      for (const size_t i : members[c]) {
        const Eigen::Map<const Eigen::VectorXf> point(points.row(i), n);
        scatter.selfadjointView<Eigen::Lower>().rankUpdate((point - centre).cast<double>());
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scatter);
      for (size_t k = 0; k < axes_each; ++k) {
        float* axis = axes.row(c * axes_each + k);
        Eigen::Map<Eigen::VectorXf>(axis, n) =
            solver.eigenvectors().col(n - 1 - static_cast<Eigen::Index>(k)).cast<float>();
        dot_rows(axis, 1, centres.row(c), 1, points.length, &offsets[c * axes_each + k]);
      }
    });
    const bool moved = assign(
        points.count, worker,
        [&](size_t first, size_t count, double* out) {
          distances_to(points, centres, first, count, out);
          std::vector<double> along(count * axes.count);
          dot_rows(points.row(first), count, axes.row(0), axes.count, points.length, along.data());
          for (size_t i = 0; i < count; ++i)
            for (size_t a = 0; a < axes.count; ++a) {
              const double d = along[i * axes.count + a] - offsets[a];
              out[i * centres.count + a / axes_each] -= d * d;
            }
        },
        clustering);
    if (!moved) break;
  }
}

std::vector<Representative> find_representatives(const Rows& points, const Clustering& clustering, size_t per_cluster,
                                                 uint64_t seed, const Worker& worker) {
  std::vector<Representative> found;
  const auto members = clustering.members();
  for (size_t c = 0; c < clustering.count && !worker.cancelled(); ++c) {
    Rows own(members[c].size(), points.length);
    for (size_t i = 0; i < own.count; ++i)
      std::copy(points.row(members[c][i]), points.row(members[c][i]) + points.length, own.row(i));
    const Clustering parts = k_means(own, per_cluster, seed + c + 1, worker);
    const Rows centres = means(own, parts);
    std::vector<Representative> nearest(parts.count);
    std::vector<double> least(parts.count, std::numeric_limits<double>::max());
    for (size_t i = 0; i < own.count; ++i) {
      const size_t part = parts.of[i];
      ++nearest[part].stands_for;
      const double d = distance2(own.row(i), centres.row(part), own.length);
      if (d < least[part]) least[part] = d, nearest[part].texel = members[c][i], nearest[part].cluster = c;
    }
    found.insert(found.end(), nearest.begin(), nearest.end());
  }
  return found;
}

}  // namespace vamp::fit
