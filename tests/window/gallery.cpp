// Shows every widget: gallery [--size WxH] [--scale S] [--show PANEL] [--do ACTION]; without a window with
// --picture FILE.ppm or --times; in a window with [--ui cpu|vulkan] [--validate].
#include <imgui.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

#include "app/window/cpu_rasteriser.h"
#include "app/window/window.h"
#include "editor/widgets/notify.h"
#include "editor/widgets/theme.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "tests/window/gallery_content.h"

namespace {

using namespace vamp;

struct Options {
  std::string picture;
  std::string action;
  std::string panel;
  int width = 1600;
  int height = 1000;
  float scale = 1;
  float mouse_x = -1, mouse_y = -1;
  std::string renderer;
  bool times = false;
  bool validate = false;
};

Options read_options(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const char* value = i + 1 < count ? words[i + 1] : "";
    if (word == "--picture") options.picture = value;
    if (word == "--do") options.action = value;
    if (word == "--show") options.panel = value;
    if (word == "--size") std::sscanf(value, "%dx%d", &options.width, &options.height);
    if (word == "--mouse") std::sscanf(value, "%f,%f", &options.mouse_x, &options.mouse_y);
    if (word == "--scale") options.scale = std::stof(value);
    if (word == "--ui") options.renderer = value;
    if (word == "--validate") options.validate = true;
    if (word == "--times") options.times = true;
  }
  return options;
}

// The time this thread has worked, so that other programs do not count.
double now_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

// Draws frames without a window and keeps the last as a picture.
int draw_to_file(const Options& options) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = ImVec2(static_cast<float>(options.width), static_cast<float>(options.height));
  ui::apply_theme(options.scale);
  window::Textures textures;
  textures.add_fonts(*io.Fonts);
  gallery::Gallery gallery(textures);
  if (!options.panel.empty()) gallery.dock().show(options.panel);
  window::CpuRasteriser raster(textures);
  std::vector<uint32_t> pixels(static_cast<size_t>(options.width) * static_cast<size_t>(options.height));
  const window::Canvas canvas{pixels.data(), options.width, options.height, static_cast<size_t>(options.width)};
  io.DeltaTime = 0.1f;
  io.MousePos = ImVec2(options.mouse_x, options.mouse_y);
  for (int frame = 0; frame < (options.times ? 400 : 20); ++frame) {
    const double start = now_ms();
    ImGui::NewFrame();
    gallery.draw();
    if (frame == 3 && !options.action.empty()) gallery.actions().run(options.action);
    ImGui::Render();
    const double built = now_ms();
    if (options.times && frame % 2 == 0) raster.forget();
    const auto changed = raster.draw(*ImGui::GetDrawData(), canvas);
    if (options.times) {
      std::printf("frame %d: ImGui %.2f ms, raster %.2f ms, %zu rectangles, %d vertices\n", frame, built - start,
                  now_ms() - built, changed.size(), ImGui::GetDrawData()->TotalVtxCount);
    }
  }
  if (!options.picture.empty()) {
    std::ofstream file(options.picture, std::ios::binary);
    file << "P6\n" << options.width << " " << options.height << "\n255\n";
    for (const uint32_t p : pixels) {
      const char rgb[3] = {static_cast<char>(p >> 16), static_cast<char>(p >> 8), static_cast<char>(p)};
      file.write(rgb, 3);
    }
  }
  ImGui::DestroyContext();
  return 0;
}

// A real window until it is closed; reports on stdout what happened, for scripts.
int show_in_window(const Options& options) {
  start_log("info");
  const auto refuse = [](const Error& error) {
    std::fprintf(stderr, "%s\n", error.message().c_str());
    return static_cast<int>(error.kind);
  };
  auto extensions = window::Window::instance_extensions();
  if (!extensions) return refuse(extensions.error());
  gpu::Options how;
  how.validate = options.validate;
  how.instance_extensions = *extensions;
  how.device_extensions = window::Window::device_extensions();
  auto device = gpu::Device::create(how);
  if (!device) return refuse(device.error());
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  size_t messages = 0;
  {
    window::Textures textures;
    gallery::Gallery gallery(textures);
    window::WindowOptions wanted;
    wanted.title = "Gallery";
    wanted.place.width = options.width;
    wanted.place.height = options.height;
    wanted.scale = options.scale;
    if (options.renderer == "vulkan") wanted.renderer = window::UiRenderer::vulkan;
    auto window = window::Window::open(**device, textures, wanted);
    if (!window) return refuse(window.error());
    window::Hooks hooks;
    hooks.rescale = ui::apply_theme;
    hooks.frame = [&] {
      gallery.draw();
      if (gallery.quit_wanted()) (*window)->quit();
    };
    hooks.wake_after = ui::take_frame_request;
    hooks.close_wanted = [&] { gallery.actions().run("file.quit"); };
    hooks.dropped = [](const std::vector<std::string>& paths) {
      for (const std::string& path : paths) ui::notify(ui::Notice::info, path);
    };
    (*window)->run(hooks);
    const window::FrameTimes& times = (*window)->times();
    std::printf("edits %d, undo steps %zu, frames %llu, presented %llu, build %.2f ms, draw %.2f ms, present %.2f ms\n",
                gallery.edits(), gallery.steps(), static_cast<unsigned long long>(times.frames),
                static_cast<unsigned long long>(times.presented), times.build_ms, times.draw_ms, times.present_ms);
    messages = (*device)->validation_messages().size();
    std::printf("validation messages %zu\n", messages);
  }
  ImGui::DestroyContext();
  return messages == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  const Options options = read_options(count, words);
  return options.picture.empty() && !options.times ? show_in_window(options) : draw_to_file(options);
}
