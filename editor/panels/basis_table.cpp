#include "editor/panels/basis_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "editor/model/edits_material.h"
#include "editor/panels/fit_figures.h"
#include "editor/panels/registry_rows.h"
#include "editor/widgets/colour.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/places.h"
#include "editor/widgets/theme.h"
#include "engine/material/tables.h"

namespace vamp::ui {

namespace {

constexpr float kSmall = 0.01f;  // of the cluster's energy: below it a row is folded away
constexpr float kMuch = 0.03f;   // from here on a row is shown even if it is a filler
constexpr size_t kMost = 10;     // rows that are shown unasked

size_t at(int index) { return static_cast<size_t>(index); }

// The mean weight of a function over the cluster's texels, after the edit.
vec3 mean_weight(const FitFigures& figures, const Spmm& fit, const EditLayer& edits, BasisKey key) {
  const size_t cluster = at(key.cluster);
  const double texels = std::max(figures.sums.texels[cluster], 1.0);
  return vec3(figures.sums.weights[cluster * fit.dictionary.size() + at(key.basis)] / texels) * edits.edit_of(key).gain;
}

bool differs(const EditLayer& edits, BasisKey key) {
  BasisEdit edit = edits.edit_of(key);
  edit.lock = false;
  return !(edit == BasisEdit{});
}

void weight_cell(const vec3& weight, const vec3& gain) {
  const ImVec2 at_pixel = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 low(at_pixel.x, at_pixel.y + (line - px(13)) / 2), high(low.x + px(22), low.y + px(13));
  const float largest = std::max({weight.x, weight.y, weight.z});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ImGui::GetColorU32(screen_colour(largest > 0 ? weight / largest : vec3(0))), px(2));
  list.AddRect(low, high, ImGui::GetColorU32(theme().field_border), px(2));
  ImGui::Dummy(ImVec2(px(22), line));
  ImGui::SameLine(0, px(4));
  ImGui::Text("%.2f", static_cast<double>(std::max({gain.x, gain.y, gain.z})));
}

}  // namespace

void BasisTable::refresh(const PanelContext& context) {
  const ProjectPtr project = context.document.project();
  const MaterialInstance& material = *find_material(*project, context.selection.material);
  const bool other = fit_ != material.fit || cluster_ != context.selection.cluster;
  if (!other && edits_ == material.edits) return;
  fit_ = material.fit;
  edits_ = material.edits;
  cluster_ = context.selection.cluster;
  const FitFigures& figures = fit_figures(fit_);
  energy_ = contributions(*fit_, edits_, cluster_, figures.sums);
  if (other) fitted_energy_ = contributions(*fit_, EditLayer{}, cluster_, figures.sums);
  // Rows do not change places under the user's hand.
  if (!other && context.document.in_gesture()) return;
  order_ = figures.bases[at(cluster_)];
  const bool solo = any_solo(edits_, cluster_);  // then all others are at 0: the fit's order says more
  std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) {
    return solo ? fitted_energy_[at(a)] > fitted_energy_[at(b)] : energy_[at(a)] > energy_[at(b)];
  });
}

bool BasisTable::is_folded(const PanelContext& context, size_t place) const {
  const int basis = order_[place];
  const bool small = energy_[at(basis)] < kSmall && fitted_energy_[at(basis)] < kSmall;
  // A fit calls what stands for shadows and masking, not for a layer of the material, "filler".
  // It is folded away while it is small: what holds much of the light is pulled, whatever it is called.
  const bool filler = fit_->dictionary[at(basis)].name.starts_with("filler") && energy_[at(basis)] < kMuch;
  return (small || filler || place >= kMost) && basis != context.selection.basis && !differs(edits_, {cluster_, basis});
}

void BasisTable::draw(PanelContext& context) {
  refresh(context);
  if (std::find(order_.begin(), order_.end(), context.selection.basis) == order_.end()) {
    context.selection.basis = order_.empty() ? -1 : order_.front();
  }
  std::vector<int> rows;  // a click on a switch may sort anew
  for (size_t place = 0; place < order_.size(); ++place)
    if (all_ || !is_folded(context, place)) rows.push_back(order_[place]);
  shown_ = rows.size();
  const std::string title = fmt::format("Bases by contribution — {} of {} shown", shown_, order_.size());
  section(title.c_str());
  gap(2);
  if (order_.empty()) {
    ImGui::TextDisabled("No texel of this cluster has a function");
    return;
  }
  if (ImGui::BeginTable("bases", 5)) {
    ImGui::TableSetupColumn("M S L", ImGuiTableColumnFlags_WidthFixed, px(56));
    ImGui::TableSetupColumn("Basis", ImGuiTableColumnFlags_WidthStretch, 1.45f);
    ImGui::TableSetupColumn("Model", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("Weight", ImGuiTableColumnFlags_WidthFixed, px(58));
    ImGui::TableSetupColumn("Energy", ImGuiTableColumnFlags_WidthFixed, px(66));
    ImGui::TableNextRow();
    for (const char* head : {" M   S   L", "Basis", "Model", "Weight", "Energy"}) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", head);
    }
    for (const int basis : rows) draw_row(context, basis);
    ImGui::EndTable();
  }
  if (all_ || shown_ < order_.size()) {
    const std::string more = all_ ? "Fold small ones" : fmt::format("{} more", order_.size() - shown_);
    if (ImGui::SmallButton(more.c_str())) all_ = !all_;
    hover_text("Functions that carry little of the cluster's light, and those that only fill shadows");
  }
  gap(2);
}

void BasisTable::draw_row(PanelContext& context, int basis) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const int index = context.selection.material;
  const MaterialInstance& material = *find_material(*project, index);
  const BasisKey key{cluster_, basis};
  const BasisEdit edit = material.edits.edit_of(key);
  const Basis shown = effective_basis(*material.fit, material.edits, key);
  const bool selected = context.selection.basis == basis;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(basis);
  if (row_selectable("##row", selected, px(18))) context.selection.basis = basis;
  const Rows row = one_row(index, key);
  if (icon_button("##mute", Icon::mute, "Mute: as if the function were not there", edit.mute, theme().changed)) {
    document.edit(set_mute(*project, row, !edit.mute));
  }
  ImGui::SameLine(0, px(2));
  if (icon_button("##solo", Icon::solo, "Solo: only this function of the cluster", edit.solo, theme().changed)) {
    document.edit(set_solo(*project, row, !edit.solo));
  }
  ImGui::SameLine(0, px(2));
  if (icon_button("##lock", edit.lock ? Icon::lock : Icon::unlocked, "Lock: guards the function against edits",
                  edit.lock)) {
    document.edit(set_lock(*project, row, !edit.lock));
  }
  ImGui::TableNextColumn();
  const std::string name = shown.name.empty() ? fmt::format("function {}", basis) : shown.name;
  cell_text(name.c_str(), differs(material.edits, key) ? theme().changed : 0);
  note_place(name.c_str(), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  ImGui::TableNextColumn();
  cell_text(std::string(model_row(shown.lobe.model).label).c_str());
  if (ImGui::IsItemHovered()) hover_text(model_text(shown.lobe).c_str());
  ImGui::TableNextColumn();
  weight_cell(mean_weight(fit_figures(material.fit), *material.fit, material.edits, key), edit.gain);
  ImGui::TableNextColumn();
  energy_bar(energy_[at(basis)], selected);
  ImGui::PopID();
}

}  // namespace vamp::ui
