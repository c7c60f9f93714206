#include "app/commands/command.h"
#include "engine/core/progress.h"
#include "engine/gpu/device.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <future>

namespace vamp {
namespace {

std::atomic<bool> stop_asked{false};

void ask_to_stop(int) { stop_asked.store(true); }

void print_devices() {
  const auto devices = gpu::list_devices();
  if (!devices) {
    std::fprintf(stderr, "vamp: %s\n", devices.error().message().c_str());
    std::exit(static_cast<int>(devices.error().kind));
  }
  for (const gpu::DeviceInfo& device : *devices)
    fmt::print("{}: {} ({}, {}){}\n", device.index, device.name, gpu::name_of(device.type), device.driver,
               device.unsuitable.empty() ? "" : ", cannot serve: " + device.unsuitable);
  std::exit(0);
}

}  // namespace

void add_common_options(CLI::App& app, CommonOptions& options) {
  app.set_version_flag("--version", "vamp 0.1.0");
  app.add_flag_callback("--list-devices", print_devices, "List the Vulkan devices and stop");
  app.add_option("--device", options.device, "Vulkan device: an index of --list-devices or part of a name");
  app.add_flag("--validate", options.validate, "Turn on Vulkan's validation layer");
  app.add_option("--log-level", options.log_level, "What is said on stderr")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  app.fallthrough();  // so that they may stand behind the verb
}

Result<std::unique_ptr<gpu::Device>> open_device(const CommonOptions& options) {
  return gpu::Device::create({.device = options.device, .validate = options.validate});
}

bool interrupted() { return stop_asked.load(); }

void run_with_progress(const std::string& label, Progress& progress, const std::function<void()>& work) {
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  auto done = std::async(std::launch::async, work);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  while (done.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    if (interrupted()) progress.cancel();
    if (terminal) fmt::print(stderr, "\r{} {:3.0f} %", label, 100.0 * static_cast<double>(progress.fraction()));
  }
  if (terminal) fmt::print(stderr, "\r{:{}}\r", "", label.size() + 8);
  done.get();
}

}  // namespace vamp
