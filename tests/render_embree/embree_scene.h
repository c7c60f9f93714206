#pragma once
// A scene's triangles in Embree, an independent ray tracer: the triangle numbers are the scene's.
#include <embree3/rtcore.h>

#include <cstring>

#include "engine/scene/scene.h"

namespace vamp {

class EmbreeScene {
 public:
  explicit EmbreeScene(const Scene& scene) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    // Watertight, as ours is.
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3),
                                              scene.positions.size());
    std::memcpy(positions, scene.positions.data(), scene.positions.size() * sizeof(vec3));
    void* triangles = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3),
                                              scene.triangles.size());
    std::memcpy(triangles, scene.triangles.data(), scene.triangles.size() * sizeof(uvec3));
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  struct Hit {
    int triangle = -1;   // -1: nothing
    float distance = 0;  // along the unit direction
  };
  Hit nearest(vec3 origin, vec3 direction) const {
    RTCRayHit ray{};
    ray.ray = ray_of(origin, direction, kFar);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {static_cast<int>(ray.hit.primID), ray.ray.tfar};
  }

  // True when nothing lies nearer than `distance`.
  bool unoccluded(vec3 origin, vec3 direction, float distance) const {
    RTCRay ray = ray_of(origin, direction, distance);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_, &context, &ray);
    return ray.tfar >= 0;  // Embree says -infinity where something is
  }

 private:
  static constexpr float kFar = 3.0e38f;

  static RTCRay ray_of(vec3 origin, vec3 direction, float t_max) {
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = t_max;
    ray.mask = ~0u;
    return ray;
  }

  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace vamp
