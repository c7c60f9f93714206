#include "bench/pathtracer.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>

#include "bench/sample_cost.h"
#include "bench/scene.h"
#include "bench/temporary_folder.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

std::string obj_of(const Scene& scene) {
  std::string text;
  for (const vec3& p : scene.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const uvec3& t : scene.triangles) text += fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  return text;
}

double children_cpu_ms() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

class Pathtracer {
 public:
  Pathtracer(const fs::path& obj, const Project& project, int side) {
    const Camera& camera = project.camera;
    const auto place = [](vec3 p) { return fmt::format("{} {} {}", p.x, p.y, p.z); };
    command_ = fmt::format(
        "pathtracer -i {} --vp {} --vi {} --vu 0 1 0 --fov {} --size {} {} --pointlight {} 1 1 1 --max-path-length 2 "
        "--spp 1 --threads {}",
        obj.string(), place(camera.eye), place(camera.target), camera.fov_degrees, side, side,
        place(project.lights[0].center), processors());
  }

  // One frame's time: that of many frames less that of few, so that reading and building drop out.
  Result<Times> frame() const {
    constexpr int kFew = 2, kMany = 34;
    VAMP_TRY(const Times few, run(kFew));
    VAMP_TRY(const Times many, run(kMany));
    return Times{(many.cpu_ms - few.cpu_ms) / (kMany - kFew), (many.wall_ms - few.wall_ms) / (kMany - kFew)};
  }

 private:
  Result<Times> run(int frames) const {
    const double before = children_cpu_ms();
    const Stopwatch watch;
    const int code = std::system(fmt::format("{} --benchmark 0 {} >/dev/null 2>&1", command_, frames).c_str());
    if (code != 0)
      return fail(ErrorKind::failed, "pathtracer", "", "Embree's path tracer (package embree-tools)",
                  fmt::format("exit status {}", code));
    return Times{(children_cpu_ms() - before) / processors(), watch.stop().wall_ms};
  }

  std::string command_;
};

}  // namespace

Result<Report> bench_pathtracer(gpu::Device& device, Project project, const PathtracerBench& options) {
  VAMP_CHECK_STATUS(keep_one_light(project));
  VAMP_TRY(const TemporaryFolder folder, TemporaryFolder::make());
  const fs::path obj = folder.path() / "scene.obj";
  VAMP_CHECK_STATUS(write_text_atomically(obj, obj_of(*project.scene)));
  const Pathtracer peer(obj, project, options.side);
  VAMP_TRY(const auto cost, SampleCost::make(device, std::move(project), options.side, options.side));
  Series theirs;
  for (int round = 0; round < options.rounds; ++round) {
    VAMP_TRY(const Times frame, peer.frame());
    theirs.add(frame);
    VAMP_CHECK_STATUS(cost->round());
  }
  Report report(options.name, fmt::format("{}, {} x {}, medians of {} alternating rounds, {}.", options.scene_words,
                                          options.side, options.side, options.rounds, device.info().name));
  report.table({"", "a sample", "of Embree's path tracer", "asked"});
  report.row({"Embree's path tracer, two vertices, a point light", theirs.text(), "1", ""});
  const auto ours = [&](const char* what, const Series& series) {
    report.row({what, series.text(), fmt::format("{:.2f}", series.cpu() / theirs.cpu()), "below 1"});
  };
  ours("a single sample with a primary ray of its own", cost->single);
  ours("four samples a primary ray, four a dispatch", cost->batch);
  report.data() = {{"embree", theirs.json()}, {"single", cost->single.json()}, {"batch", cost->batch.json()}};
  return report;
}

}  // namespace vamp
