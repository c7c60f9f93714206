// Read by GLSL and C++: the structs of the test kernels.
#ifndef TESTS_GPU_KERNELS_PROBE_H
#define TESTS_GPU_KERNELS_PROBE_H
#ifdef __cplusplus
#include <cstdint>
namespace vamp::test {
using uint = uint32_t;
#endif

struct ScalePush {
  float shift;
  uint count;
};

// Members of all widths, so that a wrong layout rule would move one.
struct Probe {
  float first;
#ifdef __cplusplus
  float normal[3];
#else
  vec3 normal;
#endif
  uint index;
#ifdef __cplusplus
  float uv[2];
  uint slots[3];
#else
  vec2 uv;
  uint slots[3];
#endif
  float last;
};

#ifdef __cplusplus
}  // namespace vamp::test
#endif
#endif
