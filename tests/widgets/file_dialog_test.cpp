// The file dialog, driven by the keyboard over a folder made for it.
#include "editor/widgets/file_dialog.h"

#include <unistd.h>

#include <fstream>

#include "tests/widgets/ui_test.h"

namespace vamp::ui {
namespace {

namespace fs = std::filesystem;

class FileDialogTest : public UiTest {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("vamp_file_dialog_" + std::to_string(getpid()));
    fs::create_directories(folder_ / "sub");
    for (const char* name : {"shoe.glb", "notes.txt", "sub/inner.glb"}) std::ofstream(folder_ / name) << "x";
    folder_ = fs::canonical(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void start(FileRequest::Mode mode) {
    FileRequest request;
    request.mode = mode;
    request.folder = folder_;
    request.extensions = {".glb"};
    request.done = [this](const fs::path& path) { chosen_ = path; };
    dialog_.open(request);
    step(4);
  }
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      frame([&] { dialog_.draw(); });
    }
  }
  void tap(int code) {
    key(code, true);
    step();
    key(code, false);
    step(2);
  }
  void write(const char* text) {
    type(text);
    step(2);
    tap(kEnter);
  }
  FileDialog dialog_;
  fs::path folder_, chosen_;
};

TEST_F(FileDialogTest, ATypedNameOpensTheFile) {
  start(FileRequest::Mode::open);
  write("shoe.glb");
  EXPECT_EQ(chosen_, folder_ / "shoe.glb");
  EXPECT_FALSE(dialog_.is_open());
  EXPECT_EQ(dialog_.recent().front(), folder_);
}

TEST_F(FileDialogTest, AFolderIsEnteredAndAPathIsTaken) {
  start(FileRequest::Mode::open);
  write("sub");
  EXPECT_TRUE(dialog_.is_open());
  write("inner.glb");
  EXPECT_EQ(chosen_, folder_ / "sub" / "inner.glb");
  start(FileRequest::Mode::open);
  write((folder_ / "shoe.glb").c_str());
  EXPECT_EQ(chosen_, folder_ / "shoe.glb");
}

TEST_F(FileDialogTest, AMissingFileIsNotOpened) {
  start(FileRequest::Mode::open);
  write("none.glb");
  EXPECT_TRUE(dialog_.is_open());
  EXPECT_TRUE(chosen_.empty());
}

TEST_F(FileDialogTest, SavingAddsTheExtension) {
  start(FileRequest::Mode::save);
  write("fresh");
  EXPECT_EQ(chosen_, folder_ / "fresh.glb");
}

TEST_F(FileDialogTest, OverwritingIsAskedFor) {
  start(FileRequest::Mode::save);
  write("shoe");
  EXPECT_TRUE(dialog_.is_open());
  tap(kEnter);
  EXPECT_EQ(chosen_, folder_ / "shoe.glb");
}

TEST_F(FileDialogTest, ArrowsAndEnterChoose) {
  start(FileRequest::Mode::open);
  tap(kDown);
  tap(kDown);  // sub, then shoe.glb: other kinds are not listed
  tap(kEnter);
  EXPECT_EQ(chosen_, folder_ / "shoe.glb");
}

TEST_F(FileDialogTest, EscLeavesEverythingAsItWas) {
  start(FileRequest::Mode::open);
  tap(kEscape);
  tap(kEscape);
  EXPECT_FALSE(dialog_.is_open());
  EXPECT_TRUE(chosen_.empty());
}

}  // namespace
}  // namespace vamp::ui
