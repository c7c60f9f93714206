#include "engine/render/fetch_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "engine/core/clock.h"
#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

constexpr const char* kVariable = "VAMP_FETCH";
constexpr uint64_t kMaxBytes = 1u << 16;
constexpr size_t kMaxDevices = 32;

struct Remembered {
  std::string device, driver;  // DeviceInfo::name and driver, which hold the driver's version
  double texel_ms = 0, storage_ms = 0;
};

fs::path file_of_devices() { return cache_dir() / "devices.json"; }

Result<std::vector<Remembered>> read_devices() {
  const std::string file = file_of_devices().string();
  VAMP_TRY(const std::string text, read_text(file, kMaxBytes));
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader root(json, file);
  const JsonReader devices = root.member("devices");
  std::vector<Remembered> all;
  for (size_t i = 0; i < devices.size(kMaxDevices); ++i) {
    const JsonReader one = devices.element(i);
    constexpr double kLeast = 1e-6, kMost = 1e6;
    all.push_back({one.member("device").text(), one.member("driver").text(), one.member("texel_ms").real(kLeast, kMost),
                   one.member("storage_ms").real(kLeast, kMost)});
  }
  VAMP_CHECK_STATUS(root.status());
  return all;
}

Status write_devices(const std::vector<Remembered>& all) {
  Json devices = Json::array();
  for (const Remembered& one : all)
    devices.push_back(
        {{"device", one.device}, {"driver", one.driver}, {"texel_ms", one.texel_ms}, {"storage_ms", one.storage_ms}});
  std::error_code code;
  fs::create_directories(file_of_devices().parent_path(), code);
  return write_text_atomically(file_of_devices(), print_json(Json{{"devices", devices}}));
}

std::optional<bool> forced() {
  const char* value = std::getenv(kVariable);
  if (value == nullptr) return std::nullopt;
  const std::string_view text = value;
  if (text == "texel" || text == "storage") return text == "storage";
  return std::nullopt;
}

// A bumpy ball of 20,000 triangles on nothing, seen from near by.
Project probe_project() {
  constexpr int kRings = 72;
  auto scene = std::make_shared<Scene>();
  scene->parts.resize(1);
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j < 2 * kRings; ++j) {
      const float theta = std::numbers::pi_v<float> * static_cast<float>(i) / kRings;
      const float phi = std::numbers::pi_v<float> * static_cast<float>(j) / kRings;
      const vec3 out(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      scene->positions.push_back((1 + 0.1f * std::sin(9 * theta) * std::sin(11 * phi)) * out);
      scene->normals.push_back(out);
      scene->tangents.emplace_back(-std::sin(phi), 0, std::cos(phi), 1);
      scene->uvs.emplace_back(0);
    }
  const auto at = [](int i, int j) { return static_cast<uint32_t>(i * 2 * kRings + j % (2 * kRings)); };
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < 2 * kRings; ++j) {
      if (i > 0) scene->triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      if (i < kRings - 1) scene->triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  scene->triangle_part.resize(scene->triangles.size());
  scene->lights.emplace_back();
  finish_scene(*scene);
  Project project = make_project(scene, "probe");
  project.camera.eye = vec3(0, 1, 2.2f);
  project.camera.target = vec3(0);
  return project;
}

Remembered measure(gpu::Device& device) {
  constexpr int kSide = 160, kRounds = 7;
  const auto project = std::make_shared<const Project>(probe_project());
  std::array<std::unique_ptr<Renderer>, 2> renderers;
  std::array<std::vector<double>, 2> ms;
  for (size_t storage = 0; storage < 2; ++storage) {
    renderers[storage] = std::make_unique<Renderer>(device);
    renderers[storage]->set_storage_fetch(storage != 0);
    if (const auto taken = renderers[storage]->set_project(project); !taken)
      throw MachineError(taken.error().kind, taken.error().message());
    renderers[storage]->set_region(kSide, kSide, {0, 0, kSide, kSide});
  }
  // The first compiles.
  for (int round = -1; round < kRounds; ++round)
    for (size_t storage = 0; storage < 2; ++storage) {
      const Clock::time_point start = Clock::now();
      device.wait(renderers[storage]->render_occlusion(0, SAMPLES_PER_HIT));
      if (round >= 0) ms[storage].push_back(1e3 * seconds_since(start));
    }
  for (auto& series : ms) std::nth_element(series.begin(), series.begin() + kRounds / 2, series.end());
  return {device.info().name, device.info().driver, ms[0][kRounds / 2], ms[1][kRounds / 2]};
}

const Remembered* find(const std::vector<Remembered>& all, const gpu::DeviceInfo& device) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Remembered& one) {
    return one.device == device.name && one.driver == device.driver;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

FetchPath fetch_path(const gpu::DeviceInfo& device) {
  if (const auto storage = forced()) return {FetchPath::Reason::forced, *storage};
  // A file that is not there, damaged or of another driver says nothing.
  if (const auto all = read_devices())
    if (const Remembered* one = find(*all, device))
      return {FetchPath::Reason::measured, one->storage_ms < one->texel_ms, one->texel_ms, one->storage_ms};
  return {FetchPath::Reason::assumed, !(device.is_lavapipe && device.driver_major < 25)};
}

void tune_fetch_path(gpu::Device& device) {
  if (fetch_path(device.info()).reason != FetchPath::Reason::assumed) return;
  std::vector<Remembered> all = read_devices().value_or(std::vector<Remembered>());
  // Of a driver that was replaced nothing is kept.
  std::erase_if(all, [&](const Remembered& one) { return one.device == device.info().name; });
  if (all.size() >= kMaxDevices) all.erase(all.begin());
  try {
    all.push_back(measure(device));
  } catch (const MachineError& error) {
    // What is assumed then serves as well.
    spdlog::debug("{}", error.what());
    return;
  }
  if (const Status written = write_devices(all); !written) spdlog::debug("{}", written.error().message());
}

std::string words_of(const FetchPath& path) {
  const char* const chosen = path.storage ? "storage buffers" : "texel buffers";
  const char* const other = path.storage ? "texel buffers" : "storage buffers";
  switch (path.reason) {
    case FetchPath::Reason::forced:
      return fmt::format("{}, by {}", chosen, kVariable);
    case FetchPath::Reason::measured:
      return fmt::format("{}: {:.1f} ms for what {} take {:.1f} ms for", chosen,
                         path.storage ? path.storage_ms : path.texel_ms, other,
                         path.storage ? path.texel_ms : path.storage_ms);
    case FetchPath::Reason::assumed:
      break;
  }
  return fmt::format("{}, not measured yet", chosen);
}

}  // namespace vamp
