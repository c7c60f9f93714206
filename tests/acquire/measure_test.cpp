#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <thread>

#include "engine/acquire/acquire.h"
#include "engine/core/files.h"
#include "engine/core/progress.h"
#include "tests/acquire/shapes.h"

namespace vamp::acquire {
namespace {

// Few directions, so that a test takes no time.
DirectionSet few() {
  std::vector<dvec3> directions;
  for (const auto& [theta, phi] : {std::pair(0.0, 0.0), {30.0, 45.0}, {45.0, 160.0}, {60.0, 250.0}, {75.0, 300.0}})
    directions.emplace_back(test::towards(theta, phi));
  return named_direction_set(directions);
}

Options options(int size, int samples, int threads) {
  Options result;
  result.size = size;
  result.directions = few();
  result.samples = samples;
  result.threads = threads;
  result.job["structure"] = "bumps";
  result.job["size"] = size;
  return result;
}

class Measure : public ::testing::Test {
 protected:
  Measure() : folder(fs::temp_directory_path() / ("vamp-acquire-" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
  }
  ~Measure() override { fs::remove_all(folder); }
  static std::vector<std::byte> bytes_of(const fs::path& path) {
    auto bytes = read_file(path, uint64_t{1} << 30);
    return bytes ? *bytes : std::vector<std::byte>();
  }
  fs::path folder;
};

TEST_F(Measure, AnyNumberOfThreadsGivesTheSameBytes) {
  std::vector<std::byte> first;
  for (const int threads : {1, 2, 3}) {
    Progress progress;
    const fs::path path = folder / (std::to_string(threads) + ".btf");
    const auto report = measure(test::bumps(48, 0.6f, true), options(10, 4, threads), path, progress);
    ASSERT_TRUE(report) << report.error().message();
    if (first.empty()) first = bytes_of(path);
    EXPECT_EQ(bytes_of(path), first) << threads;
  }
  EXPECT_GT(first.size(), 10u * 10 * 5 * 5 * 6);
}

TEST_F(Measure, AStoppedMeasurementGoesOnToTheSameBytes) {
  Progress undisturbed;
  const fs::path whole = folder / "whole.btf", stopped = folder / "stopped.btf";
  ASSERT_TRUE(measure(test::bumps(48, 0.6f, true), options(24, 4, 1), whole, undisturbed));

  Progress progress;
  std::jthread stopper([&] {
    while (progress.fraction() < 0.3f && !progress.cancelled()) std::this_thread::yield();
    progress.cancel();
  });
  const auto first = measure(test::bumps(48, 0.6f, true), options(24, 4, 1), stopped, progress);
  stopper.join();
  ASSERT_FALSE(first);
  EXPECT_EQ(first.error().kind, ErrorKind::interrupted);
  EXPECT_FALSE(fs::exists(stopped));

  Progress again;
  const auto second = measure(test::bumps(48, 0.6f, true), options(24, 4, 2), stopped, again);
  ASSERT_TRUE(second) << second.error().message();
  EXPECT_GE(second->resumed_rows, 7);
  EXPECT_LT(second->resumed_rows, 24);
  EXPECT_EQ(bytes_of(stopped), bytes_of(whole));
  EXPECT_FALSE(fs::exists(stopped.string() + ".part"));
  EXPECT_FALSE(fs::exists(stopped.string() + ".part.json"));
}

TEST_F(Measure, WhatIsLeftOfAnotherJobOrDamagedIsNotUsed) {
  Progress progress;
  const fs::path whole = folder / "whole.btf", path = folder / "other.btf";
  ASSERT_TRUE(measure(test::bumps(48, 0.6f, true), options(6, 4, 1), whole, progress));
  for (const char* left :
       {"", "{", "{\"job\": 3}", R"({"job":{"structure":"bumps","size":6},"rows":[0,99],"errors":[]})",
        R"({"job":{"structure":"bumps","size":6},"rows":[0],"errors":[0,0,0,0,0,0]})",
        R"({"job":{"structure":"bumps","size":7},"rows":[],"errors":[]})"}) {
    ASSERT_TRUE(write_text_atomically(path.string() + ".part.json", left));
    ASSERT_TRUE(write_text_atomically(path.string() + ".part", "no measurement"));
    Progress each;
    const auto report = measure(test::bumps(48, 0.6f, true), options(6, 4, 1), path, each);
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_EQ(report->resumed_rows, 0);
    EXPECT_EQ(bytes_of(path), bytes_of(whole)) << left;
  }
}

TEST_F(Measure, SaysOfItselfThatItIsSyntheticAndHowSureItIs) {
  Progress progress;
  const fs::path path = folder / "told.btf";
  const auto report = measure(test::bumps(48, 0.6f, true), options(6, 16, 1), path, progress);
  ASSERT_TRUE(report);
  const auto btf = Btf::open(path);
  ASSERT_TRUE(btf) << btf.error().message();
  EXPECT_TRUE(btf->info().synthetic);
  EXPECT_EQ(btf->info().name, "bumps");
  EXPECT_FLOAT_EQ(btf->info().mm_per_texel, 1.0f / 6);
  EXPECT_NE(btf->info().provenance.find("Synthetic"), std::string::npos);
  const size_t at = btf->info().provenance.find("median ");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(btf->info().provenance.substr(at + 7)), report->median_error, 1e-6);
  EXPECT_GT(report->median_error, 0);
  EXPECT_LE(report->median_error, report->worst_error);
}

TEST(Texels, TheTopRowLiesWhereTheYAxisPoints) {
  // White above the middle, black below.
  const auto skin = [](double, double v) { return Skin{0, v > 0.5 ? vec3(1) : vec3(0), 0, 0}; };
  std::vector<float> errors;
  const auto btf = measure_in_memory({"halves", 1, height_field(16, 1, skin), {Matter{}}}, options(4, 4, 1), errors);
  ASSERT_TRUE(btf);
  for (size_t texel = 0; texel < 16; ++texel) EXPECT_EQ(btf->at(texel, 0, 0, 0) > 0.1f, texel < 8) << texel;
}

TEST_F(Measure, APlaceThatCannotBeWrittenToIsOneError) {
  Progress progress;
  const auto report = measure(test::bumps(16, 0.6f, true), options(4, 1, 1), folder / "nowhere" / "x.btf", progress);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::io);
}

TEST(Errors, StatedOnesAreWhatRepeatedMeasurementsShow) {
  // Texture within a stratum counts as noise, so the stated error is a little too large, never too small.
  constexpr int kSeeds = 24;
  std::vector<std::vector<float>> values;
  double stated2 = 0, spread2 = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    Options job = options(4, 16, 1);
    job.seed = static_cast<uint64_t>(seed);
    std::vector<float> errors;
    const auto btf = measure_in_memory(test::bumps(48, 0.7f, true), job, errors);
    ASSERT_TRUE(btf);
    for (size_t t = 0; t < btf->texel_count(); ++t) {
      std::vector<float> texel(btf->values_per_texel());
      btf->read_texel(t, texel);
      double value2 = 0;
      for (const float v : texel) value2 += static_cast<double>(v) * static_cast<double>(v);
      stated2 += static_cast<double>(errors[t]) * static_cast<double>(errors[t]) * value2 / kSeeds;
      values.push_back(std::move(texel));
    }
  }
  const size_t texels = values.size() / kSeeds;
  for (size_t t = 0; t < texels; ++t)
    for (size_t k = 0; k < values[t].size(); ++k) {
      double sum = 0, square = 0;
      for (int seed = 0; seed < kSeeds; ++seed) {
        const auto v = static_cast<double>(values[static_cast<size_t>(seed) * texels + t][k]);
        sum += v, square += v * v;
      }
      spread2 += (square - sum * sum / kSeeds) / (kSeeds - 1);
    }
  const double ratio = std::sqrt(stated2 / spread2);
  EXPECT_GT(ratio, 0.97);
  EXPECT_LT(ratio, 1.8);
}

}  // namespace
}  // namespace vamp::acquire
