#include "engine/render/kernel_key.h"

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

KernelKey kernel_key(const Project& project, const LightDraws& draws, KnownSums& sums) {
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
    const SpmmPtr& fit = project.materials[static_cast<size_t>(part.material)].fit;
    key.highlight |= highlight_width(*fit, *sums.of(fit)) != 0;
  }
  key.alpha_mask = has_alpha_mask(*project.scene);
  key.residual = residual_in_view(project);
  key.lobe_models = lobe_models_in_view(project);
  key.four_taps = project.settings.tap == TexelTap::four;
  key.pixel_centres = project.settings.pixel_centres;
  return key;
}

}  // namespace vamp
