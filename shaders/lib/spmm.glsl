// Evaluation of a part's SPMM: ReflectedCos for one viewer and many directions of light. What does not depend on the light
// (texel, entries, frames, the view's side of the residual) is done once for all of them.
//
// Never multiply the result by a cosine: ReflectedCos holds it.
#include "shaders/brdf/lobe.glsl"
#include "shaders/lib/texel.glsl"

const uint DIRECTION_COUNT = SAMPLES * RAY_COUNT;

// The measured directions around one of a residual's, by its weights on the parabolic disk. Like the texel, either one of the
// three is drawn, or all are read: nine records in 18 fetches were half of the shading on lavapipe, and the noise of the
// draw is lost in that of the shadow rays (relMSE at 64 samples 1.002 times as large).
const int SLOTS = FOUR_TAPS ? 3 : 1;
struct DirectionWeights {
  uvec3 slot;
  vec3 weight;
};
DirectionWeights direction_weights(Part part, vec3 w, float u) {
  vec2 p = w.xy / (1.0 + max(w.z, 0.0));
  ivec2 cell = clamp(ivec2((p * 0.5 + 0.5) * 256.0), ivec2(0), ivec2(255));
  int triangle = int(part.directions.y + texelFetch(direction_map_texels, int(part.directions.z) + cell.y * 256 + cell.x).x);
  vec4 row1 = texelFetch(direction_triangle_texels, 2 * triangle);
  vec4 row2 = texelFetch(direction_triangle_texels, 2 * triangle + 1);
  uint slots = floatBitsToUint(row1.w);
  float a = dot(row1.xy, p) + row1.z;
  float b = dot(row2.xy, p) + row2.z;
  vec3 l = max(vec3(a, b, 1.0 - a - b), vec3(0.0));
  DirectionWeights d;
  d.slot = uvec3(slots & 1023u, (slots >> 10) & 1023u, (slots >> 20) & 1023u);
  d.weight = l / (l.x + l.y + l.z);
  if (!FOUR_TAPS) {
    float beyond = u - d.weight.x;
    d.slot.x = beyond < 0.0 ? d.slot.x : (beyond < d.weight.y ? d.slot.y : d.slot.z);
    d.weight.x = 1.0;
  }
  return d;
}

// Sum over the slots of viewer and light of mean and PCA terms, before the texel's coefficients are applied, where that is linear:
// the weighted halves are summed first, the coefficients multiply once.
vec3 residual_value(Part part, uint cluster, vec4 coefficients, DirectionWeights view, DirectionWeights light) {
  vec3 mean = vec3(0.0), b1 = vec3(0.0), b2 = vec3(0.0), b3 = vec3(0.0), b4 = vec3(0.0);
  uint count = part.directions.x;
  for (int i = 0; i < SLOTS; ++i) {
    uint row = part.base.w + (cluster * count + view.slot[i]) * count;
    for (int j = 0; j < SLOTS; ++j) {
      int record = 2 * int(row + light.slot[j]);
      float w = view.weight[i] * light.weight[j];
      uvec4 a = texelFetch(residual_texels, record);
      vec2 a0 = unpackHalf2x16(a.x), a1 = unpackHalf2x16(a.y);
      mean += w * vec3(a0, a1.x);
      if (RESIDUAL >= 2u) {
        b1 += w * vec3(a1.y, unpackHalf2x16(a.z));
      }
      if (RESIDUAL >= 3u) {
        uvec4 b = texelFetch(residual_texels, record + 1);
        vec2 c0 = unpackHalf2x16(b.x), c1 = unpackHalf2x16(b.y);
        b2 += w * vec3(unpackHalf2x16(a.w), c0.x);
        if (RESIDUAL >= 4u) b3 += w * vec3(c0.y, c1);
        if (RESIDUAL >= 5u) b4 += w * vec3(unpackHalf2x16(b.z), unpackHalf2x16(b.w).x);
      }
    }
  }
  return mean + coefficients.x * b1 + coefficients.y * b2 + coefficients.z * b3 + coefficients.w * b4;
}

