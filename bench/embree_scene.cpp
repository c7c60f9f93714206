#include "bench/embree_scene.h"

#include <cstring>

namespace vamp {
namespace {

constexpr float kFar = 3.0e38f;

template <class T>
void set_buffer(RTCGeometry mesh, RTCBufferType type, RTCFormat format, std::span<const T> values) {
  std::memcpy(rtcSetNewGeometryBuffer(mesh, type, 0, format, sizeof(T), values.size()), values.data(),
              values.size_bytes());
}

}  // namespace

EmbreeScene::EmbreeScene(std::span<const vec3> positions, std::span<const uvec3> triangles, Edges edges)
    : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
  if (edges == Edges::watertight) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  set_buffer(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
  set_buffer(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene_, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene_);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

EmbreeScene::Hit EmbreeScene::nearest(vec3 origin, vec3 direction) const {
  RTCRayHit found = ray_hit(origin, direction);
  intersect(found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {static_cast<int>(found.hit.primID), found.ray.tfar, vec3(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z)};
}

bool EmbreeScene::unoccluded(vec3 origin, vec3 direction, float distance) const {
  RTCRay tested = ray(origin, direction, distance);
  occluded(tested);
  return tested.tfar >= 0;  // Embree says -infinity where something is
}

RTCRay EmbreeScene::ray(vec3 origin, vec3 direction, float distance) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = distance;
  ray.mask = ~0u;
  return ray;
}

RTCRayHit EmbreeScene::ray_hit(vec3 origin, vec3 direction) {
  RTCRayHit hit{};
  hit.ray = ray(origin, direction, kFar);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return hit;
}

void EmbreeScene::intersect(RTCRayHit& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_, &context, &ray);
}

void EmbreeScene::occluded(RTCRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_, &context, &ray);
}

}  // namespace vamp
