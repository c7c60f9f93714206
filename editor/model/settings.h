#pragma once
// How the user likes the program: kept in config_dir()/settings.json.
#include <cstdint>
#include <filesystem>
#include <string>

#include "engine/core/error.h"

namespace vamp {

enum class Theme { dark, light, high_contrast };

struct WindowPlace {
  int x = 0, y = 0;
  int width = 1440, height = 900;
  bool maximized = false;
  bool placed = false;  // x and y are known; otherwise the window manager chooses
  bool operator==(const WindowPlace&) const = default;
};

struct Settings {
  float ui_scale = 0;  // 0: the display's own; else 0.5 to 4
  Theme theme = Theme::dark;
  std::string layout;  // the panels' places, written by the dock tree; empty: as shipped
  int layout_version = 0;
  std::string device;  // part of the device's name; empty: the best there is
  WindowPlace window;
  bool reopen_last = true;
  bool reduced_motion = false;
  std::string last_folder;  // of the open and save dialogs
  bool operator==(const Settings&) const = default;
};

struct LoadedSettings {
  Settings settings;
  std::string problem;  // not empty: the file is damaged, and what of it is not used
};

// `file`: empty for config_dir()/settings.json. Never fails: no file gives the defaults; members that are missing or
// wrong take their defaults one by one and `problem` names the first; a file that is no JSON at all is put aside as
// "settings.json.damaged".
LoadedSettings load_settings(const std::filesystem::path& file = {});
Status save_settings(const Settings& settings, const std::filesystem::path& file = {});

// The window where it still can be seen and grabbed: at least a part of its top lies in the given monitor's work area.
WindowPlace clamp_to_monitor(const WindowPlace& place, int left, int top, int width, int height);

}  // namespace vamp
