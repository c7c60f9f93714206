#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "engine/core/half.h"
#include "engine/core/hash.h"

namespace vamp {
namespace {

TEST(Hash, MeetsThePublishedValuesOfNoBytes) {
  // xxHash's own test vectors for XXH3, length 0, seed 0.
  EXPECT_EQ(hash64({}), 0x2d06800538d394c2u);
  EXPECT_EQ(checksum({}), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, DependsOnEveryByteAndTheSeed) {
  std::vector<std::byte> bytes(1000);
  const auto before = checksum(bytes);
  EXPECT_NE(hash64(bytes), hash64(bytes, 1));
  bytes[999] = std::byte{1};
  EXPECT_NE(checksum(bytes), before);
  EXPECT_EQ(before.size(), 32u);
}

TEST(Half, KnownValues) {
  EXPECT_EQ(half_from_float(0.0f), 0x0000);
  EXPECT_EQ(half_from_float(-0.0f), 0x8000);
  EXPECT_EQ(half_from_float(1.0f), 0x3c00);
  EXPECT_EQ(half_from_float(-2.0f), 0xc000);
  EXPECT_EQ(half_from_float(65504.0f), 0x7bff);
  EXPECT_EQ(half_from_float(65519.99f), 0x7bff);
  EXPECT_EQ(half_from_float(65520.0f), 0x7c00);
  EXPECT_EQ(half_from_float(1e38f), 0x7c00);
  EXPECT_EQ(half_from_float(0x1p-24f), 0x0001);
  EXPECT_EQ(half_from_float(0x1p-25f), 0x0000);  // a tie, to even
  EXPECT_EQ(half_from_float(0x1.8p-24f), 0x0002);
  EXPECT_EQ(half_from_float(1.0f + 0x1p-11f), 0x3c00);  // a tie, to even
  EXPECT_EQ(half_from_float(1.0f + 0x1.8p-10f), 0x3c02);
  EXPECT_TRUE(std::isnan(float_from_half(half_from_float(std::numeric_limits<float>::quiet_NaN()))));
  EXPECT_TRUE(std::isinf(float_from_half(half_from_float(-std::numeric_limits<float>::infinity()))));
}

TEST(Half, EveryHalfComesBack) {
  for (uint32_t bits = 0; bits < 65536; ++bits) {
    const float value = float_from_half(static_cast<uint16_t>(bits));
    if (std::isnan(value)) continue;
    ASSERT_EQ(half_from_float(value), bits);
    const uint32_t magnitude = bits & 0x7fff;
    const double exact = magnitude < 0x400
                             ? std::ldexp(magnitude, -24)
                             : std::ldexp(0x400 | (magnitude & 0x3ff), static_cast<int>(magnitude >> 10) - 25);
    if (magnitude < 0x7c00) {
      ASSERT_EQ(std::abs(static_cast<double>(value)), exact);
    }
  }
}

TEST(Half, RoundsToTheNearestWithTiesToEven) {
  for (uint32_t bits = 0; bits < 0x7bff; ++bits) {
    const auto low = static_cast<double>(float_from_half(static_cast<uint16_t>(bits)));
    const auto high = static_cast<double>(float_from_half(static_cast<uint16_t>(bits + 1)));
    const auto middle = static_cast<float>((low + high) / 2);
    ASSERT_EQ(half_from_float(middle), bits + (bits & 1));
    ASSERT_EQ(half_from_float(std::nextafter(middle, 0.0f)), bits);
    ASSERT_EQ(half_from_float(std::nextafter(middle, 1e6f)), bits + 1);
  }
}

}  // namespace
}  // namespace vamp
