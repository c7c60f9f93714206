// Which lights a sample draws where there are many (LIGHT_SLOTS > 0): each of its slots chooses one light, in proportion to what
// the lights could send here at unit power. Geometry alone decides, never a material or a light's power: an edit of those
// moves no ray, and what a light adds to its own plane of the accumulators stays linear in its power.
//
// The unit interval belongs to the lights in proportion to their weights, and in equal shares to the slots. A slot's
// coordinate lies in the slot's share, so that slots seldom meet in one light, and says which light; where it lies in that light's
// stretch is the first coordinate on the light. So choices and points on lights together stay as evenly spread as the
// scrambled Sobol points that they are.

// Up to light i of the sum of all weights; any number of lights has a place.
const uint LIGHT_ENDS = LIGHT_SLOTS > 0u && LIGHT_COUNT > 0u ? LIGHT_COUNT : 1u;
const uint SLOT_ENDS = LIGHT_SLOTS > 0u ? LIGHT_SLOTS : 1u;

// Read as texels where each lane has a light of its own: on lavapipe a third of what a storage buffer takes.
LightRow fetch_light(uint which) {
  if (LIGHT_SLOTS == 0u) return lights[which];
  int at = int(which) * LIGHT_ROW_TEXELS;
  vec4 a = texelFetch(light_texels, at), b = texelFetch(light_texels, at + 1), c = texelFetch(light_texels, at + 2);
  vec4 d = texelFetch(light_texels, at + 3), e = texelFetch(light_texels, at + 4);
  return LightRow(a.xyz, floatBitsToUint(a.w), b.xyz, b.w, c.xyz, c.w, d.xyz, d.w, e.x, e.y, e.z, e.w);
}

// 0 only where the light cannot contribute: its whole extent below the face or the shading normal, the point behind a flat
// emitter, outside a spot's cone or inside a sphere. Elsewhere about the irradiance of a unit of power, times 4 pi, with floors
// for what it leaves out: materials that send light on at grazing angles, and parts of a light that are nearer than its middle.
float light_weight(uint which, SurfacePoint point) {
  int at = int(which) * LIGHT_ROW_TEXELS;
  vec4 place = texelFetch(light_texels, at);
  vec4 axis = texelFetch(light_texels, at + 3);
  vec4 rest = texelFetch(light_texels, at + 4);
  uint type = floatBitsToUint(place.w);
  float extent = rest.w;  // of a sphere about the centre that holds all of the light
  precise vec3 to = place.xyz - point.position;
  if (type == LIGHT_DIRECTIONAL) to = -axis.xyz;
  precise float d2 = dot(to, to) + extent * extent;
  float inverse = inversesqrt(max(d2, 1e-24));

  // How much of the extent is above the surface, and its mean height there if it is spread evenly.
  precise float height = dot(to, point.normal);
  precise float lowest = min(height, dot(to, point.face));
  float above = clamp((lowest + extent) / max(2.0 * extent, 1e-24), 0.0, 1.0);
  precise float cosine = (above < 1.0 ? max(height, extent * above * above) : height) * inverse;
  precise float weight = above * (0.1 + max(cosine, 0.0));

  precise float facing = -dot(to, axis.xyz) * inverse;
  if ((LIGHT_TYPES & ((1u << LIGHT_RECT) | (1u << LIGHT_DISK))) != 0u && (type == LIGHT_RECT || type == LIGHT_DISK))
    weight *= facing > 0.0 ? 0.2 + 4.0 * facing : 0.0;
  if ((LIGHT_TYPES & (1u << LIGHT_SPOT)) != 0u && type == LIGHT_SPOT) {
    float edge = clamp(facing * rest.y + rest.z, 0.0, 1.0);
    weight *= edge > 0.0 ? 0.01 + edge * edge : 0.0;
  }
  if ((LIGHT_TYPES & (1u << LIGHT_SPHERE)) != 0u && type == LIGHT_SPHERE)
    weight = d2 > 2.0 * extent * extent ? weight : 0.0;
  // A light without a place counts as one that stands at the scene's size.
  precise float share = weight * (type == LIGHT_DIRECTIONAL ? rest.x : inverse * inverse);
  return share;
}

void light_ends(SurfacePoint point, out float ends[LIGHT_ENDS]) {
  precise float sum = 0.0;
  for (uint i = 0u; i < LIGHT_ENDS; ++i) {
    sum += light_weight(i, point);
    ends[i] = sum;
  }
}

// The light that slot `slot` draws; share: how often it is drawn in the mean of samples, over all slots, 0 if no light can
// contribute. u.x becomes the coordinate in the light's stretch.
struct LightChoice {
  uint light;
  float share;
};
LightChoice choose_light(float ends[LIGHT_ENDS], uint slot, inout vec2 u) {
  float total = ends[LIGHT_ENDS - 1u];
  precise float at = min((u.x + float(slot)) / float(LIGHT_SLOTS), 0.99999994) * total;
  LightChoice choice = LightChoice(0u, 0.0);
  float begin = 0.0, end = ends[0];
  for (uint i = 1u; i < LIGHT_ENDS; ++i) {
    bool beyond = at >= ends[i - 1u];
    choice.light = beyond ? i : choice.light;
    begin = beyond ? ends[i - 1u] : begin;
    end = beyond ? ends[i] : end;
  }
  precise float length = end - begin;
  precise float inside = (at - begin) / max(length, 1e-37);
  u.x = clamp(inside, 0.0, 0.99999994);
  choice.share = total > 0.0 ? float(LIGHT_SLOTS) * length / total : 0.0;
  return choice;
}
