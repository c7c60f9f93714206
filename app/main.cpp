// The program: verbs, options that all of them share, and what is said when something goes wrong.
#include "app/commands/command.h"
#include "engine/core/log.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <new>

namespace {

int say(const vamp::Error& error) {
  std::fprintf(stderr, "vamp: %s\n", error.message().c_str());
  return static_cast<int>(error.kind);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace vamp;
  CLI::App app{"Vamp: shapes how the leather and cloth of a shoe look, ray-traced as it is edited.", "vamp"};
  CommonOptions common;
  Action action;
  add_common_options(app, common);
  add_render(app, common, action);
  add_compare(app, common, action);
  add_info(app, common, action);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version are no errors; everything else is wrong usage, whatever number CLI11 gives it.
    return app.exit(error) == 0 ? 0 : static_cast<int>(ErrorKind::usage);
  }
  start_log(common.log_level);
  try {
    if (!action) {
      std::fputs(app.help().c_str(), stdout);
      return static_cast<int>(ErrorKind::usage);
    }
    const Status status = action();
    return status ? 0 : say(status.error());
  } catch (const MachineError& error) {
    return say({error.kind(), "", "", error.what(), ""});
  } catch (const std::bad_alloc&) {
    return say({ErrorKind::failed, "", "", "the computer's memory ran out", ""});
  }
}
