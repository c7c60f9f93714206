// Short cuts in materials, measured in pictures: terms of the residual, texture taps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/accuracy.h"
#include "bench/pruned.h"
#include "bench/scene.h"
#include "bench/series.h"
#include "engine/gpu/device.h"
#include "engine/image/metrics.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

constexpr vec3 kGrid(0.85f), kBlue(0.12f, 0.35f, 0.65f), kOrange(0.80f, 0.37f, 0.08f);

// A picture that can be started again.
class Picture {
 public:
  Picture(gpu::Device& device, Project project, int side)
      : device_(device), project_(std::move(project)), renderer_(device), side_(side) {}

  Status begin() {
    ++project_.settings.seed;
    VAMP_CHECK_STATUS(renderer_.set_project(std::make_shared<const Project>(project_)));
    if (renderer_.tile_count() == 0) renderer_.set_region(side_, side_, {0, 0, side_, side_});
    return {};
  }
  // RGB after so many samples in all.
  std::vector<float> refine(uint32_t samples) {
    uint64_t done = 0;
    while (renderer_.samples() < samples) device_.wait(done = renderer_.refine_all(samples));
    std::vector<float> rgb;
    const std::vector<float> rgba = renderer_.linear_picture(done);
    for (size_t i = 0; i < rgba.size(); ++i)
      if (i % 4 != 3) rgb.push_back(rgba[i]);
    return rgb;
  }
  // Time of a sample, of four to a primary ray.
  Status time(Series& series) {
    VAMP_CHECK_STATUS(begin());
    refine(4);
    const Stopwatch watch;
    device_.wait(renderer_.refine_all(8));
    series.add(watch.stop(), 0.25);
    return {};
  }

 private:
  gpu::Device& device_;
  Project project_;
  Renderer renderer_;
  int side_;
};

std::string ms(const Series& s) { return fmt::format("{:.1f} ({:.1f} to {:.1f})", s.cpu(), s.cpu(0.1), s.cpu(0.9)); }

// sqrt(sum (a - r)^2 / sum r^2)
double relative_rms(const std::vector<float>& a, const std::vector<float>& r) {
  const std::vector<float> zeros(r.size(), 0.f);
  return rmse(a, r) / rmse(r, zeros);
}

}  // namespace

Result<Plot> measure_terms(gpu::Device& device, const AccuracyBench& options, Report& report) {
  VAMP_TRY(const Project project, bench_project(""));
  struct Way {
    std::string name;
    std::unique_ptr<Picture> picture;
    std::vector<float> values;
    Series time;
  };
  std::vector<Way> ways;
  for (int terms = -1; terms <= kMaxResidualTerms; ++terms) {
    Project changed = terms < 0 ? without_residuals(project) : project;
    for (MaterialInstance& material : changed.materials) material.edits.residual_terms = std::max(terms, 0);
    ways.push_back({terms < 0    ? "none"
                    : terms == 0 ? "mean"
                                 : fmt::format("mean and {}", terms),
                    std::make_unique<Picture>(device, std::move(changed), options.side),
                    {},
                    {}});
    VAMP_CHECK_STATUS(ways.back().picture->begin());
    ways.back().values = ways.back().picture->refine(std::min(options.samples, 64u));
  }
  for (int round = 0; round < options.rounds; ++round)
    for (Way& way : ways) VAMP_CHECK_STATUS(way.picture->time(way.time));

  report.table({"the shipped shoe, residual", "relative RMS error to four terms", "ms a sample", "of none"});
  Json& data = report.data()["terms"] = Json::array();
  // One seed each: the noise is the same in all, and what differs is the residual.
  std::vector<double> errors;
  for (const Way& way : ways) {
    errors.push_back(relative_rms(way.values, ways.back().values));
    const double ratio = way.time.cpu() / ways[0].time.cpu();
    report.row({way.name, fmt::format("{:.2f} %", 100 * errors.back()), ms(way.time), fmt::format("{:.3f}", ratio)});
    data.push_back({{"residual", way.name}, {"error", errors.back()}, {"sample", way.time.json()}, {"ratio", ratio}});
  }

  Figure figure(560, 340);
  const double most = *std::max_element(errors.begin(), errors.end()) * 1.1;
  double fast = 1e9, slow = 0;
  for (const Way& way : ways) fast = std::min(fast, way.time.cpu()), slow = std::max(slow, way.time.cpu());
  const auto at = [&](double time, double error) {
    return vec2(80 + 400 * static_cast<float>((time - fast) / std::max(slow - fast, 1e-3)),
                280 - 220 * static_cast<float>(error / std::max(most, 1e-9)));
  };
  for (int i = 0; i <= 4; ++i) {
    figure.line({at(fast, most * i / 4), at(slow, most * i / 4)}, kGrid);
    figure.words(at(fast, most * i / 4) - vec2(14, 0), fmt::format("{:.2f} %", 25 * most * i), 11, Anchor::right);
    const double time = fast + (slow - fast) * i / 4;
    figure.words(at(time, 0) + vec2(0, 18), fmt::format("{:.1f}", time), 11, Anchor::middle);
  }
  for (size_t i = 0; i < ways.size(); ++i) {
    const vec2 place = at(ways[i].time.cpu(), errors[i]);
    figure.area(place - 3.0f, vec2(6), kBlue);
    figure.words(place + vec2(6, -10), ways[i].name, 11, Anchor::left);
  }
  figure.words(vec2(16, 20), "Terms of the residual: relative RMS error to four terms, by ms a sample", 13,
               Anchor::left);
  return Plot{"terms", figure};
}

