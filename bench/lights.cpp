#include "bench/lights.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "bench/series.h"
#include "engine/gpu/device.h"
#include "engine/image/metrics.h"

namespace vamp {
namespace {

// Rectangles and disks in turn on a spiral over the upper hemisphere, at two to three radii of the scene, of 40 W for
// each square of its radius in all. `first`: share of the first one's power, the others share the rest alike.
std::vector<Light> lights_around(const Bounds& bounds, size_t count, float first) {
  const float radius = bounds.radius();
  std::vector<Light> lights;
  for (size_t i = 0; i < count; ++i) {
    const float part = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float height = 0.25f + 0.65f * part;  // sine of the elevation
    const float azimuth = 0.8f + 2 * std::numbers::pi_v<float> * std::numbers::phi_v<float> * static_cast<float>(i);
    const float flat = std::sqrt(1 - height * height), distance = radius * (2 + static_cast<float>(i % 3) * 0.5f);
    Light light;
    light.type = i % 2 == 0 ? LightType::rect : LightType::disk;
    light.target = bounds.center();
    light.center = light.target + distance * vec3(flat * std::cos(azimuth), height, flat * std::sin(azimuth));
    light.size = vec2(0.5f, 0.4f) * radius;
    light.radius = 0.25f * radius;
    light.power = 40 * radius * radius * (i == 0 ? first : (1 - first) / static_cast<float>(count - 1));
    lights.push_back(light);
  }
  return lights;
}

// One way to take so many lights.
struct Way {
  size_t lights = 1;
  bool key = false;  // one has half of the power
  bool drawn = false;
  std::unique_ptr<Renderer> renderer;
  std::shared_ptr<const Project> project;
  Series sample;
  std::vector<std::pair<double, double>> errors;  // samples, relMSE

  double error_at(double samples) const {
    for (const auto& [n, error] : errors)
      if (n >= samples) return error;
    return errors.back().second;
  }
  // Between two measured numbers of samples, or beyond the last, along the line through the nearest two in logarithms.
  double samples_to(double error) const {
    size_t i = 1;
    while (i + 1 < errors.size() && errors[i].second > error) ++i;
    const auto [n0, e0] = errors[i - 1];
    const auto [n1, e1] = errors[i];
    return n0 * std::pow(n1 / n0, std::log(e0 / error) / std::log(e0 / e1));
  }
};

std::vector<float> colours(const std::vector<float>& linear) {
  std::vector<float> rgb;
  for (size_t i = 0; i < linear.size(); ++i)
    if (i % 4 != 3) rgb.push_back(linear[i]);
  return rgb;
}

std::vector<float> refined(gpu::Device& device, Renderer& renderer, uint32_t samples) {
  uint64_t value = device.last_submitted();
  // One at a time in flight: a queue of a thousand dispatches would hold all their commands.
  while (renderer.samples() < samples) device.wait(value = renderer.refine_all(samples));
  return colours(renderer.linear_picture(value));
}

}  // namespace

Result<Report> bench_lights(gpu::Device& device, Project project, const LightsBench& options) {
  project.environment = {};
  if (project.ambient == vec3(0)) project.ambient = vec3(0.2f);
  if (project.settings.ao_radius == 0) project.settings.ao_radius = project.scene->bounds.radius() * 0.2f;
  const Region whole{0, 0, options.side, options.side};
  std::vector<Way> ways;
  std::vector<std::pair<size_t, bool>> cases;
  for (const size_t count : options.counts) {
    cases.emplace_back(count, false);
    if (count == 16) cases.emplace_back(count, true);
  }
  for (const auto& [count, key] : cases) {
    project.lights = lights_around(project.scene->bounds, count, key ? 0.5f : 1 / static_cast<float>(count));
    const bool draws = count > options.draws.above;
    // With other random numbers, drawn where that is quicker: the mean is the same.
    Project other = project;
    other.settings.seed = project.settings.seed + 1000;
    Renderer far(device);
    far.set_light_draws(options.draws);
    VAMP_CHECK_STATUS(far.set_project(std::make_shared<const Project>(other)));
    far.set_region(options.side, options.side, whole);
    const std::vector<float> reference = refined(device, far, options.reference);
    for (const bool drawn : draws ? std::vector<bool>{true, false} : std::vector<bool>{false}) {
      Way& way = ways.emplace_back();
      way.lights = count;
      way.key = key;
      way.drawn = drawn;
      way.project = std::make_shared<const Project>(project);
      way.renderer = std::make_unique<Renderer>(device);
      way.renderer->set_light_draws(drawn ? options.draws : LightDraws{.above = MAX_LIGHTS});
      VAMP_CHECK_STATUS(way.renderer->set_project(way.project));
      way.renderer->set_region(options.side, options.side, whole);
      for (uint32_t n = 8; n <= 4 * options.samples; n *= 2)
        way.errors.emplace_back(n, rel_mse(refined(device, *way.renderer, n), reference));
    }
  }

  // All kernels are compiled and all memory is touched; the ways take turns.
  for (int round = 0; round < options.rounds; ++round)
    for (Way& way : ways) {
      const uint32_t before = way.renderer->samples();
      const Stopwatch watch;
      while (way.renderer->samples() < before + SAMPLES_PER_HIT)
        device.wait(way.renderer->refine_all(before + SAMPLES_PER_HIT));
      way.sample.add(watch.stop(), 1.0 / SAMPLES_PER_HIT);
    }

  const Way& one = ways.front();
  const double goal = one.error_at(options.samples);
  const double goal_ms = one.samples_to(goal) * one.sample.cpu();
  Report report(options.name,
                fmt::format("{}, {} x {}, relMSE against {} samples, medians of {} rounds, {}.", options.scene_words,
                            options.side, options.side, options.reference, options.rounds, device.info().name));
  report.table({"lights", "a sample", "of one light's", fmt::format("relMSE at {} samples", options.samples),
                "samples to one light's relMSE", "time to it, of one light's"});
  Json& data = report.data()["ways"] = Json::array();
  for (const Way& way : ways) {
    const double samples = way.samples_to(goal), ratio = samples * way.sample.cpu() / goal_ms;
    std::string words = fmt::format("{}", way.lights);
    if (way.key) words += " with a key light";
    if (way.lights > 1) words += way.drawn ? fmt::format(", {} a sample", options.draws.slots) : ", a ray to each";
    report.row({words, way.sample.text(), fmt::format("{:.2f}", way.sample.cpu() / one.sample.cpu()),
                fmt::format("{:.3g}", way.error_at(options.samples)), fmt::format("{:.0f}", samples),
                fmt::format("{:.2f}", ratio)});
    Json row{{"lights", way.lights},
             {"key", way.key},
             {"drawn", way.drawn ? options.draws.slots : 0},
             {"sample", way.sample.json()},
             {"relmse", way.error_at(options.samples)},
             {"samples_to_goal", samples},
             {"time_of_one", ratio}};
    data.push_back(std::move(row));
  }
  report.data()["samples"] = options.samples;
  return report;
}

}  // namespace vamp
