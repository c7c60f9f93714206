#include "engine/core/error.h"

#include <gtest/gtest.h>

#include "engine/core/check.h"

namespace vamp {
namespace {

Result<int> half_of(int value) {
  if (value % 2 != 0)
    return fail(ErrorKind::bad_input, "numbers.txt", "line 3", "an even number", std::to_string(value));
  return value / 2;
}

Result<int> quarter_of(int value) {
  VAMP_TRY(const int half, half_of(value));
  VAMP_TRY(const int quarter, half_of(half));
  return quarter;
}

Status check_quarter(int value) {
  VAMP_CHECK_STATUS(quarter_of(value));
  return {};
}

TEST(Error, SaysFilePlaceExpectedAndFound) {
  EXPECT_EQ(half_of(3).error().message(), "numbers.txt: line 3: expected an even number, found 3");
  EXPECT_EQ((Error{ErrorKind::io, "a.png", "", "cannot be written: no space", ""}.message()),
            "a.png: cannot be written: no space");
  EXPECT_EQ((Error{ErrorKind::failed, "", "", "", "nothing"}.message()), "nothing");
}

TEST(Error, IsOneLineWhateverStandsInTheFile) {
  const Error error{ErrorKind::bad_input, "a\nb.png", "", "x", "\x1b[31mred\r\n"};
  for (const char c : error.message()) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
}

TEST(Error, IsHandedUpwards) {
  EXPECT_EQ(*quarter_of(12), 3);
  EXPECT_EQ(quarter_of(6).error().found, "3");
  EXPECT_TRUE(check_quarter(4));
  EXPECT_EQ(check_quarter(5).error().kind, ErrorKind::bad_input);
}

TEST(CheckDeathTest, SaysWhereItFailed) {
  EXPECT_DEATH(CHECK(1 + 1 == 3), "internal error: .*error_test.cpp.*1 \\+ 1 == 3");
}

}  // namespace
}  // namespace vamp