// Adds ReflectedCos of every direction to `result`. `wo` and `wi` in the texel's frame, z the normal, above the horizon.
// `met`: the clusters read, as bits (PART_SEEN_SHIFT).
void spmm_eval(Part part, vec2 uv, vec2 tap, vec3 wo, vec3 wi[DIRECTION_COUNT], inout vec3 result[DIRECTION_COUNT],
               inout uint met) {
  for (uint corner = 0u; corner < (FOUR_TAPS ? 4u : 1u); ++corner) {
    float tap_weight;
    vec2 rest;
    uvec4 texel = texelFetch(texel_texels, tap_texel(part, uv, tap, corner, tap_weight, rest));
    uint cluster = texel.y & 255u;
    uint count = (texel.y >> 8) & 255u;
    uint first_entry = part.base.y + texel.x;
    uint first_row = part.base.z + cluster * part.shape.z;
    met |= 1u << (((part.shape.w >> PART_SEEN_SHIFT) + cluster) & 31u);

    for (uint e = 0u; e < count; ++e) {
      uvec2 entry = texelFetch(entry_texels, int(first_entry + e)).xy;
      int row = 3 * int(first_row + (entry.x & 0xffffu));
      vec4 frame = texelFetch(basis_texels, row);
      vec4 k = texelFetch(basis_texels, row + 1);
      vec4 scale = texelFetch(basis_texels, row + 2);
      vec3 weight = scale.rgb * vec3(unpackHalf2x16(entry.x).y, unpackHalf2x16(entry.y)) * tap_weight;

      // Rows of the rotation into the function's frame: shortest-arc frame about n_j (Duff et al. 2017, n_j.z > 0),
      // then the tangent angle.
      vec3 n = vec3(frame.xy, sqrt(max(1.0 - dot(frame.xy, frame.xy), 0.0)));
      float a = -1.0 / (1.0 + n.z);
      vec3 t = vec3(1.0 + n.x * n.x * a, n.x * n.y * a, -n.x);
      vec3 b = vec3(n.x * n.y * a, 1.0 + n.y * n.y * a, -n.y);
      vec3 x = frame.z * t + frame.w * b;
      vec3 y = frame.z * b - frame.w * t;
      uint tag = floatBitsToUint(scale.w);
      LobeView view = lobe_view(tag, k, vec3(dot(x, wo), dot(y, wo), dot(n, wo)));
      for (uint d = 0u; d < DIRECTION_COUNT; ++d) {
        vec3 i = vec3(dot(x, wi[d]), dot(y, wi[d]), dot(n, wi[d]));
        result[d] += weight * lobe_eval_view(tag, k, i, view);
      }
    }

    if (RESIDUAL > 0u) {
      // The part's own number of PCA terms may be below the kernel's.
      vec4 used = vec4(lessThan(uvec4(0u, 1u, 2u, 3u), uvec4((part.shape.w >> 8) & 7u)));
      vec4 coefficients = vec4(unpackHalf2x16(texel.z), unpackHalf2x16(texel.w)) * used;
      // Parts without a residual read slot 0 of an empty set: a record of zeros (render/tables).
      DirectionWeights view = direction_weights(part, wo, rest.x);
      vec3 scale = texelFetch(cluster_texels, int(part.shape.y + cluster)).rgb * tap_weight;
      float last_ring_cos = uintBitsToFloat(part.directions.w);
      for (uint d = 0u; d < DIRECTION_COUNT; ++d) {
        // One number for all of a hit's directions, turned by the golden ratio from one to the next.
        float turn = float(visibility_bit(d / RAY_COUNT, d % RAY_COUNT)) * 0.618034;
        DirectionWeights light = direction_weights(part, wi[d], fract(rest.y + turn));
        float fade = min(1.0, wi[d].z / last_ring_cos);
        result[d] += scale * fade * residual_value(part, cluster, coefficients, view, light);
      }
    }
  }
}
