#pragma once
// A picture of any size, rendered to the end: the command line's render and the editor's snapshot.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/image/image.h"
#include "engine/project/project.h"

namespace vamp {

class Progress;
namespace gpu {
class Device;
}

enum class Layer { depth, normal, uv, part, cluster, ao };
inline constexpr const char* kLayerNames[] = {"depth", "normal", "uv", "part", "cluster", "ao"};

struct StillOptions {
  int width = 1280, height = 960;  // 1 to 16384 a side
  uint32_t samples = 64;           // of every pixel
  double seconds = 0;              // stops earlier when over 0, all pixels at the same number of samples
  float noise_goal = 0;            // over 0: tiles stop earlier where their relative noise is below (goal.h)
  std::vector<Layer> layers;
};

struct Still {
  // Linear Rec.709: R, G, B, A (coverage), then the layers: depth.Z (distance along the ray, scene units, 0 where
  // nothing is), normal.X/Y/Z (world), uv.U/V, part.Y and cluster.Y (numbers, -1 where nothing is), ao.Y (-1 where
  // nothing is). All but the ambient occlusion are those of the pixel's centre.
  Image image;
  uint32_t samples = 0;      // of the least refined pixel
  double mean_samples = 0;   // of a pixel
  float noise = -1;          // estimated relative noise of the picture; -1: too few samples to know
  double seconds = 0;        // of rendering, set-up left out
  double ms_per_sample = 0;  // of the whole picture: median over its samples
  double rays = 0;           // that the picture asked for
  uint64_t gpu_bytes = 0;
  bool complete = true;  // false: stopped by `seconds` or by the user
};

// Large pictures are rendered in regions that the device's memory holds; a pixel's value does not depend on them.
// Errors: what Renderer::set_project refuses; sizes out of range. A cancelled `progress` (may be null) gives what there
// is.
Result<Still> render_still(gpu::Device& device, std::shared_ptr<const Project> project, const StillOptions& options,
                           Progress* progress);

}  // namespace vamp
