#include "bench/fit_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/acquire/acquire.h"
#include "engine/acquire/facet_grid.h"
#include "engine/acquire/structure.h"

namespace vamp {
namespace {

constexpr int kFacetsOfATexel = 6;

// Periods are scaled so that a yarn or a plate has the same number of texels as it has in the shipped presets.
const std::array<FitMaterial, 7> kMaterials = {{
    {"calf", true, {{"mm", 7}, {"plates", 11}}},
    {"nubuck", true, {{"mm", 8}}},
    {"leather", true, {{"mm", 6}, {"plates", 8}}},
    {"wool-twill", true, {{"mm", 6}, {"ends", 12}, {"picks", 12}}},
    {"denim", true, {{"mm", 6}, {"ends", 16}, {"picks", 12}}},
    {"air-mesh", true, {{"mm", 8}, {"holes", 3}, {"hole_rows", 4}}},
    {"crocodile", false, {{"mm", 16}, {"columns", 3}, {"rows", 4}}},
}};

// 24 directions within 74 degrees that lie between those of UBO2003: a spiral of equal projected areas.
DirectionSet directions_between() {
  constexpr int kCount = 24;
  const double most = std::pow(std::sin(74 * std::numbers::pi / 180), 2);
  std::vector<dvec3> directions;
  for (int i = 0; i < kCount; ++i) {
    const double r = std::sqrt(most * (i + 0.5) / kCount), phi = i * std::numbers::pi * (3 - std::sqrt(5.0)) + 0.1;
    directions.emplace_back(r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r * r));
  }
  return named_direction_set(std::move(directions));
}

// The file itself where it is whole and of this job.
std::optional<Btf> whole(const fs::path& path, const Json& job) {
  std::error_code code;
  if (!fs::exists(path, code)) return {};
  Result<Btf> btf = Btf::open(path);
  if (!btf || btf->info().provenance.find("Job: " + job.dump()) == std::string::npos) return {};
  return std::move(*btf);
}

Result<std::unique_ptr<acquire::Structure>> structure_of(const FitMaterial& material) {
  VAMP_TRY(std::unique_ptr<acquire::Structure> structure, acquire::make_structure(material.name));
  for (const auto& [name, value] : material.settings) VAMP_CHECK_STATUS(acquire::set(*structure, name, value));
  return structure;
}

Result<Btf> acquired(const FitMaterial& material, const FitDataOptions& options, const acquire::Mesostructure& built,
                     bool between, Progress& progress) {
  acquire::Options job;
  job.size = options.size;
  job.samples = between ? kPathsBetween * options.samples : options.samples;
  job.directions = between ? directions_between() : ubo81();
  job.seed = between ? 2 : 1;
  job.job = {{"structure", material.name}, {"size", job.size}, {"samples", job.samples}, {"between", between}};
  for (const auto& [name, value] : material.settings) job.job["settings"][name] = value;
  const fs::path path = options.cache / fmt::format("{}{}.btf", material.name, between ? "-between" : "");
  if (auto btf = whole(path, job.job)) return std::move(*btf);
  if (const auto report = acquire::measure(built, job, path, progress); !report) return tl::unexpected(report.error());
  return Btf::open(path);
}

double tilt_of(const acquire::Mesostructure& built) {
  const acquire::FacetGrid grid(built.facets);
  constexpr int kRays = 256;  // a side
  double sum = 0;
  for (int y = 0; y < kRays; ++y)
    for (int x = 0; x < kRays; ++x) {
      const vec3 above((static_cast<float>(x) + 0.5f) / kRays, (static_cast<float>(y) + 0.5f) / kRays, grid.top() + 1);
      const auto hit = grid.first_hit(above, vec3(0, 0, -1));
      if (hit.facet != acquire::FacetGrid::kNone) sum += std::acos(std::min(grid.normal(hit.facet).z, 1.f));
    }
  return sum / (kRays * kRays) * 180 / std::numbers::pi;
}

// Of all values together, from a texel's stated errors: the provenance holds the median of texels, which is what is
// taken for all.
double noise_of(const Btf& btf) {
  const std::string& text = btf.info().provenance;
  const size_t at = text.find("median ");
  return at == std::string::npos ? 0 : std::atof(text.c_str() + at + 7);
}

}  // namespace

std::span<const FitMaterial> fit_materials() { return kMaterials; }

Result<FitData> fit_data(const FitMaterial& material, const FitDataOptions& options, Progress& progress) {
  std::error_code code;
  fs::create_directories(options.cache, code);
  if (code) return fail(ErrorKind::io, options.cache.string(), "", "a folder that can be made", code.message());
  VAMP_TRY(const std::unique_ptr<acquire::Structure> structure, structure_of(material));
  const acquire::Mesostructure built = structure->build(std::max(256, options.size * kFacetsOfATexel));
  VAMP_TRY(Btf measured, acquired(material, options, built, false, progress));
  VAMP_TRY(Btf between, acquired(material, options, built, true, progress));
  const double noise = noise_of(measured), noise_between = noise_of(between);
  return FitData{std::move(measured), std::move(between), noise, noise_between, tilt_of(built)};
}

}  // namespace vamp
