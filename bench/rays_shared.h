// What bench/rays.comp reads beside the tree, and what it writes; read by GLSL and C++.
#ifdef __cplusplus
#pragma once
namespace vamp {
#endif

#define BINDING_READY_RAYS 100  // bench/ready_rays.h
#define BINDING_FOUND 101
#define SPEC_NEAREST 100        // bool: the nearest hit, else whether anything is in the way of a ray and of the next

struct Found {
  float distance;  // of the nearest hit, or 1 where nothing is in the way; else -1
  int triangle;    // of the nearest hit, in the tree's order; else -1
};

#ifdef __cplusplus
}  // namespace vamp
#endif
