#include "engine/fit/clusters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "engine/fit/coordinates.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

// `count` points about each of `centres` far apart.
Rows blobs(uint32_t seed, size_t centres, size_t count) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  Rows points(centres * count, 6);
  for (size_t i = 0; i < points.count; ++i)
    for (size_t k = 0; k < 6; ++k) points.row(i)[k] = normal(random) * 0.1f + (k == i % centres ? 10.f : 0.f);
  return points;
}

TEST(KMeans, FindsGroupsThatLieApart) {
  const Rows points = blobs(1, 5, 40);
  const Clustering clustering = k_means(points, 5, 3, {});
  ASSERT_EQ(clustering.count, 5u);
  for (size_t i = 0; i < points.count; ++i) EXPECT_EQ(clustering.of[i], clustering.of[i % 5]);
  EXPECT_EQ(std::set<uint16_t>(clustering.of.begin(), clustering.of.end()).size(), 5u);
}

TEST(KMeans, EqualPointsMakeOneCluster) {
  Rows points(30, 3);
  const Clustering clustering = k_means(points, 8, 1, {});
  EXPECT_EQ(clustering.count, 1u);
}

TEST(KMeans, MorePointsThanClustersOrFewerEveryClusterHasOne) {
  for (const size_t wanted : {1u, 3u, 12u, 40u}) {
    const Rows points = blobs(2, 4, 3);
    const Clustering clustering = k_means(points, wanted, 1, {});
    EXPECT_LE(clustering.count, std::min<size_t>(wanted, points.count));
    for (const auto& members : clustering.members()) EXPECT_FALSE(members.empty());
  }
}

TEST(KMeans, ThreadsDoNotShow) {
  const Rows points = blobs(3, 7, 300);
  EXPECT_EQ(k_means(points, 9, 5, {.threads = 1}).of, k_means(points, 9, 5, {.threads = 5}).of);
}

// Two crossing lines share their mean; only what they are spread along tells them apart.
TEST(Subspaces, TellLinesApartThatCross) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Rows points(400, 3);
  for (size_t i = 0; i < points.count; ++i) points.row(i)[i % 2] = uniform(random) * 3;
  Clustering clustering{2, {}};
  for (size_t i = 0; i < points.count; ++i)  // right for three points of four
    clustering.of.push_back(static_cast<uint16_t>(random() % 4 == 0 ? 1 - i % 2 : i % 2));
  fit_subspaces(points, 1, 20, {}, clustering);
  size_t right = 0;
  for (size_t i = 0; i < points.count; ++i) right += clustering.of[i] == clustering.of[i % 2] ? 1u : 0u;
  EXPECT_GT(right, 390u);
}

TEST(Representatives, StandForAllTexelsOfTheirCluster) {
  const Rows points = blobs(6, 3, 50);
  const Clustering clustering = k_means(points, 3, 1, {});
  const auto found = find_representatives(points, clustering, 4, 1, {});
  std::vector<size_t> stands(3);
  for (const Representative& each : found) {
    EXPECT_EQ(clustering.of[each.texel], each.cluster);
    stands[each.cluster] += each.stands_for;
  }
  EXPECT_EQ(stands, std::vector<size_t>({50, 50, 50}));
}

// Texels that are sums of few functions lie in a space of as many dimensions; coordinates keep what lies between them.
TEST(Coordinates, KeepDistancesOfLowRankMeasurements) {
  const test::Synthetic truth = test::random_synthetic(4, 64, 6, 3);
  const Btf btf = test::measure(truth, 8, 8);
  const Measurement measurement(btf);
  const Coordinates found = find_coordinates(measurement, {.rank = 20}, {});
  std::vector<float> a(measurement.values()), b(measurement.values());
  for (size_t t = 1; t < 64; t += 9) {
    measurement.read(0, a.data()), measurement.read(t, b.data());
    double true_distance = 0, distance = 0;
    for (size_t i = 0; i < a.size(); ++i) true_distance += std::pow(double{a[i] - b[i]}, 2);
    for (size_t k = 0; k < found.coordinates.length; ++k)
      distance += std::pow(double{found.coordinates.row(0)[k] - found.coordinates.row(t)[k]}, 2);
    EXPECT_NEAR(std::sqrt(distance), std::sqrt(true_distance), 1e-3 * std::sqrt(true_distance));
  }
  std::vector<double> gram(found.directions.count * found.directions.count);
  gram_rows(found.directions.row(0), found.directions.count, found.directions.length, gram.data());
  for (size_t i = 0; i < found.directions.count; ++i)
    for (size_t j = 0; j < found.directions.count; ++j)
      EXPECT_NEAR(gram[i * found.directions.count + j], i == j ? 1 : 0, 1e-4);
}

}  // namespace
}  // namespace vamp::fit
