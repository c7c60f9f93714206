// What every kernel of a picture reads besides the big tables. Scalar layout, 4-byte members, read by GLSL and C++.
#ifdef __cplusplus
#pragma once
#include "engine/core/vec.h"
namespace vamp::frame {
using uint = std::uint32_t;
#endif

#define BINDING_PARAMS 0
#define BINDING_LIGHTS 1
#define BINDING_NODES 2
#define BINDING_TRIANGLES 3
#define BINDING_NODES_STORAGE 4
#define BINDING_TRIANGLES_STORAGE 5
#define BINDING_SURFACE 6
#define BINDING_PARTS 7
#define BINDING_TEXELS 8
#define BINDING_ENTRIES 9
#define BINDING_BASES 10
#define BINDING_CLUSTERS 11
#define BINDING_RESIDUAL 12
#define BINDING_DIRECTION_TRIANGLES 13
#define BINDING_DIRECTION_MAP 14
#define BINDING_ENVIRONMENT 15
#define BINDING_ENVIRONMENT_CELLS 16
#define BINDING_ALPHA 17
#define BINDING_HITS 18
#define BINDING_VISIBILITY 19
#define BINDING_ACCUMULATORS 20
#define BINDING_DISPLAY 21
#define BINDING_AOV 22
#define BINDING_BOXES 23
#define BINDING_BOXES_STORAGE 24
#define BINDING_LIST 25
#define BINDING_SEEN 26
#define BINDING_WHOLE 27
#define BINDING_LIGHT_TEXELS 28
#define BINDING_RAYS 29             // where kernels ask the device for rays

// What a kernel is specialised for (constant_id): the scene pays only for what it uses.
#define SPEC_SAMPLES 0             // samples in one dispatch: 1 or 4
#define SPEC_LIGHT_COUNT 1         // 0 to MAX_LIGHTS
#define SPEC_LIGHT_TYPES 2         // a bit per LIGHT_*
#define SPEC_AMBIENT 3             // bool
#define SPEC_ENVIRONMENT 4         // bool: an environment lights the scene
#define SPEC_MIRROR 5              // bool: some visible part reflects
#define SPEC_ALPHA_MASK 6          // bool
#define SPEC_RESIDUAL 7            // 0: none, 1: mean, 2 to 5: mean and 1 to 4 PCA terms
#define SPEC_LOBE_MODELS 8         // a bit per model
#define SPEC_FOUR_TAPS 9           // bool: blended values of four texels instead of one stochastic tap
#define SPEC_STORAGE_FETCH 10      // bool: nodes and triangles through storage buffers instead of texel buffers
#define SPEC_PIXEL_CENTRES 11      // bool: no jitter
#define SPEC_NEW_HIT 12            // bool: trace the primary ray, else take the stored hit
#define SPEC_LIST 13               // bool: pixels from a list instead of a tile
#define SPEC_HIGHLIGHT 14          // bool: some visible part has a sharp highlight that directions are drawn from too
#define SPEC_LIGHT_SLOTS 15        // 0: a ray to every light; else so many lights are drawn by each sample

#define MAX_LIGHTS 32
#define TILE_SIDE 64
#define GROUP_SIZE 64
#define SAMPLES_PER_HIT 4          // one stored primary hit serves four samples

#define LIGHT_POINT 0
#define LIGHT_SPOT 1
#define LIGHT_DIRECTIONAL 2
#define LIGHT_RECT 3
#define LIGHT_DISK 4
#define LIGHT_SPHERE 5

// A light's place and shape; what it emits stands apart (FrameParams::emission), so that it can change without a restart.
struct LightRow {
  vec3 center;
  uint type;
  vec3 u;            // unit axes; n is the side that emits, or the direction of view of a spot or directional light
  float half_width;
  vec3 v;
  float half_height;
  vec3 n;
  float radius;
  float area;        // square scene units; directional: 1 / square of the scene's radius, see light_choice.glsl
  float spot_scale, spot_offset;
  float extent;      // radius of a sphere about the centre that holds all of the light
};
#define LIGHT_ROW_TEXELS 5         // RGBA32F

// One part: its geometry's use of a material. 6 texels RGBA32UI.
struct PartRow {
  uint texel_base, entry_base, basis_base, residual_base;        // first rows of its material
  uint size;                                                     // width in bits 0..15, height in bits 16..31
  uint cluster_base, basis_count, flags;
  float uv_xx, uv_xy, uv_yx, uv_yy;                              // texture coordinate = matrix * uv + offset, in periods
  float offset_x, offset_y, rotation_cos, rotation_sin;          // of the tangent frame
  uint direction_count, direction_triangles, direction_map;      // the residual's directions; 0: none
  float last_ring_cos;
  float mirror_f0, alpha_cutoff;
  uint alpha_base, alpha_size;                                   // alpha mask, in bytes; width and height as in size
};
#define PART_ROW_TEXELS 6
#define PART_TERMS_SHIFT 8         // flags, bits 8..10: PCA terms of the residual in use
#define PART_SEEN_SHIFT 16         // flags, bits 16..20: cluster 0 sets this bit of what a pixel has seen, the next one the next
#define PART_HIGHLIGHT_SHIFT 24    // flags, bits 24..31: width of its sharp highlight as 2^(-code / steps), 0: none
#define PART_HIGHLIGHT_STEPS 32.0

// One picture's camera, grid and display.
struct FrameParams {
  vec3 origin;       // CameraFrame
  uint seed;
  vec3 right;
  float ao_radius;   // scene units; a huge number where unbounded
  vec3 up;
  float offset_scale;  // ray offset in proportion to the scene, scene units
  vec3 forward;
  vec3 grid_origin;
  uint picture_width;
  vec3 grid_scale;
  uint picture_height;
  uint region_x, region_y, region_width, region_height;          // what is rendered of it, in pixels
  vec3 background;   // radiance behind everything
  uint background_is_environment;
  vec3 ambient;      // radiance
  float exposure;    // a factor
  uint tone_map;     // 0: none, 1: Khronos PBR Neutral
  uint environment_width, environment_height;
  float environment_intensity;
  float environment_cos, environment_sin;
  uint light_count;
  uint planes;       // accumulator planes
  uint list_end;     // of the tree's boxes (shaders/shared/intersect.h)
  uint history;      // hits stored for each pixel, at least 1; later ones take the place of the last
  vec3 emission[MAX_LIGHTS];  // radiance of area lights, intensity of the others
};

// What a dispatch is about.
struct TilePush {
  uint x, y;                // of the tile in the region, pixels; with SPEC_LIST: first entry of the list, 0
  uint width, height;       // of the tile; with SPEC_LIST: number of entries, 1
  uint sample_base;         // first sample of this dispatch
  uint stride;              // 1, or every stride-th pixel of every stride-th row, shown as a block
  uint weights_alone;       // 1: what the tables' functions reflect, into sums that nobody sees (WeightSums)
  float step;               // of the recombine pass, along a direction of weights
};

// Accumulator planes of a pixel, each two texels RGBA32F: the compensated sum and its compensation (Kahan 1965).
//   0: seen directly (environment behind the model and in mirrors; w: coverage).
//   1 ..: one for each light at unit emission, then ambient at unit radiance, then the environment at intensity 1.
#define PLANE_DIRECT 0
#define PLANE_LIGHTS 1

#ifdef __cplusplus
static_assert(sizeof(LightRow) == 80 && sizeof(PartRow) == 96 && sizeof(TilePush) == 32);
static_assert(sizeof(FrameParams) == 180 + 12 * MAX_LIGHTS);
}  // namespace vamp::frame
#endif
