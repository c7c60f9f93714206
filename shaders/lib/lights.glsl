// Shadow rays: one to each light or to some of many, one for the ambient, one to the environment. Trace draws them to find what is in the way,
// shade draws the same ones again to weigh them; both from the same counters.

// A direction to sample, how far to look, and the factor that turns ReflectedCos into this sample's share of the picture
// for a light of unit emission (area * cosine / distance^2 for area lights). factor 0: no ray.
struct LightSample {
  vec3 direction;
  float distance;
  float factor;
};

// Concentric map of the square to the unit disk (Shirley & Chiu 1997).
vec2 disk_point(vec2 u) {
  vec2 p = 2.0 * u - 1.0;
  bool wide = abs(p.x) > abs(p.y);
  float r = wide ? p.x : p.y;
  float ratio = wide ? p.y / (abs(p.x) > 0.0 ? p.x : 1.0) : p.x / (abs(p.y) > 0.0 ? p.y : 1.0);
  float phi = wide ? (PI / 4.0) * ratio : (PI / 2.0) - (PI / 4.0) * ratio;
  return r * vec2(cos(phi), sin(phi));
}

// Any orthonormal frame about a unit vector (Duff et al. 2017).
void basis_about(vec3 n, out vec3 t, out vec3 b) {
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float c = n.x * n.y * a;
  t = vec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x);
  b = vec3(c, s + n.y * n.y * a, -n.y);
}

LightSample sample_light(LightRow light, vec3 p, vec2 u) {
  vec3 to = light.center - p;
  LightSample s = LightSample(vec3(0, 0, 1), 0.0, 0.0);
  uint type = light.type;

  // Points on flat emitters; the centre for lights without size.
  vec3 target = to;
  if ((LIGHT_TYPES & (1u << LIGHT_RECT)) != 0u && type == LIGHT_RECT)
    target += light.u * (light.half_width * (2.0 * u.x - 1.0)) + light.v * (light.half_height * (2.0 * u.y - 1.0));
  if ((LIGHT_TYPES & (1u << LIGHT_DISK)) != 0u && type == LIGHT_DISK) {
    vec2 d = disk_point(u) * light.radius;
    target += light.u * d.x + light.v * d.y;
  }
  float d2 = max(dot(target, target), 1e-24);
  float inverse = inversesqrt(d2);
  s.direction = target * inverse;
  s.distance = d2 * inverse;
  float facing = -dot(s.direction, light.n);
  // point: 1 / d^2.
  s.factor = 1.0 / d2;
  if ((LIGHT_TYPES & ((1u << LIGHT_RECT) | (1u << LIGHT_DISK))) != 0u && (type == LIGHT_RECT || type == LIGHT_DISK))
    s.factor = max(facing, 0.0) * light.area / d2;
  if ((LIGHT_TYPES & (1u << LIGHT_SPOT)) != 0u && type == LIGHT_SPOT) {
    float edge = clamp(facing * light.spot_scale + light.spot_offset, 0.0, 1.0);
    s.factor *= edge * edge;
  }
  if ((LIGHT_TYPES & (1u << LIGHT_DIRECTIONAL)) != 0u && type == LIGHT_DIRECTIONAL)
    s = LightSample(-light.n, HUGE, 1.0);
  if ((LIGHT_TYPES & (1u << LIGHT_SPHERE)) != 0u && type == LIGHT_SPHERE) {
    // Uniform over the cone that the sphere fills; its solid angle from 1 - cos without cancellation.
    float c2 = max(dot(to, to), 1e-24);
    float sin2 = min(light.radius * light.radius / c2, 1.0);
    float one_minus_cos = sin2 / (1.0 + sqrt(max(1.0 - sin2, 0.0)));
    float z1 = u.x * one_minus_cos;  // 1 - cos of the sample
    float sin_theta = sqrt(max(z1 * (2.0 - z1), 0.0));
    float phi = 2.0 * PI * u.y;
    vec3 axis = to * inversesqrt(c2), t, b;
    basis_about(axis, t, b);
    s.direction = normalize(axis * (1.0 - z1) + (t * cos(phi) + b * sin(phi)) * sin_theta);
    float along = dot(to, s.direction);
    s.distance = along - sqrt(max(light.radius * light.radius - max(c2 - along * along, 0.0), 0.0));
    // Inside the sphere there is no one-sided light.
    s.factor = sin2 < 1.0 ? 2.0 * PI * one_minus_cos : 0.0;
  }
  return s;
}

