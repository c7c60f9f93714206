#pragma once
// The rays of a picture as arrays that are ready, so that both sides of a comparison trace the very same ones.
#include <vector>

#include "bench/embree_scene.h"
#include "bench/series.h"
#include "engine/project/project.h"

namespace vamp {

enum class RayQuestion { nearest, any };  // the nearest hit; whether anything is in the way

// As the kernel reads it: two texels RGBA32F.
struct ReadyRay {
  vec3 origin{0};
  float distance = 0;  // how far it looks, in lengths of the direction
  vec3 direction{0, 0, 1};
  float unused = 0;
};

struct ReadyRays {
  std::vector<ReadyRay> primary;  // one a pixel, through a jittered place in it
  // `each` from every hit, one after another: to points of the first light, and cosine-weighted up to the ambient
  // radius. Hits whose light stands below the surface for one of them have no shadow rays.
  std::vector<ReadyRay> shadow, ambient;
};

// Pixels in the kernels' order: Morton within blocks of 8 x 8, those row by row within tiles. `side`: of the picture, a
// multiple of a tile's.
ReadyRays draw_rays(const EmbreeScene& embree, const Project& project, int side, int each);

// Embree's single-ray calls on as many threads as there are processors.
Times embree_time(const EmbreeScene& embree, RayQuestion question, std::span<const ReadyRay> rays);

}  // namespace vamp
