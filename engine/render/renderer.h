#pragma once
// The renderer without a thread or a window: takes a project, finds what changed, and refines one tile at a time. The
// interactive session and the command line both stand on it, so that they give the same bytes.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/project/project.h"
#include "engine/render/gpu_scene.h"
#include "engine/render/kernels.h"
#include "engine/render/material_tables.h"
#include "engine/render/placed_scene.h"
#include "engine/render/region.h"
#include "engine/render/replay.h"
#include "engine/render/scene_tables.h"
#include "engine/render/weight_sums.h"

namespace vamp {

// What taking over a project came to.
struct Change {
  bool restarted = false;   // the accumulators start again
  uint64_t reshaded = 0;    // else so many pixels are shaded again from what was traced; see replay()
  uint64_t recombined = 0;  // else so many were made anew from sums that were at hand; shown by what was submitted last
  bool recomposed = false;  // only what is linear in them, or the display, changed
  bool places_moved = false;  // what a pixel shows may lie in another cluster or part now
  std::string what;           // "camera", "light moved", "material edited": the first reason
  uint64_t bytes = 0;         // sent to the device
};

class Renderer {
 public:
  // `shade`: see Kernels.
  explicit Renderer(gpu::Device& device, std::span<const uint32_t> shade = {});

  // Memory for hits and visibility by which samples can be shaded again, in bytes. A pixel's four samples take 8 of
  // them, 16 with mirrors, half as much again with more than 8 shadow rays. Samples that do not fit are traced again.
  // Before set_region(); 0 at first: a still picture is not edited.
  void set_history(uint64_t bytes) { history_bytes_ = bytes; }
  // Memory for the sums of weights at hand, in bytes; weights that do not fit are shaded again.
  void set_weight_memory(uint64_t bytes) { weight_bytes_ = bytes; }

  // From now on kernels are made beside the queue: a picture goes on with generic ones, or sample by sample, until the
  // right ones are there; which gives the same bytes. `arrived` is called on another thread whenever a kernel is there.
  // Nothing where it is of no use on this device. Before set_project().
  void make_kernels_in_background(std::function<void()> arrived) { kernels_.make_in_background(std::move(arrived)); }
  // See Kernels.
  void use_generic_kernels_alone() { kernels_.use_generic_alone(); }
  // Those that have arrived, from now on.
  void take_kernels() { kernels_.collect(); }
  // Whether a picture of the project could be begun without waiting for kernels; if not, they are wanted from now on.
  // Of the first project always.
  bool has_kernels_for(const Project& project);

  // From now on set_project() makes no new tree where parts have moved far, which takes some three frames' time, but
  // goes on with the old one until make_tree(). Meanwhile the picture can be previewed and not refined, so that its
  // samples are all of one tree: rays that hit two triangles in one place see the one that comes first in it. Where the
  // device traces rays itself no other tree is ever wanted.
  void make_trees_later() { trees_later_ = true; }
  bool wants_tree() const { return placed_ && !key_.path.ray_queries && placed_->wants_tree(); }
  // Makes it whether it is wanted or not. Nothing of the picture may be in flight, and no sample be counted. Errors:
  // too large for the device, which then needs another project.
  Status make_tree();

  // Instead of the device's trace_paths(). Before set_project().
  void set_trace_path(const TracePath& path) { key_.path = path; }
  // Another way of drawing lights, for measurements. Before set_project().
  void set_light_draws(const LightDraws& draws) { draws_ = draws; }

  // Whether the device takes the sums of a region of this size, with the lights of the project. Error: what does not
  // fit.
  Status region_fits(int width, int height) const;
  // Size of the whole picture and the part of it that is rendered; it fits. Restarts.
  void set_region(int picture_width, int picture_height, const Region& region);

  // Compares with the project drawn last and sends the difference. Errors: tables too large for the device, no such
  // direction set. Nothing of the picture may be in flight (wait for the last submit).
  Result<Change> set_project(std::shared_ptr<const Project> project);