Result<Plot> measure_taps(gpu::Device& device, const AccuracyBench& options, Report& report) {
  VAMP_TRY(Project project, bench_project(""));
  // So near that texels are larger than pixels, where taps matter.
  project.camera.fov_degrees /= 8;
  Project four = project;
  four.settings.tap = TexelTap::four;
  Picture picture_of_one(device, project, options.side), picture_of_four(device, four, options.side);
  // The reference: many samples of a seed that comes again in neither.
  Project other = four;
  other.settings.seed = 1000;
  Picture reference_picture(device, other, options.side);
  VAMP_CHECK_STATUS(reference_picture.begin());
  const std::vector<float> reference = reference_picture.refine(4 * options.samples);

  struct Point {
    uint32_t samples;
    double one, four;
  };
  std::vector<Point> points;
  VAMP_CHECK_STATUS(picture_of_one.begin());
  VAMP_CHECK_STATUS(picture_of_four.begin());
  for (uint32_t samples = 1; samples <= options.samples; samples *= 4)
    points.push_back({samples, rel_mse(picture_of_one.refine(samples), reference),
                      rel_mse(picture_of_four.refine(samples), reference)});
  Series one_time, four_time;
  for (int round = 0; round < options.rounds; ++round) {
    VAMP_CHECK_STATUS(picture_of_one.time(one_time));
    VAMP_CHECK_STATUS(picture_of_four.time(four_time));
  }

  report.table(
      {"the shipped shoe from near by", "one tap at random, relMSE", "four taps, relMSE", "ratio at equal time"});
  Json& data =
      report.data()["taps"] = {{"one", one_time.json()}, {"four", four_time.json()}, {"errors", Json::array()}};
  const double dearer = four_time.cpu() / one_time.cpu();
  Figure figure(560, 360);
  double most = 0, least = 1;
  for (const Point& p : points) most = std::max({most, p.one, p.four}), least = std::min({least, p.one, p.four});
  const double slowest = four_time.cpu() * points.back().samples, fastest = one_time.cpu();
  const auto at = [&](double time, double error) {
    return vec2(80 + 440 * static_cast<float>(std::log(time / fastest) / std::log(slowest / fastest)),
                300 - 240 * static_cast<float>(std::log(error / least) / std::log(most / least)));
  };
  std::vector<vec2> one_line, four_line;
  for (const Point& p : points) {
    report.row({fmt::format("{} samples", p.samples), fmt::format("{:.2e}", p.one), fmt::format("{:.2e}", p.four),
                fmt::format("{:.2f}", p.one / (p.four * dearer))});
    data["errors"].push_back({{"samples", p.samples}, {"one", p.one}, {"four", p.four}});
    one_line.push_back(at(one_time.cpu() * p.samples, p.one));
    four_line.push_back(at(four_time.cpu() * p.samples, p.four));
    figure.words(four_line.back() + vec2(6, -8), fmt::format("{:.0e}", p.four), 10, Anchor::left, kOrange);
  }
  report.row({"ms a sample", ms(one_time), ms(four_time), fmt::format("{:.2f}", 1 / dearer)});
  figure.line(one_line, kBlue, 2);
  figure.line(four_line, kOrange, 2);
  figure.words(vec2(100, 320), "one tap at random", 12, Anchor::left, kBlue);
  figure.words(vec2(260, 320), "four taps", 12, Anchor::left, kOrange);
  figure.words(vec2(16, 20), "Texture taps: relMSE by time, both logarithmic", 13, Anchor::left);
  figure.words(vec2(280, 344), fmt::format("{:.0f} to {:.0f} ms", fastest, slowest), 12, Anchor::middle);
  return Plot{"taps", figure};
}

}  // namespace vamp
