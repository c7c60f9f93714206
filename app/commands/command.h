#pragma once
// What the verbs share. Each verb adds its options to the command line and sets `action` to what is to be done; results go
// to stdout, messages to stderr.
#include "engine/core/error.h"

#include <functional>
#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace vamp {

class Progress;
namespace gpu {
class Device;
}

struct CommonOptions {
  std::string log_level = "info";
  std::string device;      // --device: index or part of a name
  bool validate = false;   // --validate: Vulkan's validation layer
  bool json = false;       // --json, of the verbs that have it
};

using Action = std::function<Status()>;

void add_common_options(CLI::App& app, CommonOptions& options);
void add_render(CLI::App& app, CommonOptions& common, Action& action);
void add_compare(CLI::App& app, CommonOptions& common, Action& action);
void add_info(CLI::App& app, CommonOptions& common, Action& action);

// The device that the options name.
Result<std::unique_ptr<gpu::Device>> open_device(const CommonOptions& options);

// Draws `label` and the fraction done on stderr while `work` runs on another thread; Ctrl+C and SIGTERM cancel it.
void run_with_progress(const std::string& label, Progress& progress, const std::function<void()>& work);
// Whether a signal asked to stop.
bool interrupted();

}  // namespace vamp
