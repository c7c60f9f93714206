#include "bench/rays.h"

#include <fmt/format.h>

#include "bench/ray_cost.h"
#include "bench/sample_cost.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

// What is asked of the speed, of Embree's, at 250,000 triangles; and hoped for.
struct Asked {
  double least, aim;
};
constexpr Asked kAsked[] = {{0.88, 0.95}, {0.72, 0.80}, {0.55, 0.65}};

std::string speed(const RayCost::Kind& kind, const Series& series) {
  return fmt::format("{:.1f} ({:.1f} to {:.1f})", kind.million_a_second(series),
                     static_cast<double>(kind.rays.size()) / series.cpu(0.9) * 1e-3,
                     static_cast<double>(kind.rays.size()) / series.cpu(0.1) * 1e-3);
}

}  // namespace

Result<Report> bench_rays(gpu::Device& device, Project project, const RaysBench& options) {
  VAMP_CHECK_STATUS(keep_one_light(project));
  VAMP_TRY(const std::unique_ptr<RayCost> cost, RayCost::make(device, project, options.side));
  for (int round = 0; round < options.rounds; ++round) cost->round();
  Report report(options.name, fmt::format("{}, {} x {}, medians of {} alternating rounds, {}.", options.scene_words,
                                          options.side, options.side, options.rounds, device.info().name));
  report.table({"rays", "number", "ours, Mrays/s", "Embree, Mrays/s", "ours / Embree", "asked (aim)", "other answers"});
  for (size_t i = 0; i < cost->kinds().size(); ++i) {
    const RayCost::Kind& kind = cost->kinds()[i];
    const auto row = [&](const std::string& name, const RayCost::Traced& traced) {
      report.row({name, fmt::format("{}", fmt::group_digits(kind.rays.size())), speed(kind, traced.series),
                  speed(kind, kind.embree), fmt::format("{:.2f}", kind.ratio(traced)),
                  fmt::format("{:.2f} ({:.2f})", kAsked[i].least, kAsked[i].aim), std::to_string(traced.otherwise)});
    };
    row(kind.name, kind.own);
    if (kind.queries) row(fmt::format("{}, ray queries", kind.name), *kind.queries);
    report.data()[kind.name] = kind.json();
  }
  return report;
}

Result<Report> bench_triangles(gpu::Device& device, const TrianglesBench& options) {
  struct Size {
    std::string triangles;
    std::unique_ptr<RayCost> rays;
    std::unique_ptr<SampleCost> sample;
  };
  std::vector<Size> sizes;
  for (const int triangles : options.triangles) {
    VAMP_TRY(Project project, bench_project(fmt::format("shapes:{}", triangles)));
    VAMP_CHECK_STATUS(keep_one_light(project));
    VAMP_TRY(auto rays, RayCost::make(device, project, options.side));
    const size_t count = project.scene->triangles.size();
    VAMP_TRY(auto sample, SampleCost::make(device, std::move(project), options.side, options.side));
    sizes.push_back({fmt::format("{}", fmt::group_digits(count)), std::move(rays), std::move(sample)});
  }
  for (int round = 0; round < options.rounds; ++round)
    for (Size& size : sizes) {
      size.rays->round();
      VAMP_CHECK_STATUS(size.sample->round());
    }

  Report report("triangles",
                fmt::format("Shapes, {} x {}, medians of {} alternating rounds, {}; in parentheses of Embree's speed.",
                            options.side, options.side, options.rounds, device.info().name));
  report.table({"triangles", "primary, Mrays/s", "shadow", "ambient", "a single sample, ms", "of four, ms"});
  Json& data = report.data()["sizes"] = Json::array();
  for (const Size& size : sizes) {
    std::vector<std::string> cells = {size.triangles};
    Json row = {{"triangles", size.triangles}};
    for (const RayCost::Kind& kind : size.rays->kinds()) {
      cells.push_back(fmt::format("{:.1f} ({:.2f})", kind.million_a_second(kind.own.series), kind.ratio(kind.own)));
      row[kind.name] = kind.json();
    }
    for (const Series* series : {&size.sample->single, &size.sample->batch})
      cells.push_back(fmt::format("{:.1f} ({:.1f} to {:.1f})", series->cpu(), series->cpu(0.1), series->cpu(0.9)));
    row["single"] = size.sample->single.json();
    row["batch"] = size.sample->batch.json();
    data.push_back(std::move(row));
    report.row(std::move(cells));
  }
  // Asked: 1,000,000 triangles at most 1.4 times as dear as 250,000.
  report.table({"as many times the time", "primary", "shadow", "ambient", "a single sample", "of four"});
  for (size_t i = 1; i < sizes.size(); ++i) {
    const Size &now = sizes[i], &before = sizes[i - 1];
    std::vector<std::string> cells = {fmt::format("{} for {} triangles", now.triangles, before.triangles)};
    const auto ratio = [&](double later, double earlier) { cells.push_back(fmt::format("{:.2f}", later / earlier)); };
    for (size_t k = 0; k < now.rays->kinds().size(); ++k)
      ratio(1 / now.rays->kinds()[k].million_a_second(now.rays->kinds()[k].own.series),
            1 / before.rays->kinds()[k].million_a_second(before.rays->kinds()[k].own.series));
    ratio(now.sample->single.cpu(), before.sample->single.cpu());
    ratio(now.sample->batch.cpu(), before.sample->batch.cpu());
    report.row(std::move(cells));
  }
  return report;
}

}  // namespace vamp
