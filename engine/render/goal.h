#pragma once
// When a picture is good enough: at a number of samples, or tile by tile at a relative noise. Samples go where the
// noise is, because tiles that have reached the goal are left alone.
#include <vector>

#include "engine/render/noise.h"
#include "engine/render/renderer.h"

namespace vamp {

class Goal {
 public:
  // The picture starts again.
  void restart(const Renderer& renderer) { noise_.restart(renderer.tiles(), renderer.region().width); }
  // What is seen has changed, but is about as noisy.
  void forget_picture() { noise_.forget_picture(); }

  // Whether a tile is to be refined further, up to `max_samples`. For a while nobody knows its noise: then it is.
  bool wants(const Renderer& renderer, int tile, uint32_t max_samples, float noise_goal) const;
  bool reached(const Renderer& renderer, uint32_t max_samples, float noise_goal) const;
  // Compares where a comparison is due. After a pass over the tiles; nothing may be in flight.
  void look(Renderer& renderer);
  // Of the picture; -1: not known yet.
  float noise(const Renderer& renderer) const { return noise_.of_picture(renderer.samples_of_tiles()); }

 private:
  NoiseEstimate noise_;
};

}  // namespace vamp
