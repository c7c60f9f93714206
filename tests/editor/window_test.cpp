// The editor as its users meet it: a real window, real keys, real files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/image/load.h"
#include "tests/editor/window_fixture.h"

namespace vamp::editor_test {
namespace {

TEST_F(Window, ShowsAfterAnEditWhatAFreshRenderShows) {
  EditorRun editor(display(), home(), {"--record-exit", (home() / "shown.exr").string(), document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  edit_the_material(editor);
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << "the edit is not in the saved project";
  editor.key("ctrl+q");
  ASSERT_EQ(editor.wait_for_end(), 0) << editor.log();

  const auto shown = load_image(home() / "shown.exr");
  ASSERT_TRUE(shown) << shown.error().message();
  int code = 0;
  const std::string said = vamp("render --from shown.exr -o fresh.exr", &code);
  ASSERT_EQ(code, 0) << said;
  const auto fresh = load_image(home() / "fresh.exr");
  ASSERT_TRUE(fresh) << fresh.error().message();
  EXPECT_EQ(shown->width, fresh->width);
  EXPECT_EQ(shown->channels, fresh->channels);
  EXPECT_EQ(shown->pixels, fresh->pixels);
}

// The view turns and the editor ends in the same breath, before the renderer has seen the new view.
TEST_F(Window, RecordsTheLastChangeEvenWhenTheEditorEndsAtOnce) {
  EditorRun editor(display(), home(), {"--record-exit", (home() / "shown.exr").string(), document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  editor.click(554, 420);  // the arrow keys are the picture's now
  editor.key("--delay 0 Left Left Left ctrl+q");
  ASSERT_EQ(editor.wait_for_end(), 0) << editor.log();
  int code = 0;
  const std::string said = vamp("render --from shown.exr -o fresh.exr", &code);
  ASSERT_EQ(code, 0) << said;
  const auto shown = load_image(home() / "shown.exr"), fresh = load_image(home() / "fresh.exr");
  ASSERT_TRUE(shown && fresh);
  EXPECT_EQ(shown->pixels, fresh->pixels);
}

TEST_F(Window, UndoBringsBackWhatWasThere) {
  const std::string before = read_text(document(), 1 << 24).value_or("");
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  edit_the_material(editor);
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; }));
  editor.key("ctrl+z");
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) == 0; }));
  EXPECT_EQ(read_text(document(), 1 << 24).value_or("none"), before);
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

