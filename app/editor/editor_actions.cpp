// The registry of everything that can be done: menus, tools, shortcuts, palette.
#include <imgui.h>

#include "app/editor/editor.h"
#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/notify.h"
#include "engine/core/files.h"
#include "engine/gpu/device.h"
#include "engine/project/studio.h"

namespace vamp {
namespace {

// A light of a type where the studio's key stands: it shines on the model wherever that is.
Light new_light(const Scene& scene, LightType type) {
  Light light = studio_lights(scene.bounds).front();
  light.type = type;
  light.name = std::string(name_of(type));
  light.name[0] = static_cast<char>(light.name[0] - 'a' + 'A');
  light.radius = 0.5f * std::max(light.size.x, light.size.y);
  return light;
}

}  // namespace

void Editor::add_actions() {
  add_file_actions();
  add_edit_actions();
  add_selection_actions();
  add_material_actions();
  add_light_actions();
  add_view_actions();
  add_render_actions();
  actions_.add(
      {.id = "help.palette", .label = "Command palette…", .menu = "Help", .shortcut = "Ctrl+Shift+P", .run = [this] {
         actions_.open_palette();
       }});
  actions_.add({.id = "help.keys", .label = "Keyboard shortcuts", .menu = "Help", .shortcut = "F1", .run = [this] {
                  actions_.open_sheet();
                }});
  actions_.add(
      {.id = "help.about", .label = "About Vamp", .menu = "Help", .run = [this] { about_ = true; }, .group = 1});
}

void Editor::add_file_actions() {
  const auto ready = [this] { return files_.ready(); };
  actions_.add({.id = "file.new",
                .label = "New",
                .menu = "File",
                .shortcut = "Ctrl+N",
                .run = [this] { files_.new_document(); },
                .tooltip = "The shipped shoe with the shipped materials"});
  actions_.add({.id = "file.open",
                .label = "Open…",
                .menu = "File",
                .shortcut = "Ctrl+O",
                .run = [this] { files_.open(); },
                .tooltip = "A model (.glb, .gltf) or a project (.vampproj)"});
  // The list of recent files is the only thing in this submenu beside its last entry.
  actions_.add({.id = "file.forget",
                .label = "Forget the list",
                .menu = "File/Open recent",
                .run =
                    [this] {
                      if (const Status status = files_.recent().clear(); !status)
                        ui::notify(ui::Notice::error, status.error().message());
                    },
                .enabled = [this] { return !files_.recent().list().empty(); }});
  actions_.add_menu_part("File/Open recent", [this] { draw_recent_files(); });
  actions_.add({.id = "file.save",
                .label = "Save",
                .menu = "File",
                .shortcut = "Ctrl+S",
                .run = [this] { files_.save(); },
                .enabled = ready,
                .group = 1});
  actions_.add({.id = "file.save_as",
                .label = "Save as…",
                .menu = "File",
                .shortcut = "Ctrl+Shift+S",
                .run = [this] { files_.save_as(); },
                .enabled = ready,
                .group = 1});
  actions_.add({.id = "file.environment",
                .label = "Import environment…",
                .menu = "File",
                .run = [this] { choose_environment(); },
                .enabled = ready,
                .group = 2});
  actions_.add({.id = "file.save_preset",
                .label = "Save preset as…",
                .menu = "File",
                .shortcut = "Ctrl+Shift+M",
                .run = [this] { preset_dialog_.open(project(), selection_.material); },
                .enabled = [this] { return selection_.material >= 0; },
                .group = 2});
  actions_.add({.id = "file.snapshot",
                .label = "Export snapshot…",
                .menu = "File",
                .run = [this] { actions_.run("render.snapshot"); },
                .enabled = [this] { return files_.ready() && !snapshot_.running(); },
                .group = 3});
  actions_.add({.id = "file.quit",
                .label = "Quit",
                .menu = "File",
                .shortcut = "Ctrl+Q",
                .run = [this] { close_wanted(); },
                .group = 4});
}

void Editor::draw_recent_files() {
  // A copy: opening one changes the list.
  const std::vector<fs::path> list = files_.recent().list();
  if (list.empty()) return;
  ImGui::Separator();
  for (const fs::path& path : list) {
    const bool there = RecentFiles::exists(path);
    ImGui::PushID(path.c_str());
    if (ImGui::MenuItem(path.filename().c_str(), nullptr, false, there)) files_.open(path);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", path.c_str());
    ImGui::PopID();
  }
}

void Editor::add_edit_actions() {
  const auto undo = [this] { document_.undo(); };
  const auto redo = [this] { document_.redo(); };
  const auto can_redo = [this] { return document_.can_redo(); };
  actions_.add({.id = "edit.undo",
                .label = "Undo",
                .menu = "Edit",
                .shortcut = "Ctrl+Z",
                .run = undo,
                .enabled = [this] { return document_.can_undo(); },
                .text = [this] { return "Undo " + document_.undo_name(); }});
  actions_.add({.id = "edit.redo",
                .label = "Redo",
                .menu = "Edit",
                .shortcut = "Ctrl+Shift+Z",
                .run = redo,
                .enabled = can_redo,
                .text = [this] { return "Redo " + document_.redo_name(); }});
  actions_.add(
      {.id = "edit.redo_too", .label = "Redo (second key)", .shortcut = "Ctrl+Y", .run = redo, .enabled = can_redo});
  actions_.add({.id = "edit.reset_cluster",
                .label = "Reset the selected cluster",
                .menu = "Edit",
                .run =
                    [this] {
                      document_.edit(
                          reset_rows(project(), rows_of_cluster(project(), selection_.material, selection_.cluster)));
                    },
                .enabled = [this] { return selection_.material >= 0 && selection_.cluster >= 0; },
                .group = 1});
  actions_.add({.id = "edit.reset_material",
                .label = "Reset the whole material",
                .menu = "Edit",
                .run = [this] { document_.edit(reset_material(project(), selection_.material)); },
                .enabled = [this] { return selection_.material >= 0; },
                .group = 1});
}

void Editor::add_selection_actions() {
  const auto chosen = [this] { return selection_.part >= 0; };
  const auto ready = [this] { return files_.ready(); };
  actions_.add({.id = "select.none",
                .label = "Nothing",
                .menu = "Select",
                .shortcut = "Esc",
                .run = [this] { selection_ = {}; },
                .enabled = chosen});
  actions_.add({.id = "select.next_part",
                .label = "Next part",
                .menu = "Select",
                .shortcut = "PageDown",
                .run = [this] { step_part(1); },
                .enabled = ready,
                .group = 1});
  actions_.add({.id = "select.previous_part",
                .label = "Previous part",
                .menu = "Select",
                .shortcut = "PageUp",
                .run = [this] { step_part(-1); },
                .enabled = ready,
                .group = 1});
  actions_.add({.id = "select.next_cluster",
                .label = "Next cluster",
                .menu = "Select",
                .shortcut = "Ctrl+PageDown",
                .run = [this] { step_cluster(1); },
                .enabled = chosen,
                .group = 2});
  actions_.add({.id = "select.previous_cluster",
                .label = "Previous cluster",
                .menu = "Select",
                .shortcut = "Ctrl+PageUp",
                .run = [this] { step_cluster(-1); },
                .enabled = chosen,
                .group = 2});
  actions_.add({.id = "select.material",
                .label = "The whole material",
                .menu = "Select",
                .shortcut = "Ctrl+A",
                .run = [this] { selection_.cluster = selection_.basis = -1; },
                .enabled = chosen,
                .group = 2});
}

void Editor::add_material_actions() {
  const auto chosen = [this] { return selection_.part >= 0; };
  actions_.add({.id = "material.assign",
                .label = "Put a preset from a file on the part…",
                .menu = "Material",
                .run = [this] { choose_preset_file(); },
                .enabled = chosen});
  actions_.add({.id = "material.own",
                .label = "Show the model's own material",
                .menu = "Material",
                .run = [this] { document_.edit(use_own_material(project(), selection_.part)); },
                .enabled =
                    [this] {
                      return selection_.material >= 0 &&
                             !project().materials[static_cast<size_t>(selection_.material)].preset.empty();
                    }});
  actions_.add({.id = "material.unique",
                .label = "Make the material unique to this part",
                .menu = "Material",
                .run = [this] { document_.edit(make_material_unique(project(), selection_.part)); },
                .enabled = chosen});
  actions_.add({.id = "material.rescan",
                .label = "Look for presets again",
                .menu = "Material",
                .run = [this] { presets_.rescan(); },
                .group = 1});
}

void Editor::add_light_actions() {
  const auto room = [this] { return files_.ready() && project().lights.size() < kMaxLights; };
  const auto add = [&](const char* id, const char* label, LightType type) {
    actions_.add({.id = id,
                  .label = label,
                  .menu = "Light",
                  .run = [this, type] { document_.edit(add_light(project(), new_light(*project().scene, type))); },
                  .enabled = room});
  };
  add("light.rect", "Add a rectangle", LightType::rect);
  add("light.disk", "Add a disk", LightType::disk);
  add("light.sphere", "Add a sphere", LightType::sphere);
  add("light.point", "Add a point", LightType::point);
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
  actions_.add({.id = "view.outlines",
                .label = "Outlines",
                .menu = "View",
                .shortcut = "Ctrl+H",
                .run = [this] { context_.show_outlines = !context_.show_outlines; },
                .checked = [this] { return context_.show_outlines; },
                .tooltip = "Lines around the selection and what the mouse is over",
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
                      paused_ = !paused_;
                      session_->pause(paused_ || snapshot_.running());
                    },
                .enabled = running,
                .checked = [this] { return paused_; }});
  actions_.add({.id = "render.restart",
                .label = "Start the renderer anew",
                .menu = "Render",
                .run =
                    [this] {
                      context_.session = nullptr;
                      session_ = nullptr;
                  render_device_ = nullptr;  // perhaps it was lost
                      picture_.clear();
                    },
                .enabled = running});
  actions_.add({.id = "render.snapshot",
                .label = "Export snapshot…",
                .menu = "Render",
                .shortcut = "F12",
                .run = [this] { snapshot_.open(document_.project(), viewport_width_, viewport_height_); },
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
