// A render that is stopped writes what it has.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/app/program.h"

namespace vamp::test {
namespace {

class Interrupt : public Program, public ::testing::WithParamInterface<int> {};

TEST_P(Interrupt, TheFileIsWrittenAndSaysThatItIsNotComplete) {
  const pid_t process = start(
      {"render", box_on_floor(), "-o", "a.png", "--size", "24x16", "--samples", "1048576", "--log-level", "debug"});
  // It says when it has begun; without that the test's own time limit ends the wait.
  while (said().find("rendering") == std::string::npos) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_EQ(::kill(process, GetParam()), 0);
  const Ended ended = finish(process);
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_THAT(ended.err, ::testing::HasSubstr("a.png: stopped"));

  const Json info = run({"info", "a.png", "--json"}).json();
  EXPECT_EQ(info["job"]["complete"], false);
  EXPECT_GE(info["job"]["samples"].get<int>(), 1);
  EXPECT_LT(info["job"]["samples"].get<int>(), 1048576);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace vamp::test
