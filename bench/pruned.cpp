#include "bench/pruned.h"

#include <algorithm>

#include "engine/core/half.h"
#include "engine/image/display.h"

namespace vamp {
namespace {

vec3 weight_of(const tables::Entry& entry) {
  const auto half = [](uint32_t bits) { return float_from_half(static_cast<uint16_t>(bits & 0xffffu)); };
  return {half(entry.basis_red >> 16), half(entry.green_blue), half(entry.green_blue >> 16)};
}

tables::Entry with_weight(tables::Entry entry, vec3 weight) {
  const auto half = [](float value) { return uint32_t{half_from_float(value)}; };
  return {(entry.basis_red & 0xffffu) | half(weight.r) << 16, half(weight.g) | half(weight.b) << 16};
}

SpmmPtr pruned(const Spmm& fit, size_t most) {
  auto less = std::make_shared<Spmm>(fit);
  less->entries.clear();
  std::vector<float> albedo;
  for (const Basis& basis : fit.dictionary) albedo.push_back(lobe_albedo(basis.lobe, 1));
  for (tables::Texel& texel : less->texels) {
    const tables::Entry* first = &fit.entries[texel.first_entry];
    std::vector<tables::Entry> entries(first, first + (texel.cluster_count >> 8 & 0xffu));
    const auto sent = [&](const tables::Entry& e) { return weight_of(e) * albedo[e.basis_red & 0xffffu]; };
    const auto bright = [&](const tables::Entry& e) {
      const vec3 light = sent(e);
      return luminance(double{light.r}, double{light.g}, double{light.b});
    };
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const tables::Entry& a, const tables::Entry& b) { return bright(a) > bright(b); });
    vec3 all(0), kept(0);
    for (size_t i = 0; i < entries.size(); ++i) {
      all += sent(entries[i]);
      if (i < most) kept += sent(entries[i]);
    }
    entries.resize(std::min(entries.size(), most));
    vec3 raise(1);
    for (int c = 0; c < 3; ++c)
      if (kept[c] > 0) raise[c] = std::min(all[c] / kept[c], 4.f);
    texel.first_entry = static_cast<uint32_t>(less->entries.size());
    texel.cluster_count = (texel.cluster_count & 0xffu) | static_cast<uint32_t>(entries.size()) << 8;
    for (const tables::Entry& entry : entries) less->entries.push_back(with_weight(entry, weight_of(entry) * raise));
  }
  return less;
}

}  // namespace

Project without_residuals(Project project) {
  for (MaterialInstance& material : project.materials) {
    auto bare = std::make_shared<Spmm>(*material.fit);
    bare->residual = {};
    material.fit = std::move(bare);
  }
  return project;
}

Project with_terms(Project project, int terms) {
  for (MaterialInstance& material : project.materials) material.edits.residual_terms = terms;
  return project;
}

Project with_functions(Project project, int most) {
  for (MaterialInstance& material : project.materials) material.fit = pruned(*material.fit, static_cast<size_t>(most));
  return project;
}

double functions_of(const Spmm& fit) {
  return static_cast<double>(fit.entries.size()) / static_cast<double>(fit.texels.size());
}

}  // namespace vamp
