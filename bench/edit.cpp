#include "bench/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>

#include "bench/moved.h"
#include "bench/series.h"
#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/render/session.h"
#include "shaders/shared/tonemap.h"

namespace vamp {
namespace {

constexpr int kWidth = 640, kHeight = 480;

class Bench {
 public:
  Bench(Project project, gpu::Device& device, Report& report)
      : project_(std::move(project)),
        report_(report),
        session_(device, std::make_shared<const Project>(project_), kWidth, kHeight) {
    wait([&] { return session_.status().finished; });
  }

  // Selects rows, and tells after how many milliseconds their weights are at hand, at all samples.
  void select(const std::string& what, const WeightGroup& group, int rounds) {
    Series series;
    selected_ = true;
    for (int round = 0; round < rounds; ++round) {
      session_.set_weights_at_hand({});
      wait([&] { return !session_.status().weights_at_hand; });
      const Stopwatch watch;
      session_.set_weights_at_hand(group);
      wait([&] { return session_.status().weights_at_hand; });
      series.add(watch.stop());
    }
    report_.row({what, "", "", fmt::format("{:.0f} ({:.0f})", series.wall(), series.wall(0.95))});
    report_.data()["edits"].push_back(Json{{"edit", what}, {"at_hand", series.json()}});
  }

  void select_nothing() {
    session_.set_weights_at_hand({});
    selected_ = false;
  }

  // `edit` changes the project, a little differently each round.
  void measure(const std::string& what, int rounds, const std::function<void(Project&, int round)>& edit) {
    Series first, back;
    uint64_t pixels = 0;
    for (int round = 0; round < rounds; ++round) {
      // What is selected has had the time to be gathered.
      if (selected_) wait([&] { return session_.status().weights_at_hand; });
      edit(project_, round);
      const Stopwatch watch;
      show(what);
      first.add(watch.stop());
      wait([&] { return session_.status().finished; });
      back.add(watch.stop());
      pixels = session_.status().restarted_pixels;
    }
    tell(what, pixels, first, back);
  }

  // The first look after each of many small moves, and how much brighter or darker it is than the finished picture.
  void measure_moves(const std::string& what, int rounds, const std::function<void(Project&, int round)>& edit) {
    Series first, back;
    double shift = 0;
    for (int round = 0; round < rounds; ++round) {
      edit(project_, round);
      const Stopwatch watch;
      show(what);
      first.add(watch.stop());
      PixelLayer look, finished;
      session_.copy_picture(look);
      wait([&] { return session_.status().finished; });
      back.add(watch.stop());
      session_.copy_picture(finished);
      shift = std::max(shift, std::abs(mean_radiance(look) / mean_radiance(finished) - 1));
    }
    tell(what, uint64_t{kWidth} * kHeight, first, back);
    report_.remark(fmt::format("First looks, {}: at most {:.1f} % brighter or darker than the finished pictures.", what,
                               100 * shift));
    report_.data()["edits"].back()["brightness_shift"] = shift;
  }

 private:
  void tell(const std::string& what, uint64_t pixels, const Series& first, const Series& back) {
    const double share = static_cast<double>(pixels) / (kWidth * kHeight);
    report_.row({what, fmt::format("{:.1f} %", 100 * share),
                 fmt::format("{:.0f} ({:.0f})", first.wall(), first.wall(0.95)),
                 fmt::format("{:.0f} ({:.0f})", back.wall(), back.wall(0.95))});
    report_.data()["edits"].push_back(
        Json{{"edit", what}, {"pixels", share}, {"first_picture", first.json()}, {"samples_again", back.json()}});
  }

  // Of what is shown, as light.
  static double mean_radiance(const PixelLayer& picture) {
    double sum = 0;
    for (const uint32_t pixel : picture.pixels)
      for (int shift = 0; shift < 24; shift += 8)
        sum += static_cast<double>(srgb_decode(static_cast<float>(pixel >> shift & 255u) / 255.0f));
    return sum / static_cast<double>(picture.pixels.size());
  }

  // Until a first picture of the project as it is now.
  void show(const std::string& what) {
    const auto next = std::make_shared<const Project>(project_);
    const uint64_t version = session_.picture_version();
    session_.set_project(next, what);
    wait([&] { return session_.status().project == next && session_.picture_version() > version; });
  }

