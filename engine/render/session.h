#pragma once
// The interactive renderer: a thread of its own that refines the picture tile by tile, one tile in flight, and takes a
// new project between two tiles. Nothing here waits for the GPU on the caller's thread.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/project/project.h"
#include "engine/render/pick.h"
#include "engine/render/pixel_layer.h"
#include "engine/render/weight_span.h"

namespace vamp {

namespace gpu {
class Device;
}

// What the renderer says of itself.
struct RenderStatus {
  int width = 0, height = 0;
  uint32_t samples = 0;        // of the least refined pixel
  double seconds = 0;          // of rendering since the last restart
  double ms_per_sample = 0;    // for the whole picture, recent median
  float noise = -1;            // estimated relative noise, RMS over the picture; -1: not known yet
  std::string restart_reason;  // "roughness of grain in cluster 7": what the last restart was for
  uint64_t restarted_pixels = 0;
  uint64_t recombined_pixels = 0;  // changed by the last edit without a restart, from sums at hand
  bool weights_at_hand = false;    // an edit of the selected weights would be answered so
  uint64_t bytes_uploaded = 0;     // by the last edit
  uint64_t gpu_bytes = 0;
  double mrays_per_second = 0;
  bool finished = false;                   // max_samples or noise_goal reached
  std::shared_ptr<const Project> project;  // that the picture is of: the last one that was taken over
  std::string device;
  std::string error;  // why there is no picture of the project
  bool lost = false;  // the device is gone: the session has stopped for good, the document is safe
};

class RenderSession {
 public:
  // Where kernels are made: beside the picture, which goes on meanwhile, or on its queue at first use, for
  // measurements.
  enum class Kernels { in_background, on_queue };
  // `edit_memory`: bytes for what edits are answered from, stored hits and sums of weights; 0: edits are traced again.
  // kAutomaticMemory: a sixteenth of the device's memory, at most 416 MiB.
  static constexpr uint64_t kAutomaticMemory = ~uint64_t{0};
  RenderSession(gpu::Device& device, std::shared_ptr<const Project> project, int width, int height,
                uint64_t edit_memory = kAutomaticMemory, Kernels kernels = Kernels::in_background);
  ~RenderSession();
  RenderSession(const RenderSession&) = delete;
  RenderSession& operator=(const RenderSession&) = delete;

  // Takes the project at the next tile; `reason` is shown if something restarts. Cheap: call it on every mouse move.
  void set_project(std::shared_ptr<const Project> project, std::string reason);
  void resize(int width, int height);
  void pause(bool paused);

  // Rows whose weights may be pulled next: what is selected. Cheap: call it every frame.
  void set_weights_at_hand(const WeightGroup& group);

  // Called on the render thread whenever the picture shows for the first time what was asked for last: an edit, a view,
  // a size; what is answered before this is set is not told. It must not call the session.
  void when_answered(std::function<void()> answered);
  // The copied picture of this version, or a later one, is on the screen. Where the renderer computes on the processor
  // it leaves it to the window between an answer and this call, for some milliseconds at the most.
  void picture_shown(uint64_t version);

  // As if the device were lost at the next tile, for tests.
  void lose_device();

  RenderStatus status() const;

  // Number that grows whenever the picture changed.
  uint64_t picture_version() const;
  // The displayed picture: RGBA8, sRGB. Copied if it is newer than the layer given.
  bool copy_picture(PixelLayer& layer) const;

  // What lies under a pixel, by a CPU ray against the same hierarchy. Answers at once.
  Pick pick(float x, float y) const;

  // Part (low 16 bits) and cluster (high 16 bits) + 1 of each pixel's centre, 0 where nothing is; for outlines. Empty
  // until known for the view that the picture shows.
  bool copy_ids(PixelLayer& layer) const;
  // 1 for the pixels that the last edit restarted, else 0.
  bool copy_restarted(PixelLayer& layer) const;

  // The linear accumulators of the picture so far, as a fresh command-line render writes them (RGBA float).
  std::vector<float> linear_picture(int& width, int& height, uint32_t& samples) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vamp
