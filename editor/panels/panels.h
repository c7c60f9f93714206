#pragma once
// All panels of the editor and where they stand at first.
#include "editor/panels/camera_panel.h"
#include "editor/panels/context.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/lights_panel.h"
#include "editor/panels/log_panel.h"
#include "editor/panels/material_panel.h"
#include "editor/panels/parts_panel.h"
#include "editor/panels/presets_panel.h"
#include "editor/panels/render_panel.h"
#include "editor/panels/viewport_panel.h"
#include "editor/widgets/dock.h"

namespace vamp::ui {

struct Panels {
  ViewportPanel viewport;
  PresetsPanel presets;
  PartsPanel parts;
  LightsPanel lights;
  CameraPanel camera;
  HistoryPanel history;
  LogPanel log;
  MaterialPanel material;
  RenderPanel render;
};

// Enters them into the dock: viewport, presets, parts, lights, camera, history, log, material, render. `panels` and
// `context` must outlive it.
void add_panels(Dock& dock, Panels& panels, PanelContext& context);

// For the dock: presets over parts over history on the left, the picture, the material on the right.
DockLayout default_layout();

}  // namespace vamp::ui
