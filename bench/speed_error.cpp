#include "bench/speed_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "bench/progressive.h"
#include "bench/pruned.h"
#include "engine/core/hash.h"
#include "engine/gpu/device.h"
#include "engine/image/load.h"
#include "engine/image/save.h"

namespace vamp {
namespace {

constexpr uint32_t kReferenceSeed = 0x40000000, kSeedsOfARound = 0x10000;
// Until the plain way comes down to the smallest error that is asked for.
constexpr uint32_t kPlainSamples = 4096, kOwnSamples = 1024;
constexpr double kErrors[] = {1e-2, 1e-3}, kEnough = 0.8 * kErrors[1];

// Changes whenever pictures do, so that old references are not taken.
constexpr int kVersion = 1;

std::string key_of(const Project& project, const SpeedErrorBench& options) {
  std::string key = fmt::format("{} {} {} {} {}", kVersion, options.scene_words, options.side,
                                options.reference_samples, project.model_checksum);
  for (const MaterialInstance& material : project.materials) key += " " + material.checksum;
  return checksum(std::as_bytes(std::span(key)));
}

Result<Image> reference_of(gpu::Device& device, const Project& project, const SpeedErrorBench& options) {
  const fs::path path = options.cache / fmt::format("reference-{}.exr", key_of(project, options));
  std::error_code failure;
  if (fs::exists(path, failure)) return load_image(path, ColourSpace::linear);
  VAMP_TRY(const auto picture, Progressive::make(device, project, {.side = options.side}));
  VAMP_TRY(Image image, picture->picture(kReferenceSeed, options.reference_samples));
  fs::create_directories(options.cache, failure);
  VAMP_CHECK_STATUS(save_exr(path, image));
  return image;
}

struct Way {
  std::string name;
  std::unique_ptr<Progressive> picture;
  uint32_t most;
  std::vector<ErrorCurve> runs;
  ErrorCurve curve;
};

// Ways that share a panel of the plots, alternating.
class Family {
 public:
  Family(gpu::Device& device, const SpeedErrorBench& options, const Image& reference, std::string title)
      : device_(device), options_(options), reference_(reference), title_(std::move(title)) {}

  Status add(std::string name, Project project, Progressive::Way how, uint32_t most) {
    VAMP_TRY(auto picture, Progressive::make(device_, std::move(project), how));
    ways_.push_back({std::move(name), std::move(picture), most, {}, {}});
    return {};
  }

  Status measure() {
    for (int round = 0; round < options_.rounds; ++round)
      for (Way& way : ways_) {
        VAMP_TRY(ErrorCurve curve, way.picture->run(static_cast<uint32_t>(round) * kSeedsOfARound + 1, way.most,
                                                    reference_, way.most > options_.samples ? kEnough : 0));
        way.runs.push_back(std::move(curve));
      }
    for (Way& way : ways_) way.curve = mean_of(way.runs);
    return {};
  }

  const Way& way(size_t i) const { return ways_[i]; }

  Panel panel(const std::function<double(const ErrorPoint&)>& error) const {
    Panel panel{title_, {}};
    for (const Way& way : ways_) {
      Curve curve{way.name, {}};
      for (const ErrorPoint& p : way.curve) curve.points.push_back({p.ms, error(p)});
      panel.curves.push_back(std::move(curve));
    }
    return panel;
  }

  void rows(Report& report) const {
    for (const Way& way : ways_) {
      std::vector<std::string> cells = {fmt::format("{}: {}", title_, way.name)};
      for (const uint32_t samples : {4u, 32u, 256u}) {
        const auto point =
            std::find_if(way.curve.begin(), way.curve.end(), [&](const ErrorPoint& p) { return p.samples == samples; });
        cells.push_back(point == way.curve.end()
                            ? "-"
                            : fmt::format("{:.0f}; {:.1e}; {:.3f}", point->ms, point->rel_mse, point->mssim));
      }
      report.row(std::move(cells));
      Json& curve = report.data()["curves"][title_][way.name] = Json::array();
      for (const ErrorPoint& p : way.curve)
        curve.push_back({{"samples", p.samples}, {"ms", p.ms}, {"rel_mse", p.rel_mse}, {"mssim", p.mssim}});
    }
  }

