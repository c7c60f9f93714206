// The registry of everything that can be done: menus, tools, shortcuts, palette.
#include <imgui.h>

#include "app/editor/editor.h"
#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "editor/panels/part_menu.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/notify.h"
#include "engine/core/files.h"

namespace vamp {

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
  explain_the_mouse();
}

void Editor::explain_the_mouse() {
  for (const auto& [what, how] : std::initializer_list<std::pair<const char*, const char*>>{
           {"Select part and cluster", "click the picture"},
           {"Menu of a part", "right click on it"},
           {"Turn the view", "right or middle drag, Alt+drag"},
           {"Turn it by 5°, by 1°", "arrow keys, with Shift"},
           {"Move the view", "Shift+middle drag, Ctrl+Alt+drag"},
           {"Zoom to the mouse", "wheel"},
           {"Frame the model", "double-click beside it"},
           {"Frame a part", "double-click it in the list"},
           {"Put a preset on a part", "drag it onto the picture"},
           {"Open a file", "drop it on the window"},
           {"Change a value", "drag slider or number"},
           {"Finely", "Shift+drag"},
           {"Type a value", "double-click, Ctrl+click, Tab"},
           {"Take a drag back", "Esc before letting go"},
           {"Reset, copy, paste a value", "right click on it"},
           {"Rename a kept view", "double-click its name"},
           {"Move a panel", "drag its tab"}})
    actions_.explain(what, how);
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
  const auto chosen = [this] { return selection_.part >= 0; };
  actions_.add({.id = "edit.copy",
                .label = "Copy material",
                .menu = "Edit",
                .shortcut = "Ctrl+C",
                .run = [this] { ui::copy_material(context_, selection_.part); },
                .enabled = chosen,
                .tooltip = "The selected part's material with its edits",
                .group = 1});
  actions_.add({.id = "edit.paste",
                .label = "Paste material",
                .menu = "Edit",
                .shortcut = "Ctrl+V",
                .run = [this] { ui::paste_material_onto(context_, selection_.part); },
                .enabled = [this] { return selection_.part >= 0 && ui::can_paste_material(context_); },
                .tooltip = "Onto the selected part",
                .group = 1});
  actions_.add({.id = "edit.reset_cluster",
                .label = "Reset the selected cluster",
                .menu = "Edit",
                .run =
                    [this] {
                      document_.edit(
                          reset_rows(project(), rows_of_cluster(project(), selection_.material, selection_.cluster)));
                    },
                .enabled = [this] { return selection_.material >= 0 && selection_.cluster >= 0; },
                .group = 2});
  actions_.add({.id = "edit.reset_material",
                .label = "Reset the whole material",
                .menu = "Edit",
                .run = [this] { document_.edit(reset_material(project(), selection_.material)); },
                .enabled = [this] { return selection_.material >= 0; },
                .group = 2});
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

}  // namespace vamp
