// From a stored triangle number back to the surface point, its frames and its texture coordinates. Trace and shade both
// come through here, with the same arithmetic, so that a stored hit is four bytes.
//
// A triangle's surface record is four texels RGBA32UI: normals of its three corners (octahedral, 2 x 16 bits) and its part;
// u0 v0 u1 v1; u2 v2 and the tangents of corners 0 and 1; the tangent of corner 2. A tangent is octahedral with 16 and 15
// bits, its lowest bit says that the bitangent is flipped.

vec3 octahedral(vec2 p) {
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float t = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -t : t;
  n.y += n.y >= 0.0 ? -t : t;
  return n;  // not normalised
}
vec3 unpack_normal(uint bits) {
  return normalize(octahedral(vec2(float(bits & 0xffffu), float(bits >> 16)) * (2.0 / 65535.0) - 1.0));
}
vec3 unpack_tangent(uint bits) {
  return normalize(octahedral(vec2(float(bits >> 16) * (2.0 / 65535.0), float((bits >> 1) & 0x7fffu) * (2.0 / 32767.0)) - 1.0));
}

struct Ray {
  vec3 origin, direction;
};

// Primary ray of stored hit number `slot` of a pixel of the whole picture.
Ray primary_ray(uvec2 pixel, uint seed, uint slot) {
  vec2 jitter = vec2(0.5);
  if (!PIXEL_CENTRES) jitter = random_pair(seed, slot, PAIR_PIXEL);
  precise vec2 p = (vec2(pixel) + jitter) / vec2(params.picture_width, params.picture_height);
  precise vec3 d = params.forward + (2.0 * p.x - 1.0) * params.right + (1.0 - 2.0 * p.y) * params.up;
  return Ray(params.origin, normalize(d));
}

// What shadow rays need.
struct SurfacePoint {
  vec3 position;
  float t;
  vec3 face;     // geometric normal, on the viewer's side
  vec3 normal;   // shading normal, on the viewer's side
  vec3 view;     // unit, to the viewer
  uint part;
  float u, v;    // barycentrics of corners 1 and 2
  float side;    // -1 seen from behind, else 1
};

SurfacePoint surface_point(Ray ray, int triangle) {
  vec3 a = fetch_triangle(3 * triangle).xyz;
  vec3 b = fetch_triangle(3 * triangle + 1).xyz;
  vec3 c = fetch_triangle(3 * triangle + 2).xyz;
  vec4 r = intersect_triangle(ray.origin, ray.direction, ray_side(ray.direction), ray_above(ray.direction), a, b, c, -HUGE,
                              HUGE);
  uvec4 s = texelFetch(surface_texels, 4 * triangle);
  SurfacePoint point;
  point.view = -ray.direction;
  point.t = r.x;
  point.u = r.y;
  point.v = r.z;
  float w = 1.0 - r.y - r.z;
  point.position = w * a + r.y * b + r.z * c;
  vec3 face = normalize(cross(b - a, c - a));
  point.face = dot(face, ray.direction) > 0.0 ? -face : face;
  point.part = s.w;
  // The stored normal decides which side is the front: models whose winding disagrees with their normals are common.
  vec3 n = normalize(w * unpack_normal(s.x) + r.y * unpack_normal(s.y) + r.z * unpack_normal(s.z));
  point.side = dot(n, point.face) < 0.0 ? -1.0 : 1.0;
  n *= point.side;
  // A shading normal that looks away from the viewer is bent until he sees it at 89 degrees: the rule for silhouettes.
  float cosine = -dot(n, ray.direction);
  if (cosine < 0.0175) n = normalize(n - (0.0175 - cosine) * ray.direction);
  point.normal = n;
  return point;
}

// Start of a ray that leaves the surface on the side of its face: off it by the rounding of the position.
vec3 leave_surface(SurfacePoint point) {
  vec3 m = abs(point.position);
  float size = max(max(m.x, m.y), max(m.z, point.t * 0.25));
  return point.position + point.face * (size * 4.0e-6 + params.offset_scale);
}

// Texture coordinates and the tangent along +dP/du with the handedness of the bitangent, in world space.
struct SurfaceFrame {
  vec2 uv;
  vec3 tangent, bitangent;
};

SurfaceFrame surface_frame(SurfacePoint point, int triangle) {
  uvec4 s1 = texelFetch(surface_texels, 4 * triangle + 1);
  uvec4 s2 = texelFetch(surface_texels, 4 * triangle + 2);
  uint s3 = texelFetch(surface_texels, 4 * triangle + 3).x;
  float w = 1.0 - point.u - point.v;
  SurfaceFrame f;
  f.uv = w * uintBitsToFloat(s1.xy) + point.u * uintBitsToFloat(s1.zw) + point.v * uintBitsToFloat(s2.xy);
  vec3 t = w * unpack_tangent(s2.z) + point.u * unpack_tangent(s2.w) + point.v * unpack_tangent(s3);
  // Gram-Schmidt; where the tangent vanishes any direction serves.
  t -= point.normal * dot(point.normal, t);
  float length2 = dot(t, t);
  vec3 fallback = abs(point.normal.x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 1, 0);
  fallback = normalize(fallback - point.normal * dot(point.normal, fallback));
  f.tangent = length2 > 1e-8 ? t * inversesqrt(max(length2, 1e-8)) : fallback;
  // Seen from behind the normal has turned, and the handedness with it.
  float hand = ((s2.z & 1u) != 0u ? -1.0 : 1.0) * point.side;
  f.bitangent = cross(point.normal, f.tangent) * hand;
  return f;
}

bool alpha_passes(int triangle, float u, float v) {
  uint part = texelFetch(surface_texels, 4 * triangle).w;
  uvec4 s1 = texelFetch(surface_texels, 4 * triangle + 1);
  uvec4 s2 = texelFetch(surface_texels, 4 * triangle + 2);
  vec2 uv = (1.0 - u - v) * uintBitsToFloat(s1.xy) + u * uintBitsToFloat(s1.zw) + v * uintBitsToFloat(s2.xy);
  int row = int(part) * PART_ROW_TEXELS;
  uvec4 a = texelFetch(part_texels, row + 5);
  ivec2 size = ivec2(a.w & 0xffffu, a.w >> 16);
  vec2 f = uv - floor(uv);
  ivec2 t = min(ivec2(f * vec2(size)), size - 1);
  float alpha = float(texelFetch(alpha_texels, int(a.z) + max(t.y, 0) * size.x + max(t.x, 0)).x) * (1.0 / 255.0);
  return size.x == 0 || alpha >= uintBitsToFloat(a.y);
}
