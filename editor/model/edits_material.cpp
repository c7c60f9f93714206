#include "editor/model/edits_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <set>
#include <utility>

#include "engine/brdf/registry.h"
#include "engine/project/file_reference.h"
#include "engine/project/fit_checksum.h"
#include "engine/project/limits.h"

namespace vamp {
namespace {

constexpr float kMinNormalZ = 0.05f;  // 87 degrees: beyond it a frame sees next to nothing of the upper hemisphere

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

MaterialInstance* material_of(Project& project, int index) {
  const bool there = index >= 0 && static_cast<size_t>(index) < project.materials.size();
  return there ? &project.materials[static_cast<size_t>(index)] : nullptr;
}
const MaterialInstance* material_of(const Project& project, int index) {
  const bool there = index >= 0 && static_cast<size_t>(index) < project.materials.size();
  return there ? &project.materials[static_cast<size_t>(index)] : nullptr;
}

bool exists(const Spmm& fit, BasisKey key) {
  return key.cluster >= 0 && static_cast<size_t>(key.cluster) < fit.clusters.size() && key.basis >= 0 &&
         static_cast<size_t>(key.basis) < fit.dictionary.size();
}

// Rows that are equal to the fit again are not stored.
void tidy(const Spmm& fit, BasisKey key, BasisEdit& row) {
  const Basis& fitted = fit.dictionary[static_cast<size_t>(key.basis)];
  if (row.lobe == fitted.lobe) row.lobe.reset();
  if (row.normal == fitted.normal) row.normal.reset();
  if (row.psi == fitted.psi) row.psi.reset();
}

std::string key_text(const Rows& rows) {
  if (rows.keys.empty()) return {};
  const BasisKey first = rows.keys.front(), last = rows.keys.back();
  return fmt::format("{}:{}.{}-{}.{}x{}", rows.material, first.cluster, first.basis, last.cluster, last.basis,
                     rows.keys.size());
}

// An edit that does `change(row, fit, key)` to each row.
template <class Change>
Edit edit_rows(const Project& project, Rows rows, std::string_view what, bool locked_too, Change change) {
  Edit edit;
  edit.name = fmt::format("{} of {}", what, describe(project, rows));
  edit.merge_key = fmt::format("{} {}", what, key_text(rows));
  edit.change = [rows = std::move(rows), locked_too, change = std::move(change)](Project& target) {
    MaterialInstance* material = material_of(target, rows.material);
    if (material == nullptr) return;
    for (const BasisKey key : rows.keys) {
      if (!exists(*material->fit, key)) continue;
      BasisEdit row = material->edits.edit_of(key);
      if (row.lock && rows.keys.size() > 1 && !locked_too) continue;
      change(row, *material->fit, key);
      tidy(*material->fit, key, row);
      material->edits.set(key, row);
    }
  };
  return edit;
}

Lobe lobe_of(const BasisEdit& row, const Spmm& fit, BasisKey key) {
  return row.lobe.value_or(fit.dictionary[static_cast<size_t>(key.basis)].lobe);
}

// The designer's word for a parameter: that of the first row that has it.
std::string parameter_label(const Project& project, const Rows& rows, std::string_view parameter) {
  if (const MaterialInstance* material = material_of(project, rows.material))
    for (const BasisKey key : rows.keys) {
      if (!exists(*material->fit, key)) continue;
      const Lobe lobe = lobe_of(material->edits.edit_of(key), *material->fit, key);
      if (const ParameterRow* row = find_parameter(lobe.model, lobe.variant, parameter)) return std::string(row->label);
    }
  return std::string(parameter);
}

template <class Change>
Edit edit_material(const Project& project, int index, std::string_view what, Change change) {
  const MaterialInstance* material = material_of(project, index);
  Edit edit;
  edit.name = fmt::format("{} of {}", what, material != nullptr ? material->name : "a material");
  edit.merge_key = fmt::format("{} {}", what, index);
  edit.change = [index, change = std::move(change)](Project& target) {
    if (MaterialInstance* found = material_of(target, index)) change(*found);
  };
  return edit;
}

}  // namespace

Rows one_row(int material, BasisKey key) { return {material, {key}}; }

Rows rows_of_cluster(const Project& project, int material, int cluster) {
  Rows rows{material, {}};
  if (const MaterialInstance* found = material_of(project, material))
    for (int basis = 0; basis < static_cast<int>(found->fit->dictionary.size()); ++basis)
      rows.keys.push_back({cluster, basis});
  return rows;
}

Rows rows_of_basis(const Project& project, int material, int basis) {
  Rows rows{material, {}};
  if (const MaterialInstance* found = material_of(project, material))
    for (int cluster = 0; cluster < static_cast<int>(found->fit->clusters.size()); ++cluster)
      rows.keys.push_back({cluster, basis});
  return rows;
}

Rows rows_of_material(const Project& project, int material) {
  Rows rows{material, {}};
  if (const MaterialInstance* found = material_of(project, material))
    for (int cluster = 0; cluster < static_cast<int>(found->fit->clusters.size()); ++cluster)
      for (int basis = 0; basis < static_cast<int>(found->fit->dictionary.size()); ++basis)
        rows.keys.push_back({cluster, basis});
  return rows;
}

std::string cluster_name(const MaterialInstance& material, int cluster) {
  if (const auto renamed = material.edits.cluster_names.find(cluster); renamed != material.edits.cluster_names.end())
    return renamed->second;
  if (cluster < 0 || static_cast<size_t>(cluster) >= material.fit->clusters.size()) return {};
  const std::string& name = material.fit->clusters[static_cast<size_t>(cluster)].name;
  return name.empty() ? fmt::format("cluster {}", cluster) : name;
}

std::string describe(const Project& project, const Rows& rows) {
  const MaterialInstance* material = material_of(project, rows.material);
  if (material == nullptr || rows.keys.empty()) return "nothing";
  const BasisKey key = rows.keys.front();
  if (rows.keys.size() > 1 || !exists(*material->fit, key))
    return fmt::format("{} functions of {}", rows.keys.size(), material->name);
  const std::string& name = material->fit->dictionary[static_cast<size_t>(key.basis)].name;
  return fmt::format("{} in {}", name.empty() ? fmt::format("function {}", key.basis) : name,
                     cluster_name(*material, key.cluster));
}

Edit set_gain(const Project& project, Rows rows, vec3 gain) {
  return edit_rows(project, std::move(rows), "Weight", false, [gain](BasisEdit& row, const Spmm&, BasisKey) {
    if (finite(gain)) row.gain = glm::clamp(gain, vec3(0), vec3(kMaxGain));
  });
}

Edit set_parameter(const Project& project, Rows rows, std::string_view parameter, float value) {
  const std::string label = parameter_label(project, rows, parameter);
  return edit_rows(project, std::move(rows), label, false,
                   [name = std::string(parameter), value](BasisEdit& row, const Spmm& fit, BasisKey key) {
                     Lobe lobe = lobe_of(row, fit, key);
                     const ParameterRow* found = find_parameter(lobe.model, lobe.variant, name);
                     if (found == nullptr || !std::isfinite(value)) return;
                     lobe.params[found->slot] = std::clamp(value, found->min, found->max);
                     row.lobe = lobe;
                   });
}

Edit set_normal(const Project& project, Rows rows, vec3 normal) {
  return edit_rows(project, std::move(rows), "Normal", false, [normal](BasisEdit& row, const Spmm&, BasisKey) {
    const float length = glm::length(normal);
    if (!finite(normal) || !(length > 1e-6f) || !std::isfinite(length)) return;
    vec3 unit = normal / length;
    if (unit.z < kMinNormalZ) {
      // Down to the rim on the side it points to.
      const float across = std::sqrt(unit.x * unit.x + unit.y * unit.y);
      const float reach = std::sqrt(1 - kMinNormalZ * kMinNormalZ);
      unit = across > 0 ? vec3(unit.x * reach / across, unit.y * reach / across, kMinNormalZ) : vec3(0, 0, 1);
    }
    row.normal = glm::normalize(unit);
  });
}

Edit set_psi(const Project& project, Rows rows, float radians) {
  return edit_rows(project, std::move(rows), "Grain direction", false,
                   [radians](BasisEdit& row, const Spmm&, BasisKey) {
                     // One turn: the same look, and numbers that stay readable.
                     if (std::isfinite(radians)) row.psi = std::remainder(radians, glm::two_pi<float>());
                   });
}

Edit set_model(const Project& project, Rows rows, Model model, uint8_t variant) {
  return edit_rows(project, std::move(rows), "Model", false,
                   [model, variant](BasisEdit& row, const Spmm& fit, BasisKey key) {
                     if (variant >= model_row(model).variants.size()) return;
                     const Lobe lobe = lobe_of(row, fit, key);
                     row.lobe = lobe.model == model ? with_variant(lobe, variant) : default_lobe(model, variant);
                   });
}

Edit set_mute(const Project& project, Rows rows, bool mute) {
  return edit_rows(project, std::move(rows), mute ? "Mute" : "Unmute", false,
                   [mute](BasisEdit& row, const Spmm&, BasisKey) { row.mute = mute; });
}

Edit set_solo(const Project& project, Rows rows, bool solo) {
  return edit_rows(project, std::move(rows), solo ? "Solo" : "End solo", false,
                   [solo](BasisEdit& row, const Spmm&, BasisKey) { row.solo = solo; });
}

Edit set_lock(const Project& project, Rows rows, bool lock) {
  return edit_rows(project, std::move(rows), lock ? "Lock" : "Unlock", true,
                   [lock](BasisEdit& row, const Spmm&, BasisKey) { row.lock = lock; });
}

Edit reset_control(const Project& project, Rows rows, Control control) {
  return edit_rows(project, std::move(rows), "Reset", false, [control](BasisEdit& row, const Spmm&, BasisKey) {
    switch (control) {
      case Control::gain:
        row.gain = vec3(1);
        break;
      case Control::lobe:
        row.lobe.reset();
        break;
      case Control::normal:
        row.normal.reset();
        break;
      case Control::psi:
        row.psi.reset();
        break;
    }
  });
}

Edit reset_parameter(const Project& project, Rows rows, std::string_view parameter) {
  const std::string label = parameter_label(project, rows, parameter);
  return edit_rows(project, std::move(rows), "Reset " + label, false,
                   [name = std::string(parameter)](BasisEdit& row, const Spmm& fit, BasisKey key) {
                     Lobe lobe = lobe_of(row, fit, key);
                     const ParameterRow* found = find_parameter(lobe.model, lobe.variant, name);
                     if (found == nullptr) return;
                     const Lobe& fitted = fit.dictionary[static_cast<size_t>(key.basis)].lobe;
                     const bool same = fitted.model == lobe.model && fitted.variant == lobe.variant;
                     lobe.params[found->slot] = same ? fitted.params[found->slot] : found->fallback;
                     row.lobe = lobe;
                   });
}

Edit reset_rows(const Project& project, Rows rows) {
  return edit_rows(project, std::move(rows), "Reset", false, [](BasisEdit& row, const Spmm&, BasisKey) {
    const bool lock = row.lock;
    row = BasisEdit{};
    row.lock = lock;
  });
}

Edit reset_material(const Project& project, int material) {
  return edit_material(project, material, "Reset", [](MaterialInstance& target) {
    EditLayer kept;
    for (const auto& [key, row] : target.edits.bases)
      if (row.lock) kept.bases[key] = row;
    target.edits = std::move(kept);
  });
}

Edit rename_cluster(const Project& project, int material, int cluster, std::string name) {
  return edit_material(project, material, "Cluster name",
                       [cluster, name = name.substr(0, kMaxNameBytes)](MaterialInstance& target) {
                         if (!exists(*target.fit, {cluster, 0})) return;
                         if (name.empty() || name == target.fit->clusters[static_cast<size_t>(cluster)].name)
                           target.edits.cluster_names.erase(cluster);
                         else
                           target.edits.cluster_names[cluster] = name;
                       });
}

Edit rename_material(const Project& project, int material, std::string name) {
  return edit_material(project, material, "Name", [name = name.substr(0, kMaxNameBytes)](MaterialInstance& target) {
    if (!name.empty()) target.name = name;
  });
}

Edit become_preset(const Project& project, int material, const Preset& saved, const std::string& path) {
  std::set<std::string_view> taken;
  for (size_t i = 0; i < project.materials.size(); ++i)
    if (static_cast<int>(i) != material) taken.insert(project.materials[i].name);
  const std::string wanted = saved.name.substr(0, kMaxNameBytes - 8);
  std::string name = wanted;
  for (int i = 2; taken.contains(name); ++i) name = fmt::format("{} {}", wanted, i);
  Edit edit =
      edit_material(project, material, "Preset",
                    [name, path, fit = saved.fit, checksum = fit_checksum(*saved.fit)](MaterialInstance& target) {
                      target.name = name;
                      target.preset = make_reference(path);
                      target.model_part.clear();
                      // A model's own material is rounded when it is saved; a preset's tables stay as they are.
                      if (std::exchange(target.checksum, checksum) != checksum) target.fit = fit;
                    });
  edit.name = "Save preset " + saved.name;
  return edit;
}

Edit set_residual_terms(const Project& project, int material, int terms) {
  return edit_material(project, material, "Residual terms", [terms](MaterialInstance& target) {
    target.edits.residual_terms = std::clamp(terms, 0, kMaxResidualTerms);
  });
}

Edit set_residual_strength(const Project& project, int material, float strength) {
  return edit_material(project, material, "Residual strength", [strength](MaterialInstance& target) {
    if (std::isfinite(strength)) target.edits.residual_strength = std::clamp(strength, 0.0f, 2.0f);
  });
}

Edit set_residual_policy(const Project& project, int material, ResidualPolicy policy) {
  return edit_material(project, material, "Residual",
                       [policy](MaterialInstance& target) { target.edits.residual_policy = policy; });
}

}  // namespace vamp
