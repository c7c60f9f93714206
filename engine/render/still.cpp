#include "engine/render/still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/clock.h"
#include "engine/core/progress.h"
#include "engine/gpu/device.h"
#include "engine/render/goal.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

// A region's buffers take about 100 bytes a pixel and 32 for each accumulator plane: some 300 MB at 1024 x 1024 with
// few lights, and at 512 x 512 with 32 of them.
std::vector<Region> regions_of(int width, int height, uint32_t planes) {
  const int side = planes <= 16 ? 1024 : 512;
  std::vector<Region> regions;
  for (int y = 0; y < height; y += side)
    for (int x = 0; x < width; x += side)
      regions.push_back({x, y, std::min(side, width - x), std::min(side, height - y)});
  return regions;
}

std::vector<std::string> channels_of(Layer layer) {
  switch (layer) {
    case Layer::depth:
      return {"depth.Z"};
    case Layer::normal:
      return {"normal.X", "normal.Y", "normal.Z"};
    case Layer::uv:
      return {"uv.U", "uv.V"};
    case Layer::part:
      return {"part.Y"};
    case Layer::cluster:
      return {"cluster.Y"};
    case Layer::ao:
      return {"ao.Y"};
  }
  return {};
}

// A pixel's values of a layer from the kernels' rows (shaders/passes/aov.comp and occlusion.comp).
void put_layer(Layer layer, const float* centre, const float* place, const float* occlusion, float* out) {
  switch (layer) {
    case Layer::depth:
      out[0] = centre[3];
      break;
    case Layer::normal:
      std::copy(centre, centre + 3, out);
      break;
    case Layer::uv:
      std::copy(place, place + 2, out);
      break;
    case Layer::part:
      out[0] = place[2];
      break;
    case Layer::cluster:
      out[0] = place[3];
      break;
    case Layer::ao:
      out[0] = occlusion[1] > 0 ? occlusion[0] / occlusion[1] : -1.0f;
      break;
  }
}

// How many samples of every pixel `options.seconds` allow. All regions must end with the same number, or the picture's
// job could not be rendered again, so a first look at each of them says what the whole picture costs. The look counts
// against the time; its samples are thrown away.
uint32_t samples_in_time(gpu::Device& device, Renderer& renderer, const std::vector<Region>& regions,
                         const StillOptions& options, const Progress* progress) {
  // The first sample of a stored hit costs more than the others.
  uint32_t looks = std::min<uint32_t>(SAMPLES_PER_HIT, options.samples);
  const Clock::time_point start = Clock::now();
  for (const Region& region : regions) {
    renderer.set_region(options.width, options.height, region);
    while (renderer.samples() < looks) {
      device.wait(renderer.refine_all(options.samples));
      if (progress != nullptr && progress->cancelled()) return 1;
      // Where the time is short, a rough figure is the better use of it.
      const bool first = &region == &regions.front() && renderer.samples() == 1;
      if (first && seconds_since(start) * static_cast<double>(regions.size()) > options.seconds / 16) looks = 1;
    }
  }
  const double spent = seconds_since(start);
  const double fits = (options.seconds - spent) / spent * looks;
  return static_cast<uint32_t>(std::clamp(fits, 1.0, static_cast<double>(options.samples)));
}

double mean_samples(const Renderer& renderer) {
  double sum = 0, pixels = 0;
  for (int tile = 0; tile < renderer.tile_count(); ++tile) {
    const double area = static_cast<double>(renderer.tile(tile).width) * renderer.tile(tile).height;
    sum += area * renderer.samples_of(tile);
    pixels += area;
  }
  return sum / pixels;
}

// All tiles at once where each has the same number of samples to go, else those that want more.
void refine_once(gpu::Device& device, Renderer& renderer, Goal& goal, uint32_t samples, float noise_goal) {
  if (noise_goal <= 0) {
    device.wait(renderer.refine_all(samples));
  } else {
    for (int tile = 0; tile < renderer.tile_count(); ++tile)
      if (goal.wants(renderer, tile, samples, noise_goal)) device.wait(renderer.refine(tile, samples));
  }
  goal.look(renderer);
}

}  // namespace

