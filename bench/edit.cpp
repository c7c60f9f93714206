// What an edit costs from the moment it is handed over to the first picture that shows it, and until the picture is as
// clean as before, beside the same edit answered by starting again:
//   bench_edit [SCENE] [--samples N] [--rounds N]
// 640 x 480, the renderer's own thread as in the window, without the window's share (events, drawing, presenting).
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

#include "engine/core/check.h"
#include "engine/core/clock.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/project/default_project.h"
#include "engine/project/project_file.h"
#include "engine/render/session.h"

namespace vamp {
namespace {

constexpr int kWidth = 640, kHeight = 480;

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

std::string text(const std::vector<double>& ms) {
  return fmt::format("{:6.0f} ms ({:.0f} at 95 %)", quantile(ms, 0.5), quantile(ms, 0.95));
}

class Bench {
 public:
  Bench(Project project, gpu::Device& device, uint32_t samples)
      : project_(std::move(project)),
        samples_(samples),
        session_(device, std::make_shared<const Project>(project_), kWidth, kHeight) {
    wait([&] { return session_.status().finished; });
  }

  // `edit` changes the project, a little differently each round.
  void measure(const std::string& what, int rounds, const std::function<void(Project&, int round)>& edit) {
    std::vector<double> first, back;
    uint64_t pixels = 0;
    for (int round = 0; round < rounds; ++round) {
      edit(project_, round);
      const auto next = std::make_shared<const Project>(project_);
      const Clock::time_point start = Clock::now();
      const uint64_t version = session_.picture_version();
      session_.set_project(next, what);
      wait([&] { return session_.status().project == next && session_.picture_version() > version; });
      first.push_back(1e3 * seconds_since(start));
      wait([&] { return session_.status().finished; });
      back.push_back(1e3 * seconds_since(start));
      pixels = session_.status().restarted_pixels;
    }
    fmt::print("{:44} {:5.1f} % of the pixels, first picture {}, {} samples again {}\n", what,
               100.0 * static_cast<double>(pixels) / (kWidth * kHeight), text(first), samples_, text(back));
    std::fflush(stdout);
  }

 private:
  template <class Done>
  void wait(const Done& done) {
    while (!done()) {
      CHECK(session_.status().error.empty());
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  }

  Project project_;
  uint32_t samples_;
  RenderSession session_;
};

int run(const std::string& scene, uint32_t samples, int rounds) {
  Result<Project> opened = scene.empty() ? default_project() : open_scene(scene);
  if (!opened) {
    fmt::print(stderr, "{}\n", opened.error().message());
    return 3;
  }
  Project project = std::move(*opened);
  project.settings.max_samples = samples;
  auto device = gpu::Device::create();
  CHECK(device);
  const int vamp = std::max(project.scene->find_part("Vamp"), 0);
  const size_t material = static_cast<size_t>(project.parts[static_cast<size_t>(vamp)].material);
  const auto& fit = *project.materials[material].fit;
  const int bases = static_cast<int>(fit.dictionary.size());
  const int clusters = static_cast<int>(fit.clusters.size());
  const auto tilt = [&](Project& p, int round, int first, int end) {
    BasisEdit edit;
    const float x = 0.02f * static_cast<float>(round + 1);
    edit.normal = vec3(x, 0, std::sqrt(1 - x * x));
    for (int c = first; c < end; ++c)
      for (int b = 0; b < bases; ++b) p.materials[material].edits.set({c, b}, edit);
  };
  fmt::print("{} x {}, {} triangles, {}\n", kWidth, kHeight, project.scene->triangles.size(), (*device)->info().name);
  Bench bench(project, **device, samples);
  bench.measure("normal of all functions of a cluster", rounds,
                [&](Project& p, int round) { tilt(p, round, clusters / 2, clusters / 2 + 1); });
  bench.measure("normal of all functions of a material", rounds,
                [&](Project& p, int round) { tilt(p, round, 0, clusters); });
  if (!project.lights.empty())
    bench.measure("power of a light", rounds, [&](Project& p, int) { p.lights[0].power *= 1.1f; });
  bench.measure("everything again (another seed)", std::max(rounds / 4, 1),
                [&](Project& p, int) { ++p.settings.seed; });
  return 0;
}

}  // namespace
}  // namespace vamp

int main(int argc, char** argv) {
  vamp::start_log("warn");
  std::string scene;
  int samples = 64, rounds = 9;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--samples" && i + 1 < argc)
      samples = std::max(std::atoi(argv[++i]), 1);
    else if (option == "--rounds" && i + 1 < argc)
      rounds = std::max(std::atoi(argv[++i]), 1);
    else
      scene = option;
  }
  return vamp::run(scene, static_cast<uint32_t>(samples), rounds);
}