  template <class Done>
  void wait(const Done& done) {
    while (!done()) {
      CHECK(session_.status().error.empty());
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
  }

  Project project_;
  Report& report_;
  RenderSession session_;
  bool selected_ = false;
};

}  // namespace

Result<Report> bench_edit(gpu::Device& device, Project project, const EditBench& options) {
  const int vamp = std::max(project.scene->find_part("Vamp"), 0);
  const size_t material = static_cast<size_t>(project.parts[static_cast<size_t>(vamp)].material);
  const int materials = static_cast<int>(project.materials.size());
  const int bases = static_cast<int>(project.materials[material].fit->dictionary.size());
  const int clusters = static_cast<int>(project.materials[material].fit->clusters.size());
  const auto tilt = [&](Project& p, int round, int first, int end) {
    BasisEdit edit;
    const float x = 0.02f * static_cast<float>(round + 1);
    edit.normal = vec3(x, 0, std::sqrt(1 - x * x));
    for (int c = first; c < end; ++c)
      for (int b = 0; b < bases; ++b) p.materials[material].edits.set({c, b}, edit);
  };
  project.settings.max_samples = options.samples;
  Report report("edit", fmt::format("{}, {} x {}, {} rounds, {}; milliseconds of wall time, in parentheses at 95 %.",
                                    options.scene_words, kWidth, kHeight, options.rounds, device.info().name));
  report.table({"edit", "pixels", "first picture", fmt::format("{} samples again", options.samples)});
  Bench bench(project, device, report);
  bench.measure("normal of all functions of a cluster", options.rounds,
                [&](Project& p, int round) { tilt(p, round, clusters / 2, clusters / 2 + 1); });
  bench.measure("normal of all functions of a material", options.rounds,
                [&](Project& p, int round) { tilt(p, round, 0, clusters); });
  // A function of one cluster, then of all.
  for (const int end : {clusters / 2 + 1, clusters}) {
    const int first = end == clusters ? 0 : clusters / 2;
    const std::string where = end == clusters ? "in all clusters" : "in a cluster";
    WeightGroup group{static_cast<int>(material), {}};
    for (int c = first; c < end; ++c) group.rows.push_back({c, 0});
    bench.select("selected: a function " + where, group, options.rounds);
    bench.measure("its weight, pulled " + where, options.rounds, [&](Project& p, int round) {
      for (const BasisKey key : group.rows) {
        BasisEdit edit = p.materials[material].edits.edit_of(key);
        edit.gain = vec3(1.5f + 0.1f * static_cast<float>(round));
        p.materials[material].edits.set(key, edit);
      }
    });
  }
  bench.select_nothing();
  if (materials > 1)
    bench.measure("another material on a part", options.rounds, [&](Project& p, int round) {
      p.parts[static_cast<size_t>(vamp)].material = (static_cast<int>(material) + round + 1) % materials;
    });
  if (!project.lights.empty())
    bench.measure("power of a light", options.rounds, [&](Project& p, int) { p.lights[0].power *= 1.1f; });
  bench.measure_moves("camera turned by a degree", options.rounds, [](Project& p, int) {
    const vec3 arm = p.camera.eye - p.camera.target;
    const float c = std::cos(0.01745f), s = std::sin(0.01745f);
    p.camera.eye = p.camera.target + vec3(c * arm.x + s * arm.z, arm.y, c * arm.z - s * arm.x);
  });
  const float step = 0.002f * project.scene->parts[static_cast<size_t>(vamp)].bounds.radius();
  bench.measure_moves("part moved", options.rounds, [&](Project& p, int round) {
    p.parts[static_cast<size_t>(vamp)].place = {vec3(0, step * static_cast<float>(round + 1), 0), {}};
  });
  bench.measure_moves("part turned", options.rounds, [&](Project& p, int round) {
    p.parts[static_cast<size_t>(vamp)].place = {{}, vec3(0.002f * static_cast<float>(round + 1), 0, 0)};
  });
  bench.measure("everything again (another seed)", std::max(options.rounds / 4, 1),
                [&](Project& p, int) { ++p.settings.seed; });
  VAMP_CHECK_STATUS(measure_moved_parts(device, project, options.rounds, report));
  return report;
}

}  // namespace vamp