Result<Still> render_still(gpu::Device& device, std::shared_ptr<const Project> project, const StillOptions& options,
                           Progress* progress) {
  constexpr int kMaxSide = 16384;
  if (options.width < 1 || options.height < 1 || options.width > kMaxSide || options.height > kMaxSide)
    return fail(ErrorKind::usage, "", "size", fmt::format("1 to {} pixels a side", kMaxSide),
                fmt::format("{} x {}", options.width, options.height));
  if (options.samples == 0) return fail(ErrorKind::usage, "", "samples", "at least 1", "0");

  std::vector<std::string> channels = {"R", "G", "B", "A"};
  for (const Layer layer : options.layers)
    for (const std::string& name : channels_of(layer)) channels.push_back(name);
  const bool wants_occlusion =
      std::find(options.layers.begin(), options.layers.end(), Layer::ao) != options.layers.end();

  Still still;
  still.image = Image(options.width, options.height, channels);
  still.samples = options.samples;
  Renderer renderer(device);
  VAMP_CHECK_STATUS(renderer.set_project(project));
  const std::vector<Region> regions = regions_of(options.width, options.height, renderer.key().planes());
  const bool by_time = options.seconds > 0;
  const uint32_t samples =
      by_time && regions.size() > 1 ? samples_in_time(device, renderer, regions, options, progress) : options.samples;
  std::vector<double> ms_per_sample;
  double done_pixels = 0, noise2 = 0;
  const double all_pixels = static_cast<double>(options.width) * options.height;

  for (const Region& region : regions) {
    renderer.set_region(options.width, options.height, region);
    const double share = static_cast<double>(region.width) * region.height / all_pixels;
    const Clock::time_point start = Clock::now();
    Goal goal;
    goal.restart(renderer);
    while (!goal.reached(renderer, samples, options.noise_goal)) {
      const double before = mean_samples(renderer);
      const Clock::time_point batch = Clock::now();
      refine_once(device, renderer, goal, samples, options.noise_goal);
      const double now = mean_samples(renderer);
      ms_per_sample.push_back(1e3 * seconds_since(batch) / (now - before) / share);
      const float part = static_cast<float>(now / samples);
      if (progress != nullptr) progress->fraction(static_cast<float>(done_pixels) + static_cast<float>(share) * part);
      const bool out_of_time = by_time && regions.size() == 1 && seconds_since(start) >= options.seconds;
      if (out_of_time || (progress != nullptr && progress->cancelled())) break;
    }
    still.seconds += seconds_since(start);
    still.complete = still.complete && goal.reached(renderer, options.samples, options.noise_goal);
    still.samples = std::min(still.samples, renderer.samples());
    still.mean_samples += share * mean_samples(renderer);
    const float noise = goal.noise(renderer);
    noise2 = noise < 0 || noise2 < 0 ? -1 : noise2 + share * double{noise} * double{noise};

    uint64_t value = renderer.last_submitted();
    const std::vector<float> picture = renderer.linear_picture(value);
    std::vector<float> layers;
    if (!options.layers.empty()) {
      value = renderer.render_aov();
      if (wants_occlusion) value = renderer.render_occlusion(0, renderer.samples());
      layers = renderer.aov_layers(value);
    }
    double covered = 0;
    const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    for (size_t i = 0; i < pixels; ++i) {
      const int x = region.x + static_cast<int>(i) % region.width, y = region.y + static_cast<int>(i) / region.width;
      float* out = &still.image.at(x, y, 0);
      std::copy(&picture[4 * i], &picture[4 * i] + 4, out);
      covered += static_cast<double>(out[3]);
      out += 4;
      for (const Layer layer : options.layers) {
        put_layer(layer, &layers[4 * i], &layers[4 * (pixels + i)], &layers[4 * (2 * pixels + i)], out);
        out += channels_of(layer).size();
      }
    }
    still.rays += renderer.rays_per_sample(covered / static_cast<double>(pixels)) * renderer.samples();
    still.gpu_bytes = std::max(still.gpu_bytes, device.bytes_allocated());
    done_pixels += share;
    if (progress != nullptr && progress->cancelled()) {
      still.complete = false;
      break;
    }
  }
  std::nth_element(ms_per_sample.begin(), ms_per_sample.begin() + static_cast<std::ptrdiff_t>(ms_per_sample.size() / 2),
                   ms_per_sample.end());
  still.ms_per_sample = ms_per_sample[ms_per_sample.size() / 2];
  still.noise = noise2 < 0 ? -1 : static_cast<float>(std::sqrt(noise2));
  return still;
}

}  // namespace vamp
