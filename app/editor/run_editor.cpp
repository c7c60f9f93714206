#include <imgui.h>

#include <exception>
#include <memory>
#include <new>

#include "app/editor/editor.h"
#include "app/editor/options.h"
#include "app/window/textures.h"
#include "app/window/window.h"
#include "editor/widgets/theme.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/project/project_file.h"

namespace vamp {
namespace {

struct ImGuiScope {
  ImGuiScope() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  }
  ~ImGuiScope() { ImGui::DestroyContext(); }
};

window::WindowOptions window_options(const EditorOptions& options, const Settings& settings) {
  window::WindowOptions wanted;
  const WindowPlace& place = settings.window;
  wanted.place = {place.x, place.y, place.width, place.height, place.maximized, place.placed};
  if (options.width > 0) wanted.place = {0, 0, options.width, options.height, false, false};
  wanted.scale = settings.ui_scale;
  if (options.ui == "cpu") wanted.renderer = window::UiRenderer::cpu;
  if (options.ui == "vulkan") wanted.renderer = window::UiRenderer::vulkan;
  return wanted;
}

// Without a window a file can still be judged, and one that is damaged is worth more words than the window.
Status no_window(const Error& why, const EditorOptions& options) {
  const Result<Project> project = options.file.empty() ? Project() : open_scene(options.file);
  if (!project) return tl::unexpected(project.error());
  return tl::unexpected(why);
}

}  // namespace

Status run_editor(const EditorOptions& options) {
  Settings settings;
  if (!options.safe_mode) {
    LoadedSettings loaded = load_settings();
    if (!loaded.problem.empty()) spdlog::warn("settings: {}", loaded.problem);
    settings = std::move(loaded.settings);
  }
  const Result<std::vector<std::string>> extensions = window::Window::instance_extensions();
  if (!extensions) return no_window(extensions.error(), options);
  gpu::Options how;
  how.device = options.device.empty() ? settings.device : options.device;
  how.validate = options.validate;
  how.instance_extensions = *extensions;
  how.device_extensions = window::Window::device_extensions();
  VAMP_TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create(how));

  const ImGuiScope imgui;
  window::Textures textures;
  VAMP_TRY(const std::unique_ptr<window::Window> window,
           window::Window::open(*device, textures, window_options(options, settings)));
  auto editor = std::make_unique<Editor>(*device, *window, textures, settings, options);
  window::Hooks hooks;
  hooks.rescale = ui::apply_theme;
  hooks.frame = [&] { editor->frame(); };
  hooks.shown = [&] { editor->shown(); };
  hooks.wake_after = [&] { return editor->wake_after(); };
  hooks.close_wanted = [&] { editor->close_wanted(); };
  hooks.dropped = [&](const std::vector<std::string>& paths) { editor->dropped(paths); };
  try {
    window->run(hooks);
    return editor->finish();
  } catch (const MachineError& error) {
    // Nothing more is asked of the device; the next start offers the document.
    editor->abandon();
    return fail(error.kind(), "", "", std::string(error.what()) + "; unsaved changes are offered at the next start");
  } catch (const std::bad_alloc&) {
    // Here rather than further up: there the editor is gone already, and its autosave with it.
    editor->abandon();
    return fail(ErrorKind::failed, "", "", "out of memory; unsaved changes are offered at the next start");
  } catch (const std::exception& error) {
    editor->abandon();
    return fail(ErrorKind::failed, "", "",
                std::string(error.what()) + "; unsaved changes are offered at the next start");
  }
}

}  // namespace vamp
