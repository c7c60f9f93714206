// Presets: what the fit holds and what it costs.
#include <set>

#include "app/commands/info.h"
#include "engine/brdf/registry.h"
#include "engine/material/preset.h"
#include "engine/material/tables.h"

namespace vamp {
namespace {

Json basis_info(const Basis& basis) {
  const ModelRow& model = model_row(basis.lobe.model);
  Json json;
  json["name"] = basis.name;
  json["model"] = model.name;
  if (model.variants.size() > 1) json["variant"] = model.variants[basis.lobe.variant].name;
  Json parameters = Json::object();
  for (const ParameterRow& row : model.parameters)
    if (!row.hidden && row.belongs_to(basis.lobe.variant))
      parameters[std::string(row.name)] = json_number(basis.lobe.params[row.slot] * row.display_factor());
  json["parameters"] = std::move(parameters);
  json["normal"] = {json_number(basis.normal.x), json_number(basis.normal.y), json_number(basis.normal.z)};
  json["psi_degrees"] = json_number(basis.psi * 57.29577951308232f);
  return json;
}

}  // namespace

Result<Json> preset_info(const fs::path& path) {
  VAMP_TRY(const Preset preset, load_preset(path));
  const Spmm& fit = *preset.fit;
  Json json;
  json["file"] = path.string();
  json["kind"] = "preset";
  json["name"] = preset.name;
  json["tags"] = preset.tags;
  json["size_mm"] = {json_number(fit.size_mm().x), json_number(fit.size_mm().y)};
  json["texels"] = {fit.width, fit.height};
  json["functions_per_texel"] =
      json_number(static_cast<float>(static_cast<double>(fit.entries.size()) / static_cast<double>(fit.texels.size())));
  std::set<std::string> models;
  for (const Basis& basis : fit.dictionary) models.insert(std::string(model_row(basis.lobe.model).name));
  json["models"] = models;
  const bool residual = !fit.residual.records.empty();
  json["residual"] =
      residual ? Json{{"terms", fit.residual.terms}, {"directions", fit.residual.directions.size()}} : Json();
  json["bytes_on_gpu"] = bytes_on_gpu(fit);
  json["edited_rows"] = preset.edits.bases.size();
  json["provenance"] = preset.provenance;
  json["licence"] = preset.licence;

  std::vector<size_t> texels(fit.clusters.size());
  for (const tables::Texel& texel : fit.texels) ++texels[texel.cluster_count & 255u];
  json["clusters"] = Json::array();
  for (size_t i = 0; i < fit.clusters.size(); ++i) {
    const auto renamed = preset.edits.cluster_names.find(static_cast<int>(i));
    const bool own = renamed == preset.edits.cluster_names.end();
    json["clusters"].push_back({{"name", own ? fit.clusters[i].name : renamed->second}, {"texels", texels[i]}});
  }
  json["bases"] = Json::array();
  for (const Basis& basis : fit.dictionary) json["bases"].push_back(basis_info(basis));
  return json;
}

}  // namespace vamp
