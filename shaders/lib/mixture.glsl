// Directions drawn from a material's sharp highlight besides those drawn from lights: multiple importance sampling (Veach
// and Guibas 1995), one ray by one of the two and divided by the density of both. Where a light is larger than the
// highlight, points on the light alone would seldom meet it.
//
// A part's highlight is a Gaussian of slopes about the shading normal, as wide as the sharp functions of its material
// as it was fitted (highlight_width() in engine/material/highlight.h): geometry and the fit alone decide where a ray
// goes, so that an edit can be shaded again from stored visibility.
//
// For lights.glsl, which includes it behind its samplers.
#include "shaders/brdf/ward.glsl"

// Width of slopes; 0: the part has no sharp highlight.
float part_highlight(uint part) {
  if (!HIGHLIGHT) return 0.0;
  uint code = texelFetch(part_texels, int(part) * PART_ROW_TEXELS + 1).w >> PART_HIGHLIGHT_SHIFT;
  return code == 0u ? 0.0 : exp2(float(code) * (-1.0 / PART_HIGHLIGHT_STEPS));
}

// The highlight as it is seen from one side.
struct Highlight {
  vec3 t, b, n;
  vec3 wo;      // in that frame
  float alpha;  // 0: none
};

Highlight highlight_at(SurfacePoint point) {
  Highlight h;
  h.n = point.normal;
  basis_about(h.n, h.t, h.b);
  h.wo = vec3(dot(h.t, point.view), dot(h.b, point.view), dot(h.n, point.view));
  h.alpha = part_highlight(point.part);
  return h;
}

vec3 highlight_direction(Highlight h, vec2 u) {
  float alpha = max(h.alpha, 0.001);
  vec3 wi = ward_direction(alpha, alpha, h.wo, u);
  return normalize(h.t * wi.x + h.b * wi.y + h.n * wi.z);
}

float highlight_pdf(Highlight h, vec3 direction) {
  float alpha = max(h.alpha, 0.001);
  return ward_pdf(alpha, alpha, vec3(dot(h.t, direction), dot(h.b, direction), dot(h.n, direction)), h.wo);
}

// Share of rays to a light of this solid angle that are drawn from the highlight: half where the light is the larger.
float highlight_chance(Highlight h, float solid_angle) {
  float width = 4.0 * PI * h.alpha * h.alpha;
  return h.alpha > 0.0 ? 0.5 * solid_angle / (solid_angle + width) : 0.0;
}

// u.x < chance picks; what is left of it is spread again over [0, 1).
bool picks_highlight(float chance, inout vec2 u) {
  bool picked = u.x < chance;
  u.x = picked ? u.x / max(chance, 1e-6) : min((u.x - chance) / (1.0 - chance), 0.99999994);
  return picked;
}

const uint AREA_LIGHTS = (1u << LIGHT_RECT) | (1u << LIGHT_DISK) | (1u << LIGHT_SPHERE);

// Where a ray from p meets an area light on the side that emits: x the distance, 0 if it does not; y the density of
// sample_light() there.
vec2 meet_light(LightRow light, vec3 p, vec3 direction) {
  vec3 to = light.center - p;
  float facing = -dot(direction, light.n);
  float t = -dot(to, light.n) / (facing > 0.0 ? facing : 1.0);
  vec3 q = direction * t - to;
  bool inside = light.type == LIGHT_RECT
                    ? abs(dot(q, light.u)) <= light.half_width && abs(dot(q, light.v)) <= light.half_height
                    : light.type == LIGHT_DISK && dot(q, q) <= light.radius * light.radius;
  bool on_flat = facing > 0.0 && t > 0.0 && inside;
  vec2 met = on_flat ? vec2(t, t * t / max(facing * light.area, 1e-30)) : vec2(0.0);
  if ((LIGHT_TYPES & (1u << LIGHT_SPHERE)) != 0u && light.type == LIGHT_SPHERE) {
    float c2 = max(dot(to, to), 1e-24);
    float along = dot(to, direction);
    float sin2 = min(light.radius * light.radius / c2, 1.0);
    float one_minus_cos = max(sin2 / (1.0 + sqrt(max(1.0 - sin2, 0.0))), 1e-30);
    float rest = light.radius * light.radius - max(c2 - along * along, 0.0);
    bool on_sphere = along > 0.0 && rest >= 0.0 && sin2 < 1.0;
    met = on_sphere ? vec2(along - sqrt(max(rest, 0.0)), 1.0 / (2.0 * PI * one_minus_cos)) : vec2(0.0);
  }
  return met;
}

// A point of an area light, or where the highlight meets it.
LightSample sample_light_or_highlight(LightRow light, SurfacePoint point, Highlight highlight, vec2 u) {
  bool area = (AREA_LIGHTS >> light.type & 1u) != 0u;
  vec3 to = light.center - point.position;
  float d2 = max(dot(to, to), 1e-24);
  float facing = light.type == LIGHT_SPHERE ? 0.25 : abs(dot(to, light.n)) * inversesqrt(d2);
  float chance = area ? highlight_chance(highlight, light.area * facing / d2) : 0.0;
  bool picked = picks_highlight(chance, u);
  LightSample s = sample_light(light, point.position, u);
  float density = s.factor > 0.0 ? 1.0 / s.factor : 0.0;
  if (picked) {
    s.direction = highlight_direction(highlight, u);
    vec2 met = meet_light(light, point.position, s.direction);
    s.distance = met.x;
    density = met.y;
  }
  float both = (1.0 - chance) * density + chance * highlight_pdf(highlight, s.direction);
  if (chance > 0.0) s.factor = density > 0.0 ? 1.0 / both : 0.0;
  return s;
}

// The ambient's mixture with half of its lobe given to the highlight.
LightSample sample_ambient_or_highlight(SurfacePoint point, Highlight highlight, vec2 u, float choice) {
  LightSample s = sample_ambient(point.normal, point.view, u, choice);
  if (highlight.alpha > 0.0) {
    if (choice >= 0.8) s.direction = highlight_direction(highlight, u);
    s.factor = 2.0 * PI / (ambient_density(point.normal, point.view, s.direction, 0.5) +
                           0.4 * PI * highlight_pdf(highlight, s.direction));
  }
  return s;
}

// A texel of the environment, or what the highlight sees of it.
LightSample sample_environment_or_highlight(Highlight highlight, vec2 cell, vec2 inside, out vec3 radiance) {
  float chance = highlight_chance(highlight, 2.0 * PI);
  bool picked = picks_highlight(chance, cell);
  LightSample s = sample_environment(cell, inside, radiance);
  float density = s.factor > 0.0 ? 1.0 / s.factor : 0.0;
  if (picked) {
    s.direction = highlight_direction(highlight, inside);
    vec4 texel = texelFetch(environment_texels, environment_texel(s.direction));
    radiance = texel.rgb;
    density = texel.a;
  }
  float both = (1.0 - chance) * density + chance * highlight_pdf(highlight, s.direction);
  if (chance > 0.0) s.factor = density > 0.0 ? 1.0 / both : 0.0;
  return s;
}
