#version 460
// The program's own traversal on rays that are ready.
#extension GL_GOOGLE_include_directive : require
#include "bench/rays_shared.h"
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"

layout(constant_id = SPEC_NEAREST) const bool NEAREST = true;
layout(binding = BINDING_READY_RAYS) uniform samplerBuffer rays;
// The nearest hit's distance, or 1 where nothing is in the way; else -1.
layout(scalar, binding = BINDING_FOUND) writeonly buffer Found { float found[]; };

bool alpha_passes(int triangle, float u, float v) { return true; }

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= tile.width) return;
  if (NEAREST) {
    vec3 origin = texelFetch(rays, int(2u * i)).xyz;
    TriangleHit hit = nearest_hit(origin, texelFetch(rays, int(2u * i + 1u)).xyz, 0.0, HUGE);
    found[i] = hit.triangle < 0 ? -1.0 : hit.t;
  } else {
    vec4 x = texelFetch(rays, int(4u * i));
    vec4 y = texelFetch(rays, int(4u * i + 2u));
    bvec2 free = unoccluded(x.xyz, texelFetch(rays, int(4u * i + 1u)).xyz, x.w, texelFetch(rays, int(4u * i + 3u)).xyz, y.w);
    found[2u * i] = free.x ? 1.0 : -1.0;
    found[2u * i + 1u] = free.y ? 1.0 : -1.0;
  }
}
