// Tables 3 and 4: what functions and residual cost, and what the residual's terms are worth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/material.h"
#include "bench/paper.h"
#include "bench/progressive.h"
#include "bench/pruned.h"
#include "bench/sample_cost.h"
#include "bench/shapes.h"
#include "engine/core/files.h"
#include "engine/gpu/device.h"
#include "engine/image/compare.h"
#include "engine/material/preset.h"

namespace vamp {
namespace {

constexpr const char* kMaterials[] = {"crocodile", "felt", "denim", "calf", "corduroy", "nubuck"};

// A row of the paper's table 3: functions a texel; milliseconds of rays, functions, residual at 1280 x 962.
struct Table3 {
  const char* material;
  double functions, rays, basis, residual;
};
constexpr Table3 kTable3[] = {{"ceiling", 3.12, 18.9, 10.4, 11.1},  {"floortile", 4.41, 18.9, 13.3, 11.0},
                              {"wool", 5.23, 18.9, 14.2, 11.7},     {"proposte", 5.64, 18.9, 13.8, 12.2},
                              {"pulli", 5.93, 18.9, 13.4, 9.4},     {"wallpaper", 6.21, 18.9, 13.5, 13.1},
                              {"corduroy", 7.84, 18.9, 17.6, 14.1}, {"impala", 8.71, 18.9, 18.0, 11.3}};

// Rows of the paper's table 4, from no residual to its mean and four terms: frames a second, MSSIM, RMSE in 255ths.
struct Table4 {
  double frames, mssim, rmse;
};
constexpr Table4 kPulli[] = {{81.32, 0.950, 5.687}, {72.91, 0.976, 2.067}, {66.63, 0.981, 1.715},
                             {60.91, 0.987, 1.352}, {55.52, 0.991, 1.044}, {50.67, 1, 0}};
constexpr Table4 kWool[] = {{84.36, 0.956, 6.181}, {76.17, 0.978, 1.768}, {70.93, 0.986, 1.343},
                            {64.29, 0.991, 0.999}, {60.52, 0.992, 0.901}, {56.11, 1, 0}};

Result<Project> shapes_of(const std::string& material) {
  VAMP_TRY(const Preset preset, load_preset(shipped_dir("presets") / (material + ".vamp")));
  Project project = shapes_project(250'000);
  project.materials.resize(1);
  project.materials[0].fit = preset.fit;
  return project;
}

std::string share(double part, double whole) { return fmt::format("{:.1f} ({:.0f} %)", part, 100 * part / whole); }

// Of the shown pictures, in 255ths.
double rmse255(const ChannelErrors& colours) { return colours.psnr ? 255 * std::pow(10, -*colours.psnr / 20) : 0; }

}  // namespace

Status paper_table3(gpu::Device& device, const PaperBench& options, Report& report) {
  constexpr int kWidth = 640, kHeight = 481;
  report.table({"table 3", "functions a texel", "rays, ms", "functions", "residual"});
  for (const Table3& row : kTable3) {
    const double all = row.rays + row.basis + row.residual;
    report.row({fmt::format("paper: {}", row.material), fmt::format("{:.2f}", row.functions), share(row.rays, all),
                share(row.basis, all), share(row.residual, all)});
  }
  struct Row {
    std::string name;
    double functions, rays, basis, residual;
  };
  std::vector<Row> rows;
  for (const char* name : kMaterials) {
    VAMP_TRY(const Project full, shapes_of(name));
    Project lambert = full;
    lambert.materials[0].fit = bench_material({.used = {Model::lambert}, .functions = 1, .residual = false});
    std::vector<std::unique_ptr<SampleCost>> costs;
    for (const Project& project : {lambert, without_residuals(full), full}) {
      VAMP_TRY(auto cost, SampleCost::make(device, project, kWidth, kHeight, SampleCost::Rounds::single));
      costs.push_back(std::move(cost));
    }
    for (int round = 0; round < options.rounds; ++round)
      for (const auto& cost : costs) VAMP_CHECK_STATUS(cost->single_round());
    const double rays = costs[0]->single.cpu(), with_basis = costs[1]->single.cpu(), all = costs[2]->single.cpu();
    rows.push_back({name, functions_of(*full.materials[0].fit), rays, with_basis - rays, all - with_basis});
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.functions < b.functions; });
  Json& data = report.data()["table3"] = Json::array();
  for (const Row& row : rows) {
    const double all = row.rays + row.basis + row.residual;
    report.row({"ours: " + row.name, fmt::format("{:.2f}", row.functions), share(row.rays, all), share(row.basis, all),
                share(row.residual, all)});
    data.push_back({{"material", row.name},
                    {"functions", row.functions},
                    {"rays_ms", row.rays},
                    {"functions_ms", row.basis},
                    {"residual_ms", row.residual}});
  }
  return {};
}

Status paper_table4(gpu::Device& device, const PaperBench& options, Report& report) {
  constexpr uint32_t kSamples = 64, kSeed = 1;
  report.table({"table 4: residual", "paper: pulli", "paper: wool", "ours: corduroy", "ours: felt"});
  std::vector<std::vector<std::string>> columns;
  for (const std::span<const Table4> paper : {std::span(kPulli), std::span(kWool)}) {
    std::vector<std::string>& column = columns.emplace_back();
    for (const Table4& row : paper)
      column.push_back(
          fmt::format("{:.2f} of full; {:.3f}; {:.2f}", row.frames / paper.back().frames, row.mssim, row.rmse));
  }
  for (const char* name : {"corduroy", "felt"}) {
    VAMP_TRY(const Project full, shapes_of(name));
    std::vector<Project> ways = {without_residuals(full)};
    for (int terms = 0; terms <= kMaxResidualTerms; ++terms) ways.push_back(with_terms(full, terms));
    std::vector<std::unique_ptr<SampleCost>> costs;
    std::vector<Image> pictures;
    for (const Project& project : ways) {
      VAMP_TRY(auto cost, SampleCost::make(device, project, options.side, options.side, SampleCost::Rounds::single));
      costs.push_back(std::move(cost));
      VAMP_TRY(const auto picture, Progressive::make(device, project, {.side = options.side}));
      VAMP_TRY(Image image, picture->picture(kSeed, kSamples));
      pictures.push_back(std::move(image));
    }
    for (int round = 0; round < options.rounds; ++round)
      for (const auto& cost : costs) VAMP_CHECK_STATUS(cost->single_round());
    std::vector<std::string>& column = columns.emplace_back();
    Json& data = report.data()["table4"][name] = Json::array();
    for (size_t i = 0; i < ways.size(); ++i) {
      VAMP_TRY(const CompareReport errors, compare_images(pictures[i], pictures.back(), {}, "picture", "reference"));
      const ChannelErrors& colours = errors.sets.front();
      const double frames = costs.back()->single.cpu() / costs[i]->single.cpu();
      column.push_back(
          fmt::format("{:.2f} of full; {:.3f}; {:.2f}", frames, colours.mssim.value_or(1), rmse255(colours)));
      data.push_back(
          {{"ms", costs[i]->single.json()}, {"mssim", colours.mssim.value_or(1)}, {"rmse", rmse255(colours)}});
    }
  }
  for (size_t i = 0; i < columns.front().size(); ++i) {
    std::vector<std::string> cells = {i == 0 ? "none" : i == 1 ? "mean" : fmt::format("mean and {}", i - 1)};
    for (const auto& column : columns) cells.push_back(column[i]);
    report.row(std::move(cells));
  }
  return {};
}

}  // namespace vamp
