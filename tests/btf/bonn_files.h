#pragma once
// .btf files as others write them, byte by byte from the description of the formats.
#include <filesystem>

namespace vamp::test {

// Both: setup "dome", sensor "camera", light "LED", 10 pixels per mm, 2 x 2 texels, 2 views, 3 lights, no cosine.

// Two rows a chunk, a mask that leaves texel 1 out, description of version 2, one rotation. The value of a sample is
// texel + view / 2 + light / 4 + channel / 8, without the cosine.
void write_foreign_bdi(const std::filesystem::path& path);

// Version 3 of the description, XML of another kind, model 0, doubles, one component: texel + 1 times 1 + light / 8.
void write_foreign_dfmf(const std::filesystem::path& path);

}  // namespace vamp::test
