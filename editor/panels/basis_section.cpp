#include "editor/panels/basis_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "editor/panels/apply_edit.h"
#include "editor/panels/fit_figures.h"
#include "editor/panels/lengths.h"
#include "editor/panels/registry_rows.h"
#include "editor/widgets/controls.h"

namespace vamp::ui {

namespace {

constexpr float kMaxTilt = 87;  // as far as edits let a frame normal lean

// What the rows are drawn from.
struct Shown {
  const MaterialInstance& material;
  BasisKey key;
  BasisEdit edit;
  Basis basis;          // after the edit
  const Basis& fitted;  // before it

  Shown(const Project& project, const Selection& selection)
      : material(*find_material(project, selection.material)),
        key{selection.cluster, selection.basis},
        edit(material.edits.edit_of(key)),
        basis(effective_basis(*material.fit, material.edits, key)),
        fitted(material.fit->dictionary[static_cast<size_t>(selection.basis)]) {}
};

// Whether `get` gives different values for the rows' functions.
template <class Get>
bool differ(const Shown& shown, const Rows& rows, Get get) {
  const auto first = get(shown.basis, shown.edit);
  return std::any_of(rows.keys.begin(), rows.keys.end(), [&](BasisKey key) {
    return get(effective_basis(*shown.material.fit, shown.material.edits, key), shown.material.edits.edit_of(key)) !=
           first;
  });
}

// The items of a list with their tooltips.
class Choices {
 public:
  void add(std::string_view name, std::string_view detail) {
    texts_.emplace_back(name);
    details_.emplace_back(detail);
  }
  // Good until the next call.
  std::span<const char* const> names() { return pointers(texts_, name_pointers_); }
  std::span<const char* const> details() { return pointers(details_, detail_pointers_); }

 private:
  static std::span<const char* const> pointers(const std::vector<std::string>& texts, std::vector<const char*>& out) {
    out.clear();
    for (const std::string& text : texts) out.push_back(text.c_str());
    return out;
  }
  std::vector<std::string> texts_, details_;
  std::vector<const char*> name_pointers_, detail_pointers_;
};

float half_turn(float radians) { return std::remainder(glm::degrees(radians), 360.0f); }

// The rows that an edit of the weight would reach: of several, locked ones are left alone.
WeightGroup weights_of(const Rows& rows, const Project& project) {
  WeightGroup group{rows.material, {}};
  const MaterialInstance* material = find_material(project, rows.material);
  if (material == nullptr) return {};
  for (const BasisKey key : rows.keys)
    if (rows.keys.size() == 1 || !material->edits.edit_of(key).lock) group.rows.push_back(key);
  return group;
}

}  // namespace

Rows rows_in_scope(const PanelContext& context, EditScope scope) {
  const Selection& selection = context.selection;
  Rows rows = one_row(selection.material, {selection.cluster, selection.basis});
  const ProjectPtr project = context.document.project();
  const MaterialInstance* material = find_material(*project, selection.material);
  if (scope == EditScope::this_cluster || material == nullptr) return rows;
  const FitFigures& figures = fit_figures(material->fit);
  for (size_t cluster = 0; cluster < figures.bases.size(); ++cluster) {
    const std::vector<int>& used = figures.bases[cluster];
    const bool uses = std::find(used.begin(), used.end(), selection.basis) != used.end();
    const BasisKey key{static_cast<int>(cluster), selection.basis};
    if (uses && key != rows.keys.front()) rows.keys.push_back(key);
  }
  return rows;
}

void BasisSection::draw(PanelContext& context, EditScope scope) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const Shown shown(*project, context.selection);
  const Rows rows = rows_in_scope(context, scope);
  context.weights_at_hand = weights_of(rows, *context.document.project());
  const std::string name = shown.basis.name.empty() ? fmt::format("function {}", shown.key.basis) : shown.basis.name;
  section(fmt::format("{} — {}{}", name, model_text(shown.basis.lobe), shown.edit.lock ? " (locked)" : "").c_str());
  gap(4);
  vec3 gain = shown.edit.gain;
  RowState state;
  state.locked = shown.edit.lock;
  state.mixed = differ(shown, rows, [](const Basis&, const BasisEdit& edit) { return edit.gain; });
  // Further than 4 only where it has been before.
  const MaterialInstance* before = find_material(*document.gesture_start(), rows.material);
  const vec3 start = before != nullptr ? before->edits.edit_of(shown.key).gain : gain;
  const float high = std::max({4.0f, start.x, start.y, start.z});
  const EditOf<vec3> weight =
      gain_row("Weight", gain, high, "Multiplies the fitted weights of this function, per colour channel.", state);
  apply_edit(document, weight, [&] {
    return weight.reset ? reset_control(*project, rows, Control::gain) : set_gain(*project, rows, gain);
  });
  draw_model(context, rows);
  draw_parameters(context, rows);
  draw_frame(context, rows);
}

