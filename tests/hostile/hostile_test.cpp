// Ten thousand mutated files of every kind: each is read, or refused in one clear line; none crashes a reader, keeps it
// busy for two seconds, takes memory on its word, or passes for the sound file with other contents.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <ctime>
#include <fstream>

#include "engine/core/files.h"
#include "engine/core/log.h"
#include "tests/hostile/format.h"
#include "tests/hostile/mutated.h"
#include "tests/material/temporary_folder.h"

// One allocation of more than this on a small file's word is an error that the sanitizer reports.
extern "C" const char* __asan_default_options() { return "max_allocation_size_mb=1024"; }

namespace vamp {
namespace {

using test::Content;
using test::Format;

constexpr double kHangs = 2;  // seconds of processor time

int mutation_count() {
  const char* wanted = std::getenv("VAMP_MUTATIONS");
  return wanted == nullptr ? 10000 : std::atoi(wanted);
}

class Hostile : public ::testing::TestWithParam<Format> {
 protected:
  static void SetUpTestSuite() { start_log("off"); }

  // Not atomically: thousands of files need not reach the disk.
  void write(const Content& bytes) const {
    std::ofstream stream(folder_ / GetParam().damaged, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  test::TemporaryFolder folder_;
};

TEST_P(Hostile, MutatedFilesAreRefusedOrReadAsWhatTheyAre) {
  const Format& format = GetParam();
  format.write(folder_.path());
  const Content sound = read_file(folder_ / format.damaged, 1 << 24).value();
  const auto whole = format.load(folder_.path());
  ASSERT_TRUE(whole) << whole.error().message();
  ASSERT_EQ(whole->unsound, "");

  std::mt19937 random(17);
  int refused = 0, tried = 0;
  double slowest = 0;
  for (int i = 0; i < mutation_count(); ++i) {
    const Content bytes = test::mutated(sound, random);
    if (bytes == sound) continue;
    ++tried;
    write(bytes);
    const std::clock_t start = std::clock();
    const auto loaded = format.load(folder_.path());
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    slowest = std::max(slowest, seconds);
    EXPECT_LT(seconds, kHangs) << i;
    if (loaded) {
      EXPECT_EQ(loaded->unsound, "") << i;
      EXPECT_EQ(loaded->fingerprint, whole->fingerprint) << i;
      continue;
    }
    ++refused;
    const std::string line = loaded.error().message();
    EXPECT_EQ(loaded.error().kind, ErrorKind::bad_input) << i << " " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << i << " " << line;
    EXPECT_NE(line.find(folder_.path().filename().string()), std::string::npos) << i << " " << line;
    if (HasFailure()) {
      // What failed stays for a look at it.
      const fs::path kept = fs::temp_directory_path() / (std::string("hostile_") + format.name);
      EXPECT_TRUE(write_file_atomically(kept, bytes));
      FAIL() << "the file: " << kept;
    }
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%s: %d of %d refused, the slowest took %.3f s, memory so far at most %ld MiB\n", format.name, refused,
              tried, slowest, usage.ru_maxrss / 1024);
}

std::vector<Format> all_formats() {
  std::vector<Format> all = test::measured_formats();
  const std::vector<Format> more = test::program_formats();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

INSTANTIATE_TEST_SUITE_P(Formats, Hostile, ::testing::ValuesIn(all_formats()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace vamp
