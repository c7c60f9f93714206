// Both ways of fetching the scene give the same picture; the faster one is found once and remembered, and whatever
// stands in the file where it is remembered does no harm.
#include "engine/render/fetch_path.h"

#include <unistd.h>

#include <cstdlib>

#include "engine/core/files.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class FetchPathTest : public test::EditedPicture {
 protected:
  void SetUp() override {
    EditedPicture::SetUp();
    folder_ = fs::temp_directory_path() / ("vamp-fetch-" + std::to_string(::getpid()));
    fs::create_directories(folder_ / "vamp");
    for (const char* name : {"XDG_CACHE_HOME", "VAMP_FETCH"})
      if (const char* value = std::getenv(name)) kept_.emplace_back(name, value);
    ::setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    ::unsetenv("VAMP_FETCH");
  }
  void TearDown() override {
    ::unsetenv("XDG_CACHE_HOME");
    ::unsetenv("VAMP_FETCH");
    for (const auto& [name, value] : kept_) ::setenv(name.c_str(), value.c_str(), 1);
    std::error_code code;
    fs::remove_all(folder_, code);
    EditedPicture::TearDown();
  }
  fs::path file() const { return folder_ / "vamp" / "devices.json"; }
  FetchPath now() const { return fetch_path(device->info()); }

  fs::path folder_;
  std::vector<std::pair<std::string, std::string>> kept_;
};

TEST_F(FetchPathTest, BothGiveTheSameBytes) {
  const Project project = test::two_materials();
  std::vector<float> pictures[2];
  for (const bool storage : {false, true}) {
    Renderer renderer(*device);
    renderer.set_storage_fetch(storage);
    show(renderer, project);
    renderer.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
    pictures[storage] = finish(renderer, 8);
  }
  EXPECT_TRUE(test::same_bytes(pictures[0], pictures[1]));
}

TEST_F(FetchPathTest, IsMeasuredOnceAndRemembered) {
  EXPECT_EQ(now().reason, FetchPath::Reason::assumed);
  tune_fetch_path(*device);
  const FetchPath found = now();
  EXPECT_EQ(found.reason, FetchPath::Reason::measured);
  EXPECT_GT(found.texel_ms, 0);
  EXPECT_GT(found.storage_ms, 0);
  EXPECT_EQ(found.storage, found.storage_ms < found.texel_ms);
  // Not measured again.
  const std::string text = *read_text(file(), 1 << 16);
  tune_fetch_path(*device);
  EXPECT_EQ(*read_text(file(), 1 << 16), text);
  // Of another version of the driver it says nothing.
  gpu::DeviceInfo newer = device->info();
  newer.driver += " and newer";
  EXPECT_EQ(fetch_path(newer).reason, FetchPath::Reason::assumed);

  ::setenv("VAMP_FETCH", found.storage ? "texel" : "storage", 1);
  EXPECT_EQ(now().reason, FetchPath::Reason::forced);
  EXPECT_NE(now().storage, found.storage);
}

TEST_F(FetchPathTest, ADamagedFileIsMeasuredAnew) {
  const std::string device_name = device->info().name, driver = device->info().driver;
  const auto entry = [&](const std::string& rest) {
    return R"({"devices": [{"device": ")" + device_name + R"(", "driver": ")" + driver + "\"" + rest + "}]}";
  };
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string(R"({"devices": 3})"), entry(""),
        entry(R"(, "texel_ms": "fast", "storage_ms": 1)"), entry(R"(, "texel_ms": -1, "storage_ms": 1)"),
        entry(R"(, "texel_ms": 1e999, "storage_ms": 1)"), std::string(1 << 17, ' ')}) {
    ASSERT_TRUE(write_text_atomically(file(), text));
    EXPECT_EQ(now().reason, FetchPath::Reason::assumed) << text.substr(0, 100);
  }
  tune_fetch_path(*device);
  EXPECT_EQ(now().reason, FetchPath::Reason::measured);
}

}  // namespace
}  // namespace vamp
