// What stands around the panels: tool bar, status bar, cards of running jobs.
#include <fmt/format.h>
#include <imgui.h>

#include "app/editor/editor.h"
#include "editor/panels/render_panel.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"

namespace vamp {
namespace {

// A button of the tool bar that opens a list.
bool begin_drop_down(const char* id, const std::string& label, const char* tooltip) {
  if (ui::tool_button((label + " ▾###" + id).c_str(), ImGui::IsPopupOpen(id), true, tooltip)) ImGui::OpenPopup(id);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  ImGui::SetNextWindowPos(ImVec2(low.x, high.y));
  return ImGui::BeginPopup(id);
}

}  // namespace

void Editor::draw_tools() {
  actions_.tool("file.open", "Open");
  actions_.tool("file.save");
  ui::tool_separator();
  actions_.tool("edit.undo", "↶ Undo");
  actions_.tool("edit.redo", "↷ Redo");
  ui::tool_separator();
  actions_.tool("view.pick");
  actions_.tool("view.orbit");
  actions_.tool("view.fit");
  ui::tool_separator();
  actions_.tool("view.outlines");
  actions_.tool("view.cluster", "Cluster");
  actions_.tool("render.pause");
  ui::tool_separator();
  actions_.tool("render.snapshot", "Snapshot…");
}

void Editor::draw_tools_right() {
  const Project& now = project();
  // Kept views first, then the standard ones.
  std::string camera = "free";
  for (const NamedCamera& kept : now.cameras)
    if (kept.camera == now.camera) camera = kept.name;
  if (begin_drop_down("cameras", "Camera: " + camera, "Kept views and standard views")) {
    for (const NamedCamera& kept : now.cameras) {
      ImGui::PushID(&kept);
      if (ImGui::MenuItem(kept.name.c_str(), nullptr, kept.camera == now.camera)) {
        document_.set_camera(Camera(kept.camera));
        ImGui::PopID();
        break;
      }
      ImGui::PopID();
    }
    if (!now.cameras.empty()) ImGui::Separator();
    for (const ui::StandardViewRow& row : ui::kStandardViews)
      if (ImGui::MenuItem(row.label)) ui::standard_view(context_, row.view);
    ImGui::EndPopup();
  }
  ImGui::SameLine();
  size_t on = 0;
  for (const Light& light : project().lights) on += light.on ? 1 : 0;
  std::string light = fmt::format("{} light{}", on, on == 1 ? "" : "s");
  if (project().environment.map) light += " + environment";
  if (begin_drop_down("lights", "Light: " + light, "Lights and environment")) {
    for (const char* id :
         {"light.studio", "light.rect", "light.disk", "light.sphere", "light.point", "light.spot", "light.directional",
          "file.environment", "light.show_environment", "light.remove_environment"}) {
      const ui::Action* action = actions_.find(id);
      if (ImGui::MenuItem(action->label.c_str(), nullptr, action->checked && action->checked(),
                          actions_.is_enabled(*action)))
        action->run();
    }
    ImGui::EndPopup();
  }
}

std::vector<ui::StatusItem> Editor::status_left() const {
  if (!files_.ready()) return {{files_.loading() ? "Loading…" : "Nothing is open"}};
  const RenderStatus& status = context_.status;
  std::vector<ui::StatusItem> items;
  if (context_.paused) items.push_back({"Paused", ui::theme().changed, "Render > Pause goes on"});
  if (!status.restart_reason.empty()) {
    const uint64_t all = static_cast<uint64_t>(viewport_width_) * static_cast<uint64_t>(viewport_height_);
    const std::string pulled =
        status.recombined_pixels > 0 ? fmt::format(", {} follow", ui::count_text(status.recombined_pixels)) : "";
    items.push_back({fmt::format("{} of {} pixels restarted{}: {}", ui::count_text(status.restarted_pixels),
                                 ui::count_text(all), pulled, status.restart_reason),
                     0,
                     "What the last edit began again, and what follows it with all samples (View > Restarted pixels)"});
  }
  if (status.bytes_uploaded > 0)
    items.push_back({ui::bytes_text(status.bytes_uploaded) + " to the GPU", ui::theme().dim, "Sent by the last edit"});
  return items;
}

std::vector<ui::StatusItem> Editor::status_right() const {
  if (!files_.ready()) return {};
  std::vector<ui::StatusItem> items;
  if (selection_.part >= 0 && selection_.material >= 0) {
    const Spmm& fit = *project().materials[static_cast<size_t>(selection_.material)].fit;
    const double scale = static_cast<double>(project().parts[static_cast<size_t>(selection_.part)].texture_scale);
    items.push_back({fmt::format("Texture {:.4g} × {:.4g} mm", static_cast<double>(fit.size_mm().x) * scale,
                                 static_cast<double>(fit.size_mm().y) * scale),
                     0, "What the selected part's texture measures before it repeats"});
  }
  const DisplaySettings& display = project().display;
  items.push_back(
      {fmt::format("sRGB · {} · {:.1f} EV", display.tone_map == ToneMap::pbr_neutral ? "PBR Neutral" : "linear",
                   static_cast<double>(display.exposure)),
       0, "How the linear picture is shown"});
  items.push_back({files_.saved_text(), 0, document_.path().empty() ? "No file yet" : document_.path().string()});
  return items;
}

// One small window for each running job, at the lower left: its name, how far it is, a button that stops it.
void Editor::draw_job_cards() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  float bottom = screen.y - ui::px(36);
  int number = 0;
  for (JobQueue* queue : {&exports_, &documents_}) {
    for (const JobQueue::Status& job : queue->jobs()) {
      const ImVec2 size(ui::px(300), ui::px(66));
      ImGui::SetNextWindowPos(ImVec2(screen.x / 2 - size.x / 2, bottom - size.y));
      ImGui::SetNextWindowSize(size);
      ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui::px(12), ui::px(10)));
      const std::string id = fmt::format("##job{}", number++);
      const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
      if (ImGui::Begin(id.c_str(), nullptr, flags)) {
        const std::string stage = job.progress->stage();
        const float fraction = job.progress->fraction();
        ImGui::TextUnformatted(stage.empty() ? job.name.c_str() : (job.name + ": " + stage).c_str());
        const std::string percent = fraction > 0 ? fmt::format("{:.0f} %", 100.0 * static_cast<double>(fraction)) : "…";
        ImGui::ProgressBar(fraction, ImVec2(ui::px(196), ui::px(20)), percent.c_str());
        ImGui::SameLine();
        if (ImGui::Button("Stop", ImVec2(ui::px(70), ui::px(20)))) job.progress->cancel();
      }
      ImGui::End();
      ImGui::PopStyleVar();
      bottom -= size.y + ui::px(8);
    }
  }
}

void Editor::draw_about() {
  if (!ui::begin_dialog("About Vamp", about_, 420)) return;
  ImGui::TextWrapped(
      "Vamp shapes how the leather and cloth of a shoe look: measured materials as sparse parametric mixtures (SPMM) "
      "with "
      "an edit layer over them, ray-traced as they are edited.");
  ui::gap(6);
  const RenderStatus& status = context_.status;
  ImGui::TextWrapped("%s\nUser interface drawn by %s\n%s on the device", status.device.c_str(), window_.renderer_name(),
                     ui::bytes_text(status.gpu_bytes).c_str());
  ui::gap(6);
  if (ui::primary_button("Close", ui::px(96))) about_ = false;
  if (!about_) ImGui::CloseCurrentPopup();
  ui::end_dialog();
}

}  // namespace vamp
