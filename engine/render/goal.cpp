#include "engine/render/goal.h"

namespace vamp {
namespace {

// Before, too few hits have been compared for their noise to say much.
constexpr uint32_t kLeastSamples = 32;

}  // namespace

bool Goal::wants(const Renderer& renderer, int tile, uint32_t max_samples, float noise_goal) const {
  const uint32_t samples = renderer.samples_of(tile);
  if (samples >= max_samples) return false;
  if (noise_goal <= 0 || samples < kLeastSamples) return true;
  const float noise = noise_.of_tile(static_cast<size_t>(tile), samples);
  return noise < 0 || noise > noise_goal;
}

bool Goal::reached(const Renderer& renderer, uint32_t max_samples, float noise_goal) const {
  for (int tile = 0; tile < renderer.tile_count(); ++tile)
    if (wants(renderer, tile, max_samples, noise_goal)) return false;
  return true;
}

void Goal::look(Renderer& renderer) {
  const std::vector<uint32_t>& samples = renderer.samples_of_tiles();
  if (noise_.due(samples)) noise_.add(samples, renderer.linear_picture(renderer.last_submitted()));
}

}  // namespace vamp
