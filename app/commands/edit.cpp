#include <CLI/CLI.hpp>

#include "app/commands/command.h"
#include "app/commands/interrupt.h"
#include "app/editor/options.h"
#include "engine/project/job_options.h"

namespace vamp {
namespace {

Status open_editor(EditorOptions options, const CommonOptions& common) {
  // Said before a window opens for it.
  std::error_code code;
  if (!options.file.empty() && !std::filesystem::exists(options.file, code))
    return fail(ErrorKind::bad_input, options.file.string(), "", "a file", "nothing there");
  options.device = common.device;
  options.validate = common.validate;
  catch_interrupts();
  options.interrupted = interrupted;
  VAMP_CHECK_STATUS(run_editor(options));
  if (interrupted())
    return fail(ErrorKind::interrupted, "", "", "the editor was stopped; what was not saved is kept aside");
  return {};
}

}  // namespace

void add_edit(CLI::App& app, CommonOptions& common, Action& action) {
  auto options = std::make_shared<EditorOptions>();
  auto size = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("edit", "Open the editor; also without the word: vamp [FILE]");
  verb->add_option("file", options->file,
                   "Model or project to open; what was open last, else the shipped derby by default");
  verb->add_flag("--safe-mode", options->safe_mode, "Neither read nor write settings and layout");
  verb->add_option("--ui", options->ui, "Who draws the user interface")
      ->check(CLI::IsMember({"auto", "cpu", "vulkan"}))
      ->capture_default_str();
  verb->add_option("--size", *size, "Size of the window, WxH");
  verb->add_option("--edit-memory", options->edit_memory,
                   "MiB of the device's memory from which edits are answered: stored hits, and sums of the selected "
                   "weights; a sixteenth of it, at most 416, by default")
      ->check(CLI::Range(0, 65536));
  verb->add_option("--frames", options->frames, "Draw this many frames, print what they took as JSON, and end")
      ->check(CLI::PositiveNumber);
  verb->add_option(
      "--record-exit", options->record_exit,
      "At the end write the linear picture and its job to this .exr, once it has the project's last sample");
  verb->add_flag("--tell", options->tell)->group("");
  verb->add_option("--lose-device", options->lose_device)->check(CLI::IsMember({"renderer", "window"}))->group("");
  verb->callback([options, size, &common, &action] {
    action = [options, size, &common]() -> Status {
      if (!size->empty()) {
        VAMP_TRY(const uvec2 wanted, parse_size(*size, "--size"));
        options->width = static_cast<int>(wanted.x);
        options->height = static_cast<int>(wanted.y);
      }
      return open_editor(*options, common);
    };
  });
}

Status edit(const std::string& file, const CommonOptions& common) { return open_editor({.file = file}, common); }

}  // namespace vamp
