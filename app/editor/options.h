#pragma once
// What the editor is started with.
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "engine/core/error.h"

namespace vamp {

struct EditorOptions {
  std::filesystem::path file;  // model or project; empty: what was open last, else the shipped scene
  bool safe_mode = false;      // neither reads nor writes settings and layout
  std::string device;          // number or part of the name; empty: the settings' choice, else the best
  bool validate = false;
  std::string ui = "auto";    // who draws the user interface: auto, cpu, vulkan
  int width = 0, height = 0;  // of the window; 0: as it was left
  int edit_memory = -1;       // MiB for what edits are answered from (RenderSession); -1: a share of the device's
  int frames = 0;             // over 0: draws this many frames once the picture is there, prints their times, ends
  bool tell = false;          // for programs that use the window: tells on stdout what it shows (Teller)
  std::filesystem::path record_exit;  // not empty: the linear picture with its job goes there at the end (.exr)
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
  std::string lose_device;            // for tests, after the first edit: what loses its device, "renderer" or "window"
  std::function<bool()> interrupted;  // whether the program was asked to end from outside; may be empty
};

// Opens the window and runs until it is closed. Errors: failed without a display, no_device, device_lost (after the
// document was put aside for the next start), and what keeps record_exit from being written.
Status run_editor(const EditorOptions& options);

}  // namespace vamp
