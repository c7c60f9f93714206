#include "bench/window/cycles_window.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <glm/trigonometric.hpp>
#include <sstream>

namespace vamp {
namespace {

// Arguments: the OBJ, a pipe of commands, the material that is edited, eye, target, vertical field of view in radians,
// the light's place and size; points with +Y up. Prints where the view is in the window, then for each command the time
// of CLOCK_MONOTONIC in ns at which it set the value.
constexpr const char* kScript = R"(
import math, os, sys, time, bpy
from mathutils import Vector
a = sys.argv[sys.argv.index('--') + 1:]
number = [float(x) for x in a[3:]]
point = lambda i: Vector((number[i], -number[i + 2], number[i + 1]))
eye, target, light_at = point(0), point(3), point(7)
fov, light_size = number[6], number[10]
bpy.context.preferences.view.show_splash = False
for thing in list(bpy.data.objects): bpy.data.objects.remove(thing)
bpy.ops.wm.obj_import(filepath=a[0])
for material in bpy.data.materials:
    material.use_nodes = True
principled = bpy.data.materials[a[2]].node_tree.nodes['Principled BSDF']
principled.inputs['Base Color'].default_value = (0.33, 0.13, 0.04, 1)
scene = bpy.context.scene
lamp = bpy.data.objects.new('light', bpy.data.lights.new('light', 'AREA'))
lamp.location = light_at
lamp.rotation_euler = (target - light_at).to_track_quat('-Z', 'Y').to_euler()
lamp.data.energy, lamp.data.size = 10, light_size
scene.collection.objects.link(lamp)
scene.render.engine = 'CYCLES'
cycles = scene.cycles
cycles.device, cycles.preview_samples, cycles.max_bounces = 'CPU', 2, 1
cycles.use_preview_adaptive_sampling = cycles.use_preview_denoising = False
commands = os.open(a[1], os.O_RDONLY | os.O_NONBLOCK)
view = None

def view_area():
    areas = bpy.context.window_manager.windows[0].screen.areas
    return max((x for x in areas if x.type == 'VIEW_3D'), key=lambda x: x.width * x.height)

def fill_window():
    window = bpy.context.window_manager.windows[0]
    with bpy.context.temp_override(window=window, area=view_area()):
        bpy.ops.screen.screen_full_area(use_hide_panels=True)
    bpy.app.timers.register(set_view, first_interval=0.5)

def set_view():
    global view
    area = view_area()
    space = area.spaces.active
    space.overlay.show_overlays = space.show_gizmo = space.show_region_header = False
    space.show_region_toolbar = space.show_region_ui = False
    region = next(x for x in area.regions if x.type == 'WINDOW')
    view = space.region_3d
    view.view_perspective = 'PERSP'
    view.view_location, view.view_distance = target, (eye - target).length
    view.view_rotation = (target - eye).to_track_quat('-Z', 'Y')
    # A viewport's sensor is 72 mm on its longer side.
    space.lens = 36 / (math.tan(fov / 2) * max(region.width / region.height, 1))
    space.clip_start, space.clip_end = view.view_distance / 100, view.view_distance * 100
    space.shading.type = 'RENDERED'
    window = bpy.context.window_manager.windows[0]
    print(region.x, window.height - region.y - region.height, region.width, region.height, flush=True)
    bpy.app.timers.register(obey, first_interval=0.1)

step = 0
def obey():
    global step
    try:
        command = os.read(commands, 1)
    except BlockingIOError:
        command = b''
    if command:
        step += 1
        odd = step % 2
        now = time.monotonic_ns()
        if command == b'm': principled.inputs['Roughness'].default_value = 0.3 + 0.2 * odd
        if command == b'l': lamp.data.energy = 10 + 5 * odd
        if command == b'v': view.view_rotation = view.view_rotation @ Vector((0, 0, -1)).rotation_difference(
            Vector((0.02 * (2 * odd - 1), 0, -1)))
        print(now, flush=True)
    return 0.005

bpy.app.timers.register(fill_window, first_interval=1)
)";

// What a material of the project is called there; parts that share one share it there too.
std::string material_name(int material) { return fmt::format("material{}", material); }

std::string obj_of(const Project& project) {
  const Scene& scene = *project.scene;
  std::string text;
  for (const vec3& p : scene.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  int material = -1;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    const int next = project.parts[scene.triangle_part[i]].material;
    if (material != next) text += fmt::format("usemtl {}\n", material_name(next));
    material = next;
    const uvec3 t = scene.triangles[i];
    text += fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  }
  return text;
}

tl::unexpected<Error> no_blender(std::string_view found) {
  return fail(ErrorKind::failed, "blender", "", "Cycles' viewport (package blender)", found);
}

class Blender {
 public:
  static Result<std::unique_ptr<Blender>> open(Screen& screen, const fs::path& folder, const Project& project,
                                               int material, int width, int height) {
    std::unique_ptr<Blender> blender(new Blender(screen));
    const fs::path script = folder / "cycles.py", obj = folder / "scene.obj", pipe = folder / "commands";
    VAMP_CHECK_STATUS(write_text_atomically(script, kScript));
    VAMP_CHECK_STATUS(write_text_atomically(obj, obj_of(project)));
    if (mkfifo(pipe.c_str(), 0600) != 0) return fail(ErrorKind::io, pipe.string(), "", "a pipe", "none");
    // Open for reading too, so that opening does not wait for Blender.
    blender->commands_ = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
    std::vector<std::string> words{"blender",
                                   "--factory-startup",
                                   "--window-geometry",
                                   "0",
                                   std::to_string(screen.height() - height),  // from below
                                   std::to_string(width),
                                   std::to_string(height),
                                   "--python-exit-code",
                                   "1",
                                   "--python",
                                   script.string(),
                                   "--",
                                   obj.string(),
                                   pipe.string(),
                                   material_name(material)};
    const Light& light = project.lights[0];
    const Camera& camera = project.camera;
    for (const vec3& p : {camera.eye, camera.target})
      for (int i = 0; i < 3; ++i) words.push_back(fmt::format("{}", p[i]));
    words.push_back(fmt::format("{}", glm::radians(camera.fov_degrees)));
    for (int i = 0; i < 3; ++i) words.push_back(fmt::format("{}", light.center[i]));
    words.push_back(fmt::format("{}", light.size.x));
    VAMP_TRY(blender->program_,
             Child::start(words, {"DISPLAY=" + screen.display(), "WAYLAND_DISPLAY=", "HOME=" + folder.string()},
                          folder / "blender.log"));
    // Its own lines, about what it reads, come before ours.
    const auto start = Clock::now();
    Area view;
    while (view.width == 0) {
      const Child::Line line = blender->program_->line_after(blender->read_, 1);
      if (line.number != blender->read_) {
        std::istringstream numbers(line.text);
        if (!(numbers >> view.x >> view.y >> view.width >> view.height)) view = {};
      }
      blender->read_ = line.number;
      if (view.width == 0 && !blender->program_->running()) return no_blender("it did not start");
      if (seconds_since(start) > 90) return no_blender("no view after 90 seconds");
    }
    if (view.width != width || view.height != height)
      return no_blender(fmt::format("a view of {} x {}", view.width, view.height));
    watch_picture(screen, view);
    return blender;
  }
  ~Blender() {
    program_.reset();
    if (commands_ >= 0) close(commands_);
  }
  Blender(const Blender&) = delete;
  Blender& operator=(const Blender&) = delete;

