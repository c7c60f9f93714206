#pragma once
// Lines around what is selected and what the mouse is over, drawn from the numbers that each pixel shows.
#include <cstdint>
#include <span>
#include <vector>

namespace vamp {

struct Outlined {
  int part = -1;     // -1: nothing
  int cluster = -1;  // -1: the whole part
  bool operator==(const Outlined&) const = default;
};

// An overlay of RGBA8 with straight alpha, transparent where nothing is drawn. `ids` as RenderSession::copy_ids gives
// them, width * height. A selected part has an amber line with a dark rim and shows its material as it is. A cluster is
// tinted besides, for those who look for it: the clusters of a material are often scattered over single pixels, where
// lines would cover everything. What the mouse is over has a thin white line.
std::vector<uint8_t> draw_outlines(std::span<const uint32_t> ids, int width, int height, const Outlined& selected,
                                   const Outlined& hovered);

}  // namespace vamp