  // Tiles of the region, TILE_SIDE pixels a side, in the order in which they are best refined (from the middle).
  int tile_count() const { return static_cast<int>(tiles_.size()); }
  const Region& tile(int index) const { return tiles_[static_cast<size_t>(index)]; }
  const std::vector<Region>& tiles() const { return tiles_; }
  uint32_t samples_of(int tile) const { return samples_[static_cast<size_t>(tile)]; }
  const std::vector<uint32_t>& samples_of_tiles() const { return samples_; }
  // Of the least refined tile.
  uint32_t samples() const;

  // The batch that follows `samples`: 1 until a stored hit is used up for the first time, then whole hits, cut at
  // `limit`. A batch never crosses a stored hit, and every batching gives the same bits.
  uint32_t next_batch(uint32_t samples, uint32_t limit) const;

  // Refines a tile by its next batch up to `limit` samples; returns the timeline value. One submit of trace and shade.
  uint64_t refine(int tile, uint32_t limit);

  // A coarse first look after a restart: one pixel of each block of stride x stride, shown as a block. Counts for
  // nothing.
  uint64_t preview(uint32_t stride);

  // The whole region in one submit, for work that nobody watches; all tiles must stand at the same number of samples.
  uint64_t refine_all(uint32_t limit);

  // After an edit that moved no ray: the pixels that saw it get their samples anew, from stored hits and visibility,
  // before anything else is refined. Submits the next part, of at most `most` samples; returns the timeline
  // value.
  bool replaying() const { return replay_.active(); }
  uint64_t replay(uint32_t most);
  // Has the driver compile what replay() will dispatch, so that the first edit need not wait for it. Changes nothing.
  uint64_t prepare_replay();
  // Samples that all pixels have at least, also while some are shaded again.
  uint32_t replayed_samples() const { return replaying() ? std::min(replay_.done(), samples()) : samples(); }
  // Whether replay() is between two batches: every pixel of the list has the same number of samples.
  bool replay_pass_complete() const { return replay_at_ == 0; }
  // The pixels that the last edit has restarted.
  const std::vector<uint32_t>& replayed_pixels() const { return replay_.pixels(); }

  // The group whose weights may be pulled next, or none. Once its sums are gathered, an edit of its gains, mutes
  // included, is answered by set_project() from them: the whole picture keeps its samples. Sums are gathered from
  // stored hits like those of a replay, between other work: gather_weights() submits the next part, of at most `most`
  // samples.
  void set_weights_at_hand(const WeightGroup& group);
  // `tints`: besides the sums for all channels alike, those for single ones.
  bool wants_weights(bool tints) const;
  uint64_t gather_weights(bool tints, uint32_t most);
  // Whether an edit of all channels alike, and of each channel by itself, would be answered so now.
  bool weights_ready() const;
  bool tints_ready() const;

  // Shows all tiles again from their accumulators.
  uint64_t recompose();

  // Layers of the pixels' centres (shaders/passes/aov.comp), of a tile or all of them, and `samples` of the occlusion
  // layer.
  uint64_t render_aov(int tile);
  uint64_t render_aov();
  // Whether the kernel for them is there.
  bool has_aov_kernel() const { return kernels_.ready(Pass::aov, key_); }
  uint64_t render_occlusion(uint32_t first_sample, uint32_t samples);

  uint64_t last_submitted() const;

  // --- After a timeline value, from the host.
  // RGBA: linear radiance summed over planes, and coverage; a mean over each pixel's samples.
  std::vector<float> linear_picture(uint64_t after);
  // The accumulators themselves: compensated sums, [plane][pixel][4].
  std::vector<float> accumulators(uint64_t after);
  std::vector<uint32_t> display_picture(uint64_t after);
  // One of the layers; [layer][pixel][4], all three of them.
  std::vector<vec4> aov_layer(uint32_t layer, uint64_t after);
  std::vector<float> aov_layers(uint64_t after);
  // The displayed picture where the host sees it, else nullptr.
  const uint32_t* mapped_display() const;

