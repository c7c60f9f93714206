#include "editor/model/settings.h"

#include <gtest/gtest.h>

#include "editor/model/recent.h"
#include "engine/core/files.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

class SettingsFile : public testing::Test {
 protected:
  SettingsFile() { fs::create_directories(config_dir()); }
  void write(const std::string& text) { ASSERT_TRUE(write_text_atomically(path_, text)); }

  test::TemporaryHome home_;
  fs::path path_ = config_dir() / "settings.json";
};

TEST_F(SettingsFile, ThatIsMissingGivesTheDefaultsAndNoProblem) {
  const auto loaded = load_settings();
  EXPECT_EQ(loaded.settings, Settings{});
  EXPECT_EQ(loaded.problem, "");
}

TEST_F(SettingsFile, ReadsBackWhatWasWritten) {
  Settings settings;
  settings.ui_scale = 1.25f;
  settings.theme = Theme::high_contrast;
  settings.layout = std::string(10000, 'l') + "\u00e4\u00f6" + std::string(4094, 'x') + "\u20ac{\"a\": 1}";
  settings.layout_version = 3;
  settings.device = "llvmpipe";
  settings.window = {-10, 20, 800, 600, true, true};
  settings.reopen_last = false;
  settings.reduced_motion = true;
  settings.last_folder = "/home/designer";
  ASSERT_TRUE(save_settings(settings));
  const auto loaded = load_settings();
  EXPECT_EQ(loaded.problem, "");
  EXPECT_EQ(loaded.settings, settings);
}

TEST_F(SettingsFile, LosesOnlyTheMembersThatAreDamaged) {
  write(R"({"ui_scale": "big", "theme": "dark blue", "device": "llvmpipe", "window": {"x": 1}, "reopen_last": false})");
  const auto loaded = load_settings();
  EXPECT_NE(loaded.problem, "");
  EXPECT_EQ(loaded.settings.ui_scale, 0);
  EXPECT_EQ(loaded.settings.theme, Theme::dark);
  EXPECT_EQ(loaded.settings.window, WindowPlace{});
  EXPECT_EQ(loaded.settings.device, "llvmpipe");
  EXPECT_FALSE(loaded.settings.reopen_last);
}

TEST_F(SettingsFile, ThatIsNoJsonIsPutAsideAndTheDefaultsServe) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("[]"), std::string("\0\0", 2),
                                  std::string("{\"a\":1,\"a\":2}"), std::string(100000, '[')}) {
    write(text);
    const auto loaded = load_settings();
    EXPECT_EQ(loaded.settings, Settings{});
    EXPECT_NE(loaded.problem, "");
  }
  ASSERT_TRUE(save_settings(Settings{}));
  EXPECT_EQ(load_settings().problem, "");
}

TEST(WindowPlaces, StayWhereTheyCanBeGrabbed) {
  for (const WindowPlace& place :
       {WindowPlace{5000, 5000, 800, 600, false, true}, WindowPlace{-5000, -5000, 800, 600, false, true},
        WindowPlace{10, 10, 8000, 6000, false, true}, WindowPlace{10, 10, 1, 1, false, true}}) {
    const WindowPlace clamped = clamp_to_monitor(place, 0, 0, 1920, 1080);
    EXPECT_LE(clamped.width, 1920);
    EXPECT_GE(clamped.width, 320);
    EXPECT_LE(clamped.x, 1820);
    EXPECT_GE(clamped.x + clamped.width, 100);
    EXPECT_GE(clamped.y, 0);
    EXPECT_LE(clamped.y, 980);
  }
  const WindowPlace good{100, 100, 800, 600, false, true};
  EXPECT_EQ(clamp_to_monitor(good, 0, 0, 1920, 1080), good);
}

TEST_F(SettingsFile, OfRecentFilesHoldsTheLatestFirstAndEachOnce) {
  RecentFiles recent;
  for (const char* name : {"/a.vampproj", "/b.vampproj", "/a.vampproj"}) ASSERT_TRUE(recent.add(name));
  EXPECT_EQ(recent.list(), (std::vector<fs::path>{"/a.vampproj", "/b.vampproj"}));
  EXPECT_EQ(RecentFiles().list(), recent.list());
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(recent.add("/" + std::to_string(i)));
  EXPECT_EQ(recent.list().size(), RecentFiles::kMost);
  EXPECT_EQ(recent.list().front(), "/49");
  ASSERT_TRUE(recent.remove("/49"));
  EXPECT_EQ(RecentFiles().list().front(), "/48");
  ASSERT_TRUE(recent.clear());
  EXPECT_TRUE(RecentFiles().list().empty());
}

TEST_F(SettingsFile, OfRecentFilesThatIsDamagedStartsAnew) {
  fs::create_directories(state_dir());
  for (const char* text : {"", "{", "[]", R"({"files": 3})", R"({"files": [1, 2]})"}) {
    ASSERT_TRUE(write_text_atomically(state_dir() / "recent.json", text));
    RecentFiles recent;
    EXPECT_TRUE(recent.list().empty());
    EXPECT_TRUE(recent.add("/a"));
  }
}

}  // namespace
}  // namespace vamp
