#pragma once
// A triangle mesh on its way into the scene, and what is made up where a file leaves something out.
#include <cstddef>
#include <vector>

#include "engine/core/vec.h"

namespace vamp {

// normals, tangents and uvs are empty or as long as positions.
struct Mesh {
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<vec4> tangents;
  std::vector<vec2> uvs;
  std::vector<uvec3> triangles;
};

// Removes triangles without area or with a vertex used twice; returns how many.
size_t drop_degenerate_triangles(Mesh& mesh);

// Normals of length zero become the sum of the normals of the triangles around; returns how many.
size_t repair_normals(Mesh& mesh);

// glTF 2.0, section 3.7.2.1: without normals a mesh is flat-shaded. Gives each triangle vertices of its own.
void make_flat_normals(Mesh& mesh);

// Box projection: a triangle's plane of projection follows the largest component of its geometric normal, textures
// stand upright and unmirrored from each of the six sides, one UV = 100 mm. Vertices are split where the side changes.
// Needs normals (they are copied along).
inline constexpr float kGeneratedMmPerUv = 100.0f;
void project_uvs(Mesh& mesh, float mm_per_unit);

// Tangents along +dP/du for a mesh with normals and UVs. Equivalent to MikkTSpace (Mikkelsen 2008) up to rounding:
// vertices that agree in position, normal and UV count as one whatever the indices say; dP/du and dP/dv of the
// triangles around are projected into the plane of the normal, normalised, weighted by the corner's angle and added up;
// triangles with mirrored UVs are kept apart from the others (their vertices are split), triangles without UV area
// follow their neighbours. w = +1 where the texture is seen unmirrored from the front: the bitangent w * cross(n, t)
// points to falling v, as glTF wants it. Where nothing defines a tangent, some vector across the normal stands in.
void make_tangents(Mesh& mesh);

}  // namespace vamp
