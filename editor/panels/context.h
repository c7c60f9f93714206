#pragma once
// What panels work with. They read the model and emit named edits through the document; they never write the project.
#include <imgui.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/document.h"
#include "editor/model/preset_library.h"
#include "editor/model/selection.h"
#include "engine/material/preset.h"
#include "engine/render/session.h"

namespace vamp::ui {

enum class Tool { pick, orbit };

// The picture as the viewport shows it: textures that the application keeps up to date.
struct ViewportTextures {
  ImTextureID picture = nullptr;  // the rendered picture, drawn 1:1
  ImTextureID outline = nullptr;  // RGBA overlay: outlines of the selection and of what the mouse is over; may be null
  ImTextureID restarted = nullptr;  // RGBA overlay: the pixels that the last edit restarted; may be null
  int width = 0, height = 0;
};

// One for the whole editor; references stay valid while it runs.
struct PanelContext {
  Document& document;
  Selection& selection;
  PresetLibrary& presets;

  // The renderer: null until it runs. Status is refreshed once a frame.
  RenderSession* session = nullptr;
  RenderStatus status;
  WeightGroup weights_at_hand;  // rows whose weight a panel shows: those the renderer is to be ready for
  ViewportTextures viewport;
  std::string problem;         // why no document is open; empty while one is, or is being loaded
  ImVec2 viewport_size{0, 0};  // of its panel, in pixels; 0 before it was drawn
  Tool tool = Tool::pick;
  bool paused = false;  // refinement rests
  bool show_outlines = true;
  bool show_restarted = false;  // the pixels that the last edit restarted are marked in the picture
  bool show_cluster = false;  // the selected cluster is tinted in the picture
  Camera opened_camera;       // where the camera stood when the document was opened: what its rows go back to
  Pick hover;                 // what the mouse is over in the viewport; part -1 while it is elsewhere

  // What was copied from a part, and the model that it was copied in.
  std::optional<MaterialInstance> copied_material;
  std::shared_ptr<const Scene> copied_from;

  // What lies under a point of the picture, in pixels; empty: the session answers.
  std::function<Pick(float x, float y)> pick;

  // Asked by panels, done by the application.
  std::function<void(int width, int height)> resize_viewport;                 // in pixels, when its panel changed size
  std::function<ImTextureID(const PresetInfo&)> thumbnail;                    // null texture: none
  std::function<void(const std::filesystem::path&, int part)> assign_preset;  // loads it and puts it on a part
  std::function<void(int material)> save_preset_as;                           // opens the dialog for a name
  std::function<std::vector<std::filesystem::path>()> recent_files;
  std::function<void(const std::filesystem::path&)> open_file;  // a model or project
  std::function<void()> choose_environment;                     // opens the file dialog
  std::function<void(const std::string& action)> run;           // an action of the registry by its id
  std::function<void(const std::string& line)> report;          // something failed: one line to show
};

}  // namespace vamp::ui
