// What measured BTFs stand on: direction sets and memory maps.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <map>
#include <numbers>

#include "engine/core/direction_set.h"
#include "engine/core/memory_map.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

// How many directions lie on each ring, by theta in tenths of a degree.
std::map<int, int> rings(const DirectionSet& set) {
  std::map<int, int> counts;
  for (const dvec3& direction : set.directions)
    ++counts[static_cast<int>(std::lround(angles_of(direction).theta / kDegree * 10))];
  return counts;
}

TEST(DirectionSet, RingsAreThoseOfTheInstruments) {
  EXPECT_EQ(rings(ubo81()), (std::map<int, int>{{0, 1}, {150, 6}, {300, 12}, {450, 18}, {600, 20}, {750, 24}}));
  EXPECT_EQ(
      rings(dome151()),
      (std::map<int, int>{
          {0, 1}, {110, 6}, {235, 12}, {300, 12}, {375, 12}, {450, 18}, {525, 18}, {600, 24}, {675, 24}, {750, 24}}));
  EXPECT_EQ(ubo81().size(), 81u);
  EXPECT_EQ(dome151().size(), 151u);
  EXPECT_NEAR(angles_of(dome151()[1]).phi / kDegree, 15, 1e-9);
}

TEST(DirectionSet, AnglesGoThereAndBack) {
  for (const DirectionSet& set : {ubo81(), dome151()})
    for (const dvec3& direction : set.directions) {
      const SphericalAngles angles = angles_of(direction);
      EXPECT_GE(angles.phi, 0);
      EXPECT_LT(angles.phi, 2 * std::numbers::pi);
      EXPECT_LT(glm::length(direction_of(angles) - direction), 1e-15);
    }
  EXPECT_EQ(angles_of({0, 0, 1}).phi, 0);
}

TEST(DirectionSet, StandardSetsAreKnownByTheirDirectionsInTheirOrder) {
  EXPECT_EQ(named_direction_set(ubo81().directions).name, "ubo81");
  auto directions = dome151().directions;
  directions[80] = direction_of({angles_of(directions[80]).theta + 1e-4, angles_of(directions[80]).phi});
  EXPECT_EQ(named_direction_set(directions).name, "dome151");
  std::swap(directions[3], directions[4]);
  EXPECT_EQ(named_direction_set(directions).name, "own");
  EXPECT_EQ(named_direction_set({}).name, "own");
}

class Map : public ::testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(Map, WhatIsWrittenIsInTheFile) {
  {
    auto map = MemoryMap::create(folder_ / "a", 10000);
    ASSERT_TRUE(map) << map.error().message();
    map->writable()[9999] = std::byte{7};
    MemoryMap moved = std::move(*map);
    EXPECT_TRUE(map->bytes().empty());
    moved.writable()[0] = std::byte{1};
    moved.forget(0, 10000);
    EXPECT_EQ(moved.bytes()[0], std::byte{1});
    ASSERT_TRUE(moved.flush(folder_ / "a"));
  }
  const auto map = MemoryMap::open(folder_ / "a", MapAccess::read);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->bytes().size(), 10000u);
  EXPECT_EQ(map->bytes()[0], std::byte{1});
  EXPECT_EQ(map->bytes()[5000], std::byte{0});
  EXPECT_EQ(map->bytes()[9999], std::byte{7});
}

TEST_F(Map, AFileThatIsReplacedStaysWholeForThoseWhoReadIt) {
  ASSERT_TRUE(write_text_atomically(folder_ / "a", "old"));
  const MemoryMap old = MemoryMap::open(folder_ / "a", MapAccess::read).value();
  ASSERT_TRUE(MemoryMap::create(folder_ / "a", 5));
  EXPECT_EQ(std::to_integer<char>(old.bytes()[2]), 'd');
}

TEST_F(Map, WhatIsNoFileIsRefusedAtOnce) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  ASSERT_TRUE(write_text_atomically(folder_ / "empty", ""));
  const auto message = [](const fs::path& path) { return MemoryMap::open(path, MapAccess::read).error().message(); };
  EXPECT_THAT(message(folder_ / "pipe"), HasSubstr("expected a file, found a device or a pipe"));
  EXPECT_THAT(message("/dev/zero"), HasSubstr("expected a file, found a device or a pipe"));
  EXPECT_THAT(message(folder_.path()), HasSubstr("expected a file, found a folder"));
  EXPECT_THAT(message(folder_ / "empty"), HasSubstr("found an empty file"));
  EXPECT_THAT(message(folder_ / "none"), HasSubstr("nothing there"));
}

TEST_F(Map, WithoutRoomNothingIsLeftBehind) {
  // More than any disk has.
  const auto map = MemoryMap::create(folder_ / "a", uint64_t{1} << 60);
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().kind, ErrorKind::io);
  EXPECT_FALSE(fs::exists(folder_ / "a"));
  EXPECT_FALSE(MemoryMap::create("/dev/full", 10));
  EXPECT_FALSE(MemoryMap::create(folder_ / "no" / "a", 10));
}

}  // namespace
}  // namespace vamp
