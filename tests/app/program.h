#pragma once
// Starts the built program in a folder of its own and says how it ended.
#include <gtest/gtest.h>
#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/json.h"

namespace vamp::test {

struct Ended {
  int code = -1;  // 128 + the signal's number where one killed it
  std::string out, err;
  Json json() const;  // of `out`; null with a failed expectation when it is none
};

class Program : public ::testing::Test {
 protected:
  Program();
  ~Program() override;

  // In `folder`, with settings and state of its own. `environment`: further variables.
  Ended run(const std::vector<std::string>& arguments,
            const std::vector<std::pair<std::string, std::string>>& environment = {});
  // The same in two halves, for signals in between.
  pid_t start(const std::vector<std::string>& arguments,
              const std::vector<std::pair<std::string, std::string>>& environment = {});
  Ended finish(pid_t process);
  // What the program has said on stderr so far.
  std::string said() const;

  // A white box of 0.1 units a side around the origin on a grey floor, in `folder`.
  std::string box_on_floor();
  // `vamp render` of that scene, 24 x 16 pixels, 2 samples, under the validation layer, and further arguments.
  Ended render(std::vector<std::string> arguments);
  std::string bytes_of(const std::string& name) const;

  fs::path folder;
  fs::path output;  // where the program's stdout goes
};

}  // namespace vamp::test
