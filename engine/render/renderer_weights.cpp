// Weights at hand: their sums, gathered while nothing else is asked for, and edits answered from them.
#include <algorithm>
#include <utility>

#include "engine/core/check.h"
#include "engine/gpu/command_list.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

// Pixels times samples: some 40 ms on two cores of lavapipe.
constexpr uint64_t kCaughtUpAtOnce = 1u << 18;

}  // namespace

void Renderer::set_weights_at_hand(const WeightGroup& group) {
  if (group == at_hand_) return;
  at_hand_ = group;
  weights_.reset();
  weight_memory_.clear();
}

void Renderer::forget_weights() {
  if (weights_) weight_memory_ = std::move(*weights_).take_memory();
  weights_.reset();
}

void Renderer::make_weight_sums() {
  if (static_cast<size_t>(at_hand_.material) >= project_->materials.size()) {
    at_hand_ = {};
    return;
  }
  weights_.emplace(*device_, WeightSpan(material_tables_, *project_, at_hand_), display_.count(), key_.planes(),
                   tiles_.size(), weight_bytes_, std::exchange(weight_memory_, {}));
  for (WeightSums::Direction& direction : weights_->directions) {
    std::vector<gpu::Bound> bound = bound_tables();
    const auto replace = [&](gpu::Bound with) {
      const auto at =
          std::find_if(bound.begin(), bound.end(), [&](const auto& b) { return b.binding == with.binding; });
      *at = std::move(with);
    };
    replace({BINDING_BASES, direction.bases.view});
    replace({BINDING_CLUSTERS, direction.clusters.view});
    replace({BINDING_ACCUMULATORS, direction.accumulators_view});
    replace({BINDING_LIST, weights_->list});
    direction.set = gpu::DescriptorSet(*device_, "weights at hand", kernel_bindings(key_.path), bound);
  }
}

std::optional<WeightSums::Step> Renderer::next_weight_step(bool tints) const {
  for (size_t k = 0; k < std::min(weights_->directions.size(), tints ? ~size_t{0} : weights_->span.needed()); ++k) {
    const std::vector<uint32_t>& have = weights_->directions[k].samples;
    WeightSums::Step step;
    step.direction = k;
    step.base = ~0u;
    for (size_t t = 0; t < tiles_.size(); ++t)
      if (have[t] < samples_[t]) step.base = std::min(step.base, have[t]);
    if (step.base == ~0u) continue;
    uint32_t least = ~0u;
    for (size_t t = 0; t < tiles_.size(); ++t) {
      if (have[t] != step.base || samples_[t] <= step.base) continue;
      step.tiles.push_back(t);
      least = std::min(least, samples_[t] - step.base);
      // What has no place of its own would be traced over a hit that the picture still wants.
      if (!hit_is_stored(step.base) && samples_[t] % SAMPLES_PER_HIT != 0) return std::nullopt;
    }
    const bool whole_hit = step.base % SAMPLES_PER_HIT == 0 && least >= SAMPLES_PER_HIT && batches_fit() &&
                           kernels_there(true, !hit_is_stored(step.base), SAMPLES_PER_HIT);
    if (!hit_is_stored(step.base) && !whole_hit) return std::nullopt;
    step.batch = whole_hit ? SAMPLES_PER_HIT : 1;
    return step;
  }
  return std::nullopt;
}

bool Renderer::wants_weights(bool tints) const {
  if (at_hand_.rows.empty() || replaying() || region_.width == 0 || samples() < SAMPLES_PER_HIT) return false;
  if (!kernels_there_to_replay() || !kernels_.ready(Pass::recombine, key_)) return false;
  return !weights_ || weights_->step || next_weight_step(tints);
}

void Renderer::begin_weight_step(bool tints) {
  weights_->step = next_weight_step(tints);
  if (!weights_->step) return;
  WeightSums::Step& step = *weights_->step;
  weights_->clear(*device_, step.direction);
  std::vector<bool> wanted(tiles_.size());
  for (const size_t t : step.tiles) wanted[t] = true;
  step.pixels = pixels_that_see(weights_->span.seen(), wanted);
}

void Renderer::send_weight_list(const std::vector<uint32_t>& pixels) {
  if (pixels == weights_->listed) return;
  if (!pixels.empty()) device_->upload_rows<uint32_t>(weights_->list, 0, pixels);
  weights_->listed = pixels;
}

