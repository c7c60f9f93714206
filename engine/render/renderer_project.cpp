// How a renderer takes over a project: what differs from the one drawn last, what is sent, what of the picture stays.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"
#include "engine/scene/camera.h"

namespace vamp {
namespace {

static_assert(kMaxLights == MAX_LIGHTS);

constexpr float kUnbounded = 3.0e38f;

// Place and shape; not what it emits.
bool same_geometry(Light a, Light b) {
  a.name = b.name = "";
  a.on = b.on = true;
  a.power = b.power = 1;
  a.color = b.color = vec3(1);
  return a == b;
}

uint32_t highlight_code(const frame::PartRow& row) { return row.flags >> PART_HIGHLIGHT_SHIFT; }

}  // namespace

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
  // Whether only weights at hand were edited, and how far along each of their directions, if the sums are there.
  bool weights_alone = false;
  std::optional<std::vector<double>> steps;
  const auto reshade = [&](uint32_t seen, const char* why) {
    if (change.what.empty()) change.what = why;
    touched |= seen;
    weights_alone = false;
  };
  const bool new_geometry = geometry_differs(now);
  if (new_geometry || parts_moved(now)) {
    VAMP_TRY(new_tables, take_geometry(now, change));
    change.places_moved = true;
    restart(new_geometry ? "geometry" : "part moved");
  }
  if (materials_differ(now)) {
    VAMP_TRY(material_tables_, build_material_tables(now, sums_));
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
      if (!material_tables_.sums[i]) continue;  // no visible part shows it
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
      if (seen == 0) continue;
      const bool first = touched == 0 && !change.restarted;
      reshade(seen, "material edited");
      weights_alone = first && holds_weights_of(i);
      if (weights_alone) steps = steps_of_weights();
    }
  }
  const std::vector<frame::PartRow> rows = vamp::part_rows(now, *scene_tables_, material_tables_);
  if (part_rows_.size() == rows.size())
    for (size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].mirror_f0 != part_rows_[i].mirror_f0) restart("mirror of a part");
      // Another material may draw its rays another way.
      if (highlight_code(rows[i]) != highlight_code(part_rows_[i])) restart("highlight of a part");
    }
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
  // A row says how a light stands to the scene.
  if (lights_moved(now) || new_geometry) {
    lights_.clear();
    std::vector<frame::LightRow> light_rows;
    for (size_t i = 0; i < now.lights.size(); ++i)
      if (now.lights[i].on) {
        lights_.push_back(i);
        light_rows.push_back(light_row(now.lights[i], now.scene->bounds.radius()));
      }
    change.bytes += gpu_.send_lights(*device_, light_rows);
    restart("lights");
  }

  // What the kernels are specialised for.
  KernelKey key = kernel_key(now, draws_, sums_);
  key.path = key_.path;
  const bool new_picture = key.planes() != key_.planes() || key.mirror != key_.mirror || !hits_;
  if (new_picture) VAMP_CHECK_STATUS(sums_fit(key.planes(), region_.width, region_.height));
  // Kernels that are specialised for other ways of shading may round differently; then all pixels go through the same
  // one.
  KernelKey same_rays = key;
  same_rays.residual = key_.residual;
  same_rays.lobe_models = key_.lobe_models;
  same_rays.four_taps = key_.four_taps;
  if (same_rays != key_)
    restart("what the scene needs");
  else if (key.four_taps != key_.four_taps || (key != key_ && !kernels_.same_bits()))
    reshade(~0u, "how texels are blended");
  const bool first = !project_;
  const bool other_kernels = std::exchange(key_, key) != key || first;

  if (project_) {
    if (now.camera != project_->camera) {
      change.places_moved = true;
      restart("camera");
    }
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
  // What no kernel is there for starts again.
  const bool replays = touched != 0 && region_.width > 0 && !(weights_alone && steps);
  if (replays && !kernels_there_to_replay()) change.restarted = true;
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
    forget_weights();
  } else if (touched != 0 && region_.width > 0) {
    if (weights_alone && steps) {
      recombine(*steps, change);
    } else {
      // Their sums stay good, but count from the picture as it will be.
      if (weights_alone)
        weights_->start_from(material_tables_);
      else
        forget_weights();
      begin_replay(touched, change);
    }
  }
  if (other_kernels) want_kernels(first);
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

}  // namespace vamp
