#include "engine/render/kernel_key.h"

#include <algorithm>

#include "engine/material/highlight.h"
#include "engine/render/material_tables.h"
#include "engine/render/scene_tables.h"
#include "shaders/brdf/lobe_tags.h"
#include "shaders/shared/frame.h"

namespace vamp {

KernelKey generic(KernelKey key) {
  key.lobe_models = LOBE_EVERYTHING;
  key.residual = 1 + kMaxResidualTerms;
  key.light_types = (2u << LIGHT_SPHERE) - 1;
  key.highlight = true;
  return key;
}

bool KernelKeys::has_highlight(const SpmmPtr& fit) {
  std::erase_if(highlights_, [](const auto& known) { return known.first.expired(); });
  const auto known =
      std::find_if(highlights_.begin(), highlights_.end(), [&](const auto& k) { return k.first.lock() == fit; });
  if (known != highlights_.end()) return known->second;
  highlights_.emplace_back(fit, highlight_width(*fit, fit_sums(*fit)) != 0);
  return highlights_.back().second;
}

KernelKey KernelKeys::key_of(const Project& project, const LightDraws& draws) {
  KernelKey key;
  for (const Light& light : project.lights) {
    if (!light.on) continue;
    ++key.light_count;
    key.light_types |= 1u << static_cast<uint32_t>(light.type);
  }
  key.light_slots = key.light_count > draws.above ? draws.slots : 0;
  key.environment = project.environment.map != nullptr;
  key.ambient = project.ambient != vec3(0) || (key.light_count == 0 && !key.environment);
  for (const PartState& part : project.parts) {
    if (!part.visible) continue;
    key.mirror |= part.mirror_f0 > 0;
    key.highlight |= has_highlight(project.materials[static_cast<size_t>(part.material)].fit);
  }
  key.alpha_mask = has_alpha_mask(*project.scene);
  key.residual = residual_in_view(project);
  key.lobe_models = lobe_models_in_view(project);
  key.four_taps = project.settings.tap == TexelTap::four;
  key.pixel_centres = project.settings.pixel_centres;
  return key;
}

}  // namespace vamp
