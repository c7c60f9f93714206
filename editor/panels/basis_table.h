#pragma once
// The functions of a cluster, those that carry most of its light first.
#include <vector>

#include "editor/panels/context.h"

namespace vamp::ui {

class BasisTable {
 public:
  // Draws the table; a click selects a row. Needs a valid material and cluster in the selection; gives it a basis when
  // it has none.
  void draw(PanelContext& context);

  // Rows that the table has, and those shown now (small ones are folded); of the last draw.
  size_t rows() const { return order_.size(); }
  size_t shown() const { return shown_; }

 private:
  void refresh(const PanelContext& context);
  void draw_row(PanelContext& context, int basis);
  bool is_folded(const PanelContext& context, size_t place) const;

  SpmmPtr fit_;
  EditLayer edits_;
  int cluster_ = -1;
  std::vector<float> energy_;         // [basis] after the edits
  std::vector<float> fitted_energy_;  // [basis] of the fit
  std::vector<int> order_;
  size_t shown_ = 0;
  bool all_ = false;
};

}  // namespace vamp::ui
