#include "bench/material.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/material/directions.h"

namespace vamp {
namespace {

constexpr int kSide = 256, kCell = 8, kClusters = 32, kFunctions = 32;

Basis any_basis(Model model, std::mt19937& random) {
  const auto uniform = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  Basis basis;
  basis.name = std::string(model_row(model).name);
  basis.lobe = default_lobe(model);
  // Widths and exponents by their sliders; the others stay as they are usually.
  for (const ParameterRow& row : model_row(model).parameters)
    if (row.belongs_to(basis.lobe.variant) && !row.hidden && row.mapping == Mapping::logarithmic)
      basis.lobe.params[row.slot] = from_slider(row, uniform(0.3f, 0.7f));
  const float tilt = uniform(0, 0.5f), azimuth = uniform(0, 2 * std::numbers::pi_v<float>);
  basis.normal = vec3(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt));
  basis.psi = azimuth;
  return basis;
}

uint32_t half(float value) { return half_from_float(value); }

}  // namespace

SpmmPtr bench_material(const BenchMaterial& what) {
  std::mt19937 random(what.seed);
  const auto uniform = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  auto fit = std::make_shared<Spmm>();
  fit->width = fit->height = kSide;
  fit->mm_per_texel = 0.5f;
  fit->clusters.resize(kClusters);
  for (int c = 0; c < kClusters; ++c) fit->clusters[static_cast<size_t>(c)].name = std::to_string(c);
  for (const Model model : what.also_held) fit->dictionary.push_back(any_basis(model, random));
  const size_t first = fit->dictionary.size();
  while (fit->dictionary.size() < kFunctions)
    fit->dictionary.push_back(any_basis(what.used[fit->dictionary.size() % what.used.size()], random));

  std::vector<uint32_t> cells((kSide / kCell) * (kSide / kCell));
  for (uint32_t& cluster : cells) cluster = static_cast<uint32_t>(random() % kClusters);
  const auto count = static_cast<uint32_t>(what.functions);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const uint32_t cluster = cells[static_cast<size_t>(y / kCell * (kSide / kCell) + x / kCell)];
      const auto coefficients = [&] { return half(uniform(-1, 1)) | half(uniform(-1, 1)) << 16; };
      fit->texels.push_back(
          {static_cast<uint32_t>(fit->entries.size()), cluster | count << 8, coefficients(), coefficients()});
      for (uint32_t e = 0; e < count; ++e) {
        const auto basis = static_cast<uint32_t>(first + random() % (kFunctions - first));
        fit->entries.push_back(
            {basis | half(uniform(0, 0.2f)) << 16, half(uniform(0, 0.2f)) | half(uniform(0, 0.2f)) << 16});
      }
    }
  if (!what.residual) return fit;
  fit->residual.directions = ubo2003_directions();
  fit->residual.terms = kMaxResidualTerms;
  const size_t directions = fit->residual.directions.size();
  fit->residual.records.resize(kClusters * directions * directions);
  for (tables::ResidualRecord& record : fit->residual.records) {
    for (uint32_t& word : record.halves) word = half(uniform(-0.01f, 0.01f)) | half(uniform(-0.01f, 0.01f)) << 16;
    record.halves[7] &= 0xffffu;
  }
  return fit;
}

void dress(Project& project, const BenchMaterial& what, int materials) {
  project.materials.clear();
  BenchMaterial each = what;
  for (int i = 0; i < materials; ++i, ++each.seed) {
    MaterialInstance material;
    material.name = fmt::format("bench {}", i + 1);
    material.preset = "made in memory";
    material.fit = bench_material(each);
    project.materials.push_back(std::move(material));
  }
  for (size_t i = 0; i < project.parts.size(); ++i) project.parts[i].material = static_cast<int>(i) % materials;
}

}  // namespace vamp
