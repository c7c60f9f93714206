#include "editor/panels/history_panel.h"

#include "editor/widgets/theme.h"

namespace vamp::ui {

void HistoryPanel::draw(PanelContext& context) {
  Document& document = context.document;
  const std::vector<std::string> names = document.step_names();
  const size_t done = document.steps_done();
  const bool moved = revision_ != document.revision();
  revision_ = document.revision();
  size_t wanted = done;
  const auto line = [&](const char* text, size_t step) {
    ImGui::PushID(static_cast<int>(step));
    // What was taken back is dim, where we are is bright.
    const ImU32 colour = step == done ? theme().text : step < done ? theme().label : theme().dim;
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    if (ImGui::Selectable(text, step == done)) wanted = step;
    ImGui::PopStyleColor();
    if (step == done && moved) ImGui::SetScrollHereY(1);
    ImGui::PopID();
  };
  line("As it was opened", 0);
  for (size_t i = 0; i < names.size(); ++i) line(names[i].c_str(), i + 1);
  if (wanted != done) document.go_to_step(wanted);
}

}  // namespace vamp::ui
