#include "engine/core/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <thread>

namespace vamp {
namespace {

class Files : public ::testing::Test {
 protected:
  Files() {
    std::string name = (fs::temp_directory_path() / "vamp-test-XXXXXX").string();
    EXPECT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  ~Files() override {
    std::error_code code;
    fs::remove_all(folder, code);
  }
  long entries() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }
  static unsigned mode(const fs::path& path) { return static_cast<unsigned>(fs::status(path).permissions()); }
  fs::path folder;
};

TEST_F(Files, WhatIsWrittenIsRead) {
  const fs::path path = folder / "a file";
  const std::string text = std::string("line\n\0bytes", 11) + std::string(200000, 'x');
  ASSERT_TRUE(write_text_atomically(path, text));
  EXPECT_EQ(*read_text(path, 1 << 20), text);
  ASSERT_TRUE(write_text_atomically(path, ""));
  EXPECT_EQ(read_file(path, 0)->size(), 0u);
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, ReadingIsLimited) {
  ASSERT_TRUE(write_text_atomically(folder / "a", "12345"));
  EXPECT_TRUE(read_text(folder / "a", 5));
  EXPECT_EQ(read_text(folder / "a", 4).error().kind, ErrorKind::bad_input);
  EXPECT_EQ(read_text("/dev/zero", 1 << 20).error().kind, ErrorKind::bad_input);
}

TEST_F(Files, WhatIsNotAFileIsSaid) {
  EXPECT_EQ(read_text(folder / "none", 1).error().found, "nothing there");
  EXPECT_EQ(read_text(folder, 1).error().found, "a folder");
  ASSERT_TRUE(write_text_atomically(folder / "a", "x"));
  EXPECT_FALSE(read_text(folder / "a" / "b", 1));
  EXPECT_FALSE(read_text(folder / std::string(300, 'n'), 1));
}

TEST_F(Files, TheOldFileStaysWholeWhenTheDiskIsFull) {
  const fs::path path = folder / "a";
  ASSERT_TRUE(write_text_atomically(path, "old"));
  // A file size limit fails writes as a full disk does.
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit tiny{1000, old.rlim_max};
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &tiny);
  const Status status = write_text_atomically(path, std::string(5000, 'n'));
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::io);
  EXPECT_EQ(*read_text(path, 100), "old");
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, ModesAreTheUmaskThenTheOldFiles) {
  const mode_t old = ::umask(0027);
  ASSERT_TRUE(write_text_atomically(folder / "a", "x"));
  ::umask(old);
  EXPECT_EQ(mode(folder / "a"), 0640u);
  fs::permissions(folder / "a", fs::perms(0600));
  ASSERT_TRUE(write_text_atomically(folder / "a", "y"));
  EXPECT_EQ(mode(folder / "a"), 0600u);
}

TEST_F(Files, ALinkStaysALink) {
  ASSERT_TRUE(write_text_atomically(folder / "real", "old"));
  fs::create_symlink("real", folder / "link");
  ASSERT_TRUE(write_text_atomically(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(*read_text(folder / "real", 10), "new");
}

TEST_F(Files, DevicesAreWrittenToAndStayDevices) {
  EXPECT_TRUE(write_text_atomically("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Status full = write_text_atomically("/dev/full", "x");
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().kind, ErrorKind::io);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Files, PlacesThatCannotBeWrittenAreIoErrors) {
  for (const fs::path& path : {folder, folder / "none" / "a", fs::path("/proc/a")}) {
    const Status status = write_text_atomically(path, "x");
    ASSERT_FALSE(status) << path;
    EXPECT_EQ(status.error().kind, ErrorKind::io);
    EXPECT_EQ(status.error().file, path.string());
  }
}

TEST_F(Files, NamesMayBeAsLongAsTheSystemAllows) {
  EXPECT_TRUE(write_text_atomically(folder / std::string(255, 'n'), "x"));
}

TEST_F(Files, WritersAtTheSameTimeLeaveOneWholeFile) {
  std::vector<std::thread> writers;
  for (int i = 0; i < 4; ++i)
    writers.emplace_back([this, i] {
      for (int k = 0; k < 5; ++k)
        EXPECT_TRUE(write_text_atomically(folder / "a", std::string(10000, static_cast<char>('a' + i))));
    });
  for (auto& writer : writers) writer.join();
  const std::string text = *read_text(folder / "a", 1 << 20);
  EXPECT_EQ(text, std::string(10000, text[0]));
  EXPECT_EQ(entries(), 1);
}

TEST_F(Files, RelativePathsStayInside) {
  fs::create_directory(folder / "sub");
  fs::create_symlink("/etc", folder / "out");
  fs::create_symlink("sub", folder / "in");
  const auto inside = [this](std::string_view path) { return resolve_inside(folder, path, "a.gltf", "uri"); };
  EXPECT_EQ(*inside("sub/a.png"), fs::canonical(folder) / "sub/a.png");
  EXPECT_EQ(*inside("./in/a.png"), fs::canonical(folder) / "sub/a.png");
  for (const std::string_view path :
       {"", "/etc/passwd", "../a", "sub/../../a", "sub/..", "out/passwd", "file:///etc/passwd", "http://a/b", "a\\b"})
    EXPECT_FALSE(inside(path)) << path;
  EXPECT_FALSE(inside(std::string_view("a\0b", 3)));
  EXPECT_EQ(inside("../a").error().kind, ErrorKind::bad_input);
}

TEST_F(Files, HomesFollowTheEnvironmentWhenItIsAbsolute) {
  const char* before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  EXPECT_EQ(config_dir(), folder / "vamp");
  setenv("XDG_CONFIG_HOME", "relative", 1);
  EXPECT_TRUE(config_dir().is_absolute());
  EXPECT_EQ(config_dir().filename(), "vamp");
  before != nullptr ? setenv("XDG_CONFIG_HOME", kept.c_str(), 1) : unsetenv("XDG_CONFIG_HOME");
}

TEST_F(Files, ShippedFoldersAreFoundByTheEnvironment) {
  fs::create_directory(folder / "presets");
  setenv("VAMP_DATA", folder.c_str(), 1);
  EXPECT_EQ(shipped_dir("presets"), folder / "presets");
  unsetenv("VAMP_DATA");
  EXPECT_TRUE(shipped_dir("no-such-folder").empty());
}

}  // namespace
}  // namespace vamp
