#pragma once
// A small document, and an editor's window on it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/project/project_file.h"
#include "tests/editor/editor_run.h"
#include "tests/project/small_project.h"

namespace vamp::editor_test {

inline const Display& display() {
  static const Display the_display;
  return the_display;
}

// A filled slider on the screen.
struct Slider {
  int x0 = 0, x1 = 0, y = 0;
};

// The sliders of the panel at the right, from the top: runs in the theme's fill colour, at least 8 pixels high.
inline std::vector<Slider> sliders(const Image& screen) {
  const auto is_fill = [&](int x, int y) {
    constexpr float kFill[3] = {71, 112, 154};
    for (size_t c = 0; c < 3; ++c)
      if (std::abs(255 * screen.at(x, y, c) - kFill[c]) > 2) return false;
    return true;
  };
  std::vector<Slider> found;
  const int left = screen.width - 428 + 100;
  for (int y = 60; y + 8 < screen.height; ++y) {
    int x0 = left;
    while (x0 < screen.width && !is_fill(x0, y)) ++x0;
    int x1 = x0;
    while (x1 < screen.width && is_fill(x1, y)) ++x1;
    if (x1 - x0 < 12 || !is_fill(x0 + 2, y + 8)) continue;
    found.push_back({x0, x1, y + 4});
    y += 14;
  }
  return found;
}

class Window : public testing::Test {
 protected:
  void SetUp() override {
    if (display().name().empty()) GTEST_SKIP() << "needs Xvfb, xdotool and ImageMagick's import";
    test::write_model(home() / "boxes.glb");
    auto project = open_scene(home() / "boxes.glb");
    ASSERT_TRUE(project) << project.error().message();
    const Preset preset = test::small_preset("Small");
    ASSERT_TRUE(save_preset(preset, home() / "small.vamp"));
    assign_preset(*project, 0, preset, (home() / "small.vamp").string());
    project->settings.max_samples = 8;
    ASSERT_TRUE(save_project(*project, document()));
  }

  const fs::path& home() const { return home_.path(); }
  fs::path document() const { return home() / "boxes.vampproj"; }

  // A material is selected and its first slider pulled to the right.
  void edit_the_material(EditorRun& editor) {
    editor.click(554, 420);  // the middle of the picture
    std::vector<Slider> rows;
    ASSERT_TRUE(wait_until([&] { return !(rows = sliders(editor.screen())).empty(); })) << editor.log();
    const Slider row = rows.front();
    editor.drag(row.x1 - 3, row.y, row.x1 + 30, row.y);
    editor.move(554, 420);
  }

  size_t edited_rows(const fs::path& project_file) const {
    const auto project = load_project(project_file);
    if (!project) return 0;
    size_t rows = 0;
    for (const MaterialInstance& material : project->materials) rows += material.edits.bases.size();
    return rows;
  }

  std::string vamp(const std::string& arguments, int* code) const {
    return output_of(fmt::format("cd {} && {} {} 2>&1", home().string(), VAMP_PROGRAM, arguments), code);
  }

  std::vector<fs::path> files(const fs::path& folder, const std::string& extension) const {
    std::vector<fs::path> found;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code))
      if (entry.path().extension() == extension) found.push_back(entry.path());
    return found;
  }

 private:
  test::TemporaryHome home_;
};

}  // namespace vamp::editor_test
