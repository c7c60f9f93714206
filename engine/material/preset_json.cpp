#include "engine/material/preset_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "engine/brdf/registry.h"
#include "engine/core/log.h"

namespace vamp {
namespace {

constexpr std::string_view kFormat = "vamp-material";
constexpr int kMajor = 1, kMinor = 0;
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr float kMaxGain = 1e4f, kMaxStrength = 2;
constexpr std::array<std::string_view, 3> kPolicies = {"follow", "keep", "fade"};
constexpr std::array<std::string_view, 14> kKnown = {
    "format",  "schema_version", "generator", "units",    "colour_space", "name",   "tags",
    "size_mm", "texels",         "basis",     "clusters", "residual",     "tables", "edits"};
constexpr std::array<std::string_view, 2> kKnownTexts = {"provenance", "licence"};

// The shortest decimal whose value divided by `factor` is the same float again.
Json converted(float value, double factor) {
  if (factor == 1) return json_number(value);
  const double exact = static_cast<double>(value) * factor;
  for (int digits = 1; digits < 17; ++digits) {
    const double rounded = std::strtod(fmt::format("{:.{}g}", exact, digits).c_str(), nullptr);
    if (static_cast<float>(rounded / factor) != value) continue;
    return rounded == std::trunc(rounded) && std::abs(rounded) < 1e7 ? Json(static_cast<int64_t>(rounded))
                                                                     : Json(rounded);
  }
  return exact;
}

Json from_vec(vec3 v) { return Json::array({json_number(v.x), json_number(v.y), json_number(v.z)}); }

Json from_lobe(const Lobe& lobe) {
  const ModelRow& model = model_row(lobe.model);
  Json params = Json::object();
  for (const ParameterRow& row : model.parameters)
    if (row.belongs_to(lobe.variant) && !(row.hidden && lobe.params[row.slot] == row.fallback))
      params[std::string(row.name)] = converted(lobe.params[row.slot], double{row.display_factor()});
  return {{"model", std::string(model.name)},
          {"variant", std::string(model.variants[lobe.variant].name)},
          {"params", params}};
}

Json from_edits(const EditLayer& edits) {
  Json rows = Json::array();
  for (const auto& [key, edit] : edits.bases) {
    Json row{{"cluster", key.cluster}, {"basis", key.basis}};
    if (edit.gain != vec3(1)) row["gain"] = from_vec(edit.gain);
    if (edit.lobe) row["lobe"] = from_lobe(*edit.lobe);
    if (edit.normal) row["normal"] = from_vec(*edit.normal);
    if (edit.psi) row["psi"] = converted(*edit.psi, kDegrees);
    for (const auto& [name, flag] : {std::pair{"mute", edit.mute}, {"solo", edit.solo}, {"lock", edit.lock}})
      if (flag) row[name] = true;
    rows.push_back(row);
  }
  Json names = Json::object();
  for (const auto& [cluster, name] : edits.cluster_names) names[std::to_string(cluster)] = name;
  return {{"bases", rows},
          {"cluster_names", names},
          {"residual",
           {{"terms", edits.residual_terms},
            {"strength", json_number(edits.residual_strength)},
            {"policy", std::string(kPolicies[static_cast<size_t>(edits.residual_policy)])}}}};
}

vec3 to_vec(const JsonReader& reader, float low, float high) {
  if (reader.size(3) != 3) reader.refuse("three numbers", std::to_string(reader.size(3)));
  return {reader.element(0).number(low, high), reader.element(1).number(low, high),
          reader.element(2).number(low, high)};
}

// Files rounded by hand are unit to a few digits: made unit again; what the program wrote stays bit for bit.
vec3 to_normal(const JsonReader& reader) {
  const vec3 v = to_vec(reader, -1.001f, 1.001f);
  const dvec3 d(v);
  const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  if (!(std::abs(length - 1) < 1e-3) || !(v.z > 0)) {
    reader.refuse("a unit vector with z above 0", fmt::format("({}, {}, {})", v.x, v.y, v.z));
    return {0, 0, 1};
  }
  return std::abs(length - 1) < 1e-6 ? v : vec3(d / length);
}

float to_psi(const JsonReader& reader) { return static_cast<float>(reader.real(-3600, 3600) / kDegrees); }

Lobe to_lobe(const JsonReader& reader) {
  const std::string name = reader.member("model").text(64);
  const auto model = find_model(name);
  if (!model) {
    reader.member("model").refuse("one of the 7 BRDF models", "\"" + name + "\"");
    return {};
  }
  uint8_t variant = model_row(*model).default_variant;
  if (reader.has("variant")) {
    const std::string asked = reader.member("variant").text(64);
    if (const auto found = find_variant(*model, asked))
      variant = *found;
    else
      reader.member("variant").refuse("a variant of " + name, "\"" + asked + "\"");
  }
  Lobe lobe = default_lobe(*model, variant);
  const JsonReader params = reader.member("params");
  for (const std::string& key : params.keys(16)) {
    const ParameterRow* row = find_parameter(*model, variant, key);
    if (row == nullptr) {
      params.member(key).refuse("a parameter of " + name, "\"" + key + "\"");
      continue;
    }
    const double factor{row->display_factor()}, slack = 1e-6 * (double{row->max} - double{row->min});
    lobe.params[row->slot] = static_cast<float>(
        params.member(key).real((double{row->min} - slack) * factor, (double{row->max} + slack) * factor) / factor);
  }
  return lobe;
}

EditLayer to_edits(const JsonReader& reader) {
  EditLayer edits;
  const JsonReader rows = reader.member("bases");
  for (size_t i = 0, count = rows.size(size_t{1} << 20); i < count; ++i) {
    const JsonReader row = rows.element(i);
    const BasisKey key{static_cast<int>(row.member("cluster").integer(0, kMaxClusters - 1)),
                       static_cast<int>(row.member("basis").integer(0, kMaxBases - 1))};
    BasisEdit edit;
    if (row.has("gain")) edit.gain = to_vec(row.member("gain"), 0, kMaxGain);
    if (row.has("lobe")) edit.lobe = to_lobe(row.member("lobe"));
    if (row.has("normal")) edit.normal = to_normal(row.member("normal"));
    if (row.has("psi")) edit.psi = to_psi(row.member("psi"));
    if (row.has("mute")) edit.mute = row.member("mute").boolean();
    if (row.has("solo")) edit.solo = row.member("solo").boolean();
    if (row.has("lock")) edit.lock = row.member("lock").boolean();
    if (edits.bases.contains(key)) row.refuse("one row for each cluster and basis", "a second one");
    edits.set(key, edit);
  }
  const JsonReader names = reader.member("cluster_names");
  for (const std::string& key : names.keys(kMaxClusters)) {
    int cluster = -1;
    const auto [end, code] = std::from_chars(key.data(), key.data() + key.size(), cluster);
    if (code != std::errc() || end != key.data() + key.size() || cluster < 0 || cluster >= kMaxClusters)
      names.member(key).refuse("the number of a cluster", "\"" + key + "\"");
    edits.cluster_names[cluster] = names.member(key).text(256);
  }
  const JsonReader residual = reader.member("residual");
  edits.residual_terms = static_cast<int>(residual.member("terms").integer(0, kMaxResidualTerms));
  edits.residual_strength = residual.member("strength").number(0, kMaxStrength);
  const std::string policy = residual.member("policy").text(64);
  const auto found = std::find(kPolicies.begin(), kPolicies.end(), policy);
  if (found == kPolicies.end())
    residual.member("policy").refuse("follow, keep or fade", "\"" + policy + "\"");
  else
    edits.residual_policy = static_cast<ResidualPolicy>(found - kPolicies.begin());
  return edits;
}

// Semantic versions: another major is another format, a later minor may hold what is not understood here.
Status check_version(const JsonReader& root, std::string_view file) {
  if (const std::string format = root.member("format").text(64); format != kFormat)
    root.member("format").refuse(fmt::format("\"{}\"", kFormat), "\"" + format + "\"");
  const std::string version = root.member("schema_version").text(64);
  VAMP_CHECK_STATUS(root.status());
  int part[3] = {-1, -1, -1};
  const char* at = version.data();
  const char* const end = version.data() + version.size();
  for (int i = 0; i < 3; ++i) {
    const auto [next, code] = std::from_chars(at, end, part[i]);
    if (code != std::errc() || part[i] < 0 || (i < 2 && (next == end || *next != '.')) || (i == 2 && next != end))
      return fail(ErrorKind::bad_input, file, "schema_version", "a version such as 1.0.0", "\"" + version + "\"");
    at = next + 1;
  }
  if (part[0] != kMajor)
    return fail(ErrorKind::bad_input, file, "schema_version", fmt::format("{}.x", kMajor), version);
  if (part[1] > kMinor)
    spdlog::warn("{}: made by a later version of the program (schema {}); what is new in it is not shown", file,
                 version);
  return {};
}

void read_head(const JsonReader& root, std::string& name, std::vector<std::string>& tags) {
  name = root.member("name").text(kMaxPresetName);
  const JsonReader list = root.member("tags");
  for (size_t i = 0, count = list.size(64); i < count; ++i) tags.push_back(list.element(i).text(64));
}

}  // namespace

Json edit_layer_to_json(const EditLayer& edits) { return from_edits(edits); }
EditLayer edit_layer_from_json(const JsonReader& reader) { return to_edits(reader); }

Json preset_to_json(const Preset& preset, const TablesNote& tables) {
  const Spmm& fit = *preset.fit;
  Json json{{"format", std::string(kFormat)},
            {"schema_version", fmt::format("{}.{}.0", kMajor, kMinor)},
            {"generator", "vamp"},
            {"units", {{"length", "mm"}, {"angle", "deg"}}},
            {"colour_space", "lin_rec709"},
            {"name", preset.name},
            {"tags", preset.tags},
            {"provenance", preset.provenance},
            {"licence", preset.licence},
            {"size_mm", {json_number(fit.size_mm().x), json_number(fit.size_mm().y)}},
            {"texels", {{"width", fit.width}, {"height", fit.height}, {"mm", json_number(fit.mm_per_texel)}}}};
  Json basis = Json::array();
  for (const Basis& b : fit.dictionary) {
    Json row{{"name", b.name}};
    row.update(from_lobe(b.lobe));
    row["normal"] = from_vec(b.normal);
    row["psi"] = converted(b.psi, kDegrees);
    basis.push_back(row);
  }
  Json clusters = Json::array();
  for (const Cluster& cluster : fit.clusters) clusters.push_back(Json{{"name", cluster.name}});
  json["basis"] = basis;
  json["clusters"] = clusters;
  json["residual"] = {
      {"terms", fit.residual.terms}, {"directions", tables.directions}, {"present", !fit.residual.records.empty()}};
  json["tables"] = {
      {"uri", tables.uri}, {"bytes", tables.bytes}, {"xxh3_128", tables.checksum}, {"entries", tables.entries}};
  json["edits"] = from_edits(preset.edits);
  if (!preset.unknown_json.empty()) {
    const auto unknown = parse_json(preset.unknown_json, "");
    if (unknown && unknown->is_object())
      for (const auto& item : unknown->items())
        if (!json.contains(item.key())) json[item.key()] = item.value();
  }
  return json;
}

Result<PresetInfo> info_from_json(std::string_view text, std::string_view file) {
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader root(json, file);
  VAMP_CHECK_STATUS(check_version(root, file));
  PresetInfo info;
  read_head(root, info.name, info.tags);
  const JsonReader size = root.member("size_mm");
  info.size_mm = {size.element(0).number(0, 1e9f), size.element(1).number(0, 1e9f)};
  if (root.has("edits")) info.edits = to_edits(root.member("edits"));
  VAMP_CHECK_STATUS(root.status());
  return info;
}

Result<Preset> preset_from_json(std::string_view text, std::string_view file, Spmm& fit, TablesNote& tables) {
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader root(json, file);
  VAMP_CHECK_STATUS(check_version(root, file));
  Preset preset;
  read_head(root, preset.name, preset.tags);
  if (root.has("provenance")) preset.provenance = root.member("provenance").text();
  if (root.has("licence")) preset.licence = root.member("licence").text();

  const JsonReader texels = root.member("texels");
  fit.width = static_cast<int>(texels.member("width").integer(1, kMaxTexelSide));
  fit.height = static_cast<int>(texels.member("height").integer(1, kMaxTexelSide));
  fit.mm_per_texel = texels.member("mm").number(1e-6f, 1e6f);
  const JsonReader basis = root.member("basis");
  for (size_t i = 0, count = basis.size(kMaxBases); i < count; ++i) {
    const JsonReader row = basis.element(i);
    fit.dictionary.push_back(
        {row.member("name").text(256), to_lobe(row), to_normal(row.member("normal")), to_psi(row.member("psi"))});
    if (!root.status()) break;
  }
  const JsonReader clusters = root.member("clusters");
  for (size_t i = 0, count = clusters.size(kMaxClusters); i < count; ++i)
    fit.clusters.push_back({clusters.element(i).member("name").text(256)});
  if (fit.dictionary.empty()) basis.refuse("at least one function", "none");
  if (fit.clusters.empty()) clusters.refuse("at least one cluster", "none");
  const JsonReader residual = root.member("residual");
  fit.residual.terms = static_cast<int>(residual.member("terms").integer(0, kMaxResidualTerms));
  const bool present = residual.member("present").boolean();
  tables.directions = static_cast<size_t>(residual.member("directions").integer(present ? 1 : 0, kMaxDirections));
  if (!present && tables.directions != 0)
    residual.member("directions").refuse("0 where there is no residual", std::to_string(tables.directions));

  const JsonReader note = root.member("tables");
  tables.uri = note.member("uri").text(256);
  tables.bytes = static_cast<uint64_t>(note.member("bytes").integer(0, INT64_MAX));
  tables.checksum = note.member("xxh3_128").text(32);
  tables.entries = static_cast<size_t>(note.member("entries").integer(0, INT32_MAX));
  preset.edits = to_edits(root.member("edits"));
  VAMP_CHECK_STATUS(root.status());

  Json unknown = Json::object();
  for (const auto& item : json.items())
    if (std::find(kKnown.begin(), kKnown.end(), item.key()) == kKnown.end() &&
        std::find(kKnownTexts.begin(), kKnownTexts.end(), item.key()) == kKnownTexts.end())
      unknown[item.key()] = item.value();
  if (!unknown.empty()) preset.unknown_json = print_json(unknown);
  return preset;
}

Status validate(const EditLayer& edits, const Spmm& fit, std::string_view file) {
  for (const auto& [key, edit] : edits.bases) {
    const std::string place = fmt::format("edits of cluster {}, basis {}", key.cluster, key.basis);
    const auto refuse = [&](std::string_view expected, const std::string& found) {
      return fail(ErrorKind::bad_input, file, place, expected, found);
    };
    if (key.cluster < 0 || static_cast<size_t>(key.cluster) >= fit.clusters.size())
      return refuse(fmt::format("a cluster below {}", fit.clusters.size()), std::to_string(key.cluster));
    if (key.basis < 0 || static_cast<size_t>(key.basis) >= fit.dictionary.size())
      return refuse(fmt::format("a basis below {}", fit.dictionary.size()), std::to_string(key.basis));
    for (int c = 0; c < 3; ++c)
      if (!(edit.gain[c] >= 0 && edit.gain[c] <= kMaxGain))
        return refuse(fmt::format("a gain from 0 to {}", kMaxGain), fmt::format("{}", edit.gain[c]));
    if (edit.lobe) VAMP_CHECK_STATUS(validate(*edit.lobe, file, place));
    if (edit.normal) {
      const dvec3 n(*edit.normal);
      const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      if (!(std::abs(length - 1) < 1e-3) || !(n.z > 0))
        return refuse("a unit normal with z above 0", fmt::format("({}, {}, {})", n.x, n.y, n.z));
    }
    if (edit.psi && !(std::abs(*edit.psi) <= 63)) return refuse("an angle", fmt::format("{} rad", *edit.psi));
  }
  for (const auto& [cluster, name] : edits.cluster_names)
    if (cluster < 0 || static_cast<size_t>(cluster) >= fit.clusters.size() || name.size() > 256)
      return fail(ErrorKind::bad_input, file, "cluster_names",
                  fmt::format("clusters below {}, names up to 256 bytes", fit.clusters.size()),
                  std::to_string(cluster));
  if (edits.residual_terms < 0 || edits.residual_terms > kMaxResidualTerms)
    return fail(ErrorKind::bad_input, file, "edits.residual.terms", "0 to 4", std::to_string(edits.residual_terms));
  if (!(edits.residual_strength >= 0 && edits.residual_strength <= kMaxStrength))
    return fail(ErrorKind::bad_input, file, "edits.residual.strength", "0 to 2",
                fmt::format("{}", edits.residual_strength));
  return {};
}

}  // namespace vamp
