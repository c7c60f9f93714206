#include "engine/core/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace vamp {
namespace {

using ::testing::HasSubstr;

std::string refusal(std::string_view text) {
  const auto json = parse_json(text, "a.json");
  EXPECT_FALSE(json) << text;
  if (json) return "";
  EXPECT_EQ(json.error().kind, ErrorKind::bad_input);
  EXPECT_EQ(json.error().message().find('\n'), std::string::npos);
  return json.error().message();
}

TEST(ParseJson, RefusesWhatStrictReadersMust) {
  EXPECT_THAT(refusal(""), HasSubstr("a.json: expected valid JSON"));
  EXPECT_THAT(refusal("{\"a\": 1, \"a\": 2}"), HasSubstr("the key \"a\" stands twice"));
  EXPECT_THAT(refusal(std::string(33, '[') + std::string(33, ']')), HasSubstr("nesting deeper than 32"));
  EXPECT_THAT(refusal("\"" + std::string(4097, 'x') + "\""), HasSubstr("over 4 KiB"));
  for (const char* text :
       {"{", "[1,]", "NaN", "[1e999]", "Infinity", "{} {}", "'a'", "[01]", "\"\xff\"", "\"a\nb\"", "// x\n1"})
    refusal(text);
  refusal(std::string_view("[\0]", 3));
  refusal(std::string(1000000, '['));
}

TEST(ParseJson, AcceptsTheLimits) {
  EXPECT_TRUE(parse_json(std::string(32, '[') + std::string(32, ']'), ""));
  EXPECT_TRUE(parse_json("\"" + std::string(4096, 'x') + "\"", ""));
  EXPECT_TRUE(parse_json("{\"a\": {\"a\": 1}, \"b\": {\"a\": 1}}", ""));
}

TEST(PrintJson, KeepsOrderAndComesBack) {
  const std::string text = "{\n  \"zebra\": 0.1,\n  \"ant\": [\n    1,\n    -2.5\n  ]\n}\n";
  const auto json = parse_json(text, "");
  ASSERT_TRUE(json);
  EXPECT_EQ(print_json(*json), text);
}

TEST(PrintJsonDeathTest, ChecksThatNumbersAreFinite) {
  EXPECT_DEATH((void)print_json(Json{{"a", std::nan("")}}), "internal error");
  EXPECT_DEATH((void)json_number(std::numeric_limits<float>::infinity()), "internal error");
}

TEST(JsonNumber, IsShortAndComesBackAsTheSameFloat) {
  EXPECT_EQ(json_number(0.1f).dump(), "0.1");
  EXPECT_EQ(json_number(3.0f).dump(), "3");
  EXPECT_EQ(json_number(-0.0f).dump(), "-0.0");
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto bits = static_cast<uint32_t>(random());
    const auto value = std::bit_cast<float>(bits);
    if (!std::isfinite(value)) continue;
    const auto json = parse_json(json_number(value).dump(), "");
    ASSERT_TRUE(json);
    constexpr float kMost = std::numeric_limits<float>::max();
    ASSERT_EQ(std::bit_cast<uint32_t>(JsonReader(*json, "").number(-kMost, kMost)), bits);
  }
}

class Reading : public ::testing::Test {
 protected:
  std::string problem() const { return reader.status() ? "" : reader.status().error().message(); }
  Json json = *parse_json(R"({"alpha": 0.1, "count": 3, "name": "calf", "on": true, "list": [1, "two"], "big": 1e300,
                              "huge": 18446744073709551615})",
                          "");
  JsonReader reader{json, "m.json"};
};

TEST_F(Reading, TakesValuesOfTheRightKind) {
  EXPECT_EQ(reader.member("alpha").number(0, 1), 0.1f);
  EXPECT_EQ(reader.member("count").integer(0, 10), 3);
  EXPECT_EQ(reader.member("name").text(), "calf");
  EXPECT_TRUE(reader.member("on").boolean());
  EXPECT_EQ(reader.member("list").size(2), 2u);
  EXPECT_EQ(reader.keys(10).size(), 7u);
  EXPECT_FALSE(reader.has("beta"));
  EXPECT_EQ(problem(), "");
}

TEST_F(Reading, AFloatLimitIncludesItsDecimal) {
  EXPECT_EQ(reader.member("alpha").number(0.1f, 1), 0.1f);
  EXPECT_EQ(reader.member("alpha").number(0, 0.1f), 0.1f);
  EXPECT_EQ(problem(), "");
}

TEST_F(Reading, NamesThePlaceOfTheFirstError) {
  reader.member("list").element(1).number(0, 1);
  reader.member("alpha").integer(0, 1);
  EXPECT_EQ(problem(), "m.json: list[1]: expected a number, found string");
}

TEST_F(Reading, RefusesValuesOutOfRange) {
  EXPECT_EQ(reader.member("count").number(0, 1), 0.0f);
  EXPECT_EQ(problem(), "m.json: count: expected a number from 0 to 1, found 3");
}

TEST_F(Reading, RefusesNumbersThatNoFloatHolds) {
  reader.member("big").number(0, std::numeric_limits<float>::max());
  EXPECT_NE(problem(), "");
}

TEST_F(Reading, RefusesIntegersThatDoNotFit) {
  EXPECT_EQ(reader.member("huge").integer(0, 100), 0);
  EXPECT_THAT(problem(), HasSubstr("18446744073709551615"));
}

TEST_F(Reading, MissingMembersAreErrorsAndReadersGoOn) {
  EXPECT_EQ(reader.member("beta").member("gamma").element(3).text(), "");
  EXPECT_EQ(problem(), "m.json: beta: expected a value, found nothing");
}

TEST_F(Reading, SizesAreLimited) {
  EXPECT_EQ(reader.member("list").size(1), 0u);
  EXPECT_EQ(problem(), "m.json: list: expected at most 1 elements, found 2");
}

}  // namespace
}  // namespace vamp
