#include "editor/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

namespace vamp::ui {

namespace {

namespace fs = std::filesystem;

Theme g_theme;
double g_frame_request = std::numeric_limits<double>::infinity();

// Latin, Greek, Cyrillic (file names), punctuation, sub- and superscripts, arrows, mathematics, shapes, check marks.
const ImWchar kGlyphs[] = {0x0020, 0x017f, 0x0370, 0x03ff, 0x0400, 0x045f, 0x2010, 0x2027, 0x2030,
                           0x2044, 0x2070, 0x2094, 0x2190, 0x21ff, 0x2200, 0x22ff, 0x2300, 0x2300,
                           0x25a0, 0x25ff, 0x2610, 0x2612, 0x2713, 0x2717, 0};

// The first of the names that exists under the usual font folders.
std::string find_font(std::initializer_list<const char*> names) {
  const char* home = std::getenv("HOME");
  const std::string own = std::string(home != nullptr ? home : "") + "/.local/share/fonts";
  const std::string folders[] = {
      "/usr/share/fonts/truetype/dejavu",     "/usr/share/fonts/dejavu-sans-fonts",    "/usr/share/fonts/TTF",
      "/usr/share/fonts/truetype/liberation", "/usr/share/fonts/truetype/liberation2", own};
  for (const char* name : names) {
    for (const std::string& folder : folders) {
      std::error_code ignored;
      const fs::path path = fs::path(folder) / name;
      if (fs::is_regular_file(path, ignored)) return path.string();
    }
  }
  return {};
}

ImFont* add_font(const std::string& path, float size) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  ImFontConfig config;
  // Whole pixels and no oversampling: text stays crisp and is copied texel by texel.
  config.OversampleH = 1;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  if (!path.empty()) {
    if (ImFont* font = atlas.AddFontFromFileTTF(path.c_str(), size, &config, kGlyphs)) return font;
  }
  config.SizePixels = size;
  return atlas.AddFontDefault(&config);
}

void load_fonts(float scale) {
  ImGui::GetIO().Fonts->Clear();
  const std::string regular = find_font({"DejaVuSans.ttf", "LiberationSans-Regular.ttf"});
  std::string bold = find_font({"DejaVuSans-Bold.ttf", "LiberationSans-Bold.ttf"});
  if (bold.empty()) bold = regular;
  g_theme.regular = add_font(regular, std::round(15 * scale));
  g_theme.bold = add_font(bold, std::round(15 * scale));
  g_theme.small_text = add_font(regular, std::round(13 * scale));
  ImGui::GetIO().FontDefault = g_theme.regular;
}

void set_colours() {
  const Theme& t = g_theme;
  ImVec4* c = ImGui::GetStyle().Colors;
  const auto set = [&](std::initializer_list<int> which, ImU32 colour) {
    for (const int i : which) c[i] = ImGui::ColorConvertU32ToFloat4(colour);
  };
  ImGui::StyleColorsDark();
  set({ImGuiCol_Text}, t.text);
  set({ImGuiCol_TextDisabled}, t.dim);
  set({ImGuiCol_WindowBg, ImGuiCol_ChildBg}, t.panel);
  set({ImGuiCol_PopupBg}, IM_COL32(43, 43, 43, 255));
  set({ImGuiCol_Border}, IM_COL32(70, 70, 70, 255));
  set({ImGuiCol_BorderShadow, ImGuiCol_TableRowBg}, IM_COL32(0, 0, 0, 0));
  set({ImGuiCol_FrameBg}, t.field);
  set({ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}, IM_COL32(36, 36, 36, 255));
  set({ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed, ImGuiCol_TableHeaderBg}, t.header);
  set({ImGuiCol_MenuBarBg}, IM_COL32(50, 50, 50, 255));
  set({ImGuiCol_ScrollbarBg}, IM_COL32(0, 0, 0, 0));
  set({ImGuiCol_ScrollbarGrab}, IM_COL32(82, 82, 82, 255));
  set({ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive}, IM_COL32(104, 104, 104, 255));
  set({ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}, t.accent_line);
  set({ImGuiCol_Button}, t.button);
  set({ImGuiCol_ButtonHovered}, t.button_hovered);
  set({ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderActive}, t.accent);
  set({ImGuiCol_HeaderHovered}, IM_COL32(64, 64, 64, 255));
  set({ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong}, IM_COL32(62, 62, 62, 255));
  set({ImGuiCol_TableRowBgAlt}, IM_COL32(255, 255, 255, 6));
  set({ImGuiCol_TextSelectedBg}, IM_COL32(60, 110, 165, 200));
  set({ImGuiCol_DragDropTarget}, t.changed);
  set({ImGuiCol_NavHighlight}, t.accent_line);
  set({ImGuiCol_ModalWindowDimBg}, IM_COL32(10, 10, 10, 120));
}

void set_sizes(float scale) {
  ImGuiStyle& s = ImGui::GetStyle();
  s = ImGuiStyle();
  s.WindowPadding = ImVec2(8, 6);
  s.FramePadding = ImVec2(8, 4);
  s.ItemSpacing = ImVec2(6, 4);
  s.ItemInnerSpacing = ImVec2(6, 4);
  s.CellPadding = ImVec2(4, 2);
  s.IndentSpacing = 16;
  s.ScrollbarSize = 11;
  s.WindowRounding = s.ChildRounding = 0;
  s.PopupRounding = s.FrameRounding = 2;
  s.ScrollbarRounding = 5;
  s.WindowBorderSize = s.PopupBorderSize = 1;
  s.ChildBorderSize = s.FrameBorderSize = 0;
  s.DisabledAlpha = 0.45f;
  s.AntiAliasedLinesUseTex = false;  // lines as polygons: one path in both renderers
  s.ScaleAllSizes(scale);
}

}  // namespace

const Theme& theme() { return g_theme; }

float px(float length) { return std::round(length * g_theme.scale); }

void apply_theme(float scale) {
  if (!std::isfinite(scale)) scale = 1;
  g_theme.scale = std::clamp(scale, 0.5f, 4.0f);
  load_fonts(g_theme.scale);
  set_sizes(g_theme.scale);
  set_colours();
}

void request_frame(double seconds) { g_frame_request = std::min(g_frame_request, seconds); }

double take_frame_request() { return std::exchange(g_frame_request, std::numeric_limits<double>::infinity()); }

}  // namespace vamp::ui
