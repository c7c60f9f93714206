// A part and the texel of its material that a surface point reads.

struct Part {
  uvec4 base;        // texel, entry, basis row, residual record
  uvec4 shape;       // size, cluster row, bases, flags
  vec4 uv_matrix;
  vec4 uv_offset;    // offset, rotation
  uvec4 directions;  // count, triangles, map, cosine of the last ring
  vec2 mirror;       // F0, alpha cutoff
};

Part fetch_part(uint part) {
  int row = int(part) * PART_ROW_TEXELS;
  Part p;
  p.base = texelFetch(part_texels, row);
  p.shape = texelFetch(part_texels, row + 1);
  p.uv_matrix = uintBitsToFloat(texelFetch(part_texels, row + 2));
  p.uv_offset = uintBitsToFloat(texelFetch(part_texels, row + 3));
  p.directions = texelFetch(part_texels, row + 4);
  p.mirror = uintBitsToFloat(texelFetch(part_texels, row + 5).xy);
  return p;
}

// The texel to read: one drawn with the bilinear weights, or the four and their weights in turn.
// `corner` 0..3 for four taps; weight 1 for the stochastic one. `rest`: what the draw leaves of u, uniform again.
int tap_texel(Part part, vec2 uv, vec2 u, uint corner, out float weight, out vec2 rest) {
  ivec2 size = ivec2(part.shape.x & 0xffffu, part.shape.x >> 16);
  vec2 p = vec2(dot(part.uv_matrix.xy, uv), dot(part.uv_matrix.zw, uv)) + part.uv_offset.xy;
  p = (p - floor(p)) * vec2(size) - 0.5;
  vec2 low = floor(p);
  vec2 f = p - low;
  ivec2 step;
  if (FOUR_TAPS) {
    step = ivec2(corner & 1u, corner >> 1);
    weight = (step.x == 1 ? f.x : 1.0 - f.x) * (step.y == 1 ? f.y : 1.0 - f.y);
    rest = u;
  } else {
    step = ivec2(u.x < f.x ? 1 : 0, u.y < f.y ? 1 : 0);
    weight = 1.0;
    rest = mix((u - f) / max(1.0 - f, vec2(1e-6)), u / max(f, vec2(1e-6)), lessThan(u, f));
  }
  ivec2 t = ivec2(low) + step;
  // Tiles repeat; t lies in [-1, size], also where p was rounded up to the size itself.
  t = t + ivec2(lessThan(t, ivec2(0))) * size;
  t = t - ivec2(greaterThanEqual(t, size)) * size;
  return int(part.base.x) + t.y * size.x + t.x;
}