// 2 pi times the density of sample_ambient(), its lobe counted with a factor.
float ambient_density(vec3 normal, vec3 view, vec3 direction, float lobe) {
  vec3 mirrored = 2.0 * dot(normal, view) * normal - view;
  float c2 = max(dot(mirrored, direction), 0.0);
  c2 *= c2;
  float c4 = c2 * c2, c8 = c4 * c4, c16 = c8 * c8;
  return 0.8 * max(dot(normal, direction), 0.0) + 0.2 + 13.2 * lobe * (c16 * c16);
}

// Constant ambient radiance: two directions in five cosine-weighted, one uniform, because ReflectedCos / cos is unbounded
// for tilted frames, and two in a lobe cos^32 about the mirror direction, because highlights stand there at grazing view
// (without it: bright dots along silhouettes). The factor is 1 / the mixture's pdf, whichever of them drew.
LightSample sample_ambient(vec3 normal, vec3 view, vec2 u, float choice) {
  vec3 mirrored = 2.0 * dot(normal, view) * normal - view;
  bool cosine = choice < 0.4;
  bool lobe = choice >= 0.6;
  float z = cosine ? sqrt(1.0 - u.x) : (lobe ? exp2(log2(1.0 - u.x) * (1.0 / 33.0)) : u.x);
  float phi = 2.0 * PI * u.y;
  vec3 axis = lobe ? mirrored : normal, t, b;
  basis_about(axis, t, b);
  LightSample s;
  s.direction = normalize((t * cos(phi) + b * sin(phi)) * sqrt(max(1.0 - z * z, 0.0)) + axis * z);
  s.distance = params.ao_radius;
  s.factor = 2.0 * PI / ambient_density(normal, view, s.direction, 1.0);
  return s;
}

// The environment's own frame: world turned back by its rotation about +Y.
vec3 environment_from_world(vec3 d) {
  return vec3(params.environment_cos * d.x - params.environment_sin * d.z, d.y,
              params.environment_sin * d.x + params.environment_cos * d.z);
}
vec3 world_from_environment(vec3 d) {
  return vec3(params.environment_cos * d.x + params.environment_sin * d.z, d.y,
              -params.environment_sin * d.x + params.environment_cos * d.z);
}

// Texel: rgb radiance, a pdf per solid angle.
int environment_texel(vec3 direction) {
  vec3 d = environment_from_world(direction);
  float u = 0.5 + atan(d.x, -d.z) * (0.5 / PI);
  float v = acos(clamp(d.y, -1.0, 1.0)) * (1.0 / PI);
  uint x = min(uint(u * float(params.environment_width)), params.environment_width - 1u);
  uint y = min(uint(v * float(params.environment_height)), params.environment_height - 1u);
  return int(y * params.environment_width + x);
}
vec3 environment_radiance(vec3 direction) {
  return texelFetch(environment_texels, environment_texel(direction)).rgb * params.environment_intensity;
}

// Drawn in proportion to luminance by the alias table; `radiance` at intensity 1.
LightSample sample_environment(vec2 cell, vec2 inside, out vec3 radiance) {
  uint count = params.environment_width * params.environment_height;
  uint i = min(uint(cell.x * float(count)), count - 1u);
  uvec2 alias = texelFetch(environment_cell_texels, int(i)).xy;
  i = cell.y < uintBitsToFloat(alias.x) ? i : alias.y;
  vec4 texel = texelFetch(environment_texels, int(i));
  uint y = i / params.environment_width;
  uint x = i - y * params.environment_width;
  float phi = ((float(x) + inside.x) / float(params.environment_width) - 0.5) * 2.0 * PI;
  float c0 = cos(PI * float(y) / float(params.environment_height));
  float c1 = cos(PI * float(y + 1u) / float(params.environment_height));
  float cosine = mix(c0, c1, inside.y);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  LightSample s;
  s.direction = world_from_environment(vec3(sine * sin(phi), cosine, -sine * cos(phi)));
  s.distance = HUGE;
  s.factor = texel.a > 0.0 ? 1.0 / texel.a : 0.0;
  radiance = texel.rgb;
  return s;
}

