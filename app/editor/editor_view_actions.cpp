// The registry, continued: light, view and rendering.
#include "app/editor/editor.h"
#include "editor/model/edits_scene.h"
#include "editor/panels/lights_panel.h"
#include "editor/panels/view_commands.h"
#include "engine/project/studio.h"

namespace vamp {
void Editor::add_light_actions() {
  const auto room = [this] { return files_.ready() && project().lights.size() < kMaxLights; };
  const auto add = [&](const char* id, const char* label, LightType type) {
    actions_.add({.id = id,
                  .label = label,
                  .menu = "Light",
                  .run =
                      [this, type] {
                        document_.edit(add_light(project(), ui::new_light(project(), type)));
                        dock_.show("lights");
                      },
                  .enabled = room});
  };
  add("light.rect", "Add a rectangle", LightType::rect);
  add("light.disk", "Add a disk", LightType::disk);
  add("light.sphere", "Add a sphere", LightType::sphere);
  add("light.point", "Add a point", LightType::point);
  add("light.spot", "Add a spot", LightType::spot);
  add("light.directional", "Add a directional light", LightType::directional);
  actions_.add({.id = "light.studio",
                .label = "Studio lights",
                .menu = "Light",
                .run =
                    [this] {
                      document_.edit("Studio lights", "", [](Project& now) {
                        now.lights = studio_lights(now.scene->bounds);
                        now.ambient = vec3(kStudioAmbient);
                        now.environment = {};
                      });
                    },
                .enabled = [this] { return files_.ready(); },
                .tooltip = "Two soft rectangles fitted to the model, in place of all lights",
                .group = 1});
  const auto has_map = [this] { return project().environment.map != nullptr; };
  actions_.add({.id = "light.show_environment",
                .label = "Show the environment behind the model",
                .menu = "Light",
                .run = [this] { document_.edit(show_environment(project(), !project().environment.visible)); },
                .enabled = has_map,
                .checked = [this] { return project().environment.visible; },
                .group = 2});
  actions_.add({.id = "light.remove_environment",
                .label = "Remove the environment",
                .menu = "Light",
                .run = [this] { document_.edit(remove_environment(project())); },
                .enabled = has_map,
                .group = 2});
}

void Editor::add_view_actions() {
  const auto ready = [this] { return files_.ready(); };
  const auto tool = [&](const char* id, const char* label, const char* key, ui::Tool which, const char* tip) {
    actions_.add({.id = id,
                  .label = label,
                  .menu = "View",
                  .shortcut = key,
                  .run = [this, which] { context_.tool = which; },
                  .checked = [this, which] { return context_.tool == which; },
                  .tooltip = tip});
  };
  tool("view.pick", "Pick", "P", ui::Tool::pick, "A click selects the part and the cluster under the mouse");
  tool("view.orbit", "Orbit", "O", ui::Tool::orbit, "The left button turns the view");
  actions_.add({.id = "view.fit",
                .label = "Frame",
                .menu = "View",
                .shortcut = "F",
                .run = [this] { ui::fit_selection(context_); },
                .enabled = ready,
                .tooltip = "Fits the selected part, or the whole model, into the picture",
                .group = 1});
  for (const ui::StandardViewRow& row : ui::kStandardViews) {
    actions_.add({.id = std::string("view.standard_") + row.label,
                  .label = row.label,
                  .menu = "View/Standard views",
                  .run = [this, view = row.view] { ui::standard_view(context_, view); },
                  .enabled = ready,
                  .tooltip = row.tooltip,
                  .group = 1});
  }
  const auto chosen = [this] { return selection_.part >= 0; };
  actions_.add({.id = "view.hide",
                .label = "Hide the part",
                .menu = "View",
                .shortcut = "H",
                .run =
                    [this] {
                      const bool visible = project().parts[static_cast<size_t>(selection_.part)].visible;
                      document_.edit(show_part(project(), selection_.part, !visible));
                    },
                .enabled = chosen,
                .group = 2,
                .text =
                    [this] {
                      const bool hidden =
                          selection_.part >= 0 && !project().parts[static_cast<size_t>(selection_.part)].visible;
                      return std::string(hidden ? "Show the part" : "Hide the part");
                    }});
  actions_.add({.id = "view.only",
                .label = "Hide the others",
                .menu = "View",
                .shortcut = "Shift+H",
                .run = [this] { document_.edit(show_only(project(), selection_.part)); },
                .enabled = chosen,
                .group = 2});
  actions_.add({.id = "view.show_all",
                .label = "Show all parts",
                .menu = "View",
                .shortcut = "Alt+H",
                .run = [this] { document_.edit(show_only(project(), -1)); },
                .enabled = ready,
                .group = 2});
  actions_.add({.id = "view.outlines",
                .label = "Outlines",
                .menu = "View",
                .shortcut = "Ctrl+H",
                .run = [this] { context_.show_outlines = !context_.show_outlines; },
                .checked = [this] { return context_.show_outlines; },
                .tooltip = "Lines around the selected part and the one under the mouse; its colours stay as they are",
                .group = 2});
  actions_.add({.id = "view.cluster",
                .label = "Show cluster",
                .menu = "View",
                .shortcut = "C",
                .run = [this] { context_.show_cluster = !context_.show_cluster; },
                .enabled = [this] { return context_.show_outlines; },
                .checked = [this] { return context_.show_cluster; },
                .tooltip = "Tints where the selected cluster lies, to look for it; switch it off to judge colours",
                .group = 2});
  actions_.add({.id = "view.restarted",
                .label = "Restarted pixels",
                .menu = "View",
                .run = [this] { context_.show_restarted = !context_.show_restarted; },
                .checked = [this] { return context_.show_restarted; },
                .tooltip = "Marks the pixels that the last edit began again; all others keep their samples",
                .group = 2});
  for (const ui::Panel& panel : dock_.panels()) {
    if (panel.central) continue;
    actions_.add({.id = "view.panel_" + panel.id,
                  .label = panel.title,
                  .menu = "View/Panels",
                  .run = [this, id = panel.id] { dock_.visible(id) ? dock_.close(id) : dock_.show(id); },
                  .checked = [this, id = panel.id] { return dock_.visible(id); },
                  .group = 3});
  }
  const auto scale = [&](const char* id, const char* label, float value) {
    actions_.add({.id = id,
                  .label = label,
                  .menu = "View/Size of the interface",
                  .run = [this, value] { set_ui_scale(value); },
                  .checked = [this, value] { return settings_.ui_scale == value; },
                  .group = 3});
  };
  scale("view.scale_auto", "As the screen asks", 0);
  scale("view.scale_100", "100 %", 1);
  scale("view.scale_125", "125 %", 1.25f);
  scale("view.scale_150", "150 %", 1.5f);
  scale("view.scale_200", "200 %", 2);
  actions_.add({.id = "view.reset_layout",
                .label = "Reset the layout",
                .menu = "View",
                .run = [this] { dock_.reset(); },
                .group = 3});
}

void Editor::add_render_actions() {
  const auto running = [this] { return session_ != nullptr; };
  actions_.add({.id = "render.pause",
                .label = "Pause",
                .menu = "Render",
                .shortcut = "Ctrl+P",
                .run =
                    [this] {
                      context_.paused = !context_.paused;
                      session_->pause(context_.paused || snapshot_.running());
                    },
                .enabled = running,
                .checked = [this] { return context_.paused; }});
  actions_.add({.id = "render.restart",
                .label = "Start the renderer anew",
                .menu = "Render",
                .run = [this] { restart_renderer(); },
                .enabled = running});
  actions_.add(
      {.id = "render.snapshot",
       .label = "Export snapshot…",
       .menu = "Render",
       .shortcut = "F12",
       .run =
           [this] { snapshot_.open(document_.project(), viewport_width_, viewport_height_, context_.status.samples); },
       .enabled = [this] { return files_.ready() && !snapshot_.running(); },
       .group = 1});
  actions_.add({.id = "render.snapshot_again",
                .label = "Export snapshot again",
                .menu = "Render",
                .shortcut = "Shift+F12",
                .run = [this] { snapshot_.repeat(document_.project()); },
                .enabled = [this] { return snapshot_.can_repeat() && files_.ready(); },
                .tooltip = "With the same choices, over the same file",
                .group = 1});
}

}  // namespace vamp
