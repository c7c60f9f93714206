#include <fmt/format.h>
#include <vulkan/vulkan.h>

#include <CLI/CLI.hpp>
#include <string_view>

#include "app/commands/command.h"
#include "app/version.h"
#include "engine/gpu/device.h"
#include "engine/render/trace_path.h"

namespace vamp {
namespace {

std::string version_text() {
  constexpr std::string_view kDescribe = VAMP_GIT_DESCRIBE;
  constexpr uint32_t kHeaders = VK_HEADER_VERSION_COMPLETE;
  return fmt::format("vamp {}{}, Vulkan headers {}.{}.{}", VAMP_VERSION,
                     kDescribe.empty() ? "" : fmt::format(" ({})", kDescribe), VK_API_VERSION_MAJOR(kHeaders),
                     VK_API_VERSION_MINOR(kHeaders), VK_API_VERSION_PATCH(kHeaders));
}

}  // namespace

Status print_devices() {
  VAMP_TRY(const auto devices, gpu::list_devices());
  for (const gpu::DeviceInfo& device : devices)
    fmt::print("{}: {} ({}, {}), {}\n", device.index, device.name, gpu::name_of(device.type), device.driver,
               device.unsuitable.empty() ? words_of(trace_paths(device)) : "cannot serve: " + device.unsuitable);
  return {};
}

void add_common_options(CLI::App& app, CommonOptions& options) {
  app.set_version_flag("--version", version_text());
  app.add_flag("--list-devices", options.list_devices, "List the Vulkan devices and stop");
  app.add_option("--device", options.device, "Vulkan device: a number of --list-devices or part of a name")
      ->type_name("DEVICE");
  app.add_flag("--validate", options.validate, "Turn on Vulkan's validation layer");
  app.add_option("--log-level", options.log_level, "What is said on stderr")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  // They may stand behind the verb too. Verbs that are added later inherit this.
  app.fallthrough();
}

void add_help(CLI::App& app, Action& action) {
  CLI::App* verb = app.add_subcommand("help", "Say what a verb does");
  auto name = std::make_shared<std::string>();
  verb->add_option("verb", *name, "One of those above");
  verb->callback([name, &app, &action] {
    action = [name, &app]() -> Status {
      if (name->empty()) {
        // Not app.help(), which speaks of the verb that was given: help.
        fmt::print("{}", app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
        return {};
      }
      const auto found = app.get_subcommands([&name](const CLI::App* each) { return each->get_name() == *name; });
      if (found.empty()) return fail(ErrorKind::usage, "", "help", "one of the verbs of vamp --help", *name);
      fmt::print("{}", found.front()->help(app.get_name()));
      return {};
    };
  });
}

Result<std::unique_ptr<gpu::Device>> open_device(const CommonOptions& options) {
  VAMP_TRY(auto device, gpu::Device::create({.device = options.device, .validate = options.validate}));
  tune_trace_paths(*device);
  return device;
}

}  // namespace vamp