void BasisSection::draw_model(PanelContext& context, const Rows& rows) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const Shown shown(*project, context.selection);
  const Lobe& lobe = shown.basis.lobe;
  RowState state;
  state.locked = shown.edit.lock;
  state.mixed = differ(shown, rows, [](const Basis& basis, const BasisEdit&) { return basis.lobe.model; });

  Choices choices;
  for (const ModelRow& row : models()) choices.add(row.label, row.tooltip);
  int model = static_cast<int>(lobe.model);
  const std::string about =
      fmt::format("{}\nAnother model starts from its own defaults.", model_row(lobe.model).tooltip);
  const EditOf<int> chosen = combo_row("Model", model, choices.names(), static_cast<int>(shown.fitted.lobe.model),
                                       about.c_str(), state, choices.details());
  apply_edit(document, chosen, [&] {
    if (chosen.reset) return reset_control(*project, rows, Control::lobe);
    const ModelRow& row = models()[static_cast<size_t>(model)];
    return set_model(*project, rows, row.model, row.default_variant);
  });

  const std::span<const VariantRow> variants = model_row(lobe.model).variants;
  if (variants.size() < 2) return;
  Choices kinds;
  for (const VariantRow& row : variants) kinds.add(row.label, fmt::format("{}\n{}", row.tooltip, row.citation));
  state.mixed = differ(shown, rows, [](const Basis& basis, const BasisEdit&) { return basis.lobe.variant; });
  const VariantRow& now = variants[std::min<size_t>(lobe.variant, variants.size() - 1)];
  const bool same_model = shown.fitted.lobe.model == lobe.model;
  const int initial = same_model ? shown.fitted.lobe.variant : model_row(lobe.model).default_variant;
  int variant = lobe.variant;
  const EditOf<int> other = combo_row("Variant", variant, kinds.names(), initial,
                                      fmt::format("{}\n{}", now.tooltip, now.citation).c_str(), state, kinds.details());
  apply_edit(document, other, [&] { return set_model(*project, rows, lobe.model, static_cast<uint8_t>(variant)); });
}

void BasisSection::draw_parameters(PanelContext& context, const Rows& rows) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const Shown shown(*project, context.selection);
  const Lobe& lobe = shown.basis.lobe;
  const bool as_fitted = shown.fitted.lobe.model == lobe.model && shown.fitted.lobe.variant == lobe.variant;
  for (const ParameterRow& row : model_row(lobe.model).parameters) {
    if (!row.belongs_to(lobe.variant) || row.hidden) continue;
    const RegistryRow words(row);
    RowState state;
    state.locked = shown.edit.lock;
    state.mixed = differ(shown, rows, [&](const Basis& basis, const BasisEdit&) {
      const ParameterRow* same = find_parameter(basis.lobe.model, basis.lobe.variant, row.name);
      return same != nullptr ? basis.lobe.params[same->slot] : lobe.params[row.slot];
    });
    const float initial = as_fitted ? shown.fitted.lobe.params[row.slot] : row.fallback;
    number_row(
        document, words.parameter(initial), lobe.params[row.slot] * words.factor,
        [&](float value) { return set_parameter(*project, rows, row.name, value / words.factor); },
        [&] { return reset_parameter(*project, rows, row.name); }, state);
  }
}

void BasisSection::draw_frame(PanelContext& context, const Rows& rows) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const Shown shown(*project, context.selection);
  RowState state;
  state.locked = shown.edit.lock;
  state.mixed = differ(shown, rows, [](const Basis& basis, const BasisEdit&) { return basis.psi; });
  Parameter angle = angle_row("Tangent angle ψ", "Turns the grain of this function about its frame normal.", -180, 180,
                              half_turn(shown.fitted.psi));
  angle.wraps = true;
  number_row(
      document, angle, half_turn(shown.basis.psi),
      [&](float value) { return set_psi(*project, rows, glm::radians(value)); },
      [&] { return reset_control(*project, rows, Control::psi); }, state);

  state.mixed = false;  // the disk shows the selected row's normal
  const vec3 normal = shown.basis.normal;
  if (glm::length(normal - normal_of_tilt_) > 1e-5f) {
    tilt_ = tilt_from_direction(normal);
    normal_of_tilt_ = normal;
  }
  Tilt tilt = tilt_;
  const Tilt initial = tilt_from_direction(shown.fitted.normal);
  const EditOf<Tilt> turned = direction_row("Frame normal", tilt, initial, kMaxTilt,
                                            "The normal that this function has in the texel's frame.", state);
  apply_edit(document, turned, [&] {
    const bool back = tilt.tilt == initial.tilt && tilt.azimuth == initial.azimuth;
    return back ? reset_control(*project, rows, Control::normal)
                : set_normal(*project, rows, direction_from_tilt(tilt));
  });
  if (turned) {
    tilt_ = tilt;
    normal_of_tilt_ = direction_from_tilt(tilt);
  }
}

}  // namespace vamp::ui
