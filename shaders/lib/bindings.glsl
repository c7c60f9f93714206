// Every table that the passes read, and what a kernel is specialised for (shaders/shared/frame.h).
#extension GL_EXT_scalar_block_layout : require
#ifdef RAY_QUERY
#extension GL_EXT_ray_query : require
#endif
#include "shaders/shared/frame.h"
#include "shaders/shared/random.h"
#include "shaders/shared/intersect.h"

layout(constant_id = SPEC_SAMPLES) const uint SAMPLES = 1;
layout(constant_id = SPEC_LIGHT_COUNT) const uint LIGHT_COUNT = 1;
layout(constant_id = SPEC_LIGHT_TYPES) const uint LIGHT_TYPES = 63;
layout(constant_id = SPEC_AMBIENT) const bool AMBIENT = true;
layout(constant_id = SPEC_ENVIRONMENT) const bool ENVIRONMENT = false;
layout(constant_id = SPEC_MIRROR) const bool MIRROR = false;
layout(constant_id = SPEC_ALPHA_MASK) const bool ALPHA_MASK = false;
layout(constant_id = SPEC_RESIDUAL) const uint RESIDUAL = 5;
#ifndef LOBE_MODELS
layout(constant_id = SPEC_LOBE_MODELS) const uint LOBES_IN_SCENE = 0xffffffff;
#define LOBE_MODELS LOBES_IN_SCENE
#endif
layout(constant_id = SPEC_FOUR_TAPS) const bool FOUR_TAPS = false;
layout(constant_id = SPEC_STORAGE_FETCH) const bool STORAGE_FETCH = false;
layout(constant_id = SPEC_PIXEL_CENTRES) const bool PIXEL_CENTRES = false;
layout(constant_id = SPEC_NEW_HIT) const bool NEW_HIT = true;
layout(constant_id = SPEC_LIST) const bool LIST = false;
layout(constant_id = SPEC_HIGHLIGHT) const bool HIGHLIGHT = false;
layout(constant_id = SPEC_LIGHT_SLOTS) const uint LIGHT_SLOTS = 0;

layout(local_size_x = GROUP_SIZE) in;

layout(scalar, binding = BINDING_PARAMS) readonly buffer ParamsBlock { FrameParams params; };
layout(scalar, binding = BINDING_LIGHTS) readonly buffer LightsBlock { LightRow lights[]; };
layout(binding = BINDING_LIGHT_TEXELS) uniform samplerBuffer light_texels;  // the same
layout(binding = BINDING_NODES) uniform samplerBuffer nodes_texels;  // bits of uvec4
layout(binding = BINDING_BOXES) uniform samplerBuffer box_texels;    // bits of uvec4
layout(binding = BINDING_TRIANGLES) uniform samplerBuffer triangle_texels;
layout(scalar, binding = BINDING_NODES_STORAGE) readonly buffer NodesBlock { uvec4 nodes_storage[]; };
layout(scalar, binding = BINDING_BOXES_STORAGE) readonly buffer BoxesBlock { uvec4 boxes_storage[]; };
layout(scalar, binding = BINDING_TRIANGLES_STORAGE) readonly buffer TrianglesBlock { vec4 triangles_storage[]; };
layout(binding = BINDING_SURFACE) uniform usamplerBuffer surface_texels;
layout(binding = BINDING_PARTS) uniform usamplerBuffer part_texels;
layout(binding = BINDING_TEXELS) uniform usamplerBuffer texel_texels;
layout(binding = BINDING_ENTRIES) uniform usamplerBuffer entry_texels;
layout(binding = BINDING_BASES) uniform samplerBuffer basis_texels;
layout(binding = BINDING_CLUSTERS) uniform samplerBuffer cluster_texels;
layout(binding = BINDING_RESIDUAL) uniform usamplerBuffer residual_texels;
layout(binding = BINDING_DIRECTION_TRIANGLES) uniform samplerBuffer direction_triangle_texels;
layout(binding = BINDING_DIRECTION_MAP) uniform usamplerBuffer direction_map_texels;
layout(binding = BINDING_ENVIRONMENT) uniform samplerBuffer environment_texels;
layout(binding = BINDING_ENVIRONMENT_CELLS) uniform usamplerBuffer environment_cell_texels;
layout(binding = BINDING_ALPHA) uniform usamplerBuffer alpha_texels;
layout(binding = BINDING_HITS, r32ui) uniform uimageBuffer hits;              // [slot][vertex][pixel]: triangle + 1
layout(binding = BINDING_VISIBILITY, r32ui) uniform uimageBuffer visibility;  // [slot][vertex][word][pixel]: a bit per shadow ray
layout(binding = BINDING_ACCUMULATORS, rgba32f) uniform imageBuffer accumulators;  // [plane][2][pixel]
layout(scalar, binding = BINDING_DISPLAY) buffer DisplayBlock { uint display[]; };  // RGBA8, sRGB
layout(binding = BINDING_AOV, rgba32f) uniform imageBuffer aov;               // [layer][pixel]

