#pragma once
// What the verbs share. Each verb adds its options to the command line and sets `action` to what is to be done; results
// go to stdout, messages to stderr (docs/command-line.md).
#include <functional>
#include <memory>
#include <string>

#include "engine/core/error.h"

namespace CLI {
class App;
}

namespace vamp {

namespace gpu {
class Device;
}

struct CommonOptions {
  std::string log_level = "info";
  std::string device;         // --device: index or part of a name
  bool list_devices = false;  // --list-devices: instead of what the verb does
  bool validate = false;      // --validate: Vulkan's validation layer
  bool json = false;          // --json, of the verbs that have it
};

using Action = std::function<Status()>;

void add_common_options(CLI::App& app, CommonOptions& options);
void add_edit(CLI::App& app, CommonOptions& common, Action& action);
void add_render(CLI::App& app, CommonOptions& common, Action& action);
void add_compare(CLI::App& app, CommonOptions& common, Action& action);
void add_bench(CLI::App& app, CommonOptions& common, Action& action);
void add_brdf(CLI::App& app, CommonOptions& common, Action& action);
void add_info(CLI::App& app, CommonOptions& common, Action& action);
void add_convert(CLI::App& app, CommonOptions& common, Action& action);
void add_acquire(CLI::App& app, CommonOptions& common, Action& action);
void add_fit(CLI::App& app, CommonOptions& common, Action& action);
void add_evaluate(CLI::App& app, CommonOptions& common, Action& action);
void add_recolour(CLI::App& app, CommonOptions& common, Action& action);
void add_help(CLI::App& app, Action& action);

// The editor on a model or project; on the shipped scene where `file` is empty. Also what happens without a verb.
Status edit(const std::string& file, const CommonOptions& common);

// What --list-devices prints.
Status print_devices();

// The device that the options name.
Result<std::unique_ptr<gpu::Device>> open_device(const CommonOptions& options);

}  // namespace vamp
