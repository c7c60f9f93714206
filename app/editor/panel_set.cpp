#include "app/editor/panel_set.h"

#include "editor/panels/camera_panel.h"
#include "editor/panels/lights_panel.h"
#include "editor/panels/material_panel.h"
#include "editor/panels/parts_panel.h"
#include "editor/panels/presets_panel.h"
#include "editor/panels/viewport_panel.h"

namespace vamp {

struct PanelSet::Panels {
  ui::ViewportPanel viewport;
  ui::PresetsPanel presets;
  ui::PartsPanel parts;
  ui::LightsPanel lights;
  ui::CameraPanel camera;
  ui::MaterialPanel material;
};

PanelSet::PanelSet() : panels_(std::make_unique<Panels>()) {}
PanelSet::~PanelSet() = default;

void PanelSet::add_to(ui::Dock& dock, ui::PanelContext& context) {
  const auto add = [&](const char* id, const char* title, auto& panel, const char* beside) {
    dock.add({.id = id, .title = title, .draw = [&panel, &context] { panel.draw(context); }, .beside = beside});
  };
  dock.add({.id = "viewport",
            .title = "Viewport",
            .draw = [this, &context] { panels_->viewport.draw(context); },
            .central = true});
  add("presets", "Presets", panels_->presets, "");
  add("parts", "Parts", panels_->parts, "presets");
  add("lights", "Lights", panels_->lights, "parts");
  add("camera", "Camera", panels_->camera, "parts");
  add("material", "Material", panels_->material, "");
}

ui::DockLayout PanelSet::default_layout() {
  using ui::DockLayout;
  auto left = DockLayout::column(
      DockLayout::leaf({"presets"}),
      DockLayout::column(DockLayout::leaf({"parts", "lights", "camera"}), DockLayout::leaf({"history"}), 0, 0.75f), 0,
      0.4f);
  auto right = DockLayout::leaf({"material", "render"});
  return DockLayout(
      DockLayout::row(std::move(left), DockLayout::row(DockLayout::leaf({"viewport"}), std::move(right), 428), 256));
}

}  // namespace vamp
