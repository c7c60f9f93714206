#include "editor/panels/panels.h"

namespace vamp::ui {

void add_panels(Dock& dock, Panels& panels, PanelContext& context) {
  const auto add = [&](const char* id, const char* title, auto& panel, const char* beside) {
    Panel entry;
    entry.id = id;
    entry.title = title;
    entry.beside = beside;
    // Where nothing is open there is nothing to edit; the log may say why.
    const bool always = entry.id == "viewport" || entry.id == "log";
    entry.draw = [&panel, &context, always] {
      ImGui::BeginDisabled(!always && !context.problem.empty());
      panel.draw(context);
      ImGui::EndDisabled();
    };
    entry.central = entry.id == "viewport";
    dock.add(std::move(entry));
  };
  add("viewport", "Viewport", panels.viewport, "");
  add("presets", "Presets", panels.presets, "");
  add("parts", "Parts", panels.parts, "");
  add("lights", "Lights", panels.lights, "parts");
  add("camera", "Camera", panels.camera, "parts");
  add("history", "History", panels.history, "");
  add("log", "Log", panels.log, "history");
  add("material", "Material", panels.material, "");
  add("render", "Render", panels.render, "material");
}

DockLayout default_layout() {
  using L = DockLayout;
  auto lower = L::column(L::leaf({"parts", "lights", "camera"}), L::leaf({"history", "log"}), 120, 0.78f);
  auto left = L::column(L::leaf({"presets"}), std::move(lower), 340, 0.37f);
  auto right = L::row(L::leaf({"viewport"}), L::leaf({"material", "render"}), 432);
  return L(L::row(std::move(left), std::move(right), 290));
}

}  // namespace vamp::ui
