#version 460
// The program's own traversal on rays that are ready.
#extension GL_GOOGLE_include_directive : require
#include "bench/rays_shared.h"
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"

layout(constant_id = SPEC_NEAREST) const bool NEAREST = true;
layout(binding = BINDING_READY_RAYS) uniform samplerBuffer rays;
layout(scalar, binding = BINDING_FOUND) writeonly buffer Found { float found[]; };
layout(scalar, binding = BINDING_FOUND_TRIANGLES) writeonly buffer FoundTriangles { int found_triangles[]; };

bool alpha_passes(int triangle, float u, float v) { return true; }

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= tile.width) return;
  if (NEAREST) {
    vec3 origin = texelFetch(rays, int(2u * i)).xyz;
    TriangleHit hit = nearest_hit(origin, texelFetch(rays, int(2u * i + 1u)).xyz, 0.0, HUGE);
    found[i] = hit.triangle < 0 ? -1.0 : hit.t;
    found_triangles[i] = hit.triangle;
  } else {
    vec3 origin = texelFetch(rays, int(2u * SAMPLES * i)).xyz;
    Bundle bundle;
    for (uint k = 0u; k < SAMPLES; ++k) {
      bundle.t_max[k] = texelFetch(rays, int(2u * (SAMPLES * i + k))).w;
      bundle.direction[k] = texelFetch(rays, int(2u * (SAMPLES * i + k) + 1u)).xyz;
    }
    uint free = unoccluded(origin, bundle);
    for (uint k = 0u; k < SAMPLES; ++k) found[SAMPLES * i + k] = (free >> k & 1u) != 0u ? 1.0 : -1.0;
  }
}
