#include "bench/progressive.h"

#include <algorithm>
#include <cmath>

#include "bench/series.h"
#include "engine/gpu/device.h"
#include "engine/image/compare.h"

namespace vamp {
namespace {

// Bilinear between the centres of pixels.
Image enlarged(const Image& image, int side) {
  if (image.width == side) return image;
  Image large(side, side, image.channels);
  const float scale = static_cast<float>(image.width) / static_cast<float>(side);
  const auto place = [&](int i, int& below, float& share) {
    const float at =
        std::clamp((static_cast<float>(i) + 0.5f) * scale - 0.5f, 0.f, static_cast<float>(image.width - 1));
    below = std::min(static_cast<int>(at), image.width - 2);
    share = at - static_cast<float>(below);
  };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      int u = 0, v = 0;
      float a = 0, b = 0;
      place(x, u, a);
      place(y, v, b);
      for (size_t c = 0; c < image.channels.size(); ++c)
        large.at(x, y, c) = std::lerp(std::lerp(image.at(u, v, c), image.at(u + 1, v, c), a),
                                      std::lerp(image.at(u, v + 1, c), image.at(u + 1, v + 1, c), a), b);
    }
  return large;
}

}  // namespace

Result<std::unique_ptr<Progressive>> Progressive::make(gpu::Device& device, Project project, Way way) {
  std::unique_ptr<Progressive> made(new Progressive(device, std::move(project), way));
  VAMP_CHECK_STATUS(made->begin(0));
  made->renderer_.set_region(way.side, way.side, {0, 0, way.side, way.side});
  while (made->renderer_.samples() < 2 * SAMPLES_PER_HIT) device.wait(made->renderer_.refine_all(2 * SAMPLES_PER_HIT));
  return made;
}

Status Progressive::begin(uint32_t seed) {
  project_.settings.seed = seed;
  const Result<Change> change = renderer_.set_project(std::make_shared<const Project>(project_));
  return change ? Status() : tl::unexpected(change.error());
}

Result<double> Progressive::refine(uint32_t seed, uint32_t samples) {
  double ms = 0;
  const auto work = [&](uint32_t limit) {
    const Stopwatch watch;
    device_.wait(done_ = renderer_.refine_all(limit));
    ms += watch.stop().cpu_ms;
  };
  if (!way_.independent) {
    while (renderer_.samples() < samples) work(samples);
    samples_ = samples;
    return ms;
  }
  for (; samples_ < samples; ++samples_) {
    VAMP_CHECK_STATUS(begin(seed + samples_));
    work(1);
    const std::vector<float> one = renderer_.linear_picture(done_);
    sum_.resize(one.size());
    for (size_t i = 0; i < one.size(); ++i) sum_[i] += static_cast<double>(one[i]);
  }
  return ms;
}

Image Progressive::mean(int side) {
  Image image(way_.side, way_.side, {"R", "G", "B"});
  const std::vector<float> rgba = way_.independent ? std::vector<float>() : renderer_.linear_picture(done_);
  for (size_t i = 0; i < image.pixel_count(); ++i)
    for (size_t c = 0; c < 3; ++c)
      image.pixels[3 * i + c] = way_.independent ? static_cast<float>(sum_[4 * i + c] / samples_) : rgba[4 * i + c];
  return enlarged(image, side);
}

Result<ErrorCurve> Progressive::run(uint32_t seed, uint32_t most, const Image& reference, double enough) {
  ErrorCurve curve;
  sum_.clear();
  samples_ = 0;
  double ms = 0;
  VAMP_CHECK_STATUS(begin(seed));
  for (uint32_t samples = 1; samples <= most; samples *= 2) {
    VAMP_TRY(const double more, refine(seed, samples));
    ms += more;
    VAMP_TRY(const CompareReport errors, compare_images(mean(reference.width), reference, {}, "picture", "reference"));
    const ChannelErrors& colours = errors.sets.front();
    curve.push_back({samples, ms, colours.rel_mse, colours.mssim.value_or(0)});
    if (colours.rel_mse < enough) break;
  }
  return curve;
}

Result<Image> Progressive::picture(uint32_t seed, uint32_t samples) {
  sum_.clear();
  samples_ = 0;
  VAMP_CHECK_STATUS(begin(seed));
  VAMP_TRY(const double ms, refine(seed, samples));
  static_cast<void>(ms);
  return mean(way_.side);
}

ErrorCurve mean_of(const std::vector<ErrorCurve>& runs) {
  ErrorCurve mean = *std::min_element(runs.begin(), runs.end(),
                                      [](const ErrorCurve& a, const ErrorCurve& b) { return a.size() < b.size(); });
  for (size_t i = 0; i < mean.size(); ++i) {
    std::vector<double> times;
    mean[i].rel_mse = mean[i].mssim = 0;
    for (const ErrorCurve& run : runs) {
      times.push_back(run[i].ms);
      mean[i].rel_mse += run[i].rel_mse / static_cast<double>(runs.size());
      mean[i].mssim += run[i].mssim / static_cast<double>(runs.size());
    }
    mean[i].ms = quantile(times, 0.5);
  }
  return mean;
}

double time_to(const ErrorCurve& curve, double rel_mse) {
  for (size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].rel_mse > rel_mse) continue;
    if (i == 0) return curve[i].ms;
    const ErrorPoint &above = curve[i - 1], &below = curve[i];
    const double along = std::log(rel_mse / above.rel_mse) / std::log(below.rel_mse / above.rel_mse);
    return std::exp(std::lerp(std::log(above.ms), std::log(below.ms), along));
  }
  return -1;
}

}  // namespace vamp