uint64_t Renderer::gather_weights(bool tints, uint32_t most) {
  CHECK(!replaying() && most > 0);
  if (!weights_) {
    make_weight_sums();
    if (weights_) prepare_recombine();
  }
  if (!weights_) return device_->last_submitted();
  if (!weights_->step) begin_weight_step(tints);
  if (!weights_->step) return device_->last_submitted();
  WeightSums::Step& step = *weights_->step;
  WeightSums::Direction& direction = weights_->directions[step.direction];
  uint64_t value = device_->last_submitted();
  const auto pixels = static_cast<uint32_t>(step.pixels.size());
  if (pixels > 0) {
    send_weight_list(step.pixels);
    frame::TilePush push{};
    push.x = step.at;
    push.width = std::min(std::max(most / step.batch, 1u), pixels - step.at);
    push.height = 1;
    push.sample_base = step.base;
    push.stride = 1;
    push.weights_alone = 1;
    value = submit_batch(push, true, !hit_is_stored(step.base), step.batch, direction.set);
    step.at += push.width;
  }
  if (step.at == pixels) {
    for (const size_t t : step.tiles) direction.samples[t] += step.batch;
    weights_->step.reset();
  }
  return value;
}

bool Renderer::weights_ready() const {
  if (!weights_ || replaying() || weights_->directions.empty()) return false;
  return weights_->ready(samples_) >= weights_->span.needed();
}

bool Renderer::tints_ready() const {
  return weights_ready() && weights_->ready(samples_) == weights_->span.directions().size();
}

bool Renderer::holds_weights_of(size_t material) const {
  return weights_ && at_hand_.material == static_cast<int>(material) &&
         weights_->span.steps_to(material_tables_, weights_->directions.size());
}

std::optional<std::vector<double>> Renderer::steps_of_weights() {
  if (replaying()) return std::nullopt;
  // A direction that the picture has been pulled along takes part: what was traced since then was pulled already.
  size_t pulled = 0;
  for (size_t k = 0; k < weights_->directions.size(); ++k)
    if (weights_->directions[k].applied != 0) pulled = k + 1;
  // Tints only where they are needed.
  for (const size_t count : {std::max(weights_->span.needed(), pulled), weights_->directions.size()}) {
    catch_up_weights(std::min(count, weights_->directions.size()));
    const size_t ready = weights_->ready(samples_);
    if (ready < pulled) break;
    const auto steps = weights_->span.steps_to(material_tables_, std::min(count, ready));
    if (steps) return steps;
  }
  return std::nullopt;
}

// Tiles may have gone ahead since the sums were gathered; a little is caught up at once.
void Renderer::catch_up_weights(size_t directions) {
  for (size_t k = 0; k < directions; ++k) {
    const std::vector<uint32_t>& have = weights_->directions[k].samples;
    uint64_t behind = 0;
    for (size_t t = 0; t < tiles_.size(); ++t) behind = std::max<uint64_t>(behind, samples_[t] - have[t]);
    if (behind * weights_->listed.size() > kCaughtUpAtOnce) return;
    while (have != samples_ && wants_weights(true)) gather_weights(true, ~0u);
  }
}

void Renderer::prepare_recombine() {
  if (weights_->directions.empty()) return;
  gpu::CommandList list = device_->begin("prepare to recombine");
  list.bind(kernels_.get(Pass::recombine, key_), weights_->directions.front().set);
  list.push(frame::TilePush{.height = 1, .stride = 1});
  list.dispatch(1);
  device_->submit(std::move(list));
}

void Renderer::recombine(const std::vector<double>& steps, Change& change) {
  send_weight_list(pixels_that_see(weights_->span.seen(), std::vector<bool>(tiles_.size(), true)));
  change.recombined = weights_->listed.size();
  if (change.what.empty()) change.what = "weights edited";
  if (weights_->listed.empty()) return;
  gpu::CommandList list = device_->begin("recombine");
  for (size_t k = 0; k < weights_->directions.size(); ++k) {
    WeightSums::Direction& direction = weights_->directions[k];
    const double step = (k < steps.size() ? steps[k] : 0) - direction.applied;
    if (step == 0 && k > 0) continue;
    CHECK(direction.cleared);
    frame::TilePush push{};
    push.width = static_cast<uint32_t>(weights_->listed.size());
    push.height = 1;
    push.stride = 1;
    // The steps taken add up to those wanted, whatever they were rounded to on the way.
    push.step = static_cast<float>(step);
    direction.applied += static_cast<double>(push.step);
    list.bind(kernels_.get(Pass::recombine, key_), direction.set);
    list.push(push);
    list.dispatch((push.width + GROUP_SIZE - 1) / GROUP_SIZE);
    list.barrier(gpu::Stage::compute, gpu::Stage::compute);
  }
  device_->submit(std::move(list));
}

}  // namespace vamp
