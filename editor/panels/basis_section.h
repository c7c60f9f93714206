#pragma once
// Everything that can be changed of one function of a cluster.
#include "editor/model/edits_material.h"
#include "editor/panels/context.h"
#include "editor/widgets/hemisphere.h"

namespace vamp::ui {

// Which rows of the basis table an edit of the selected one goes to.
enum class EditScope { this_cluster, all_clusters };

// The rows of the selection: the function in its cluster, or in every cluster that uses it.
Rows rows_in_scope(const PanelContext& context, EditScope scope);

class BasisSection {
 public:
  // Needs a valid material, cluster and basis in the selection.
  void draw(PanelContext& context, EditScope scope);

 private:
  void draw_model(PanelContext& context, const Rows& rows);
  void draw_parameters(PanelContext& context, const Rows& rows);
  void draw_frame(PanelContext& context, const Rows& rows);

  // The normal as the user gave it: at a tilt of 0 the vector alone has no azimuth.
  Tilt tilt_;
  vec3 normal_of_tilt_{0, 0, 0};
};

}  // namespace vamp::ui
