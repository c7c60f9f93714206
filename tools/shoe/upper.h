#pragma once
// The pattern of a cap-toe derby: which curves of the last bound which panel, and in what order panels lie.
#include <array>

#include "tools/shoe/panel.h"

namespace vamp::shoe {

constexpr int kSides = 2;  // 0 medial, 1 lateral

struct Upper {
  Panel vamp, toe_cap, counter, tongue;
  std::array<Panel, kSides> quarter;
  std::array<Panel, kSides> quarter_lining;  // meets its partner in the back seam without a gap
  std::array<Curve, kSides> facing;          // the quarters' front edges, upwards from the throat: where eyelets stand
  Curve topline;                             // medial facing, heel, lateral facing
};

Upper cut_upper(const Last& last);

// Padded edge of the opening.
Mesh make_collar(const Upper& upper, const Last& last);
// The inner faces of quarters and vamp.
Mesh make_lining(const Upper& upper, const Last& last);

}  // namespace vamp::shoe
