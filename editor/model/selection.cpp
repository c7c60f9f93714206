#include "editor/model/selection.h"

namespace vamp {
namespace {

bool within(int index, size_t size) { return index >= 0 && static_cast<size_t>(index) < size; }

}  // namespace

Selection valid_selection(const Project& project, Selection selection) {
  if (!within(selection.part, project.parts.size())) selection.part = -1;
  if (selection.part >= 0) selection.material = project.parts[static_cast<size_t>(selection.part)].material;
  if (!within(selection.material, project.materials.size())) return {selection.part, -1, -1, -1};
  const Spmm& fit = *project.materials[static_cast<size_t>(selection.material)].fit;
  if (!within(selection.cluster, fit.clusters.size())) selection.cluster = -1;
  if (!within(selection.basis, fit.dictionary.size())) selection.basis = -1;
  return selection;
}

Selection select_part(const Project& project, int part) { return valid_selection(project, {part, -1, -1, -1}); }

}  // namespace vamp
