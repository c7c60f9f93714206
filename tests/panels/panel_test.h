#pragma once
// Panels without a window or a renderer: a small project in memory, frames and input by hand.
#include <filesystem>

#include "editor/panels/panels.h"
#include "tests/render/scenes.h"
#include "tests/widgets/ui_test.h"

namespace vamp::ui {

inline Project shoe_in_a_box() {
  SceneBuilder builder;
  builder.add_box("Vamp", vec3(-0.1f, 0, -0.1f), vec3(0.1f, 0.1f, 0.1f));
  builder.add_quad("Sole", vec3(-0.2f, 0, 0.2f), vec3(0.4f, 0, 0), vec3(0, 0, -0.4f));
  builder.add_quad("Laces", vec3(-0.1f, 0.2f, 0.1f), vec3(0.2f, 0, 0), vec3(0, 0, -0.2f));
  Project project = dark_project(builder.build());
  put_material(project, "Vamp", make_rich_material(5));
  return project;
}

class PanelTest : public UiTest {
 protected:
  PanelTest()
      : folder_(std::filesystem::path(testing::TempDir()) / "vamp_panels_test"),
        library_(PresetLibrary::Folders{folder_, folder_, {}}),
        document_(shoe_in_a_box()) {}

  void select(const char* part, int cluster = -1, int basis = -1) {
    selection_ = select_part(*document_.project(), find_part(*document_.project(), part));
    selection_.cluster = cluster;
    selection_.basis = basis;
  }
  template <class PanelType>
  void draw(PanelType& panel, int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      frame([&] { panel.draw(context_); });
      take_abandoned_edit();
    }
  }

  std::filesystem::path folder_;
  PresetLibrary library_;
  Document document_;
  Selection selection_;
  PanelContext context_{document_, selection_, library_};
};

}  // namespace vamp::ui
