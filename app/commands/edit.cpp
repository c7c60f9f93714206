#include <CLI/CLI.hpp>

#include "app/commands/command.h"

namespace vamp {

void add_edit(CLI::App& app, CommonOptions& common, Action& action) {
  auto file = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("edit", "Open the editor; also without the word: vamp [FILE]");
  verb->add_option("file", *file, "Model or project to open; the shipped derby by default");
  verb->callback([file, &common, &action] { action = [file, &common] { return edit(*file, common); }; });
}

Status edit(const std::string&, const CommonOptions&) {
  return fail(ErrorKind::failed, "", "", "this build has no window; vamp render makes pictures without one");
}

}  // namespace vamp
