// Which kernels a picture needs, which of them are there, and in what order the others are wanted where they are made
// in the background.
#include <algorithm>

#include "engine/render/renderer.h"
#include "shaders/shared/frame.h"

namespace vamp {
namespace {

KernelKey of_samples(KernelKey key, uint32_t samples, bool list, bool new_hit = true) {
  key.samples = samples;
  key.list = list;
  key.new_hit = new_hit;
  return key;
}

// What a picture begins with.
std::vector<std::pair<Pass, KernelKey>> first_kernels(const KernelKey& key) {
  return {{Pass::trace, of_samples(key, 1, false)},
          {Pass::shade, of_samples(key, 1, false)},
          {Pass::trace, of_samples(key, 1, false, false)}};
}

// Scenes that an edit would make of this one: one more light, or with and without a mirror, ambient, an environment.
std::vector<KernelKey> neighbours(const KernelKey& key, const LightDraws& draws) {
  std::vector<KernelKey> all(4, key);
  all[0].light_count = std::min<uint32_t>(key.light_count + 1, MAX_LIGHTS);
  all[0].light_slots = all[0].light_count > draws.above ? draws.slots : 0;
  all[1].mirror = !key.mirror;
  all[2].environment = !key.environment;
  all[3].ambient = !key.ambient;
  std::erase_if(all, [](const KernelKey& k) { return k.ray_count() == 0; });
  return all;
}

}  // namespace

bool Renderer::kernels_there(bool list_of_pixels, bool trace, uint32_t batch) const {
  const auto ready = [&](Pass pass, bool new_hit) {
    return kernels_.ready(pass, of_samples(key_, batch, list_of_pixels, new_hit));
  };
  if (!ready(Pass::shade, true)) return false;
  return !trace || (ready(Pass::trace, true) && (batch == SAMPLES_PER_HIT || ready(Pass::trace, false)));
}

bool Renderer::kernels_there_to_replay() const {
  const uint32_t most = samples_.empty() ? 0 : *std::max_element(samples_.begin(), samples_.end());
  return kernels_there(true, most > 0 && !hit_is_stored(most - 1), 1);
}

// Whether it differs in what is answered from stored hits, as far as can be seen from the project alone.
bool Renderer::shades_again(const Project& now) const {
  if (now.parts != project_->parts || now.materials.size() != project_->materials.size()) return true;
  for (size_t i = 0; i < now.materials.size(); ++i)
    if (now.materials[i].fit != project_->materials[i].fit || now.materials[i].edits != project_->materials[i].edits)
      return true;
  return false;
}

bool Renderer::has_kernels_for(const Project& project) {
  if (!kernels_.in_background() || !project_) return true;
  KernelKey key = kernel_key(project, draws_, sums_);
  key.path = key_.path;
  std::vector<std::pair<Pass, KernelKey>> needed;
  if (key != key_) needed = first_kernels(key);
  // A picture keeps its samples and is shaded again, unless they are so few that it can as well begin again.
  const bool keeps = generic(key) == generic(key_) && shades_again(project) && samples() >= SAMPLES_PER_HIT;
  if (keeps) needed.emplace_back(Pass::shade, of_samples(key, 1, true));
  bool all = true;
  for (const auto& [pass, wanted] : needed) {
    if (kernels_.ready(pass, wanted)) continue;
    kernels_.want(pass, wanted, Kernels::Urgency::at_once);
    all = false;
  }
  return all;
}

void Renderer::want_kernels(bool first) {
  if (!kernels_.in_background()) return;
  using enum Kernels::Urgency;
  kernels_.want_nothing();
  const auto want = [&](Pass pass, const KernelKey& key, uint32_t samples, bool list, Kernels::Urgency urgency) {
    if (samples == 1 || batches_fit()) kernels_.want(pass, of_samples(key, samples, list), urgency);
  };
  // Until the first of all pictures nothing else is on the queue.
  for (const auto& [pass, key] : first_kernels(key_)) kernels_.want(pass, key, first && key.new_hit ? straight : soon);
  for (const Pass pass : {Pass::aov, Pass::composite}) kernels_.want(pass, key_, soon);
  want(Pass::shade, key_, 1, true, soon);
  for (const Pass pass : {Pass::trace, Pass::shade}) want(pass, key_, SAMPLES_PER_HIT, false, soon);
  want(Pass::shade, key_, SAMPLES_PER_HIT, true, soon);
  kernels_.want(Pass::recombine, key_, soon);

  // Samples beyond the stored hits are traced again, from a list too.
  for (const bool new_hit : {true, false}) kernels_.want(Pass::trace, of_samples(key_, 1, true, new_hit), spare);
  want(Pass::trace, key_, SAMPLES_PER_HIT, true, spare);
  if (!kernels_.same_bits()) return;
  const KernelKey any = generic(key_);
  for (const bool list : {true, false})
    for (const uint32_t samples : {1u, uint32_t{SAMPLES_PER_HIT}}) want(Pass::shade, any, samples, list, spare);
  for (const bool new_hit : {true, false}) kernels_.want(Pass::trace, of_samples(any, 1, false, new_hit), spare);
  for (const KernelKey& next : neighbours(any, draws_))
    for (const auto& [pass, key] : first_kernels(next)) kernels_.want(pass, key, spare);
}

}  // namespace vamp
