#pragma once
// How the residual follows an edit. What a fit leaves is mostly a function misplaced, or cut off by shadows: it lies
// where that function is bright. So an edit of a function is an edit of its share of the residual.
#include <utility>
#include <vector>

#include "engine/material/edit_layer.h"

namespace vamp {

struct FitSums;

// At each of up to 1024 pairs of directions the residual's energy is split as the functions' light is split there. What
// one channel has more of than the others, relative to that light, has a colour of its own (a white highlight on brown
// leather) and goes to the functions whose weights are the whiter.
struct ResidualShares {
  std::vector<dvec3> of_basis;  // [cluster * bases + basis]: each channel sums to 1 over a cluster, or is all 0 where
                                // no pair tells (a black channel, no residual)
  std::vector<dvec3> of_channel;  // [cluster]: its energy; the channels sum to 1
};
// `weights`: sums of the fit's RGB weights, [cluster * bases + basis].
ResidualShares residual_shares(const Spmm& spmm, const std::vector<dvec3>& weights);

// Root of the integral of fcos^2 over lights, for a viewer 30 degrees off the lobe's own normal: how large a function
// is to a squared error. A highlight made twice as wide has the same albedo and half of this.
double lobe_size(const Lobe& lobe);

// Sizes of the lobes met so far: an edit often gives one lobe to many clusters.
class LobeSizes {
 public:
  double of(const Lobe& lobe);

 private:
  std::vector<std::pair<Lobe, double>> known_;
};

// What multiplies the residual of an edited cluster: each function's share times its gain and the ratio of its sizes
// (0 for another shape where the policy is to fade), and all of it times the ratio of mean slopes, because shadows and
// masking go with the relief. Channels differ by a third of what that gives: at slanted views neighbours of another
// colour show. Linear in gains. 1 in a channel whose shares are not known. Measured by `vamp bench edits`.
dvec3 residual_scale(const Spmm& spmm, const EditLayer& edits, const FitSums& sums, int cluster, LobeSizes& sizes);

}  // namespace vamp
