#include "bench/materials.h"

#include <fmt/format.h>

#include "bench/material.h"
#include "bench/sample_cost.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

constexpr int kCounts[] = {1, 2, 4, 8};

}  // namespace

Result<Report> bench_materials(gpu::Device& device, Project project, const MaterialsBench& options) {
  VAMP_CHECK_STATUS(keep_one_light(project));
  constexpr size_t kMost = 8;
  if (project.parts.size() < kMost)
    return fail(ErrorKind::bad_input, "", "parts", "at least eight", std::to_string(project.parts.size()));
  std::vector<std::unique_ptr<SampleCost>> costs;
  for (const int count : kCounts) {
    dress(project, {.used = {Model::lambert, Model::blinn_phong, Model::ward, Model::cook_torrance}}, count);
    VAMP_TRY(auto cost, SampleCost::make(device, project, options.side, options.side));
    costs.push_back(std::move(cost));
  }
  for (int round = 0; round < options.rounds; ++round)
    for (const auto& cost : costs) VAMP_CHECK_STATUS(cost->round());

  Report report(options.name,
                fmt::format("{}, {} x {}, one light and ambient, medians of {} alternating rounds, {}.",
                            options.scene_words, options.side, options.side, options.rounds, device.info().name));
  report.table({"materials", "a single sample, ms", "of one", "of four, ms", "of one", "asked"});
  Json& data = report.data()["counts"] = Json::array();
  const auto ms = [](const Series& s) {
    return fmt::format("{:.1f} ({:.1f} to {:.1f})", s.cpu(), s.cpu(0.1), s.cpu(0.9));
  };
  for (size_t i = 0; i < costs.size(); ++i) {
    const double single = costs[i]->single.cpu() / costs[0]->single.cpu();
    const double batch = costs[i]->batch.cpu() / costs[0]->batch.cpu();
    report.row({std::to_string(kCounts[i]), ms(costs[i]->single), fmt::format("{:.3f}", single), ms(costs[i]->batch),
                fmt::format("{:.3f}", batch), kCounts[i] == 8 ? "1.15" : ""});
    data.push_back({{"materials", kCounts[i]},
                    {"single", costs[i]->single.json()},
                    {"single_ratio", single},
                    {"batch", costs[i]->batch.json()},
                    {"batch_ratio", batch}});
  }
  return report;
}

}  // namespace vamp