 private:
  gpu::Device& device_;
  const SpeedErrorBench& options_;
  const Image& reference_;
  std::string title_;
  std::vector<Way> ways_;
};

Status add_equal_errors(Report& report, const ErrorCurve& plain, const ErrorCurve& ours) {
  report.table({"relMSE", "independent numbers, ms", "as the program refines, ms", "of it", "asked"});
  Json& data = report.data()["equal_error"] = Json::array();
  const auto time = [](double ms) { return ms < 0 ? std::string("not reached") : fmt::format("{:.0f}", ms); };
  for (const double error : kErrors) {
    const double a = time_to(plain, error), b = time_to(ours, error);
    report.row(
        {fmt::format("{:.0e}", error), time(a), time(b), a < 0 || b < 0 ? "-" : fmt::format("{:.3f}", b / a), "0.5"});
    data.push_back({{"rel_mse", error}, {"plain_ms", a}, {"ours_ms", b}});
  }
  return {};
}

}  // namespace

Result<SpeedError> bench_speed_error(gpu::Device& device, const Project& project, const SpeedErrorBench& options) {
  VAMP_TRY(const Image reference, reference_of(device, project, options));
  double functions = 0;
  for (const MaterialInstance& material : project.materials)
    functions += functions_of(*material.fit) / static_cast<double>(project.materials.size());

  const Progressive::Way usual{.side = options.side};
  std::vector<Family> families;
  const auto family = [&](const char* title) -> Family& {
    return families.emplace_back(device, options, reference, title);
  };
  families.reserve(5);
  Family& numbers = family("samples");
  VAMP_CHECK_STATUS(numbers.add("independent numbers", project, {options.side, true}, kPlainSamples));
  VAMP_CHECK_STATUS(numbers.add("as refined", project, usual, kOwnSamples));
  Family& residual = family("residual");
  VAMP_CHECK_STATUS(residual.add("none", without_residuals(project), usual, options.samples));
  for (int terms = 0; terms <= kMaxResidualTerms; ++terms)
    VAMP_CHECK_STATUS(
        residual.add(terms == 0 ? "mean" : std::to_string(terms), with_terms(project, terms), usual, options.samples));
  Family& fewer = family("functions a texel");
  for (const int most : {1, 2, 3, 6})
    VAMP_CHECK_STATUS(fewer.add(fmt::format("<= {}", most), with_functions(project, most), usual, options.samples));
  VAMP_CHECK_STATUS(fewer.add("all", project, usual, options.samples));
  Family& taps = family("texels and directions");
  VAMP_CHECK_STATUS(taps.add("one at random", project, usual, options.samples));
  Project four = project;
  four.settings.tap = TexelTap::four;
  VAMP_CHECK_STATUS(taps.add("all blended", std::move(four), usual, options.samples));
  Family& resolution = family("resolution");
  for (const int part : {1, 2, 4})
    VAMP_CHECK_STATUS(resolution.add(part == 1 ? "full" : fmt::format("1/{}", part), project, {options.side / part},
                                     options.samples));
  for (Family& each : families) VAMP_CHECK_STATUS(each.measure());

  Report report(
      options.name,
      fmt::format("{}, {} x {}, against {} samples of other numbers; {:.1f} functions a texel; means of {} "
                  "pictures, medians of their times (processor time over processors), {}.",
                  options.scene_words, options.side, options.side, fmt::group_digits(options.reference_samples),
                  functions, options.rounds, device.info().name));
  VAMP_CHECK_STATUS(add_equal_errors(report, numbers.way(0).curve, numbers.way(1).curve));
  report.table({"ms; relMSE; MSSIM", "4 samples", "32", "256"});
  SpeedError found{std::move(report), {}};
  std::vector<Panel> rel_mse, mssim;
  for (const Family& each : families) {
    each.rows(found.report);
    rel_mse.push_back(each.panel([](const ErrorPoint& p) { return p.rel_mse; }));
    mssim.push_back(each.panel([](const ErrorPoint& p) { return 1 - p.mssim; }));
  }
  found.plots = {{options.name + "-relmse", log_panels(rel_mse, "relMSE by milliseconds, both logarithmic")},
                 {options.name + "-mssim", log_panels(mssim, "1 - MSSIM by milliseconds, both logarithmic")}};
  return found;
}

}  // namespace vamp
