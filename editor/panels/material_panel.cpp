#include "editor/panels/material_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/fit_figures.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

void MaterialPanel::draw(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  context.selection = valid_selection(*project, context.selection);
  const MaterialInstance* material = find_material(*project, context.selection.material);
  if (material == nullptr) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim);
    ImGui::TextWrapped("Nothing is selected. Click the model or a part in the list.");
    ImGui::PopStyleColor();
    return;
  }
  ImGui::PushID(context.selection.material);
  if (context.selection.cluster < 0) {
    // The largest: a part was chosen from the list.
    const std::vector<float>& share = fit_figures(material->fit).share;
    context.selection.cluster = static_cast<int>(std::max_element(share.begin(), share.end()) - share.begin());
  }
  gap(-6);
  section(fmt::format("{} — {}", material->name, cluster_title(*material, context.selection.cluster)).c_str());
  gap(4);
  draw_sharing(context);
  draw_cluster(context);
  gap(4);
  table_.draw(context);
  if (context.selection.basis >= 0) {
    ImGui::PushID(context.selection.cluster);
    ImGui::PushID(context.selection.basis);
    section_.draw(context, static_cast<EditScope>(scope_));
    ImGui::PopID();
    ImGui::PopID();
  }
  draw_resets(context);
  draw_residual(context);
  draw_buttons(context);
  ImGui::PopID();
}

// Who else changes with an edit, before anything is edited.
void MaterialPanel::draw_sharing(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  const Selection& selection = context.selection;
  std::string names;
  int users = 0;
  for (const PartState& part : project->parts) {
    if (part.material != selection.material) continue;
    names += (users++ == 0 ? "" : ", ") + part.name;
  }
  const RowColumns row = next_row();
  ImGui::SetCursorScreenPos(ImVec2(row.left, std::floor(row.top + (row.height - ImGui::GetTextLineHeight()) / 2)));
  ImGui::PushStyleColor(ImGuiCol_Text, users > 1 ? theme().changed : theme().dim);
  cell_text((users > 1 ? fmt::format("Shared by {} parts", users) : "Only on " + names).c_str());
  ImGui::PopStyleColor();
  if (users > 1) hover_text(("An edit changes all of them: " + names).c_str());
  constexpr const char* kUnique = "Make unique";
  const float width = ImGui::CalcTextSize(kUnique).x + px(20);
  ImGui::SetCursorScreenPos(ImVec2(row.number_end - width, std::floor(row.top + (row.height - px(22)) / 2)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(6), std::floor((px(22) - ImGui::GetFontSize()) / 2)));
  ImGui::BeginDisabled(selection.part < 0 || users < 2);
  if (ImGui::Button(kUnique, ImVec2(width, px(22))))
    context.document.edit(make_material_unique(*project, selection.part));
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  hover_text(users > 1 ? "Gives the selected part a copy of its own; edits leave the others alone then"
                       : "No other part shows this material");
  end_row(row);
}

void MaterialPanel::draw_cluster(PanelContext& context) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const int index = context.selection.material;
  const MaterialInstance& material = *find_material(*project, index);
  const std::vector<float>& share = fit_figures(material.fit).share;
  std::vector<std::string> texts;
  std::vector<const char*> names;
  for (size_t i = 0; i < share.size(); ++i) {
    texts.push_back(fmt::format("{} · {:.3g} %", cluster_title(material, static_cast<int>(i)),
                                static_cast<double>(share[i]) * 100));
  }
  for (const std::string& text : texts) names.push_back(text.c_str());
  int cluster = context.selection.cluster;
  if (combo_row("Cluster", cluster, names, -1,
                "Texels that look alike and are edited together, with their share of the texture. "
                "A click in the picture chooses one.")) {
    context.selection.cluster = cluster;
    context.selection.basis = -1;
  }
  ImGui::PushID(context.selection.cluster);
  std::string name = cluster_name(material, context.selection.cluster);
  const EditOf<std::string> named = text_row("Name", name, "What you call this cluster; empty for the fit's own name.");
  apply_edit(document, named, [&] { return rename_cluster(*project, index, context.selection.cluster, name); });
  ImGui::PopID();
  if (material.fit->clusters.size() > 1) {
    constexpr std::array<const char*, 2> kScopes{"This cluster", "All clusters with this basis"};
    combo_row("Apply to", scope_, kScopes, 0, "Which clusters an edit of a function changes; locked rows stay.");
  } else {
    scope_ = 0;
  }
}

void MaterialPanel::draw_resets(PanelContext& context) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const Selection selection = context.selection;
  gap(2);
  ImGui::BeginDisabled(selection.basis < 0);
  if (ImGui::Button("Reset row")) {
    document.edit(reset_rows(*project, rows_in_scope(context, static_cast<EditScope>(scope_))));
  }
  ImGui::EndDisabled();
  hover_text("The selected function as it was fitted");
  ImGui::SameLine();
  if (ImGui::Button("Reset cluster")) {
    document.edit(reset_rows(*project, rows_of_cluster(*project, selection.material, selection.cluster)));
  }
  hover_text("All functions of the cluster as they were fitted, but locked ones");
  ImGui::SameLine();
  if (ImGui::Button("Reset material")) document.edit(reset_material(*project, selection.material));
  hover_text("The whole material as it was fitted, but locked functions");
  gap(2);
}

void MaterialPanel::draw_residual(PanelContext& context) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const int index = context.selection.material;
  const MaterialInstance& material = *find_material(*project, index);
  section("Residual");
  gap(4);
  if (material.fit->residual.records.empty()) {
    ImGui::TextDisabled("None: the functions are the whole material");
    gap(2);
    return;
  }
  const int most = material.fit->residual.terms;
  if (most > 0) {
    const std::string format = fmt::format("%.0f of {}", most);
    Parameter terms{"PCA terms",
                    0,
                    static_cast<float>(most),
                    static_cast<float>(most),
                    format.c_str(),
                    "How many terms of the residual are added to its mean: fewer is faster and plainer.",
                    "terms"};
    terms.whole = true;
    const int now = std::min(material.edits.residual_terms, most);
    number_row(
        document, terms, static_cast<float>(now),
        [&](float value) { return set_residual_terms(*project, index, static_cast<int>(value)); },
        // All that there are, as the fit has it.
        [&] { return set_residual_terms(*project, index, kMaxResidualTerms); });
  }
  number_row(document, {"Strength", 0, 2, 1, "%.2f ×", "Scales what the functions do not explain.", "times"},
             material.edits.residual_strength,
             [&](float value) { return set_residual_strength(*project, index, value); });
  constexpr std::array<const char*, 3> kPolicies{"Follows the edit", "Stays as fitted", "Fades with the edit"};
  int policy = static_cast<int>(material.edits.residual_policy);
  const EditOf<int> chosen = combo_row(
      "After edits", policy, kPolicies, static_cast<int>(ResidualPolicy::follow),
      "What the residual does when functions are edited: it is scaled with their brightness, stays as fitted, "
      "or loses the share of functions whose shape was edited.");
  apply_edit(document, chosen,
             [&] { return set_residual_policy(*project, index, static_cast<ResidualPolicy>(policy)); });
  gap(2);
}

void MaterialPanel::draw_buttons(PanelContext& context) {
  gap(4);
  ImGui::BeginDisabled(!context.save_preset_as);
  if (ImGui::Button("Save preset…")) context.save_preset_as(context.selection.material);
  ImGui::EndDisabled();
  hover_text("Keeps this material with its edits in your library");
}

}  // namespace vamp::ui
