#pragma once
// What must hold of every tree, and the search that needs none.
#include <optional>

#include "engine/accel/bvh.h"
#include "tests/accel/meshes.h"

namespace vamp {

// Every triangle stands in exactly one leaf (a single one twice), inside all boxes above it with a quarter of a cell to
// spare; the depth is what the tree says and fits the stack; the list holds the same boxes.
void expect_valid(const Bvh& bvh);

// The nearest hit without a tree, in the same arithmetic.
std::optional<Hit> pick_without_tree(const TestMesh& mesh, const vec3& origin, const vec3& direction);

}  // namespace vamp