// What is edited can be judged: lines stand around the part that is selected, and nothing lies over it.
TEST_F(Window, ASelectionLeavesTheColoursOfItsPartAlone) {
  auto project = open_scene(document());
  ASSERT_TRUE(project) << project.error().message();
  project->settings.max_samples = 1;  // the first whole sample stays
  ASSERT_TRUE(save_project(*project, document()));
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  const auto changed_pixels = [](const Image& a, const Image& b) {
    size_t changed = 0;
    for (int y = 300; y < 560; ++y)
      for (int x = 400; x < 700; ++x) {
        bool differs = false;
        for (size_t c = 0; c < 3; ++c) differs = differs || std::abs(a.at(x, y, c) - b.at(x, y, c)) > 0.01f;
        changed += differs ? 1 : 0;
      }
    return changed;
  };
  editor.move(30, 760);  // beside the picture
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const Image before = editor.screen();
  editor.click(554, 420);
  editor.move(30, 760);
  ASSERT_TRUE(wait_until([&] { return !sliders(editor.screen()).empty(); })) << editor.log();
  const size_t outline = changed_pixels(before, editor.screen());
  EXPECT_GT(outline, 100u);
  EXPECT_LT(outline, 260u * 300u / 20);
  editor.key("c");  // shows where its cluster lies
  EXPECT_TRUE(wait_until([&] { return changed_pixels(before, editor.screen()) > 3 * outline; }));
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Window, OffersAfterACrashWhatWasNotSaved) {
  const fs::path kept = home() / "state" / "vamp" / "autosave";
  {
    EditorRun editor(display(), home(), {document().string()});
    ASSERT_TRUE(editor.shows_picture()) << editor.log();
    edit_the_material(editor);
    const auto edited = std::chrono::steady_clock::now();
    ASSERT_TRUE(wait_until([&] { return !files(kept, ".json").empty(); }, 30)) << "no autosave";
    RecordProperty("seconds_to_autosave",
                   std::to_string(std::chrono::duration<double>(std::chrono::steady_clock::now() - edited).count()));
    editor.kill_hard();
  }
  EXPECT_EQ(edited_rows(document()), 0u);
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  editor.move(554, 420);
  editor.key("Return");  // Recover
  ASSERT_TRUE(wait_until([&] { return editor.log().find("recovered") != std::string::npos; })) << editor.log();
  editor.key("ctrl+s");
  EXPECT_TRUE(wait_until([&] { return edited_rows(document()) > 0; })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
  EXPECT_TRUE(files(kept, ".json").empty());
}

TEST_F(Window, KeepsAMaterialAsAPreset) {
  EditorRun editor(display(), home(), {document().string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  edit_the_material(editor);
  editor.key("ctrl+shift+m");
  editor.key("ctrl+a");
  editor.type("Mine");
  editor.key("Return");
  const fs::path library = home() / "data" / "vamp" / "presets";
  ASSERT_TRUE(wait_until([&] { return !files(library, ".vamp").empty(); })) << editor.log();
  const auto preset = load_preset(files(library, ".vamp").front());
  ASSERT_TRUE(preset) << preset.error().message();
  EXPECT_EQ(preset->name, "Mine");
  EXPECT_FALSE(preset->edits.bases.empty());
  const auto picture = decode_image(preset->thumbnail_png, "thumbnail");
  ASSERT_TRUE(picture) << picture.error().message();
  EXPECT_EQ(picture->width, picture->height);
  // On the same ground as the shipped ones.
  EXPECT_EQ(picture->channels.size(), 3u);
  const auto shipped = load_preset_info(shipped_dir("presets") / "calf.vamp");
  ASSERT_TRUE(shipped) << shipped.error().message();
  const auto calf = decode_image(shipped->thumbnail_png, "calf");
  ASSERT_TRUE(calf) << calf.error().message();
  for (const int x : {0, picture->width - 1})
    EXPECT_NEAR(picture->at(x, 0, 1), calf->at(x * (calf->width - 1) / (picture->width - 1), 0, 1), 0.01f);
  // The material is that preset now.
  const auto material = [&] {
    editor.key("ctrl+s");
    const auto project = load_project(document());
    const size_t index = project ? static_cast<size_t>(project->parts[0].material) : 0;
    return project ? project->materials[index] : MaterialInstance{};
  };
  EXPECT_TRUE(wait_until([&] { return material().name == "Mine"; })) << editor.log();
  EXPECT_TRUE(material().preset.starts_with("library:")) << material().preset;
  EXPECT_EQ(material().edits, preset->edits);
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Window, ExportsASnapshotThatCanBeRenderedAgain) {
  EditorRun editor(display(), home(), {document().string()}, 820, 480);  // a small picture
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  editor.move(320, 240);
  editor.key("F12");
  editor.key("Return");
  const fs::path snapshot = home() / "boxes.png";
  ASSERT_TRUE(wait_until([&] { return fs::exists(snapshot); })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
  int code = 0;
  const std::string said = vamp("render --from boxes.png -o again.png", &code);
  ASSERT_EQ(code, 0) << said;
  const auto first = load_image(snapshot), again = load_image(home() / "again.png");
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->pixels, again->pixels);
}

TEST_F(Window, ReturnInAFieldOfTheSnapshotEndsTheTypingAlone) {
  EditorRun editor(display(), home(), {document().string()}, 820, 480);
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  editor.move(320, 240);
  editor.key("F12");
  // The numbers of width and height, at the right of their rows; the dialog stands in the middle.
  for (const int y : {169, 194}) {
    editor.double_click(590, y);
    editor.key("ctrl+a");
    editor.type("64");
    editor.key("Return");
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_FALSE(fs::exists(home() / "boxes.png")) << editor.log();
  editor.move(320, 440);  // away from the fields
  editor.key("Escape F12");
  editor.key("Return");
  ASSERT_TRUE(wait_until([&] { return fs::exists(home() / "boxes.png"); })) << editor.log();
  const auto picture = load_image(home() / "boxes.png");
  ASSERT_TRUE(picture) << picture.error().message();
  EXPECT_EQ(picture->width, 64);
  EXPECT_EQ(picture->height, 64);
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Window, AsksBeforeAnotherPictureIsReplaced) {
  EditorRun editor(display(), home(), {document().string()}, 820, 480);
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  ASSERT_TRUE(write_text_atomically(home() / "boxes.png", "somebody's picture"));
  const auto size = [&] { return fs::file_size(home() / "boxes.png"); };
  const auto type_the_name = [&] {
    editor.key("F12");
    editor.click(410, 318);  // the row of the file
    editor.key("ctrl+a");
    editor.type((home() / "boxes.png").string());
    editor.key("Return");  // ends the typing
  };
  editor.move(320, 240);
  type_the_name();
  editor.key("Return");
  editor.key("Escape");
  EXPECT_EQ(size(), 18u);
  type_the_name();
  editor.key("Return");
  editor.key("Return");
  EXPECT_TRUE(wait_until([&] { return size() > 18u; })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Window, OpensAnotherFileByItsTypedPath) {
  EditorRun editor(display(), home(), {(home() / "boxes.glb").string()});
  ASSERT_TRUE(editor.shows_picture()) << editor.log();
  editor.move(554, 420);
  editor.key("ctrl+o");
  editor.type(document().string());
  editor.key("Return");
  const fs::path recent = home() / "state" / "vamp" / "recent.json";
  EXPECT_TRUE(wait_until([&] {
    return read_text(recent, 1 << 20).value_or("").find("boxes.vampproj") != std::string::npos;
  })) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST_F(Window, OffersWaysOnWhenAFileIsDamaged) {
  ASSERT_TRUE(write_text_atomically(home() / "broken.glb", "glTF, but not really"));
  EditorRun editor(display(), home(), {(home() / "broken.glb").string()});
  ASSERT_TRUE(wait_until([&] { return editor.log().find("broken.glb") != std::string::npos; })) << editor.log();
  EXPECT_TRUE(editor.running());
  // "The shipped shoe" stands beside "Open…".
  std::this_thread::sleep_for(std::chrono::seconds(1));
  editor.key("Right");
  editor.key("space");
  EXPECT_TRUE(editor.shows_picture()) << editor.log();
  editor.key("ctrl+q");
  EXPECT_EQ(editor.wait_for_end(), 0) << editor.log();
}

TEST(WithoutADisplay, ADamagedFileIsStillToldByItsOwnCode) {
  const test::TemporaryHome home;
  ASSERT_TRUE(write_text_atomically(home.path() / "broken.glb", "glTF, but not really"));
  int code = 0;
  const std::string said = output_of(
      "env -u DISPLAY -u WAYLAND_DISPLAY " VAMP_PROGRAM " edit " + (home.path() / "broken.glb").string() + " 2>&1",
      &code);
  EXPECT_EQ(code, 3);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_NE(said.find("broken.glb"), std::string::npos) << said;
}

TEST(WithoutADisplay, TheEditorSaysSoInOneLine) {
  const test::TemporaryHome home;
  int code = 0;
  const std::string said = output_of("env -u DISPLAY -u WAYLAND_DISPLAY " VAMP_PROGRAM " edit 2>&1", &code);
  EXPECT_EQ(code, 1);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  EXPECT_NE(said.find("display"), std::string::npos) << said;
}

}  // namespace
}  // namespace vamp::editor_test