  Result<Answers> measure(char command, int rounds) {
    Answers answers;
    for (int round = -kWarmRounds; round < rounds; ++round) {
      if (!rests()) return no_blender("a view that does not rest");
      screen_.remember();
      if (write(commands_, &command, 1) != 1) return no_blender("a pipe that takes nothing");
      const Screen::Seen seen = screen_.wait_for_change(10);
      const Child::Line line = program_->line_after(read_, 5);
      if (line.number == read_) return no_blender("no answer to a command");
      read_ = line.number;
      if (round < 0) continue;
      const double edited = 1e-9 * std::strtod(line.text.c_str(), nullptr);
      const double ms = 1e3 * (std::chrono::duration<double>(seen.at.time_since_epoch()).count() - edited);
      // A change from before the edit is a late sample of the last picture.
      if (seen.changed && ms > 0) {
        answers.ms.push_back(ms);
      } else if (++answers.unanswered > rounds / 2) {
        return no_blender("no changed pixels after edits");
      }
    }
    return answers;
  }

 private:
  explicit Blender(Screen& screen) : screen_(screen) {}

  // Whether it comes to rest: its samples are shown some tenths of a second apart, so its work is looked at, too.
  bool rests() {
    constexpr double kWhile = 0.4, kIdle = 0.3;  // s; of a core
    for (int attempt = 0; attempt < 100; ++attempt) {
      const double before = program_->cpu_seconds();
      const bool still = screen_.wait_for_rest(kWhile, kWhile + 0.1);
      if (still && program_->cpu_seconds() - before < kIdle * kWhile) return true;
    }
    return false;
  }

  Screen& screen_;
  std::unique_ptr<Child> program_;
  uint64_t read_ = 0;
  int commands_ = -1;
};

}  // namespace

Result<CyclesAnswers> measure_cycles(Screen& screen, const fs::path& folder, const Project& project, int material,
                                     int width, int height, int rounds) {
  VAMP_TRY(const auto blender, Blender::open(screen, folder, project, material, width, height));
  CyclesAnswers answers;
  VAMP_TRY(answers.material, blender->measure('m', rounds));
  const int fewer = std::max(rounds / 2, 1);
  VAMP_TRY(answers.light, blender->measure('l', fewer));
  VAMP_TRY(answers.view, blender->measure('v', fewer));
  return answers;
}

}  // namespace vamp
