#include "editor/panels/no_document.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr size_t kRecent = 6;

void draw_recent(PanelContext& context) {
  if (!context.recent_files || !context.open_file) return;
  std::vector<std::filesystem::path> files = context.recent_files();
  if (files.empty()) return;
  files.resize(std::min(files.size(), kRecent));
  gap(8);
  ImGui::TextDisabled("Opened lately");
  for (const std::filesystem::path& file : files) {
    ImGui::PushID(file.c_str());
    if (ImGui::Selectable(file.filename().c_str())) context.open_file(file);
    hover_text(file.c_str());
    ImGui::PopID();
  }
}

}  // namespace

void draw_no_document(PanelContext& context) {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float width = std::min(px(520), size.x - px(24));
  ImGui::SetCursorScreenPos(ImVec2(low.x + (size.x - width) / 2, low.y + std::floor(size.y * 0.25f)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(16), px(14)));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, theme().panel);
  if (ImGui::BeginChild("no document", ImVec2(width, size.y * 0.7f), false,
                        ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoBackground)) {
    ImGui::PushFont(theme().bold);
    ImGui::TextUnformatted("Nothing is open");
    ImGui::PopFont();
    gap(4);
    ImGui::PushStyleColor(ImGuiCol_Text, theme().error);
    ImGui::TextWrapped("%s", context.problem.c_str());
    ImGui::PopStyleColor();
    gap(10);
    if (primary_button("Open…", px(110)) && context.run) context.run("file.open");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere(-1);
    hover_text("A model (.glb, .gltf) or a project (.vampproj)");
    ImGui::SameLine();
    if (ImGui::Button("The shipped shoe", ImVec2(0, px(28))) && context.run) context.run("file.new");
    hover_text("The derby that comes with the program, in its materials");
    draw_recent(context);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace vamp::ui
