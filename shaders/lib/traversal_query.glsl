// Rays by GL_EXT_ray_query, over an acceleration structure of the same triangles in the same order. The device has its own
// arithmetic: distances differ from the tree's in the last places, and so does what is met where triangles touch.

TriangleHit query_ray(vec3 origin, vec3 direction, float t_min, float t_max, uint flags) {
  TriangleHit hit = TriangleHit(-1, t_max, 0.0, 0.0);
  if (t_max <= t_min) return hit;
  rayQueryEXT query;
  rayQueryInitializeEXT(query, ray_scene, flags | (ALPHA_MASK ? gl_RayFlagsNoneEXT : gl_RayFlagsOpaqueEXT), 0xff, origin,
                        t_min, direction, t_max);
  // Stops at triangles that may have holes, all of them where some have.
  while (rayQueryProceedEXT(query)) {
    int triangle = rayQueryGetIntersectionPrimitiveIndexEXT(query, false);
    vec2 at = rayQueryGetIntersectionBarycentricsEXT(query, false);
    bool masked = (int(fetch_triangle(3 * triangle + 1).w) & TRIANGLE_ALPHA_MASK) != 0;
    if (!masked || alpha_passes(triangle, at.x, at.y)) rayQueryConfirmIntersectionEXT(query);
  }
  if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT) {
    hit.triangle = rayQueryGetIntersectionPrimitiveIndexEXT(query, true);
    hit.t = rayQueryGetIntersectionTEXT(query, true);
    vec2 at = rayQueryGetIntersectionBarycentricsEXT(query, true);
    hit.u = at.x;
    hit.v = at.y;
  }
  return hit;
}

TriangleHit nearest_hit(vec3 origin, vec3 direction, float t_min, float t_max) {
  return query_ray(origin, direction, t_min, t_max, gl_RayFlagsNoneEXT);
}

uint unoccluded(vec3 origin, Bundle bundle) {
  uint bits = 0u;
  for (uint k = 0u; k < SAMPLES; ++k) {
    if (bundle.t_max[k] <= 0.0) continue;
    TriangleHit hit = query_ray(origin, bundle.direction[k], 0.0, bundle.t_max[k], gl_RayFlagsTerminateOnFirstHitEXT);
    bits |= hit.triangle < 0 ? 1u << k : 0u;
  }
  return bits;
}

uvec2 unoccluded(vec3 origin, Bundle bundle_x, Bundle bundle_y) {
  return uvec2(unoccluded(origin, bundle_x), unoccluded(origin, bundle_y));
}
