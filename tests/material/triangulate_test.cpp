#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "engine/material/directions.h"
#include "tests/material/small_spmm.h"

namespace vamp {
namespace {

DirectionTables ubo_tables() { return triangulate(ubo2003_directions(), "test").value(); }

dvec3 from_disk(double px, double py) {
  const double r2 = px * px + py * py, z = (1 - r2) / (1 + r2);
  return {px * (1 + z), py * (1 + z), z};
}

// What a table over directions reads at w.
template <class F>
double interpolated(const DirectionTables& tables, const std::vector<vec3>& directions, dvec3 w, F value) {
  const auto found = find_direction(tables, w);
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) sum += found.weight[i] * value(directions[static_cast<size_t>(found.slot[i])]);
  return sum;
}

TEST(Triangulate, TheUbo2003SetHas184Triangles) { EXPECT_EQ(ubo_tables().triangles.size(), 184u); }

TEST(Triangulate, IsExactAtEveryMeasuredDirection) {
  const auto directions = ubo2003_directions();
  const DirectionTables tables = ubo_tables();
  for (size_t i = 0; i < directions.size(); ++i) {
    const auto check = [&](const auto& found, double tolerance) {
      double own = 0;
      for (size_t k = 0; k < 3; ++k)
        if (found.slot[k] == static_cast<int>(i)) own += static_cast<double>(found.weight[k]);
      // Half a unit in the last place of a half is 2.4e-4: the stored sample is read back exactly.
      EXPECT_NEAR(own, 1, tolerance) << "direction " << i;
    };
    check(find_direction(tables, dvec3(directions[i])), 1e-6);
    check(find_direction(tables, directions[i]), 2e-6);
  }
}

TEST(Triangulate, WeightsArePartitionsOfUnityEverywhereUpToTheHorizon) {
  const DirectionTables tables = ubo_tables();
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    dvec3 w = test::random_direction(random);
    if (i % 4 == 0) w = glm::dvec3(w.x, w.y, 0) / std::hypot(w.x, w.y);  // on the horizon itself
    const auto found = find_direction(tables, vec3(w));
    float sum = 0;
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_GE(found.weight[k], 0);
      EXPECT_TRUE(std::isfinite(found.weight[k]));
      EXPECT_LT(found.slot[k], 81);
      sum += found.weight[k];
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
}

TEST(Triangulate, NoDirectionLiesOutsideEveryTriangle) {
  const DirectionTables tables = ubo_tables();
  std::mt19937 random(5);
  double worst = 0;
  for (int i = 0; i < 50000; ++i) {
    const dvec3 w = test::random_direction(random);
    const double px = w.x / (1 + w.z), py = w.y / (1 + w.z);
    double best = -1;
    for (const auto& t : tables.triangles) {
      const double a = double{t.row1[0]} * px + double{t.row1[1]} * py + double{t.row1[2]};
      const double b = double{t.row2[0]} * px + double{t.row2[1]} * py + double{t.row2[2]};
      best = std::max(best, std::min({a, b, 1 - a - b}));
    }
    worst = std::min(worst, best);
  }
  EXPECT_GT(worst, -1e-6);
}

TEST(Triangulate, MapFindsTheRightTriangleButForAMapCellAtEdges) {
  const DirectionTables tables = ubo_tables();
  std::mt19937 random(7);
  for (int i = 0; i < 50000; ++i) {
    const dvec3 w = test::random_direction(random);
    const double px = w.x / (1 + w.z), py = w.y / (1 + w.z);
    const auto cell = [](double p) { return std::clamp(static_cast<int>((p * 0.5 + 0.5) * 256), 0, 255); };
    const auto& t = tables.triangles[tables.map[static_cast<size_t>(cell(py)) * 256 + static_cast<size_t>(cell(px))]];
    const double a = double{t.row1[0]} * px + double{t.row1[1]} * py + double{t.row1[2]};
    const double b = double{t.row2[0]} * px + double{t.row2[1]} * py + double{t.row2[2]};
    // A cell is 1/128 wide, the lowest triangle about 0.1 high: outside by at most its diagonal.
    EXPECT_GT(std::min({a, b, 1 - a - b}), -0.12) << px << " " << py;
  }
}

TEST(Triangulate, ReproducesPlanesOnTheDiskAndIsContinuousAcrossEdges) {
  const auto directions = ubo2003_directions();
  const DirectionTables tables = ubo_tables();
  const auto plane = [](vec3 d) {
    const dvec3 w(d);
    return 0.3 + 0.5 * w.x / (1 + w.z) - 0.2 * w.y / (1 + w.z);
  };
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const double px = uniform(random) * 0.74, py = uniform(random) * 0.74;
    if (std::hypot(px, py) > 0.755) continue;
    // Clamping a slightly negative weight near an edge moves the value by less than that weight times the slope.
    EXPECT_NEAR(interpolated(tables, directions, from_disk(px, py), plane), 0.3 + 0.5 * px - 0.2 * py, 0.012);
    const double qx = px + 1e-7, qy = py - 1e-7;
    EXPECT_NEAR(interpolated(tables, directions, from_disk(px, py), plane),
                interpolated(tables, directions, from_disk(qx, qy), plane), 0.012);
  }
}

