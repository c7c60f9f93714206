// Shows every widget: gallery --picture FILE.ppm [--size WxH] [--scale S] [--do ACTION] [--times].
#include <imgui.h>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>

#include "app/window/cpu_rasteriser.h"
#include "editor/widgets/theme.h"
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
  bool times = false;
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

}  // namespace

int main(int count, char** words) { return draw_to_file(read_options(count, words)); }
