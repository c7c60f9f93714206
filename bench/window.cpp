#include "bench/window.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/temporary_folder.h"
#include "bench/window/findings.h"
#include "engine/brdf/registry.h"
#include "engine/core/log.h"
#include "engine/project/project_file.h"

namespace vamp {
namespace {

constexpr int kWidth = 640, kHeight = 480;  // of the picture
constexpr int kScreenWidth = 1600, kScreenHeight = 1000;
constexpr uint32_t kFewSamples = 4;  // for a picture that is soon finished
constexpr uint32_t kEndless = 1u << 20;

class Bench {
 public:
  Bench(Project project, const WindowBench& options, fs::path folder, Screen& screen)
      : project_(std::move(project)), options_(options), folder_(std::move(folder)), screen_(screen) {
    part_ = std::max(project_.scene->find_part("Vamp"), 0);
    material_ = project_.parts[static_cast<size_t>(part_)].material;
  }

  Status edits() {
    spdlog::info("edits of the picture");
    VAMP_TRY(const auto window, open("edits", options_.samples));
    VAMP_CHECK_STATUS(window->fit_viewport(kWidth, kHeight));
    VAMP_CHECK_STATUS(wait_until_idle(*window));
    const Spmm& fit = *project_.materials[static_cast<size_t>(material_)].fit;
    VAMP_CHECK_STATUS(window->select(part_, static_cast<int>(fit.clusters.size() / 2)));
    VAMP_TRY(const std::string roughness, select_function(*window, fit));
    for (const bool all : {false, true}) {
      if (all) VAMP_CHECK_STATUS(window->choose("Material", "Apply to", "All clusters with this basis"));
      const std::string where = all ? "in all clusters" : "in a cluster";
      VAMP_CHECK_STATUS(measure(*window, "roughness of a function " + where, "Material", roughness, false));
      VAMP_CHECK_STATUS(measure(*window, "its weight " + where, "Material", "Weight", true));
    }
    return measure(*window, "power of a light", "Lights", "Power", false);
  }

  Status view() {
    spdlog::info("the view");
    VAMP_TRY(const auto window, open("view", kFewSamples));
    VAMP_CHECK_STATUS(window->fit_viewport(kWidth, kHeight));
    VAMP_TRY(Answers answers, turn(*window, options_.rounds));
    found_.cases.push_back({"the view, by 2.4 degrees", std::move(answers), Peer::view});
    return {};
  }

  Status pace() {
    spdlog::info("a resting and a busy window");
    {
      VAMP_TRY(const auto window, open("resting", kFewSamples));
      VAMP_CHECK_STATUS(wait_until_idle(*window));
      VAMP_TRY(found_.resting, processor_share(*window, 10));
    }
    VAMP_TRY(const auto window, open("busy", kEndless));
    VAMP_CHECK_STATUS(window->select(part_, 0));
    VAMP_TRY(found_.paces, measure_paces(*window));
    return {};
  }

  void cycles() {
    spdlog::info("Cycles' viewport");
    auto answers = measure_cycles(screen_, folder_, project_, material_, kWidth, kHeight, options_.rounds);
    if (answers) {
      found_.cycles = std::move(*answers);
    } else {
      found_.no_cycles = answers.error().message();
    }
  }

  Report report() {
    found_.looks = screen_.looks();
    return tell_window(
        found_, fmt::format("{}, picture of {} x {} and {} samples, {} rounds after {} to warm up, Xvfb; milliseconds "
                            "of wall time from the mouse's event to changed pixels in the framebuffer, in parentheses "
                            "at 5 and 95 %.",
                            options_.scene_words, kWidth, kHeight, options_.samples, options_.rounds, kWarmRounds));
  }

 private:
  Result<std::unique_ptr<EditorWindow>> open(const std::string& name, uint32_t samples) {
    Project project = project_;
    project.settings.max_samples = samples;
    project.settings.noise_goal = 0;
    const fs::path file = folder_ / (name + ".vampproj");
    VAMP_CHECK_STATUS(save_project(project, file));
    return EditorWindow::open(screen_, folder_ / name, file, kScreenWidth, kScreenHeight);
  }

  // Selects a function whose first parameter is a roughness, and gives that parameter's word.
  Result<std::string> select_function(EditorWindow& window, const Spmm& fit) {
    for (const Basis& basis : fit.dictionary) {
      if (basis.lobe.model != Model::cook_torrance) continue;
      const Result<Area> row = window.find("Material", basis.name);
      if (!row) continue;
      window.click(*row);
      return std::string(find_parameter(Model::cook_torrance, basis.lobe.variant, "m")->label);
    }
    return fail(ErrorKind::failed, "", "", "a Cook-Torrance function in the cluster", "none");
  }

  Status measure(EditorWindow& window, const std::string& what, const std::string& panel, const std::string& row,
                 bool summed) {
    VAMP_TRY(const Area slider, window.find(panel, row));
    VAMP_TRY(Answers answers, pull(window, slider, options_.rounds, summed));
    const bool light = panel == "Lights";
    if (light) answers.pixels = 1;  // all pixels are weighed anew, none is counted
    found_.cases.push_back({what, std::move(answers), light ? Peer::light : Peer::material});
    return {};
  }

  Project project_;
  const WindowBench& options_;
  fs::path folder_;
  Screen& screen_;
  int part_ = 0, material_ = 0;
  WindowFindings found_;
};

}  // namespace

Result<Report> bench_window(Project project, const WindowBench& options) {
  VAMP_TRY(const TemporaryFolder folder, TemporaryFolder::make());
  VAMP_TRY(const auto screen, Screen::open(folder.path(), kScreenWidth, kScreenHeight));
  Bench bench(std::move(project), options, folder.path(), *screen);
  if (options.edits) VAMP_CHECK_STATUS(bench.edits());
  if (options.view) VAMP_CHECK_STATUS(bench.view());
  if (options.pace) VAMP_CHECK_STATUS(bench.pace());
  if (options.cycles) bench.cycles();
  return bench.report();
}

}  // namespace vamp
