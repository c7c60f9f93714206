#pragma once
// What a designer does to a material, as named edits for Document::edit. Values out of range are clamped to the row's
// range, those that are not finite are left out, rows and materials that do not exist change nothing.
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document.h"
#include "engine/material/edit_layer.h"

namespace vamp {

// Rows of the basis table of one material. One row is edited as it was meant; of several, locked rows are left alone.
struct Rows {
  int material = -1;
  std::vector<BasisKey> keys;
};
Rows one_row(int material, BasisKey key);
Rows rows_of_cluster(const Project& project, int material, int cluster);
Rows rows_of_basis(const Project& project, int material, int basis);  // in every cluster
Rows rows_of_material(const Project& project, int material);

// "grain sheen in pore", "3 functions of calf": how an edit names what it is done to.
std::string describe(const Project& project, const Rows& rows);
std::string cluster_name(const MaterialInstance& material, int cluster);

Edit set_gain(const Project& project, Rows rows, vec3 gain);
// The parameter's value in the lobe's own measure (radians); rows whose model has no such parameter stay.
Edit set_parameter(const Project& project, Rows rows, std::string_view parameter, float value);
// Made unit; z is kept above 0.
Edit set_normal(const Project& project, Rows rows, vec3 normal);
Edit set_psi(const Project& project, Rows rows, float radians);
// Another model starts from its defaults; another variant keeps the parameters that both have.
Edit set_model(const Project& project, Rows rows, Model model, uint8_t variant);
Edit set_mute(const Project& project, Rows rows, bool mute);
Edit set_solo(const Project& project, Rows rows, bool solo);
Edit set_lock(const Project& project, Rows rows, bool lock);  // also of locked rows

// Back to the fit.
enum class Control { gain, lobe, normal, psi };
Edit reset_control(const Project& project, Rows rows, Control control);
Edit reset_parameter(const Project& project, Rows rows, std::string_view parameter);
Edit reset_rows(const Project& project, Rows rows);         // everything but lock
Edit reset_material(const Project& project, int material);  // all rows but locked ones, names and residual too

// An empty name is the fit's again.
Edit rename_cluster(const Project& project, int material, int cluster, std::string name);
Edit rename_material(const Project& project, int material, std::string name);
// It was saved as a preset, here as it is on disk: from now on it is an instance of that one and bears its name. What
// was edited meanwhile stays.
Edit become_preset(const Project& project, int material, const Preset& saved, const std::string& path);
Edit set_residual_terms(const Project& project, int material, int terms);
Edit set_residual_strength(const Project& project, int material, float strength);
Edit set_residual_policy(const Project& project, int material, ResidualPolicy policy);

}  // namespace vamp
