#pragma once
// Groups of texels that look alike, by their coordinates (coordinates.h).
#include <cstdint>
#include <vector>

#include "engine/fit/parallel.h"
#include "engine/fit/rows.h"

namespace vamp::fit {

// Which cluster each point belongs to; every cluster has at least one point.
struct Clustering {
  size_t count = 0;
  std::vector<uint16_t> of;

  std::vector<std::vector<size_t>> members() const;
};

// k-means++ (Arthur and Vassilvitskii 2007), then Lloyd's iterations until nothing moves, at most 100. Fewer clusters
// than asked for where there are fewer distinct points.
Clustering k_means(const Rows& points, size_t clusters, uint64_t seed, const Worker& worker);

// Moves points to the cluster whose affine subspace (mean and `terms` principal axes) is nearest: the clusters for
// which a residual of so many terms loses least. At most `iterations` rounds.
void fit_subspaces(const Rows& points, size_t terms, int iterations, const Worker& worker, Clustering& clustering);

// The texel nearest to the mean of each of a cluster's parts.
struct Representative {
  size_t texel = 0;
  size_t cluster = 0;
  size_t stands_for = 0;  // texels of its part
};
std::vector<Representative> find_representatives(const Rows& points, const Clustering& clustering, size_t per_cluster,
                                                 uint64_t seed, const Worker& worker);

}  // namespace vamp::fit
