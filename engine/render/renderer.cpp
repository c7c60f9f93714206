#include "engine/render/renderer.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/gpu/command_list.h"
#include "engine/gpu/device.h"
#include "engine/render/trace_path.h"

namespace vamp {
namespace {

constexpr uint32_t kAovLayers = 3;

// With more shadow rays a batch of four would spill the kernels' registers, and walk more than lavapipe lets a kernel.
constexpr uint32_t kMaxRaysOfBatch = 16;

// Pixels of which four samples each take some 3 ms on two cores of lavapipe; one each takes half.
constexpr uint32_t kLongList = 1u << 12;

std::vector<Region> tiles_from_the_middle(int width, int height) {
  std::vector<Region> tiles;
  for (int y = 0; y < height; y += TILE_SIDE)
    for (int x = 0; x < width; x += TILE_SIDE)
      tiles.push_back({x, y, std::min(TILE_SIDE, width - x), std::min(TILE_SIDE, height - y)});
  const auto distance2 = [&](const Region& t) {
    const int64_t dx = 2 * t.x + t.width - width, dy = 2 * t.y + t.height - height;
    return dx * dx + dy * dy;
  };
  std::stable_sort(tiles.begin(), tiles.end(),
                   [&](const Region& a, const Region& b) { return distance2(a) < distance2(b); });
  return tiles;
}

frame::TilePush push_of(const Region& tile, uint32_t sample_base, uint32_t stride = 1) {
  return {static_cast<uint32_t>(tile.x),
          static_cast<uint32_t>(tile.y),
          static_cast<uint32_t>(tile.width),
          static_cast<uint32_t>(tile.height),
          sample_base,
          stride};
}

uint32_t groups(uint32_t side, uint32_t stride = 1) { return (side + 8 * stride - 1) / (8 * stride); }

}  // namespace

Renderer::Renderer(gpu::Device& device, std::span<const uint32_t> shade) : device_(&device), kernels_(device, shade) {
  key_.path = trace_paths(device.info()).chosen();
  gpu_.params = gpu::TypedBuffer<frame::FrameParams>(device, "frame", 1);
}

Status Renderer::sums_fit(uint32_t planes, int width, int height) const {
  return device_->fits_texel_view("sums of each light at this size of the picture",
                                  uint64_t{2} * planes * static_cast<uint64_t>(width) * static_cast<uint64_t>(height));
}

Status Renderer::region_fits(int width, int height) const { return sums_fit(key_.planes(), width, height); }

void Renderer::set_region(int picture_width, int picture_height, const Region& region) {
  CHECK(region.width > 0 && region.height > 0 && region.x >= 0 && region.y >= 0);
  CHECK(region.x + region.width <= picture_width && region.y + region.height <= picture_height);
  picture_width_ = picture_width;
  picture_height_ = picture_height;
  region_ = region;
  tiles_ = tiles_from_the_middle(region.width, region.height);
  samples_.assign(tiles_.size(), 0);
  replay_.clear();
  weights_.reset();
  weight_memory_.clear();
  set_ = {};
  hits_ = {};
  if (project_) {
    make_picture();
    make_descriptor_set();
    send_frame();
  }
}

void Renderer::make_picture() {
  const uint64_t pixels = static_cast<uint64_t>(region_.width) * static_cast<uint64_t>(region_.height);
  const auto table = [&](auto& buffer, gpu::TexelView& view, const char* name, uint64_t count, VkFormat format) {
    buffer = std::remove_reference_t<decltype(buffer)>(*device_, name, count, gpu::Usage::storage_texel);
    view = gpu::TexelView(*device_, buffer, format);
  };
  const uint64_t vertices = key_.mirror ? 2 : 1;
  const uint64_t words = (SAMPLES_PER_HIT * key_.ray_count() + 31) / 32;
  const uint64_t hit_bytes = pixels * vertices * (1 + words) * sizeof(uint32_t);
  const uint64_t fits = device_->info().max_texel_elements / (pixels * vertices * words);
  // One more place for what is not kept.
  history_ = 1 + static_cast<uint32_t>(std::min(history_bytes_ / hit_bytes, std::max<uint64_t>(fits, 1) - 1));
  table(hits_, hits_view_, "hits", pixels * vertices * history_, VK_FORMAT_R32_UINT);
  table(visibility_, visibility_view_, "visibility", pixels * vertices * words * history_, VK_FORMAT_R32_UINT);
  table(seen_, seen_view_, "seen clusters", 2 * pixels, VK_FORMAT_R32_UINT);
  list_ = gpu::TypedBuffer<uint32_t>(*device_, "pixels to shade again", pixels);
  table(accumulators_, accumulators_view_, "accumulators", pixels * 2 * key_.planes(), VK_FORMAT_R32G32B32A32_SFLOAT);
  table(aov_, aov_view_, "layers", pixels * kAovLayers, VK_FORMAT_R32G32B32A32_SFLOAT);
  display_ = gpu::TypedBuffer<uint32_t>(*device_, "display", pixels);
}

std::vector<gpu::Bound> Renderer::bound_tables() const {
  std::vector<gpu::Bound> bound;
  gpu_.bind(*device_, bound);
  bound.insert(bound.end(), {{BINDING_HITS, hits_view_},
                             {BINDING_VISIBILITY, visibility_view_},
                             {BINDING_ACCUMULATORS, accumulators_view_},
                             {BINDING_DISPLAY, display_},
                             {BINDING_AOV, aov_view_},
                             {BINDING_LIST, list_},
                             {BINDING_SEEN, seen_view_},
                             {BINDING_WHOLE, accumulators_view_}});
  return bound;
}

void Renderer::make_descriptor_set() {
  forget_weights();
  const std::vector<gpu::Bound> bound = bound_tables();
  const std::vector<gpu::Binding>& bindings = kernel_bindings(key_.path);
  set_ = gpu::DescriptorSet(*device_, "picture", bindings, bound);
  kernels_.bound_as(bindings, bound);
}

uint32_t Renderer::samples() const {
  return samples_.empty() ? 0 : *std::min_element(samples_.begin(), samples_.end());
}

uint32_t Renderer::next_batch(uint32_t samples, uint32_t limit) const {
  if (samples >= limit) return 0;
  // The first hit's samples come one by one, so that something is seen soon.
  const bool whole_hit = samples >= SAMPLES_PER_HIT && samples % SAMPLES_PER_HIT == 0 &&
                         limit - samples >= SAMPLES_PER_HIT && batches_fit() &&
                         kernels_there(false, true, SAMPLES_PER_HIT);
  return whole_hit ? SAMPLES_PER_HIT : 1;
}

uint64_t Renderer::submit_batch(const frame::TilePush& push, bool list_of_pixels, bool trace, uint32_t batch,
                                const gpu::DescriptorSet& set) {
  if (batch == 0) return device_->last_submitted();
  KernelKey key = key_;
  key.samples = batch;
  key.new_hit = push.sample_base % SAMPLES_PER_HIT == 0;
  key.list = list_of_pixels;
  gpu::CommandList list = device_->begin("refine");
  const auto dispatch = [&](Pass pass) {
    list.bind(kernels_.get(pass, key), set);
    list.push(push);
    if (list_of_pixels)
      list.dispatch(std::max((push.width + GROUP_SIZE - 1) / GROUP_SIZE, 1u));
    else
      list.dispatch(groups(push.width, push.stride), groups(push.height, push.stride));
  };
  if (trace) {
    dispatch(Pass::trace);
    list.barrier(gpu::Stage::compute, gpu::Stage::compute);
  }
  dispatch(Pass::shade);
  return device_->submit(std::move(list));
}

std::vector<uint32_t> Renderer::pixels_that_see(uint32_t clusters, const std::vector<bool>& wanted) const {
  const std::vector<uint32_t> seen =
      device_->readback_rows<uint32_t>(seen_, 0, display_.count(), device_->last_submitted());
  std::vector<uint32_t> list;
  for (size_t t = 0; t < tiles_.size(); ++t) {
    if (!wanted[t] || samples_[t] == 0) continue;
    for (int y = tiles_[t].y; y < tiles_[t].y + tiles_[t].height; ++y)
      for (int x = tiles_[t].x; x < tiles_[t].x + tiles_[t].width; ++x) {
        const auto pixel = static_cast<uint32_t>(y * region_.width + x);
        if ((seen[pixel] & clusters) != 0) list.push_back(pixel);
      }
  }
  return list;
}

void Renderer::begin_replay(uint32_t touched, Change& change) {
  const uint64_t pixels = display_.count();
  const std::vector<uint32_t> seen = device_->readback_rows<uint32_t>(seen_, 0, pixels, device_->last_submitted());
  // Those that an earlier edit has left behind come along.
  std::vector<bool> behind(pixels);
  for (uint32_t i = 0; i < replay_.step().pixels; ++i) behind[replay_.pixels()[i]] = true;
  std::vector<uint32_t> list, targets;
  for (size_t t = 0; t < tiles_.size(); ++t) {
    if (samples_[t] == 0) continue;
    const Region& tile = tiles_[t];
    for (int y = tile.y; y < tile.y + tile.height; ++y)
      for (int x = tile.x; x < tile.x + tile.width; ++x) {
        const uint32_t pixel = static_cast<uint32_t>(y * region_.width + x);
        if (!behind[pixel] && (seen[pixel] & touched) == 0) continue;
        list.push_back(pixel);
        targets.push_back(samples_[t]);
      }
  }
  change.reshaded = list.size();
  replay_.begin(std::move(list), targets);
  replay_at_ = 0;
  // Not counted among the edit's bytes: it says where to look, not what changed.
  if (replay_.active()) device_->upload_rows<uint32_t>(list_, 0, replay_.pixels());
}

uint64_t Renderer::replay(uint32_t most) {
  CHECK(replaying() && most > 0);
  const Replay::Step step = replay_.step();
  const uint32_t done = replay_.done();
  // Of a long list the first hit's samples come one by one, too: that picture is there in half the time.
  const bool soon = done == 0 && step.pixels > kLongList;
  const bool whole_hit = !soon && done % SAMPLES_PER_HIT == 0 && step.limit - done >= SAMPLES_PER_HIT &&
                         batches_fit() && kernels_there(true, !hit_is_stored(done), SAMPLES_PER_HIT);
  const uint32_t batch = whole_hit ? SAMPLES_PER_HIT : 1;
  frame::TilePush push{};
  push.x = replay_at_;
  push.width = std::min(std::max(most / batch, 1u), step.pixels - replay_at_);
  push.height = 1;
  push.sample_base = done;
  push.stride = 1;
  const uint64_t value = submit_batch(push, true, !hit_is_stored(done), batch, set_);
  replay_at_ += push.width;
  if (replay_at_ == step.pixels) {
    replay_at_ = 0;
    replay_.advance(batch);
  }
  return value;
}

uint64_t Renderer::prepare_replay() {
  CHECK(!replaying());
  // lavapipe compiles at the first dispatch, of whatever size: a list without pixels will do.
  frame::TilePush push{};
  push.height = 1;
  push.stride = 1;
  uint64_t value = device_->last_submitted();
  if (kernels_there(true, false, 1)) value = submit_batch(push, true, false, 1, set_);
  if (batches_fit() && kernels_there(true, false, SAMPLES_PER_HIT))
    value = submit_batch(push, true, false, SAMPLES_PER_HIT, set_);
  return value;
}

bool Renderer::batches_fit() const { return SAMPLES_PER_HIT * key_.ray_count() <= kMaxRaysOfBatch; }

uint64_t Renderer::refine(int tile, uint32_t limit) {
  CHECK(!replaying() && !wants_tree());
  uint32_t& done = samples_[static_cast<size_t>(tile)];
  const uint32_t batch = next_batch(done, limit);
  const uint64_t value = submit_batch(push_of(tiles_[static_cast<size_t>(tile)], done), false, true, batch, set_);
  done += batch;
  return value;
}

uint64_t Renderer::preview(uint32_t stride) {
  CHECK(stride > 0 && !replaying() && *std::max_element(samples_.begin(), samples_.end()) == 0);
  return submit_batch(push_of({0, 0, region_.width, region_.height}, 0, stride), false, true, 1, set_);
}

uint64_t Renderer::refine_all(uint32_t limit) {
  CHECK(!replaying() && !wants_tree());
  const uint32_t done = samples_.front();
  CHECK(std::all_of(samples_.begin(), samples_.end(), [&](uint32_t s) { return s == done; }));
  const uint32_t batch = next_batch(done, limit);
  const uint64_t value = submit_batch(push_of({0, 0, region_.width, region_.height}, done), false, true, batch, set_);
  std::fill(samples_.begin(), samples_.end(), done + batch);
  return value;
}

uint64_t Renderer::recompose() {
  gpu::CommandList list = device_->begin("recompose");
  list.bind(kernels_.get(Pass::composite, key_), set_);
  const auto dispatch = [&](const Region& area) {
    list.push(push_of(area, 0));
    list.dispatch(groups(static_cast<uint32_t>(area.width)), groups(static_cast<uint32_t>(area.height)));
  };
  // One dispatch takes three quarters of what one for each tile takes.
  if (samples() > 0)
    dispatch({0, 0, region_.width, region_.height});
  else
    for (size_t i = 0; i < tiles_.size(); ++i)
      if (samples_[i] > 0) dispatch(tiles_[i]);
  return device_->submit(std::move(list));
}

uint64_t Renderer::render_aov(std::span<const Region> areas) {
  gpu::CommandList list = device_->begin("layers");
  list.bind(kernels_.get(Pass::aov, key_), set_);
  for (const Region& area : areas) {
    list.push(push_of(area, 0));
    list.dispatch(groups(static_cast<uint32_t>(area.width)), groups(static_cast<uint32_t>(area.height)));
  }
  return device_->submit(std::move(list));
}

uint64_t Renderer::render_aov() { return render_aov(tiles_); }

uint64_t Renderer::render_aov(int tile) { return render_aov(std::span(&tiles_[static_cast<size_t>(tile)], 1)); }

uint64_t Renderer::render_occlusion(uint32_t first_sample, uint32_t samples) {
  uint64_t value = device_->last_submitted();
  for (uint32_t done = first_sample; done < first_sample + samples;) {
    KernelKey key = key_;
    const uint32_t left = first_sample + samples - done;
    key.samples = done % SAMPLES_PER_HIT == 0 && left >= SAMPLES_PER_HIT ? SAMPLES_PER_HIT : 1;
    gpu::CommandList list = device_->begin("occlusion");
    list.bind(kernels_.get(Pass::occlusion, key), set_);
    for (const Region& area : tiles_) {
      list.push(push_of(area, done));
      list.dispatch(groups(static_cast<uint32_t>(area.width)), groups(static_cast<uint32_t>(area.height)));
    }
    done += key.samples;
    value = device_->submit(std::move(list));
  }
  return value;
}

uint64_t Renderer::last_submitted() const { return device_->last_submitted(); }

std::vector<float> Renderer::accumulators(uint64_t after) {
  const size_t pixels = static_cast<size_t>(region_.width) * static_cast<size_t>(region_.height);
  std::vector<float> sums(key_.planes() * pixels * 4);
  for (uint32_t plane = 0; plane < key_.planes(); ++plane)
    device_->readback(accumulators_, 2 * plane * pixels * sizeof(vec4),
                      std::as_writable_bytes(std::span(sums).subspan(plane * pixels * 4, pixels * 4)), after);
  return sums;
}

std::vector<float> Renderer::linear_picture(uint64_t after) {
  const size_t pixels = static_cast<size_t>(region_.width) * static_cast<size_t>(region_.height);
  const std::vector<float> sums = accumulators(after);
  std::vector<float> picture(pixels * 4);
  const std::vector<uint32_t> counts = device_->readback_rows<uint32_t>(seen_, pixels, pixels, after);
  for (size_t t = 0; t < tiles_.size(); ++t) {
    if (samples_[t] == 0) continue;
    for (int y = tiles_[t].y; y < tiles_[t].y + tiles_[t].height; ++y)
      for (int x = tiles_[t].x; x < tiles_[t].x + tiles_[t].width; ++x) {
        const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(region_.width) + static_cast<size_t>(x);
        const float mean = 1.0f / static_cast<float>(counts[pixel]);
        vec3 radiance(0);
        for (uint32_t plane = 0; plane < key_.planes(); ++plane) {
          const float* sum = &sums[(plane * pixels + pixel) * 4];
          radiance += plane_emission(plane) * vec3(sum[0], sum[1], sum[2]) * mean;
        }
        const float coverage = sums[pixel * 4 + 3] * mean;
        if (params_.background_is_environment == 0) radiance += params_.background * (1.0f - coverage);
        float* out = &picture[pixel * 4];
        out[0] = radiance.x;
        out[1] = radiance.y;
        out[2] = radiance.z;
        out[3] = coverage;
      }
  }
  return picture;
}

// As shaders/lib/composite.glsl.
vec3 Renderer::plane_emission(uint32_t plane) const {
  if (plane == PLANE_DIRECT) return vec3(1);
  if (plane <= key_.light_count) return params_.emission[plane - PLANE_LIGHTS];
  if (key_.ambient && plane == key_.light_count + 1) return params_.ambient;
  return vec3(params_.environment_intensity);
}

std::vector<uint32_t> Renderer::display_picture(uint64_t after) {
  return device_->readback_rows<uint32_t>(display_, 0, display_.count(), after);
}

std::vector<vec4> Renderer::aov_layer(uint32_t layer, uint64_t after) {
  const uint64_t pixels = display_.count();
  return device_->readback_rows<vec4>(aov_, layer * pixels, pixels, after);
}

std::vector<float> Renderer::aov_layers(uint64_t after) {
  std::vector<float> layers(aov_.count() * 4);
  device_->readback(aov_, 0, std::as_writable_bytes(std::span(layers)), after);
  return layers;
}

const uint32_t* Renderer::mapped_display() const {
  return display_ ? reinterpret_cast<const uint32_t*>(display_.mapped()) : nullptr;
}

double Renderer::rays_per_sample(double coverage) const {
  const double pixels = static_cast<double>(region_.width) * region_.height;
  return pixels * (1.0 / SAMPLES_PER_HIT + coverage * key_.ray_count());
}

}  // namespace vamp
