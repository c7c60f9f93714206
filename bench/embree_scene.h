#pragma once
// Triangles in Embree, an independent ray tracer: the peer of benchmarks and the oracle of tests.
#include <embree3/rtcore.h>

#include <span>

#include "engine/core/vec.h"

namespace vamp {

class EmbreeScene {
 public:
  enum class Edges { fast, watertight };

  // Triangles keep their numbers.
  EmbreeScene(std::span<const vec3> positions, std::span<const uvec3> triangles, Edges edges);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  struct Hit {
    int triangle = -1;   // -1: nothing
    float distance = 0;  // in lengths of the direction
    vec3 normal{0};      // of the triangle, not normalised
  };
  Hit nearest(vec3 origin, vec3 direction) const;

  // True when nothing lies nearer than `distance` lengths of the direction.
  bool unoccluded(vec3 origin, vec3 direction, float distance) const;

  // Embree's own calls on rays that are ready, which is what is measured.
  static RTCRay ray(vec3 origin, vec3 direction, float distance);
  static RTCRayHit ray_hit(vec3 origin, vec3 direction);
  void intersect(RTCRayHit& ray) const;
  void occluded(RTCRay& ray) const;

 private:
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace vamp
