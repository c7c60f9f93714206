#include "bench/changes.h"

#include <algorithm>
#include <cmath>

#include "engine/brdf/registry.h"
#include "engine/material/reflectance.h"

namespace vamp {
namespace {

template <class Make>
EditLayer for_every_row(const Spmm& spmm, Make make) {
  EditLayer edits;
  for (int c = 0; c < static_cast<int>(spmm.clusters.size()); ++c)
    for (int j = 0; j < static_cast<int>(spmm.dictionary.size()); ++j) edits.set({c, j}, make(BasisKey{c, j}));
  return edits;
}

bool shines(const Basis& basis) { return basis.lobe.model != Model::lambert && basis.lobe.model != Model::oren_nayar; }

// Of a highlight about the half vector, as Cook-Torrance's m; 0 for other functions.
float width_of(const Lobe& lobe) {
  const auto& p = lobe.params;
  const auto of_exponent = [](float n) { return std::sqrt(2 / (n + 2)); };
  switch (lobe.model) {
    case Model::blinn_phong:
      return of_exponent(p[1]);
    case Model::ward:
      return std::sqrt(p[1] * p[2]);
    case Model::cook_torrance:
      return p[1];
    case Model::ashikhmin_shirley:
      return std::sqrt(of_exponent(p[2]) * of_exponent(p[3]));
    default:
      return 0;
  }
}

// With all widths of its highlight times a factor.
Lobe widened(Lobe lobe, float factor) {
  const auto scale = [&](std::string_view name, float by) {
    if (const ParameterRow* row = find_parameter(lobe.model, lobe.variant, name); row != nullptr) {
      float& value = lobe.params[row->slot];
      value = std::clamp(value * by, row->min, row->max);
    }
  };
  for (const char* width : {"m", "alpha_x", "alpha_y"}) scale(width, factor);
  // An exponent n is a width of sqrt(2 / (n + 2)).
  for (const char* exponent : {"n", "nu", "nv"}) scale(exponent, 1 / (factor * factor));
  return lobe;
}

}  // namespace

EditLayer recoloured(const Spmm& spmm, const PigmentChange& change) {
  const std::vector<dvec3> before = fit_sums(spmm).weights, after = changed_colours(before, change);
  return for_every_row(spmm, [&](BasisKey key) {
    BasisEdit edit;
    const size_t row = static_cast<size_t>(key.cluster) * spmm.dictionary.size() + static_cast<size_t>(key.basis);
    for (int c = 0; c < 3; ++c)
      if (before[row][c] > 0) edit.gain[c] = static_cast<float>(after[row][c] / before[row][c]);
    return edit;
  });
}

EditLayer with_gloss(const Spmm& spmm, float gain) {
  return for_every_row(spmm, [&](BasisKey key) {
    BasisEdit edit;
    if (shines(spmm.dictionary[static_cast<size_t>(key.basis)])) edit.gain = vec3(gain);
    return edit;
  });
}

EditLayer with_roughness(const Spmm& spmm, float factor) {
  return for_every_row(spmm, [&](BasisKey key) {
    BasisEdit edit;
    const Basis& basis = spmm.dictionary[static_cast<size_t>(key.basis)];
    if (shines(basis)) edit.lobe = widened(basis.lobe, factor);
    return edit;
  });
}

EditLayer with_relief(const Spmm& spmm, float factor) {
  // The finish itself is as sharp as the sharpest highlights; what is wider is wide because slopes differ within a
  // texel.
  std::vector<float> widths;
  for (const Basis& basis : spmm.dictionary)
    if (const float width = width_of(basis.lobe); width > 0) widths.push_back(width);
  std::sort(widths.begin(), widths.end());
  const float own = widths.empty() ? 0 : widths[widths.size() / 10];
  return for_every_row(spmm, [&](BasisKey key) {
    BasisEdit edit;
    const Basis& basis = spmm.dictionary[static_cast<size_t>(key.basis)];
    const vec3 n = basis.normal;
    if (n.x != 0 || n.y != 0) edit.normal = normalize(vec3(n.x * factor, n.y * factor, n.z));
    if (const float width = width_of(basis.lobe); width > own) {
      const float narrower = std::sqrt(own * own + (width * width - own * own) * factor * factor);
      edit.lobe = widened(basis.lobe, narrower / width);
    }
    return edit;
  });
}

std::vector<Change> changes() {
  const vec3 white(1);
  const vec3 leather(0.33f, 0.128f, 0.044f), leather_crease(0.115f, 0.036f, 0.012f);
  const vec3 navy(0.045f, 0.08f, 0.26f), navy_crease(0.0157f, 0.0225f, 0.0709f);
  const vec3 red(0.36f, 0.05f, 0.04f), sand(0.5f, 0.46f, 0.38f), green(0.05f, 0.24f, 0.1f);
  const vec3 wool(0.36f, 0.045f, 0.04f), wool_second(0.5f, 0.12f, 0.1f);
  const MesoSettings cloth = {{"ends", 8.f}, {"picks", 8.f}, {"mm", 6.f},
                              {"warp", red}, {"weft", sand}, {"blend", 0.f}};
  const auto with = [](MesoSettings settings, const MesoSettings& more) {
    settings.insert(settings.end(), more.begin(), more.end());
    return settings;
  };
  const auto dyed = [](std::string name, std::string edit, std::string meso, MesoSettings before, MesoSettings after,
                       const PigmentChange& pigment) {
    return Change{std::move(name),  std::move(edit),
                  std::move(meso),  std::move(before),
                  std::move(after), [pigment](const Spmm& s) { return recoloured(s, pigment); },
                  pigment};
  };
  return {
      dyed("calf: brown becomes navy", "leather colour for another; the finish stays white", "calf", {},
           {{"colour", navy}, {"crease_colour", navy_crease}}, {leather, navy, {white}}),
      dyed("twill: the warp yarns become green", "yarn colour for another; the weft's stays", "twill", cloth,
           with(cloth, {{"warp", green}}), {red, green, {sand, white}}),
      dyed("calf: finish taken off", "the white in all weights to black", "calf", {}, {{"coat", 0.f}},
           {white, vec3(0), {leather, leather_crease}}),
      {"calf: finish rougher, 0.25 to 0.4",
       "widths of all functions that shine times 1.6",
       "calf",
       {},
       {{"roughness", 0.4f}},
       [](const Spmm& s) { return with_roughness(s, 1.6f); },
       {}},
      {"crocodile: glaze halved",
       "gain 0.5 of all functions that shine",
       "crocodile",
       {},
       {{"coat", 0.5f}},
       [](const Spmm& s) { return with_gloss(s, 0.5f); },
       {}},
      {"calf: relief halved",
       "slopes of all normals times 0.5",
       "calf",
       {},
       {{"relief", 0.5f}},
       [](const Spmm& s) { return with_relief(s, 0.5f); },
       {}},
      {"twill: relief halved",
       "slopes of all normals times 0.5",
       "twill",
       cloth,
       with(cloth, {{"relief", 0.5f}}),
       [](const Spmm& s) { return with_relief(s, 0.5f); },
       {}},
      dyed("knit: dyed darker", "yarn colour times 0.4", "knit", {},
           {{"colour", 0.4f * wool}, {"second", 0.4f * wool_second}}, {wool, 0.4f * wool, {white}}),
  };
}

}  // namespace vamp