  const Region& region() const { return region_; }
  const Project& project() const { return *project_; }
  // Shared, so that a picking thread may hold on to them.
  const std::shared_ptr<const SceneTables>& scene_tables() const { return scene_tables_; }
  const std::vector<frame::PartRow>& part_rows() const { return part_rows_; }
  const KernelKey& key() const { return key_; }
  // Rays that one sample of the region asks for, hits taken as `coverage` of its pixels.
  double rays_per_sample(double coverage) const;

 private:
  Result<Change> take_project(std::shared_ptr<const Project> next);
  Status sums_fit(uint32_t planes, int width, int height) const;
  uint64_t submit_batch(const frame::TilePush& push, bool list_of_pixels, bool trace, uint32_t batch,
                        const gpu::DescriptorSet& set);
  uint64_t render_aov(std::span<const Region> areas);
  void begin_replay(uint32_t touched, Change& change);
  // Pixels of the wanted tiles that have seen one of these clusters, tile by tile.
  std::vector<uint32_t> pixels_that_see(uint32_t clusters, const std::vector<bool>& tiles) const;
  bool hit_is_stored(uint32_t sample) const { return sample / SAMPLES_PER_HIT + 1 < history_; }
  void make_weight_sums();
  void forget_weights();
  std::optional<WeightSums::Step> next_weight_step(bool tints) const;
  void begin_weight_step(bool tints);
  void send_weight_list(const std::vector<uint32_t>& pixels);
  // Whether the tables are where weights at hand, of this material, can be pulled to.
  bool holds_weights_of(size_t material) const;
  std::optional<std::vector<double>> steps_of_weights();
  void catch_up_weights(size_t directions);
  void prepare_recombine();
  void recombine(const std::vector<double>& steps, Change& change);
  std::vector<gpu::Bound> bound_tables() const;
  bool batches_fit() const;
  bool kernels_there(bool list_of_pixels, bool trace, uint32_t batch) const;
  bool kernels_there_to_replay() const;
  void want_kernels(bool first);
  vec3 plane_emission(uint32_t plane) const;
  void make_picture();
  void make_descriptor_set();
  uint64_t send_frame();
  bool geometry_differs(const Project& now) const;
  bool parts_moved(const Project& now) const;
  Result<bool> take_geometry(const Project& now, Change& change);
  bool materials_differ(const Project& now) const;
  bool lights_moved(const Project& now) const;
  bool shades_again(const Project& now) const;

  gpu::Device* device_;
  Kernels kernels_;
  std::shared_ptr<const Project> project_;
  bool trees_later_ = false;
  std::optional<PlacedScene> placed_;
  std::shared_ptr<const SceneTables> scene_tables_;  // as the device has them
  MaterialTables material_tables_;
  std::vector<frame::PartRow> part_rows_;
  LightDraws draws_;
  KnownSums sums_;
  std::vector<size_t> lights_;  // which of the project's lights are traced
  GpuScene gpu_;
  KernelKey key_;
  frame::FrameParams params_{};

  int picture_width_ = 0, picture_height_ = 0;
  Region region_;
  std::vector<Region> tiles_;
  std::vector<uint32_t> samples_;
  uint64_t history_bytes_ = 0;
  uint32_t history_ = 1;  // hits stored for each pixel
  Replay replay_;
  uint32_t replay_at_ = 0;  // pixels of the list that have this step's batch
  gpu::TypedBuffer<uint32_t> hits_, visibility_, display_, seen_, list_;
  gpu::TypedBuffer<vec4> accumulators_, aov_;
  gpu::TexelView hits_view_, visibility_view_, seen_view_, accumulators_view_, aov_view_;
  gpu::DescriptorSet set_;

  uint64_t weight_bytes_ = 256u << 20;
  WeightGroup at_hand_;
  std::optional<WeightSums> weights_;
  WeightSums::Memory weight_memory_;  // of sums that no longer hold
};

}  // namespace vamp
