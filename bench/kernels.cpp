#include "bench/kernels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "bench/series.h"
#include "bench/temporary_folder.h"
#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/render/session.h"

namespace vamp {
namespace {

constexpr int kWidth = 640, kHeight = 480;

// The last is what a picture does by itself, and those that are repeated need no new kernel: what the tables and the
// new picture take.
constexpr std::array kEvents = {"opened",         "nothing",        "preset with other models", "the same again",
                                "one more light", "the same again", "first edit of a function"};
constexpr size_t kCount = kEvents.size();

struct Times {
  double first_ms = 0;  // until a picture shows it
  double gap_ms = 0;    // the longest between two tiles
};

// Mesa's disk cache in another folder, for devices that are opened while this lives.
class DriverCacheIn {
 public:
  explicit DriverCacheIn(const fs::path& folder) {
    if (const char* before = std::getenv(kName)) before_ = before;
    ::setenv(kName, folder.c_str(), 1);
  }
  ~DriverCacheIn() {
    if (before_.empty())
      ::unsetenv(kName);
    else
      ::setenv(kName, before_.c_str(), 1);
  }
  DriverCacheIn(const DriverCacheIn&) = delete;
  DriverCacheIn& operator=(const DriverCacheIn&) = delete;

 private:
  static constexpr const char* kName = "MESA_SHADER_CACHE_DIR";
  std::string before_;
};

class Case {
 public:
  Case(gpu::Device& device, const Project& project, RenderSession::Kernels kernels, double seconds)
      : project_(project),
        seconds_(seconds),
        opened_(Clock::now()),
        session_(device, std::make_shared<const Project>(project), kWidth, kHeight, RenderSession::kAutomaticMemory,
                 kernels) {}

  Times opened() {
    const uint64_t first = 0;
    while (session_.picture_version() == first) rest();
    const double ms = 1e3 * seconds_since(opened_);
    return {ms, watch(nullptr, first).gap_ms};
  }
  Times nothing() { return watch(nullptr, session_.picture_version()); }
  template <class Edit>
  Times edit(const Edit& change) {
    change(project_);
    const auto next = std::make_shared<const Project>(project_);
    const uint64_t before = session_.picture_version();
    session_.set_project(next, "");
    return watch(next, before);
  }

 private:
  void rest() {
    CHECK(session_.status().error.empty());
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }

  Times watch(const std::shared_ptr<const Project>& awaited, uint64_t version) {
    const Clock::time_point start = Clock::now();
    Clock::time_point last = start;
    Times times;
    bool shown = awaited == nullptr;
    while (seconds_since(start) < seconds_ || !shown) {
      rest();
      const uint64_t now = session_.picture_version();
      const double gap = 1e3 * seconds_since(last);
      times.gap_ms = std::max(times.gap_ms, gap);
      if (now == version) continue;
      version = now;
      last = Clock::now();
      if (shown || session_.status().project != awaited) continue;
      shown = true;
      times.first_ms = 1e3 * seconds_since(start);
    }
    return times;
  }

  Project project_;
  double seconds_;
  Clock::time_point opened_;
  RenderSession session_;
};

std::array<Times, kCount> run(gpu::Device& device, const Project& plain, const Project& dressed,
                              RenderSession::Kernels kernels, double seconds) {
  const auto part = static_cast<size_t>(std::max(plain.scene->find_part("Vamp"), 0));
  const int own = plain.parts[part].material;
  const auto dress = [&](Project& p) {
    if (p.materials.size() == plain.materials.size())
      p.materials.push_back(dressed.materials[static_cast<size_t>(dressed.parts[part].material)]);
    p.parts[part].material = static_cast<int>(p.materials.size()) - 1;
  };
  const auto add_light = [](Project& p) {
    Light light = p.lights.front();
    light.center = light.center * vec3(-1, 1, 1);
    p.lights.push_back(light);
  };
  std::array<Times, kCount> times;
  Case shown(device, plain, kernels, seconds);
  times[0] = shown.opened();
  times[1] = shown.nothing();
  times[2] = shown.edit(dress);
  shown.edit([&](Project& p) { p.parts[part].material = own; });
  times[3] = shown.edit(dress);
  times[4] = shown.edit(add_light);
  shown.edit([](Project& p) { p.lights.pop_back(); });
  times[5] = shown.edit(add_light);
  times[6] = shown.edit([](Project& p) {
    BasisEdit edit;
    edit.normal = vec3(0.1f, 0, std::sqrt(0.99f));
    p.materials.back().edits.set({0, 0}, edit);
  });
  return times;
}

}  // namespace

Result<Report> bench_kernels(const gpu::Options& how, const Project& plain, const Project& dressed,
                             const KernelsBench& options) {
  if (plain.lights.empty()) return fail(ErrorKind::bad_input, "", "lights", "at least one", "none");
  Project project = plain;
  project.settings.max_samples = 65536;  // never done
  project.settings.noise_goal = 0;
  constexpr std::array kKernels = {RenderSession::Kernels::on_queue, RenderSession::Kernels::in_background};
  // [cold or warm][on queue or beside it][event]: milliseconds of each round.
  std::vector<double> first[2][2][kCount], gap[2][2][kCount];
  std::string name;
  for (int round = 0; round < options.rounds; ++round)
    for (size_t k = 0; k < 2; ++k) {
      VAMP_TRY(const TemporaryFolder folder, TemporaryFolder::make());
      const DriverCacheIn cache(folder.path());
      for (size_t warm = 0; warm < 2; ++warm) {
        VAMP_TRY(const auto device, gpu::Device::create(how));
        name = device->info().name;
        const auto times = run(*device, project, dressed, kKernels[k], options.seconds);
        for (size_t e = 0; e < kCount; ++e) {
          first[warm][k][e].push_back(times[e].first_ms);
          gap[warm][k][e].push_back(times[e].gap_ms);
        }
      }
    }

  Report report("kernels",
                fmt::format("{}, {} x {}, {} rounds, {}; milliseconds of wall time: the median until a picture shows "
                            "it, and the longest time without a new tile in any round.",
                            options.scene_words, kWidth, kHeight, options.rounds, name));
  Json& data = report.data()["cases"] = Json::array();
  for (size_t warm = 0; warm < 2; ++warm) {
    report.table({warm != 0 ? "disk cache full" : "disk cache empty", "on the queue: shown", "longest gap",
                  "beside it: shown", "longest gap"});
    for (size_t e = 0; e < kCount; ++e) {
      std::vector<std::string> cells = {kEvents[e]};
      for (size_t k = 0; k < 2; ++k) {
        const double shown = quantile(first[warm][k][e], 0.5), longest = quantile(gap[warm][k][e], 1);
        cells.push_back(e == 1 ? "" : fmt::format("{:.0f}", shown));
        cells.push_back(fmt::format("{:.0f}", longest));
        data.push_back({{"event", kEvents[e]},
                        {"cache", warm != 0 ? "full" : "empty"},
                        {"kernels", k != 0 ? "in background" : "on queue"},
                        {"shown_ms", shown},
                        {"gap_ms", longest}});
      }
      report.row(std::move(cells));
    }
  }
  return report;
}

}  // namespace vamp
