// The program: verbs, options that all of them share, and what is said when something goes wrong.
#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>

#include "app/commands/command.h"
#include "engine/core/log.h"

namespace {

using namespace vamp;

int say(const Error& error) {
  std::fprintf(stderr, "vamp: %s\n", error.message().c_str());
  return static_cast<int>(error.kind);
}

// `vamp FILE`. A word that is no file was probably meant to be a verb.
Status edit_file(const std::string& file, const CommonOptions& common) {
  const std::filesystem::path path(file);
  std::error_code code;
  if (!file.empty() && !path.has_extension() && !path.has_parent_path() && !std::filesystem::exists(path, code))
    return fail(ErrorKind::usage, "", "", "a file or one of the verbs of vamp --help", "\"" + file + "\"");
  return edit(file, common);
}

Status run(const Action& action) {
  try {
    VAMP_CHECK_STATUS(action());
    if (std::fflush(stdout) != 0) return fail(ErrorKind::io, "", "standard output", std::strerror(errno));
    return {};
  } catch (const MachineError& error) {
    return fail(error.kind(), "", "", error.what());
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::failed, "", "", "the computer's memory ran out");
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Vamp: shapes how the leather and cloth of a shoe look, ray-traced while it is edited.", "vamp"};
  CommonOptions common;
  Action action;
  std::string file;
  add_common_options(app, common);
  app.add_option("file", file, "Model or project to open in the editor");
  add_edit(app, common, action);
  add_render(app, common, action);
  add_compare(app, common, action);
  add_info(app, common, action);
  add_convert(app, common, action);
  add_acquire(app, common, action);
  add_fit(app, common, action);
  add_evaluate(app, common, action);
  add_recolour(app, common, action);
  add_brdf(app, common, action);
  add_bench(app, common, action);
  add_help(app, action);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return say({ErrorKind::usage, "", "", error.what(), ""});
  }
  // Verbs leave what they do not expect to the program, whose only use for a word is a file to edit.
  if (!file.empty() && !app.get_subcommands().empty())
    return say(
        {ErrorKind::usage, "", app.get_subcommands().front()->get_name(), "no further argument", "\"" + file + "\""});
  start_log(common.log_level);
  if (common.list_devices) action = print_devices;
  if (!action) action = [&] { return edit_file(file, common); };
  const Status status = run(action);
  return status ? 0 : say(status.error());
}