layout(scalar, binding = BINDING_LIST) readonly buffer ListBlock { uint list[]; };  // pixels of the region
layout(binding = BINDING_SEEN, r32ui) uniform uimageBuffer seen;              // [2][pixel]: clusters as bits; samples

layout(binding = BINDING_WHOLE, rgba32f) uniform imageBuffer whole;           // the picture's accumulators, where those above are not

#ifdef RAY_QUERY
layout(binding = BINDING_RAYS) uniform accelerationStructureEXT ray_scene;  // of the same triangles
#endif

layout(push_constant, scalar) uniform PushBlock { TilePush tile; };

const float PI = 3.14159265358979323846;
const float HUGE = 3.0e38;

// Shadow rays of one vertex: one to each light, or to each of those drawn where there are many, then ambient, then
// environment; the order of visibility bits, and of planes but for drawn lights. At least one: where nothing lights a scene,
// the ambient is kept with a radiance of 0.
const uint LIGHT_RAYS = LIGHT_SLOTS > 0u ? LIGHT_SLOTS : LIGHT_COUNT;
const uint RAY_COUNT = LIGHT_RAYS + (AMBIENT ? 1u : 0u) + (ENVIRONMENT ? 1u : 0u);
const uint VERTEX_COUNT = MIRROR ? 2u : 1u;

// A stored hit's four samples have a bit for each shadow ray: sample * RAY_COUNT + ray, in so many words a vertex.
const uint VISIBILITY_WORDS = (SAMPLES_PER_HIT * RAY_COUNT + 31u) / 32u;

// Invocation -> pixel of the region: 4 x 2 pixels a subgroup of 8, Morton order within 8 x 8 pixels a workgroup.
// Returns false outside the tile.
bool pixel_of_invocation(out uvec2 pixel, out uint index) {
  if (LIST) {
    uint entry = gl_GlobalInvocationID.x;
    index = list[tile.x + min(entry, max(tile.width, 1u) - 1u)];
    pixel = uvec2(index % params.region_width, index / params.region_width);
    return entry < tile.width;
  }
  uint i = gl_LocalInvocationID.x;
  uvec2 inside = uvec2((i & 1u) | ((i >> 1) & 2u) | ((i >> 2) & 4u), ((i >> 1) & 1u) | ((i >> 2) & 2u) | ((i >> 3) & 4u));
  uvec2 p = (gl_WorkGroupID.xy * 8u + inside) * tile.stride;
  pixel = uvec2(tile.x, tile.y) + p;
  index = pixel.y * params.region_width + pixel.x;
  return p.x < tile.width && p.y < tile.height;
}

uint region_pixels() { return params.region_width * params.region_height; }

// Where this dispatch's hit and its bits are stored. What no longer fits takes the last place, where it cannot be replayed.
int hit_place(uint vertex, uint index) {
  uint slot = min(tile.sample_base / SAMPLES_PER_HIT, params.history - 1u);
  return int((slot * VERTEX_COUNT + vertex) * region_pixels() + index);
}
int visibility_place(uint vertex, uint word, uint index) {
  uint slot = min(tile.sample_base / SAMPLES_PER_HIT, params.history - 1u);
  return int(((slot * VERTEX_COUNT + vertex) * VISIBILITY_WORDS + word) * region_pixels() + index);
}

// Bit of shadow ray `kind` of this dispatch's sample k among those of its hit.
uint visibility_bit(uint k, uint kind) { return (tile.sample_base % SAMPLES_PER_HIT + k) * RAY_COUNT + kind; }
