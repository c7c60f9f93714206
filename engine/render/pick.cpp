#include "engine/render/pick.h"

#include <optional>
#include <shared_mutex>

#include "engine/render/shown_picture.h"

namespace vamp {

Pick pick_in(const Drawn& drawn, float x, float y) {
  Pick found;
  if (!drawn.project || drawn.width == 0) return found;
  const Project* const project = drawn.project.get();
  const float w = static_cast<float>(drawn.width), h = static_cast<float>(drawn.height);
  const CameraFrame camera = camera_frame(project->camera, w / h);
  const vec3 direction = camera_ray(camera, 2 * x / w - 1, 1 - 2 * y / h);
  std::optional<Hit> hit;
  {
    const std::shared_lock lock(*drawn.tables->moving);
    hit = pick(drawn.tables->bvh, camera.origin, direction);
  }
  if (!hit) return found;
  const Scene& scene = *project->scene;
  const uvec3 corners = scene.triangles[hit->triangle];
  found.part = static_cast<int>(scene.triangle_part[hit->triangle]);
  found.material = project->parts[static_cast<size_t>(found.part)].material;
  found.uv =
      (1 - hit->u - hit->v) * scene.uvs[corners.x] + hit->u * scene.uvs[corners.y] + hit->v * scene.uvs[corners.z];
  found.position = camera.origin + hit->t * direction;
  found.distance = hit->t;
  const Spmm& fit = *project->materials[static_cast<size_t>(found.material)].fit;
  const size_t texel = texel_at(drawn.rows[static_cast<size_t>(found.part)], found.uv);
  found.cluster = static_cast<int>(fit.texels[texel].cluster_count & 255u);
  return found;
}

}  // namespace vamp
