#include "tests/render_embree/ray_oracle.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/core/check.h"
#include "engine/render/scene_tables.h"

namespace vamp {
namespace {

using std::numbers::pi;

// The stored normal, 2 x 16 bits, as a unit vector.
dvec3 stored_normal(const vec3& normal) {
  const uint32_t bits = pack_normal(normal);
  const double x = (bits & 0xffffu) * (2.0 / 65535.0) - 1.0, y = (bits >> 16) * (2.0 / 65535.0) - 1.0;
  dvec3 n(x, y, 1.0 - std::abs(x) - std::abs(y));
  const double fold = std::max(-n.z, 0.0);
  n.x += n.x >= 0 ? -fold : fold;
  n.y += n.y >= 0 ? -fold : fold;
  return glm::normalize(n);
}

// Duff et al. 2017.
void basis_about(const dvec3& n, dvec3& t, dvec3& b) {
  const double s = n.z >= 0 ? 1.0 : -1.0;
  const double a = -1.0 / (s + n.z), c = n.x * n.y * a;
  t = dvec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x);
  b = dvec3(c, s + n.y * n.y * a, -n.y);
}

}  // namespace

OraclePoint oracle_point(const Scene& scene, int triangle, vec3 origin, vec3 direction) {
  const uvec3 corner = scene.triangles[static_cast<size_t>(triangle)];
  const dvec3 a(scene.positions[corner.x]), b(scene.positions[corner.y]), c(scene.positions[corner.z]);
  const dvec3 o(origin), d = glm::normalize(dvec3(direction));
  const dvec3 across = glm::cross(b - a, c - a);
  const double t = glm::dot(a - o, across) / glm::dot(d, across);
  OraclePoint point;
  point.position = o + t * d;
  const double area = glm::dot(across, across);
  const double u = glm::dot(glm::cross(point.position - a, c - a), across) / area;
  const double v = glm::dot(glm::cross(b - a, point.position - a), across) / area;

  point.face = glm::normalize(across);
  if (glm::dot(point.face, d) > 0) point.face = -point.face;
  dvec3 n = glm::normalize((1 - u - v) * stored_normal(scene.normals[corner.x]) +
                           u * stored_normal(scene.normals[corner.y]) + v * stored_normal(scene.normals[corner.z]));
  if (glm::dot(n, point.face) < 0) n = -n;
  const double cosine = -glm::dot(n, d);
  if (cosine < 0.0175) n = glm::normalize(n - (0.0175 - cosine) * d);
  point.normal = n;

  const dvec3 m = glm::abs(point.position);
  const double size = std::max({m.x, m.y, m.z, 0.25 * t});
  point.start = point.position + point.face * (size * 4e-6 + static_cast<double>(scene.bounds.radius()) * 1e-6);
  return point;
}

OracleRay oracle_occlusion_ray(const OraclePoint& point, vec2 u, double radius) {
  const dvec3 r(std::sqrt(static_cast<double>(u.x)), 2 * pi * static_cast<double>(u.y),
                std::sqrt(1.0 - static_cast<double>(u.x)));
  dvec3 t, b;
  basis_about(point.normal, t, b);
  OracleRay ray;
  ray.direction = glm::normalize(t * (r.x * std::cos(r.y)) + b * (r.x * std::sin(r.y)) + point.normal * r.z);
  ray.distance = radius;
  ray.carries = glm::dot(ray.direction, point.face) > 0;
  return ray;
}

OracleRay oracle_light_ray(const OraclePoint& point, const Light& light, vec2 u) {
  CHECK(light.type == LightType::rect || light.type == LightType::sphere);
  const dvec3 to = dvec3(light.center) - point.position;
  OracleRay ray;
  if (light.type == LightType::rect) {
    const LightFrame axes = light_frame(light);
    const dvec3 target = to + dvec3(axes.u) * (static_cast<double>(light.size.x) * (static_cast<double>(u.x) - 0.5)) +
                         dvec3(axes.v) * (static_cast<double>(light.size.y) * (static_cast<double>(u.y) - 0.5));
    ray.distance = glm::length(target);
    ray.direction = target / ray.distance;
    ray.carries = glm::dot(ray.direction, dvec3(axes.n)) < 0;
  } else {
    // Uniform over the cone that the sphere fills, up to its near side.
    const double c2 = glm::dot(to, to), r2 = static_cast<double>(light.radius) * static_cast<double>(light.radius);
    const double z = 1.0 - static_cast<double>(u.x) * (1.0 - std::sqrt(std::max(1.0 - r2 / c2, 0.0)));
    const double sine = std::sqrt(std::max(1.0 - z * z, 0.0)), phi = 2 * pi * static_cast<double>(u.y);
    const dvec3 axis = glm::normalize(to);
    dvec3 t, b;
    basis_about(axis, t, b);
    ray.direction = glm::normalize(axis * z + (t * std::cos(phi) + b * std::sin(phi)) * sine);
    const double along = glm::dot(to, ray.direction);
    ray.distance = along - std::sqrt(std::max(r2 - std::max(c2 - along * along, 0.0), 0.0));
    ray.carries = r2 < c2;
  }
  // The renderer's rays end this much before the emitter.
  ray.distance *= 0.9999;
  ray.carries = ray.carries && glm::dot(ray.direction, point.face) > 0 && glm::dot(ray.direction, point.normal) > 0;
  return ray;
}

}  // namespace vamp
