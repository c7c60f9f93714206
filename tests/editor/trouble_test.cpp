// What users drop on the window, and what the machine does to it.
#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/image/save.h"
#include "tests/editor/drop.h"
#include "tests/editor/window_fixture.h"

namespace vamp::editor_test {
namespace {

class Dropped : public Window {
 protected:
  void drop(const fs::path& path) { EXPECT_TRUE(drop_files(display().name(), 569, 420, {path.string()})) << path; }

  // What is saved; empty where it cannot be read.
  Project saved() const { return load_project(document()).value_or(Project{}); }
};

TEST_F(Dropped, APresetLiesOnThePartUnderTheMouse) {
  Preset other = test::small_preset("Other", 0.75f);
  ASSERT_TRUE(save_preset(other, home() / "other.vamp"));
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  editor.move(569, 420);
  drop(home() / "other.vamp");
  const auto on_a_part = [&] {
    editor.key("ctrl+s");
    const Project project = saved();
    return std::any_of(project.parts.begin(), project.parts.end(), [&](const PartState& part) {
      return project.materials[static_cast<size_t>(part.material)].name == "Other";
    });
  };
  EXPECT_TRUE(wait_until(on_a_part)) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Dropped, APresetGivesWhatWasSavedAndNotWhatWasMadeOfIt) {
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  edit_the_material(editor);
  editor.key("ctrl+s");
  ASSERT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << editor.log();
  editor.move(569, 420);
  drop(home() / "small.vamp");
  EXPECT_TRUE(wait_until([&] {
    editor.key("ctrl+s");
    return edited_rows(document()) == 0;
  })) << editor.log();
  // "Use the edited one", at the lower right once the word that it was saved is gone.
  std::this_thread::sleep_for(std::chrono::seconds(5));
  editor.click(920, 740);
  EXPECT_TRUE(wait_until([&] {
    editor.key("ctrl+s");
    return edited_rows(document()) > 0;
  })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Dropped, AnEnvironmentMapLightsTheScene) {
  Image sky(8, 4, {"R", "G", "B"});
  std::fill(sky.pixels.begin(), sky.pixels.end(), 0.5f);
  ASSERT_TRUE(save_exr(home() / "sky.exr", sky, {}));
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  drop(home() / "sky.exr");
  EXPECT_TRUE(wait_until([&] {
    editor.key("ctrl+s");
    return !saved().environment.path.empty();
  })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Dropped, AProjectIsOpenedAndAnythingElseIsLeftAlone) {
  ASSERT_TRUE(write_text_atomically(home() / "letter.txt", "not for us"));
  EditorRun editor(display(), home(), {(home() / "boxes.glb").string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  drop(home() / "letter.txt");
  drop(document());
  EXPECT_TRUE(wait_until([&] {
    return read_text(home() / "state" / "vamp" / "recent.json", 1 << 20).value_or("").find("boxes.vampproj") !=
           std::string::npos;
  })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

class Trouble : public Window {};

TEST_F(Trouble, TheGraphicsPipelineDrawsTheSameWindow) {
  EditorRun editor(display(), home(), {"--ui", "vulkan", "--validate", document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  edit_the_material(editor);
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
  EXPECT_EQ(editor.log().find("VUID"), std::string::npos) << editor.log();
}

TEST_F(Trouble, ARendererThatLostItsDeviceStartsAnew) {
  EditorRun editor(display(), home(), {"--lose-device", "renderer", document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  edit_the_material(editor);
  ASSERT_TRUE(wait_until([&] { return editor.log().find("lost") != std::string::npos; })) << editor.log();
  // What was not saved is on disk before anybody answers.
  EXPECT_TRUE(wait_until([&] { return !files(home() / "state" / "vamp" / "autosave", ".json").empty(); }));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  editor.key("Return");  // Start the renderer anew
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Trouble, ALostDeviceEndsInOneLineAndSixAndLosesNothing) {
  for (const std::string what : {"renderer", "window"}) {
    {
      EditorRun editor(display(), home(), {"--lose-device", what, document().string()});
      ASSERT_TRUE(editor.shows_picture()) << editor.log();
      edit_the_material(editor);
      if (what == "renderer") {
        ASSERT_TRUE(wait_until([&] { return editor.log().find("lost") != std::string::npos; })) << editor.log();
        // The question comes some frames after the line.
        std::this_thread::sleep_for(std::chrono::seconds(1));
        editor.key("Right");  // from "Start the renderer anew" to "Quit"
        editor.key("space");
      }
      EXPECT_EQ(editor.wait_for_end(), 6) << editor.log();
      const std::string log = editor.log(), last = log.substr(log.rfind('\n', log.size() - 2) + 1);
      EXPECT_NE(last.find("lost"), std::string::npos) << log;
      EXPECT_NE(last.find("offered at the next start"), std::string::npos) << log;
    }
    EXPECT_EQ(edited_rows(document()), 0u);
    EditorRun editor(display(), home(), {document().string()});
    ASSERT_TRUE(editor.shows_picture()) << editor.log();
    editor.move(569, 420);
    editor.key("Return");  // Recover
    ASSERT_TRUE(wait_until([&] { return editor.log().find("recovered") != std::string::npos; })) << editor.log();
    editor.key("ctrl+z");  // nothing to undo
    editor.key("ctrl+s");
    EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << editor.log();
    editor.key("ctrl+q");
    EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
    SetUp();  // the document as it was
  }
}

TEST_F(Trouble, EditingGoesOnWhereTheAutosaveFailsAndIsKeptWhenItCanBe) {
  const fs::path kept = home() / "state" / "vamp" / "autosave";
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  fs::remove_all(kept);
  edit_the_material(editor);
  ASSERT_TRUE(wait_until([&] { return editor.log().find("autosave:") != std::string::npos; })) << editor.log();
  EXPECT_TRUE(editor.running());
  fs::create_directories(kept);
  edit_the_material(editor);
  EXPECT_TRUE(wait_until([&] { return !files(kept, ".json").empty(); })) << editor.log();
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

}  // namespace
}  // namespace vamp::editor_test
