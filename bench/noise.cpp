#include "bench/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/series.h"
#include "engine/gpu/device.h"
#include "engine/render/still.h"

namespace vamp {
namespace {

constexpr uint32_t kReferenceSeed = 0x40000000;
constexpr uint32_t kSamples[] = {16, 64, 256};
constexpr double kAsked = 0.2;

double luminance(const Image& image, int x, int y) {
  return 0.2126 * double{image.at(x, y, 0)} + 0.7152 * double{image.at(x, y, 1)} + 0.0722 * double{image.at(x, y, 2)};
}

// What NoiseEstimate estimates: sqrt(mean(error^2 / (luminance^2 + 0.01))).
double relative_error(const Image& image, const Image& reference) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double truth = luminance(reference, x, y), error = luminance(image, x, y) - truth;
      sum += error * error / (truth * truth + 0.01);
    }
  return std::sqrt(sum / static_cast<double>(image.pixel_count()));
}

}  // namespace

Result<Report> bench_noise(gpu::Device& device, const std::vector<NoiseScene>& scenes, const NoiseBench& options) {
  Report report("noise", fmt::format("{} x {}, against {} samples of other numbers, {} pictures each, {}; relative "
                                     "errors of luminance in %, in parentheses the ratios' range.",
                                     options.width, options.height, fmt::group_digits(options.reference),
                                     options.rounds, device.info().name));
  report.table({"scene", "samples", "estimate", "error", "estimate / error", "asked"});
  for (const NoiseScene& scene : scenes) {
    const auto render = [&](uint32_t seed, uint32_t samples) {
      auto project = std::make_shared<Project>(scene.project);
      project->settings.seed = seed;
      return render_still(device, project, {.width = options.width, .height = options.height, .samples = samples},
                          nullptr);
    };
    VAMP_TRY(const Still reference, render(kReferenceSeed, options.reference));
    for (const uint32_t samples : kSamples) {
      std::vector<double> estimates, errors, ratios;
      for (int round = 0; round < options.rounds; ++round) {
        VAMP_TRY(const Still still, render(static_cast<uint32_t>(round), samples));
        estimates.push_back(double{still.noise});
        errors.push_back(relative_error(still.image, reference.image));
        ratios.push_back(estimates.back() / errors.back());
      }
      const double ratio = quantile(ratios, 0.5);
      report.row({scene.words, fmt::format("{}", samples), fmt::format("{:.2f}", 100 * quantile(estimates, 0.5)),
                  fmt::format("{:.2f}", 100 * quantile(errors, 0.5)),
                  fmt::format("{:.2f} ({:.2f} to {:.2f})", ratio, quantile(ratios, 0), quantile(ratios, 1)),
                  fmt::format("{} to {}", 1 - kAsked, 1 + kAsked)});
      report.data()["scenes"].push_back(Json{{"scene", scene.words},
                                             {"samples", samples},
                                             {"estimate", quantile(estimates, 0.5)},
                                             {"error", quantile(errors, 0.5)},
                                             {"ratio", ratio}});
    }
  }
  return report;
}

}  // namespace vamp
