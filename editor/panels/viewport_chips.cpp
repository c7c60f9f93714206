// The texts over the picture: what the renderer does, what the mouse is over.
#include <fmt/format.h>

#include <algorithm>

#include "editor/panels/fit_figures.h"
#include "editor/panels/viewport_panel.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

void chip(ImVec2 low, const std::string& text, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 high(low.x + size.x + px(16), low.y + size.y + px(9));
  list.AddRectFilled(low, high, IM_COL32(24, 24, 24, 230), px(2));
  list.AddText(ImVec2(low.x + px(8), low.y + px(4)), colour, text.c_str());
}

}  // namespace

std::string status_text(const RenderStatus& status) {
  std::string text = fmt::format("{} {}", status.samples, status.samples == 1 ? "sample" : "samples");
  text += fmt::format(" · {:.1f} s", status.seconds);
  if (status.noise >= 0) text += fmt::format(" · noise {:.2g} %", static_cast<double>(status.noise) * 100);
  if (status.ms_per_sample > 0)
    text += fmt::format(" · {:.{}f} ms a sample", status.ms_per_sample, status.ms_per_sample < 10 ? 1 : 0);
  if (!status.device.empty()) text += " · " + status.device.substr(0, status.device.find(" ("));
  if (status.finished) text += " · done";
  return text;
}

std::string pick_text(const Project& project, const Pick& pick) {
  if (pick.part < 0 || static_cast<size_t>(pick.part) >= project.parts.size()) return {};
  const PartState& part = project.parts[static_cast<size_t>(pick.part)];
  std::string text = part.name;
  // As the renderer saw it a moment ago: the material may be another one by now.
  const MaterialInstance* material = find_material(project, part.material);
  if (material == nullptr || pick.cluster < 0 || static_cast<size_t>(pick.cluster) >= material->fit->clusters.size()) {
    return text;
  }
  const size_t bases = fit_figures(material->fit).bases[static_cast<size_t>(pick.cluster)].size();
  text += fmt::format(" · {} · {} {}", cluster_title(*material, pick.cluster), bases, bases == 1 ? "basis" : "bases");
  return text;
}

void ViewportPanel::draw_chips(const PanelContext& context, ImVec2 low, ImVec2 size, bool over) const {
  const ImVec2 corner(low.x + px(10), low.y + px(8));
  if (!context.status.error.empty()) {
    chip(corner, context.status.error, theme().error);
  } else if (context.status.samples > 0 || context.status.ms_per_sample > 0) {
    chip(corner, status_text(context.status), theme().text);
  } else {
    // At the very first start the driver compiles for some seconds.
    chip(corner, context.session == nullptr ? "The renderer is starting" : "The picture is being prepared",
         theme().dim);
  }
  if (!over) return;
  const std::string text = pick_text(*context.document.project(), context.hover);
  if (text.empty()) return;
  // Beside the mouse, inside the picture.
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 room = ImGui::CalcTextSize(text.c_str());
  const float right = low.x + size.x - room.x - px(24);
  const float x = std::max(low.x, std::min(mouse.x + px(18), right));
  const float y = mouse.y - px(36) > low.y + px(40) ? mouse.y - px(36) : mouse.y + px(22);
  chip(ImVec2(x, y), text, theme().text);
}

}  // namespace vamp::ui
