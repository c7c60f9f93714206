#include "editor/panels/fit_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <numeric>

#include "editor/model/edits_material.h"

namespace vamp::ui {

namespace {

FitFigures make_figures(const Spmm& fit) {
  FitFigures figures;
  figures.sums = fit_sums(fit);
  const double all = std::accumulate(figures.sums.texels.begin(), figures.sums.texels.end(), 0.0);
  const size_t bases = fit.dictionary.size();
  for (size_t cluster = 0; cluster < fit.clusters.size(); ++cluster) {
    figures.share.push_back(all > 0 ? static_cast<float>(figures.sums.texels[cluster] / all) : 0);
    std::vector<int>& used = figures.bases.emplace_back();
    for (size_t basis = 0; basis < bases; ++basis) {
      const dvec3 weight = figures.sums.weights[cluster * bases + basis];
      if (weight.x != 0 || weight.y != 0 || weight.z != 0) used.push_back(static_cast<int>(basis));
    }
  }
  return figures;
}

struct Kept {
  std::weak_ptr<const Spmm> fit;
  FitFigures figures;
};
// Panels draw on one thread.
std::deque<Kept> g_kept;
constexpr size_t kKept = 8;

}  // namespace

const FitFigures& fit_figures(const SpmmPtr& fit) {
  const auto found =
      std::find_if(g_kept.begin(), g_kept.end(), [&](const Kept& kept) { return kept.fit.lock() == fit; });
  if (found != g_kept.end()) return found->figures;
  if (g_kept.size() >= kKept) g_kept.pop_front();
  g_kept.push_back({fit, make_figures(*fit)});
  return g_kept.back().figures;
}

const MaterialInstance* find_material(const Project& project, int material) {
  const bool there = material >= 0 && static_cast<size_t>(material) < project.materials.size();
  return there ? &project.materials[static_cast<size_t>(material)] : nullptr;
}

std::string cluster_title(const MaterialInstance& material, int cluster) {
  const std::string name = cluster_name(material, cluster);
  const std::string plain = fmt::format("cluster {}", cluster);
  return name.empty() || name == plain ? plain : fmt::format("{} “{}”", plain, name);
}

}  // namespace vamp::ui
