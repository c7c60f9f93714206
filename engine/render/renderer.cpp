#include "engine/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>

#include "engine/core/check.h"
#include "engine/gpu/command_list.h"
#include "engine/gpu/device.h"
#include "engine/scene/camera.h"

namespace vamp {
namespace {

static_assert(kMaxLights == MAX_LIGHTS);

constexpr float kUnbounded = 3.0e38f;
constexpr uint32_t kAovLayers = 3;

// With more shadow rays a batch of four would spill the kernels' registers, and walk more than lavapipe lets a kernel.
constexpr uint32_t kMaxRaysOfBatch = 16;

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

// Place and shape; not what it emits.
bool same_geometry(Light a, Light b) {
  a.name = b.name = "";
  a.on = b.on = true;
  a.power = b.power = 1;
  a.color = b.color = vec3(1);
  return a == b;
}

std::vector<bool> visible_parts(const Project& project) {
  std::vector<bool> visible;
  for (const PartState& part : project.parts) visible.push_back(part.visible);
  return visible;
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

bool any_lit(const Project& project) { return project.ambient != vec3(0); }

}  // namespace

Renderer::Renderer(gpu::Device& device) : device_(&device), kernels_(device) {
  // Measured: texel buffers are nearly twice as fast on lavapipe before Mesa 25, storage buffers elsewhere.
  key_.storage_fetch = !(device.info().is_lavapipe && device.info().driver_major < 25);
  gpu_.params = gpu::TypedBuffer<frame::FrameParams>(device, "frame", 1);
}

void Renderer::set_region(int picture_width, int picture_height, const Region& region) {
  CHECK(region.width > 0 && region.height > 0 && region.x >= 0 && region.y >= 0);
  CHECK(region.x + region.width <= picture_width && region.y + region.height <= picture_height);
  picture_width_ = picture_width;
  picture_height_ = picture_height;
  region_ = region;
  tiles_ = tiles_from_the_middle(region.width, region.height);
  samples_.assign(tiles_.size(), 0);
  replay_.clear();
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

void Renderer::make_descriptor_set() {
  std::vector<gpu::Bound> bound;
  gpu_.bind(*device_, bound);
  bound.insert(bound.end(), {{BINDING_HITS, hits_view_},
                             {BINDING_VISIBILITY, visibility_view_},
                             {BINDING_ACCUMULATORS, accumulators_view_},
                             {BINDING_DISPLAY, display_},
                             {BINDING_AOV, aov_view_},
                             {BINDING_LIST, list_},
                             {BINDING_SEEN, seen_view_}});
  set_ = gpu::DescriptorSet(*device_, "picture", kernel_bindings(), bound);
}

bool Renderer::geometry_differs(const Project& now) const {
  return !project_ || now.scene != project_->scene || visible_parts(now) != visible_parts(*project_);
}

bool Renderer::materials_differ(const Project& now) const {
  if (geometry_differs(now) || now.materials.size() != project_->materials.size()) return true;
  for (size_t i = 0; i < now.materials.size(); ++i)
    if (now.materials[i].fit != project_->materials[i].fit) return true;
  for (size_t i = 0; i < now.parts.size(); ++i)
    if (now.parts[i].material != project_->parts[i].material) return true;
  return false;
}

bool Renderer::lights_moved(const Project& now) const {
  if (!project_ || now.lights.size() != project_->lights.size()) return true;
  for (size_t i = 0; i < now.lights.size(); ++i) {
    const bool traced = std::find(lights_.begin(), lights_.end(), i) != lights_.end();
    // A dark light is left out, as in a fresh render: its place in the order numbers the others' random pairs.
    if (now.lights[i].on != traced) return true;
    if (traced && !same_geometry(now.lights[i], project_->lights[i])) return true;
  }
  return false;
}

Result<Change> Renderer::set_project(std::shared_ptr<const Project> next) {
  VAMP_CHECK_STATUS(validate(*next, next->model.string()));
  Result<Change> change = take_project(std::move(next));
  // Some tables are the new project's and some the old one's now: the next project is sent whole.
  if (!change) project_ = nullptr;
  return change;
}

Result<Change> Renderer::take_project(std::shared_ptr<const Project> next) {
  const Project& now = *next;
  Change change;
  const auto restart = [&](const char* why) {
    if (!change.restarted) change.what = why;
    change.restarted = true;
  };

  bool new_tables = false;
  // Clusters of which the light that they send to the viewer changed, as bits; no ray moved.
  uint32_t touched = 0;
  const auto reshade = [&](uint32_t seen, const char* why) {
    if (change.what.empty()) change.what = why;
    touched |= seen;
  };
  if (geometry_differs(now)) {
    scene_tables_ = std::make_shared<SceneTables>(build_scene_tables(*now.scene, visible_parts(now)));
    VAMP_TRY(const uint64_t bytes, gpu_.send_scene(*device_, *scene_tables_, key_.storage_fetch));
    change.bytes += bytes;
    new_tables = true;
    restart("geometry");
  }
  const bool new_geometry = new_tables;
  if (materials_differ(now)) {
    VAMP_TRY(material_tables_, build_material_tables(now));
    VAMP_TRY(const uint64_t bytes, gpu_.send_materials(*device_, material_tables_));
    change.bytes += bytes;
    new_tables = true;
    if (new_geometry)
      restart("geometry");
    else
      reshade(~0u, "material assigned");
    change.places_moved = true;
  } else {
    // The common edit: some rows of 48 or 16 bytes.
    for (size_t i = 0; i < now.materials.size(); ++i) {
      if (now.materials[i].edits == project_->materials[i].edits) continue;
      if (material_tables_.sums[i].texels.empty()) continue;  // no visible part shows it
      const ChangedRows rows = apply_edits(material_tables_, now, i);
      for (const auto& [first, count] : rows.bases)
        change.bytes += device_->upload_rows<tables::BasisRow>(gpu_.bases.rows, first,
                                                               std::span(material_tables_.bases).subspan(first, count));
      for (const auto& [first, count] : rows.clusters)
        change.bytes += device_->upload_rows<tables::ClusterRow>(
            gpu_.clusters.rows, first, std::span(material_tables_.clusters).subspan(first, count));
      const MaterialTables::Place& place = material_tables_.places[i];
      const uint32_t bases = static_cast<uint32_t>(now.materials[i].fit->dictionary.size());
      uint32_t seen = 0;
      for (const auto& [first, count] : rows.bases)
        for (uint32_t row = first; row < first + count; ++row) seen |= seen_bit(i, (row - place.basis) / bases);
      for (const auto& [first, count] : rows.clusters)
        for (uint32_t row = first; row < first + count; ++row) seen |= seen_bit(i, row - place.cluster);
      if (seen != 0) reshade(seen, "material edited");
    }
  }
  const std::vector<frame::PartRow> rows = vamp::part_rows(now, *scene_tables_, material_tables_);
  if (part_rows_.size() == rows.size())
    for (size_t i = 0; i < rows.size(); ++i)
      if (rows[i].mirror_f0 != part_rows_[i].mirror_f0) restart("mirror of a part");
  if (new_tables || rows.size() != part_rows_.size()) {
    VAMP_TRY(const uint64_t bytes, gpu_.send_parts(*device_, rows));
    change.bytes += bytes;
    part_rows_ = rows;
  } else {
    for (size_t i = 0; i < rows.size(); ++i) {
      if (std::memcmp(&rows[i], &part_rows_[i], sizeof(rows[i])) == 0) continue;
      part_rows_[i] = rows[i];
      change.bytes += device_->upload_rows<frame::PartRow>(gpu_.parts.rows, i, std::span(&rows[i], 1));
      change.places_moved = true;
      // Before and after: the texture may be of another material now.
      if (now.parts[i].visible)
        reshade(seen_bits(now, static_cast<size_t>(now.parts[i].material)), "texture of a part");
    }
  }
  if (!project_ || now.environment.map != project_->environment.map) {
    VAMP_TRY(const uint64_t bytes, gpu_.send_environment(*device_, now.environment.map.get()));
    change.bytes += bytes;
    new_tables = true;
    restart("environment");
  }
  if (lights_moved(now)) {
    lights_.clear();
    std::vector<frame::LightRow> light_rows;
    for (size_t i = 0; i < now.lights.size(); ++i)
      if (now.lights[i].on) {
        lights_.push_back(i);
        light_rows.push_back(light_row(now.lights[i]));
      }
    change.bytes += gpu_.send_lights(*device_, light_rows);
    restart("lights");
  }

  // What the kernels are specialised for.
  KernelKey key = key_;
  key.light_count = static_cast<uint32_t>(lights_.size());
  key.light_types = 0;
  for (const size_t i : lights_) key.light_types |= 1u << static_cast<uint32_t>(now.lights[i].type);
  key.environment = now.environment.map != nullptr;
  key.ambient = any_lit(now) || (key.light_count == 0 && !key.environment);
  key.mirror = std::any_of(now.parts.begin(), now.parts.end(),
                           [](const PartState& part) { return part.visible && part.mirror_f0 > 0; });
  key.alpha_mask = !scene_tables_->alpha.empty();
  key.residual = residual_in_view(now);
  key.lobe_models = lobe_models_in_view(now);
  key.four_taps = now.settings.tap == TexelTap::four;
  key.pixel_centres = now.settings.pixel_centres;
  const bool new_picture = key.planes() != key_.planes() || key.mirror != key_.mirror || !hits_;
  // Kernels that are specialised for other ways of shading may round differently, so all pixels go through the same
  // one.
  KernelKey same_rays = key;
  same_rays.residual = key_.residual;
  same_rays.lobe_models = key_.lobe_models;
  same_rays.four_taps = key_.four_taps;
  if (same_rays != key_)
    restart("what the scene needs");
  else if (key != key_)
    reshade(~0u, "how texels are blended");
  key_ = key;

  if (project_) {
    if (now.camera != project_->camera) restart("camera");
    if (now.settings.seed != project_->settings.seed || now.settings.ao_radius != project_->settings.ao_radius)
      restart("sampling settings");
    const bool turned = now.environment.rotation != project_->environment.rotation ||
                        now.environment.visible != project_->environment.visible;
    if (now.environment.map && turned) restart("environment");
    // Seen directly, or in a mirror, the environment and the background stand in an accumulator as they are.
    const bool dimmed = now.environment.intensity != project_->environment.intensity;
    if (now.environment.map && dimmed && (now.environment.visible || key.mirror)) restart("environment");
    if (key.mirror && now.background != project_->background) restart("background");
  }
  const frame::FrameParams before = params_;
  project_ = std::move(next);
  if (region_.width > 0) {
    if (new_picture) make_picture();
    if (new_picture || new_tables || !set_) make_descriptor_set();
    change.bytes += send_frame();
  }
  if (change.restarted) {
    std::fill(samples_.begin(), samples_.end(), 0u);
    replay_.clear();
  } else if (touched != 0 && region_.width > 0) {
    begin_replay(touched, change);
  }
  if (!change.restarted && std::memcmp(&before, &params_, sizeof(before)) != 0) change.recomposed = true;
  return change;
}

uint64_t Renderer::send_frame() {
  const Project& now = *project_;
  frame::FrameParams p{};
  const CameraFrame camera =
      camera_frame(now.camera, static_cast<float>(picture_width_) / static_cast<float>(picture_height_));
  p.origin = camera.origin;
  p.right = camera.right;
  p.up = camera.up;
  p.forward = camera.forward;
  p.seed = now.settings.seed;
  p.ao_radius = now.settings.ao_radius > 0 ? now.settings.ao_radius : kUnbounded;
  p.offset_scale = now.scene->bounds.radius() * 1e-6f;
  p.grid_origin = scene_tables_->bvh.grid_origin;
  p.grid_scale = scene_tables_->bvh.grid_scale;
  p.picture_width = static_cast<uint32_t>(picture_width_);
  p.picture_height = static_cast<uint32_t>(picture_height_);
  p.region_x = static_cast<uint32_t>(region_.x);
  p.region_y = static_cast<uint32_t>(region_.y);
  p.region_width = static_cast<uint32_t>(region_.width);
  p.region_height = static_cast<uint32_t>(region_.height);
  p.background = now.background;
  p.ambient = now.ambient;
  p.exposure = std::exp2(now.display.exposure);
  p.tone_map = now.display.tone_map == ToneMap::pbr_neutral ? 1 : 0;
  if (const Environment* map = now.environment.map.get()) {
    p.background_is_environment = now.environment.visible ? 1 : 0;
    p.environment_width = map->width;
    p.environment_height = map->height;
    p.environment_intensity = now.environment.intensity;
    p.environment_cos = std::cos(now.environment.rotation);
    p.environment_sin = std::sin(now.environment.rotation);
  }
  p.light_count = key_.light_count;
  p.planes = key_.planes();
  p.history = history_;
  p.list_end = static_cast<uint32_t>(scene_tables_->bvh.list_end());
  for (size_t i = 0; i < lights_.size(); ++i) p.emission[i] = light_emission(now.lights[lights_[i]]);
  if (std::memcmp(&p, &params_, sizeof(p)) == 0) return 0;
  params_ = p;
  return device_->upload_rows<frame::FrameParams>(gpu_.params, 0, std::span(&params_, 1));
}

uint32_t Renderer::samples() const {
  return samples_.empty() ? 0 : *std::min_element(samples_.begin(), samples_.end());
}

uint32_t Renderer::next_batch(uint32_t samples, uint32_t limit) const {
  if (samples >= limit) return 0;
  // The first hit's samples come one by one, so that something is seen soon.
  const bool whole_hit = samples >= SAMPLES_PER_HIT && samples % SAMPLES_PER_HIT == 0 &&
                         limit - samples >= SAMPLES_PER_HIT && batches_fit();
  return whole_hit ? SAMPLES_PER_HIT : 1;
}

uint64_t Renderer::submit_batch(const frame::TilePush& push, bool list_of_pixels, bool trace, uint32_t batch) {
  if (batch == 0) return device_->last_submitted();
  KernelKey key = key_;
  key.samples = batch;
  key.new_hit = push.sample_base % SAMPLES_PER_HIT == 0;
  key.list = list_of_pixels;
  gpu::CommandList list = device_->begin("refine");
  const auto dispatch = [&](Pass pass) {
    list.bind(kernels_.get(pass, key), set_);
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
  const bool whole_hit = done % SAMPLES_PER_HIT == 0 && step.limit - done >= SAMPLES_PER_HIT && batches_fit();
  const uint32_t batch = whole_hit ? SAMPLES_PER_HIT : 1;
  frame::TilePush push{};
  push.x = replay_at_;
  push.width = std::min(most, step.pixels - replay_at_);
  push.height = 1;
  push.sample_base = done;
  push.stride = 1;
  const bool stored = done / SAMPLES_PER_HIT + 1 < history_;
  const uint64_t value = submit_batch(push, true, !stored, batch);
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
  uint64_t value = submit_batch(push, true, false, 1);
  if (batches_fit()) value = submit_batch(push, true, false, SAMPLES_PER_HIT);
  return value;
}

bool Renderer::batches_fit() const { return SAMPLES_PER_HIT * key_.ray_count() <= kMaxRaysOfBatch; }

uint64_t Renderer::refine(int tile, uint32_t limit) {
  CHECK(!replaying());
  uint32_t& done = samples_[static_cast<size_t>(tile)];
  const uint32_t batch = next_batch(done, limit);
  const uint64_t value = submit_batch(push_of(tiles_[static_cast<size_t>(tile)], done), false, true, batch);
  done += batch;
  return value;
}

uint64_t Renderer::preview(uint32_t stride) {
  CHECK(stride > 0 && !replaying() && *std::max_element(samples_.begin(), samples_.end()) == 0);
  return submit_batch(push_of({0, 0, region_.width, region_.height}, 0, stride), false, true, 1);
}

uint64_t Renderer::refine_all(uint32_t limit) {
  CHECK(!replaying());
  const uint32_t done = samples_.front();
  CHECK(std::all_of(samples_.begin(), samples_.end(), [&](uint32_t s) { return s == done; }));
  const uint32_t batch = next_batch(done, limit);
  const uint64_t value = submit_batch(push_of({0, 0, region_.width, region_.height}, done), false, true, batch);
  std::fill(samples_.begin(), samples_.end(), done + batch);
  return value;
}

uint64_t Renderer::recompose() {
  gpu::CommandList list = device_->begin("recompose");
  list.bind(kernels_.get(Pass::composite, key_), set_);
  for (size_t i = 0; i < tiles_.size(); ++i) {
    if (samples_[i] == 0) continue;
    list.push(push_of(tiles_[i], samples_[i]));
    list.dispatch(groups(static_cast<uint32_t>(tiles_[i].width)), groups(static_cast<uint32_t>(tiles_[i].height)));
  }
  return device_->submit(std::move(list));
}

uint64_t Renderer::render_aov() {
  gpu::CommandList list = device_->begin("layers");
  list.bind(kernels_.get(Pass::aov, key_), set_);
  for (const Region& area : tiles_) {
    list.push(push_of(area, 0));
    list.dispatch(groups(static_cast<uint32_t>(area.width)), groups(static_cast<uint32_t>(area.height)));
  }
  return device_->submit(std::move(list));
}

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