#include "shaders/lib/mixture.glsl"
#include "shaders/lib/light_choice.glsl"

// Rays from below the face or the shading normal carry nothing: the rule at the terminator is that a light counts when it
// stands above both.
LightSample above_surface(LightSample s, SurfacePoint point) {
  bool above = dot(s.direction, point.face) > 0.0 && dot(s.direction, point.normal) > 0.0;
  s.factor = above ? s.factor : 0.0;
  return s;
}

// The shadow rays of a sample at one vertex, in the order of visibility bits and planes: lights, ambient, environment, and
// the radiance along the environment's at intensity 1. Each kind is drawn by code of its own: on lavapipe drawing all kinds
// and choosing one costs as much as all kinds. `ends`: of light_ends() at the point, and `drawn`: the light of each slot, where
// lights are drawn.
void draw_shadow_rays(SurfacePoint point, float ends[LIGHT_ENDS], uint seed, uint sample_index, uint vertex,
                      out LightSample rays[RAY_COUNT], out uint drawn[SLOT_ENDS], out vec3 environment) {
  uint base = vertex * PAIR_MIRROR;
  environment = vec3(0.0);
  Highlight highlight;
  if (HIGHLIGHT) highlight = highlight_at(point);
  for (uint i = 0u; i < LIGHT_RAYS; ++i) {
    vec2 u = random_pair(seed, sample_index, base + PAIR_LIGHT + i);
    LightChoice choice = LightChoice(i, 1.0);
    if (LIGHT_SLOTS > 0u) choice = choose_light(ends, i, u);
    LightRow light = fetch_light(choice.light);
    LightSample s;
    if (HIGHLIGHT) s = sample_light_or_highlight(light, point, highlight, u);
    else s = sample_light(light, point.position, u);
    if (LIGHT_SLOTS > 0u) {
      s.factor = choice.share > 0.0 ? s.factor / choice.share : 0.0;
      drawn[i] = choice.light;
    }
    rays[i] = above_surface(s, point);
  }
  if (AMBIENT) {
    vec2 u = random_pair(seed, sample_index, base + PAIR_AMBIENT);
    float choice = random_pair(seed, sample_index, base + PAIR_AMBIENT_CHOICE).x;
    LightSample s;
    if (HIGHLIGHT) s = sample_ambient_or_highlight(point, highlight, u, choice);
    else s = sample_ambient(point.normal, point.view, u, choice);
    rays[LIGHT_RAYS] = above_surface(s, point);
  }
  if (ENVIRONMENT) {
    vec2 cell = random_pair(seed, sample_index, base + PAIR_ENVIRONMENT_CELL);
    vec2 inside = random_pair(seed, sample_index, base + PAIR_ENVIRONMENT_TEXEL);
    LightSample s;
    if (HIGHLIGHT) s = sample_environment_or_highlight(highlight, cell, inside, environment);
    else s = sample_environment(cell, inside, environment);
    rays[RAY_COUNT - 1u] = above_surface(s, point);
  }
}

// An area light along a mirror's ray, nearer than `t_max`: its number, or -1. One-sided where it is flat.
int light_hit(vec3 origin, vec3 direction, float t_max) {
  int found = -1;
  float nearest = t_max;
  for (uint i = 0u; i < LIGHT_COUNT; ++i) {
    LightRow light = lights[i];
    vec3 to = light.center - origin;
    float facing = -dot(direction, light.n);
    float t = facing > 0.0 ? -dot(to, light.n) / facing : -1.0;
    vec3 q = direction * t - to;
    bool inside = light.type == LIGHT_RECT
                      ? abs(dot(q, light.u)) <= light.half_width && abs(dot(q, light.v)) <= light.half_height
                      : light.type == LIGHT_DISK && dot(q, q) <= light.radius * light.radius;
    float along = dot(to, direction);
    float rest = light.radius * light.radius - (dot(to, to) - along * along);
    bool sphere = light.type == LIGHT_SPHERE && rest >= 0.0;
    t = sphere ? along - sqrt(max(rest, 0.0)) : t;
    bool hit = (inside || sphere) && t > 0.0 && t < nearest;
    nearest = hit ? t : nearest;
    found = hit ? int(i) : found;
  }
  return found;
}
