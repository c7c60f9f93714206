#include "bench/peers.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdlib>
#include <glm/trigonometric.hpp>

#include "bench/sample_cost.h"
#include "bench/scene.h"
#include "bench/temporary_folder.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

// Arguments: the OBJ, samples, pixels a side, threads, eye, target, vertical field of view in radians, light, its size;
// points with +Y up.
constexpr const char* kCyclesScript = R"(
import sys, bpy
from mathutils import Vector
a = sys.argv[sys.argv.index('--') + 1:]
number = [float(x) for x in a[1:]]
point = lambda i: Vector((number[i], -number[i + 2], number[i + 1]))
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.wm.obj_import(filepath=a[0])
scene = bpy.context.scene
camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
camera.location = point(3)
camera.rotation_euler = (point(6) - point(3)).to_track_quat('-Z', 'Y').to_euler()
camera.data.sensor_fit, camera.data.angle = 'VERTICAL', number[9]
lamp = bpy.data.objects.new('light', bpy.data.lights.new('light', 'AREA'))
lamp.location = point(10)
lamp.rotation_euler = (point(6) - point(10)).to_track_quat('-Z', 'Y').to_euler()
lamp.data.energy, lamp.data.size = 100, number[13]
for thing in (camera, lamp): scene.collection.objects.link(thing)
scene.camera = camera
scene.render.engine = 'CYCLES'
scene.render.resolution_x = scene.render.resolution_y = int(number[1])
scene.render.threads_mode, scene.render.threads = 'FIXED', int(number[2])
cycles = scene.cycles
cycles.device, cycles.samples, cycles.max_bounces = 'CPU', int(number[0]), 1
cycles.use_adaptive_sampling = cycles.use_denoising = False
scene.render.filepath = a[0] + '.png'
bpy.ops.render.render(write_still=True)
)";

std::string obj_of(const Scene& scene) {
  std::string text;
  for (const vec3& p : scene.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const uvec3& t : scene.triangles) text += fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  return text;
}

std::string place(vec3 p) { return fmt::format("{} {} {}", p.x, p.y, p.z); }

double children_cpu_ms() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto ms = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

// A program that renders so many samples when it is run; "{}" in the command stands for their number.
struct Peer {
  const char* name;
  const char* program;
  const char* package;
  std::string command;
  bool runs = true;
  Series sample = {};

  Times run(int samples) {
    const double before = children_cpu_ms();
    const Stopwatch watch;
    const std::string line = fmt::format("{} >/dev/null 2>&1", fmt::format(fmt::runtime(command), samples));
    runs = runs && std::system(line.c_str()) == 0;
    return {(children_cpu_ms() - before) / processors(), watch.stop().wall_ms};
  }

  // The time of many less that of few, so that starting, reading and building drop out.
  void round() {
    constexpr int kFew = 2, kMany = 34;
    const Times few = run(kFew), many = runs ? run(kMany) : few;
    sample.add({many.cpu_ms - few.cpu_ms, many.wall_ms - few.wall_ms}, 1.0 / (kMany - kFew));
  }
};

std::vector<Peer> peers(const fs::path& folder, const Project& project, int side) {
  const Camera& camera = project.camera;
  const Light& light = project.lights[0];
  const std::string obj = (folder / "scene.obj").string();
  std::vector<Peer> all;
  all.push_back({"Embree's path tracer", "pathtracer", "embree-tools",
                 fmt::format("pathtracer -i {} --vp {} --vi {} --vu 0 1 0 --fov {} --size {} {} --pointlight {} 1 1 1 "
                             "--max-path-length 2 --spp 1 --threads {} --benchmark 0 {{}}",
                             obj, place(camera.eye), place(camera.target), camera.fov_degrees, side, side,
                             place(light.center), processors())});
  all.push_back(
      {"Cycles", "blender", "blender",
       fmt::format("blender -b --factory-startup --python-exit-code 1 --python {} -- {} {{}} {} {} {} {} {} {} {}",
                   (folder / "cycles.py").string(), obj, side, processors(), place(camera.eye), place(camera.target),
                   glm::radians(camera.fov_degrees), place(light.center), light.size.x)});
  return all;
}

}  // namespace

Result<Report> bench_peers(gpu::Device& device, Project project, const PeersBench& options) {
  VAMP_CHECK_STATUS(keep_one_light(project));
  VAMP_TRY(const TemporaryFolder folder, TemporaryFolder::make());
  VAMP_CHECK_STATUS(write_text_atomically(folder.path() / "scene.obj", obj_of(*project.scene)));
  VAMP_CHECK_STATUS(write_text_atomically(folder.path() / "cycles.py", kCyclesScript));
  std::vector<Peer> others = peers(folder.path(), project, options.side);
  VAMP_TRY(const auto cost, SampleCost::make(device, std::move(project), options.side, options.side));
  for (int round = 0; round < options.rounds; ++round) {
    for (Peer& peer : others)
      if (peer.runs) peer.round();
    VAMP_CHECK_STATUS(cost->round());
  }
  Report report(options.name, fmt::format("{}, {} x {}, medians of {} alternating rounds, {}.", options.scene_words,
                                          options.side, options.side, options.rounds, device.info().name));
  report.table({"", "a sample", "ours, a single one", "ours, of four"});
  report.row({"ours, a single one with a primary ray of its own", cost->single.text(), "", ""});
  report.row({"ours, of four to a primary ray and a dispatch", cost->batch.text(), "", ""});
  report.data() = {{"single", cost->single.json()}, {"batch", cost->batch.json()}};
  for (const Peer& peer : others) {
    if (!peer.runs) {
      report.row({peer.name, fmt::format("`{}` (package {}) did not run", peer.program, peer.package), "-", "-"});
      continue;
    }
    const auto of_it = [&](const Series& ours) { return fmt::format("{:.2f} of it", ours.cpu() / peer.sample.cpu()); };
    report.row({peer.name, peer.sample.text(), of_it(cost->single), of_it(cost->batch)});
    report.data()[peer.program] = peer.sample.json();
  }
  return report;
}

}  // namespace vamp
