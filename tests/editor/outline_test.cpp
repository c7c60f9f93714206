#include "app/editor/outline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/preset_dialog.h"

namespace vamp {
namespace {

// A picture of 9 x 7 pixels: part 0 fills a rectangle of 5 x 3 from (2, 2); its left column shows cluster 4, the
// rest 1.
constexpr int kWidth = 9, kHeight = 7;
std::vector<uint32_t> rectangle() {
  std::vector<uint32_t> ids(kWidth * kHeight, 0);
  for (int y = 2; y < 5; ++y)
    for (int x = 2; x < 7; ++x) ids[static_cast<size_t>(y * kWidth + x)] = 1u | (x == 2 ? 5u : 2u) << 16;
  return ids;
}

std::vector<uint8_t> alpha(const std::vector<uint8_t>& rgba) {
  std::vector<uint8_t> values;
  for (size_t i = 3; i < rgba.size(); i += 4) values.push_back(rgba[i]);
  return values;
}

size_t count(const std::vector<uint8_t>& values, uint8_t value) {
  return static_cast<size_t>(std::count(values.begin(), values.end(), value));
}

TEST(Outline, IsTransparentWhereNothingIsSelected) {
  const auto ids = rectangle();
  EXPECT_EQ(count(alpha(draw_outlines(ids, kWidth, kHeight, {}, {})), 0), ids.size());
  EXPECT_EQ(count(alpha(draw_outlines(ids, kWidth, kHeight, {7, -1}, {})), 0), ids.size());
}

TEST(Outline, FollowsTheBorderOfAHoveredPart) {
  // The border of 5 x 3 pixels is all but its middle row's 3 inner pixels.
  const auto shown = alpha(draw_outlines(rectangle(), kWidth, kHeight, {}, {0, -1}));
  EXPECT_EQ(shown.size() - count(shown, 0), 12u);
  EXPECT_EQ(shown[3 * kWidth + 4], 0);
}

TEST(Outline, OfASelectedPartHidesThatOfTheMouse) {
  const auto ids = rectangle();
  EXPECT_EQ(draw_outlines(ids, kWidth, kHeight, {0, -1}, {0, -1}), draw_outlines(ids, kWidth, kHeight, {0, -1}, {}));
}

TEST(Outline, DoesNotMistakeTheEdgeOfThePictureForABorder) {
  const std::vector<uint32_t> full(kWidth * kHeight, 1);
  EXPECT_EQ(count(alpha(draw_outlines(full, kWidth, kHeight, {0, -1}, {})), 0), full.size());
}

TEST(Outline, TintsOnlyTheSelectedCluster) {
  // A picture full of one part: no line, so that the tint stands alone.
  std::vector<uint32_t> ids(kWidth * kHeight, 1u | 2u << 16);
  ids[20] = ids[33] = 1u | 5u << 16;
  const auto shown = alpha(draw_outlines(ids, kWidth, kHeight, {0, 4}, {}));
  EXPECT_EQ(shown.size() - count(shown, 0), 2u);
  EXPECT_GT(shown[20], 0);
  EXPECT_GT(shown[33], 0);
}

TEST(Tags, AreTrimmedAndKeptOnce) {
  EXPECT_EQ(split_tags(" leather, #calf ,, leather ,full grain"),
            (std::vector<std::string>{"leather", "calf", "full grain"}));
  EXPECT_TRUE(split_tags(" , ,").empty());
}

}  // namespace
}  // namespace vamp
