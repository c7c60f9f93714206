// What bench/rays.comp reads beside the tree; read by GLSL and C++.
#ifdef __cplusplus
#pragma once
#endif

#define BINDING_READY_RAYS 100  // bench/ready_rays.h
#define BINDING_FOUND 101
#define SPEC_NEAREST 100        // bool: the nearest hit, else whether anything is in the way of a ray and of the next