TEST(Triangulate, PastTheLastRingTheNearestDirectionsAreRead) {
  const auto directions = ubo2003_directions();
  const DirectionTables tables = ubo_tables();
  for (int i = 0; i < 360; ++i) {
    const double phi = i * std::numbers::pi / 180;
    const auto found = find_direction(tables, dvec3(std::cos(phi), std::sin(phi), 0));
    for (size_t k = 0; k < 3; ++k)
      if (found.weight[k] > 1e-9) {
        const vec3 d = directions[static_cast<size_t>(found.slot[k])];
        EXPECT_GT(double{d.x} * std::cos(phi) + double{d.y} * std::sin(phi), 0.92) << i;
      }
  }
}

TEST(Triangulate, ATurnThroughTheFirstAzimuthIsContinuous) {
  const auto directions = ubo2003_directions();
  const DirectionTables tables = ubo_tables();
  const auto height = [](vec3 d) { return double{d.z} + 0.1 * double{d.x}; };
  for (const double theta : {7.0, 20.0, 40.0, 60.0, 75.0001, 80.0, 89.9}) {
    const double t = theta * std::numbers::pi / 180, e = 1e-6;
    const auto at = [&](double phi) {
      return dvec3(std::sin(t) * std::cos(phi), std::sin(t) * std::sin(phi), std::cos(t));
    };
    EXPECT_NEAR(interpolated(tables, directions, at(e), height), interpolated(tables, directions, at(-e), height),
                0.01);
  }
}

TEST(Triangulate, DoesNotDependOnTheOrderOfTheFile) {
  auto directions = ubo2003_directions();
  const DirectionTables first = triangulate(directions, "test").value();
  std::reverse(directions.begin(), directions.end());
  const DirectionTables second = triangulate(directions, "test").value();
  const auto sets = [&](const DirectionTables& tables, bool reversed) {
    std::multiset<std::set<uint32_t>> all;
    for (const auto& t : tables.triangles) {
      std::set<uint32_t> corners;
      for (int k = 0; k < 3; ++k) {
        const uint32_t slot = (t.slots >> (10 * k)) & 1023u;
        corners.insert(reversed ? 80 - slot : slot);
      }
      if (corners.size() == 3) all.insert(corners);
    }
    return all;
  };
  EXPECT_EQ(sets(first, false), sets(second, true));
}

TEST(Triangulate, OtherSetsWorkToo) {
  EXPECT_TRUE(triangulate({{0, 0, 1}}, "one"));
  std::mt19937 random(11);
  std::vector<vec3> many;
  for (int i = 0; i < 300; ++i) {
    // Fibonacci points: no two alike.
    const double z = 1 - (i + 0.5) / 300, phi = i * 2.39996323, s = std::sqrt(1 - z * z);
    many.emplace_back(static_cast<float>(s * std::cos(phi)), static_cast<float>(s * std::sin(phi)),
                      static_cast<float>(z));
  }
  const auto tables = triangulate(many, "many");
  ASSERT_TRUE(tables);
  EXPECT_EQ(tables->triangles.size(), 2 * (300u + 24) - 26);
}

TEST(Triangulate, RefusesWhatIsNoDirectionSet) {
  EXPECT_FALSE(triangulate({}, "f"));
  EXPECT_FALSE(triangulate({{0, 0, 1}, {0, 0, 1}}, "f"));
  EXPECT_FALSE(triangulate({{0, 0, -1}}, "f"));
  EXPECT_FALSE(triangulate({{0, 0, 2}}, "f"));
  EXPECT_FALSE(triangulate({{0, 0, std::nanf("")}}, "f"));
  const auto error = triangulate({{0, 0, 1}, {0, 0.6f, -0.8f}}, "x.vamp");
  ASSERT_FALSE(error);
  EXPECT_EQ(error.error().kind, ErrorKind::bad_input);
  EXPECT_EQ(error.error().place, "directions[1]");
}

}  // namespace
}  // namespace vamp
