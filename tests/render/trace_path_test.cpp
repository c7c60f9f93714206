// Both ways of fetching the scene give the same picture; the faster one is found once and remembered, as is whose rays
// are faster, and whatever stands in the file where it is remembered does no harm.
#include "engine/render/trace_path.h"

#include <unistd.h>

#include <cstdlib>

#include "engine/core/files.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class TracePathTest : public test::EditedPicture {
 protected:
  void SetUp() override {
    EditedPicture::SetUp();
    folder_ = fs::temp_directory_path() / ("vamp-trace-" + std::to_string(::getpid()));
    fs::create_directories(folder_ / "vamp");
    for (const char* name : {"XDG_CACHE_HOME", "VAMP_FETCH", "VAMP_RAYS"})
      if (const char* value = std::getenv(name)) kept_.emplace_back(name, value);
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    ::unsetenv("VAMP_FETCH");
    ::unsetenv("VAMP_RAYS");
  }
  void TearDown() override {
    ::unsetenv("XDG_CACHE_HOME");
    ::unsetenv("VAMP_FETCH");
    ::unsetenv("VAMP_RAYS");
    for (const auto& [name, value] : kept_) ::setenv(name.c_str(), value.c_str(), 1);
    std::error_code code;
    fs::remove_all(folder_, code);
    EditedPicture::TearDown();
  }
  fs::path file() const { return folder_ / "vamp" / "devices.json"; }
  TracePaths now() const { return trace_paths(device->info()); }

  fs::path folder_;
  std::vector<std::pair<std::string, std::string>> kept_;
};

TEST_F(TracePathTest, BothWaysOfFetchingGiveTheSameBytes) {
  const Project project = test::two_materials();
  std::vector<float> pictures[2];
  for (const bool storage : {false, true}) {
    Renderer renderer(*device);
    renderer.set_trace_path({storage, now().chosen().ray_queries});
    show(renderer, project);
    renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
    pictures[storage] = finish(renderer, 8);
  }
  EXPECT_TRUE(test::same_bytes(pictures[0], pictures[1]));
}

void expect_measured(const Choice& choice) {
  EXPECT_EQ(choice.reason, Choice::Reason::measured);
  EXPECT_GT(choice.first_ms, 0);
  EXPECT_GT(choice.second_ms, 0);
}

TEST_F(TracePathTest, IsMeasuredOnceAndRemembered) {
  const bool queries = device->info().ray_queries;
  EXPECT_EQ(now().fetch.reason, Choice::Reason::assumed);
  EXPECT_EQ(now().rays.reason, queries ? Choice::Reason::assumed : Choice::Reason::only);
  tune_trace_paths(*device);
  const TracePaths found = now();
  expect_measured(found.fetch);
  EXPECT_EQ(found.fetch.second, found.fetch.second_ms < found.fetch.first_ms);
  if (queries) {
    expect_measured(found.rays);
    if (found.rays.second) {
      EXPECT_LT(found.rays.second_ms, found.rays.first_ms);
    }
  }
  // Not measured again.
  const std::string text = *read_text(file(), 1 << 16);
  tune_trace_paths(*device);
  EXPECT_EQ(*read_text(file(), 1 << 16), text);
  // Of another version of the driver it says nothing.
  gpu::DeviceInfo newer = device->info();
  newer.driver += " and newer";
  EXPECT_EQ(trace_paths(newer).fetch.reason, Choice::Reason::assumed);

  ::setenv("VAMP_FETCH", found.fetch.second ? "texel" : "storage", 1);
  EXPECT_EQ(now().fetch.reason, Choice::Reason::forced);
  EXPECT_NE(now().fetch.second, found.fetch.second);
}

TEST_F(TracePathTest, RaysAreForcedOnlyWhereTheDeviceHasThem) {
  gpu::DeviceInfo with = device->info(), without = device->info();
  with.ray_queries = true;
  without.ray_queries = false;
  ::setenv("VAMP_RAYS", "query", 1);
  EXPECT_TRUE(trace_paths(with).chosen().ray_queries);
  EXPECT_FALSE(trace_paths(without).chosen().ray_queries);
  ::setenv("VAMP_RAYS", "own", 1);
  EXPECT_FALSE(trace_paths(with).chosen().ray_queries);
  EXPECT_EQ(trace_paths(with).rays.reason, Choice::Reason::forced);
  EXPECT_EQ(trace_paths(without).rays.reason, Choice::Reason::only);
  // What is no such word counts for nothing.
  ::setenv("VAMP_RAYS", "fast", 1);
  EXPECT_EQ(trace_paths(with).rays.reason, Choice::Reason::assumed);
}

TEST_F(TracePathTest, ADamagedFileIsMeasuredAnew) {
  const std::string device_name = device->info().name, driver = device->info().driver;
  const auto entry = [&](const std::string& rest) {
    return R"({"devices": [{"device": ")" + device_name + R"(", "driver": ")" + driver + "\"" + rest + "}]}";
  };
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string(R"({"devices": 3})"), entry(""),
        entry(R"(, "texel_ms": "fast", "storage_ms": 1)"), entry(R"(, "texel_ms": -1, "storage_ms": 1)"),
        entry(R"(, "texel_ms": 1e999, "storage_ms": 1)"), entry(R"(, "texel_ms": 1)"),
        entry(R"(, "own_ms": 1, "query_ms": 0)"), std::string(1 << 17, ' ')}) {
    ASSERT_TRUE(write_text_atomically(file(), text));
    EXPECT_EQ(now().fetch.reason, Choice::Reason::assumed) << text.substr(0, 100);
  }
  tune_trace_paths(*device);
  EXPECT_EQ(now().fetch.reason, Choice::Reason::measured);
}

}  // namespace
}  // namespace vamp
