#include "bench/shading.h"

#include <fmt/format.h>

#include <cmath>

#include "bench/material.h"
#include "bench/scene.h"
#include "bench/series.h"
#include "engine/brdf/registry.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"
#include "shaders/spirv.h"

namespace vamp {
namespace {

constexpr uint32_t kSamples = 12;

const std::vector<Model> kAllModels = {Model::lambert,       Model::oren_nayar, Model::blinn_phong,      Model::ward,
                                       Model::cook_torrance, Model::lafortune,  Model::ashikhmin_shirley};

// One way to render the scene, with its times in all rounds.
class Way {
 public:
  Way(gpu::Device& device, Project project, const BenchMaterial& what, int terms, int side,
      std::span<const uint32_t> kernel)
      : device_(device), project_(std::move(project)), renderer_(device, kernel) {
    dress(project_, what);
    EditLayer& edits = project_.materials[0].edits;
    edits.residual_terms = terms;
    edits.residual_policy = ResidualPolicy::keep;  // else each edit weighs its function anew
    const uint64_t pixels = static_cast<uint64_t>(side) * static_cast<uint64_t>(side);
    renderer_.set_history(pixels * 8 * (kSamples / SAMPLES_PER_HIT));
    ready_ = begin();
    if (!ready_) return;
    renderer_.set_region(side, side, {0, 0, side, side});
    // Kernels are compiled at their first dispatch.
    ready_ = round();
    single = batch = shade = {};
  }

  // Once: a sample with its own primary ray, four samples of one, four samples shaded again without rays.
  Status round() {
    VAMP_CHECK_STATUS(begin());
    {
      const Stopwatch watch;
      device_.wait(renderer_.refine_all(1));
      single.add(watch.stop());
    }
    while (renderer_.samples() < 4) device_.wait(renderer_.refine_all(4));
    {
      const Stopwatch watch;
      device_.wait(renderer_.refine_all(8));
      batch.add(watch.stop(), 0.25);
    }
    while (renderer_.samples() < kSamples) device_.wait(renderer_.refine_all(kSamples));
    BasisEdit edit;
    const float x = 0.01f + 0.001f * static_cast<float>(++turn_ % 50);
    edit.normal = vec3(x, 0, std::sqrt(1 - x * x));
    for (int c = 0; c < static_cast<int>(project_.materials[0].fit->clusters.size()); ++c)
      project_.materials[0].edits.set({c, 0}, edit);
    VAMP_CHECK_STATUS(renderer_.set_project(std::make_shared<const Project>(project_)));
    while (renderer_.replaying() && renderer_.replayed_samples() < 4) device_.wait(renderer_.replay(~0u));
    const uint32_t before = renderer_.replayed_samples();
    const Stopwatch watch;
    while (renderer_.replaying()) device_.wait(renderer_.replay(~0u));
    shade.add(watch.stop(), 1.0 / (kSamples - before));
    return {};
  }

  Series single, batch, shade;
  Status ready() const { return ready_; }

 private:
  Status begin() {
    ++project_.settings.seed;
    VAMP_CHECK_STATUS(renderer_.set_project(std::make_shared<const Project>(project_)));
    return {};
  }

  gpu::Device& device_;
  Project project_;
  Renderer renderer_;
  Status ready_;
  int turn_ = 0;
};

std::string models_in_words(const std::vector<Model>& models) {
  std::vector<std::string_view> names;
  for (const Model model : models) names.push_back(model_row(model).name);
  return fmt::format("{}", fmt::join(names, ", "));
}

class Bench {
 public:
  Bench(gpu::Device& device, const Project& project, const ShadingBench& options, Report& report)
      : device_(device), project_(project), options_(options), report_(report) {}

  struct Kind {
    std::string name;
    BenchMaterial material;
    int terms = kMaxResidualTerms;
    std::span<const uint32_t> kernel = {};
  };

  // Alternates the ways; a table of their times and of the ratios to the first one.
  Status compare(const std::string& what, const std::vector<Kind>& kinds) {
    std::vector<std::unique_ptr<Way>> ways;
    for (const Kind& kind : kinds) {
      ways.push_back(std::make_unique<Way>(device_, project_, kind.material, kind.terms, options_.side, kind.kernel));
      VAMP_CHECK_STATUS(ways.back()->ready());
    }
    for (int round = 0; round < options_.rounds; ++round)
      for (const auto& way : ways) VAMP_CHECK_STATUS(way->round());
    report_.table({what, "single sample, ms", "ratio", "of four, ms", "ratio", "shading alone, ms", "ratio"});
    Json& data = report_.data()[what] = Json::array();
    const auto ms = [](const Series& s) {
      return fmt::format("{:.1f} ({:.1f} to {:.1f})", s.cpu(), s.cpu(0.1), s.cpu(0.9));
    };
    const auto ratio = [](const Series& s, const Series& first) { return s.cpu() / first.cpu(); };
    for (size_t i = 0; i < ways.size(); ++i) {
      const Way &way = *ways[i], &first = *ways[0];
      const double a = ratio(way.single, first.single), b = ratio(way.batch, first.batch),
                   c = ratio(way.shade, first.shade);
      report_.row({kinds[i].name, ms(way.single), fmt::format("{:.3f}", a), ms(way.batch), fmt::format("{:.3f}", b),
                   ms(way.shade), fmt::format("{:.3f}", c)});
      data.push_back({{"way", kinds[i].name},
                      {"single", way.single.json()},
                      {"single_ratio", a},
                      {"batch", way.batch.json()},
                      {"batch_ratio", b},
                      {"shading", way.shade.json()},
                      {"shading_ratio", c}});
    }
    return {};
  }

 private:
  gpu::Device& device_;
  const Project& project_;
  const ShadingBench& options_;
  Report& report_;
};

}  // namespace

Result<Report> bench_shading(gpu::Device& device, Project project, const ShadingBench& options) {
  VAMP_CHECK_STATUS(keep_one_light(project));
  Report report("shading",
                fmt::format("{}, {} x {}, one light and ambient, a material of 32 clusters and six functions "
                            "a texel on every part, medians of {} alternating rounds, {}.",
                            options.scene_words, options.side, options.side, options.rounds, device.info().name));
  Bench bench(device, project, options, report);
  const BenchMaterial full{kAllModels, {}};
  VAMP_CHECK_STATUS(
      bench.compare("forms, all seven models",
                    {{"textbook", full, kMaxResidualTerms, spirv::shade_textbook_comp()}, {"robust", full}}));
  for (const std::vector<Model>& three : {std::vector{Model::lambert, Model::ward, Model::cook_torrance},
                                          std::vector{Model::lambert, Model::oren_nayar, Model::blinn_phong},
                                          std::vector{Model::lambert, Model::lafortune, Model::ashikhmin_shirley}})
    VAMP_CHECK_STATUS(bench.compare("kernel, " + models_in_words(three),
                                    {{"for these three", {three, {}}}, {"for all seven", {three, kAllModels}}}));
  std::vector<Bench::Kind> terms = {{"none", {kAllModels, {}, 6, false}}};
  for (int k = 0; k <= kMaxResidualTerms; ++k)
    terms.push_back({k == 0 ? "mean" : fmt::format("mean and {}", k), full, k});
  VAMP_CHECK_STATUS(bench.compare("residual", terms));
  return report;
}

}  // namespace vamp
