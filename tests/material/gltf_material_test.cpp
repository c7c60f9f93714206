#include "engine/material/gltf_material.h"

#include <gtest/gtest.h>

#include "engine/core/half.h"
#include "engine/image/image.h"

namespace vamp {
namespace {

vec3 weight(const tables::Entry& entry) {
  const auto half = [](uint32_t bits) { return float_from_half(static_cast<uint16_t>(bits)); };
  return {half(entry.basis_red >> 16), half(entry.green_blue & 0xffffu), half(entry.green_blue >> 16)};
}

TEST(GltfMaterial, AWhiteRoughDielectricIsExactlyLambert) {
  for (const auto& [roughness, specular] : {std::pair{1.f, 1.f}, {0.3f, 0.f}}) {
    const Spmm spmm = spmm_from_gltf({.metallic = 0, .roughness = roughness, .specular = specular});
    ASSERT_TRUE(validate(spmm, "f"));
    ASSERT_EQ(spmm.dictionary.size(), 1u);
    EXPECT_EQ(spmm.dictionary[0].lobe.model, Model::lambert);
    EXPECT_EQ(weight(spmm.entries[0]), vec3(1));
    EXPECT_TRUE(spmm.residual.records.empty());
  }
}

TEST(GltfMaterial, ADielectricHasAFinishOfFourPercent) {
  const Spmm spmm = spmm_from_gltf({.base_color = {0.5f, 0.25f, 0.125f}, .metallic = 0, .roughness = 0.5f});
  ASSERT_TRUE(validate(spmm, "f"));
  ASSERT_EQ(spmm.dictionary.size(), 2u);
  EXPECT_NEAR(spmm.dictionary[1].lobe.params[1], 0.25f, 1e-6);
  EXPECT_NEAR(spmm.dictionary[1].lobe.params[2], 0.04f, 1e-6);
  EXPECT_NEAR(weight(spmm.entries[0]).x, 0.48f, 1e-3);
  EXPECT_EQ(weight(spmm.entries[1]), vec3(1));
}

TEST(GltfMaterial, AMetalReflectsItsColourHeadOn) {
  const vec3 gold(1, 0.77f, 0.34f);
  const Spmm spmm = spmm_from_gltf({.base_color = gold, .metallic = 1, .roughness = 0.4f});
  ASSERT_TRUE(validate(spmm, "f"));
  vec3 head_on(0), grazing(0);
  for (const auto& entry : spmm.entries) {
    const Basis& basis = spmm.dictionary[entry.basis_red & 0xffffu];
    const bool diffuse = basis.lobe.model == Model::lambert;
    head_on += weight(entry) * (diffuse ? 1.f : basis.lobe.params[2]);
    grazing += weight(entry);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(head_on[c], gold[c], 1e-3);
    EXPECT_NEAR(grazing[c], 1, 1e-3);
  }
}

TEST(GltfMaterial, TexturesBecomeWeightsByAreaAverages) {
  Image image(4, 2, {"R", "G", "B"});
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) image.at(x, y, 0) = 0.25f * static_cast<float>(x), image.at(x, y, 1) = 1;
  const Spmm spmm = spmm_from_gltf(
      {.base_color = {1, 0.5f, 1}, .base_color_texture = &image, .metallic = 0, .roughness = 1, .mm_per_uv = 80});
  ASSERT_TRUE(validate(spmm, "f"));
  EXPECT_EQ(spmm.width, 4);
  EXPECT_EQ(spmm.height, 4);
  EXPECT_FLOAT_EQ(spmm.size_mm().x, 80);
  for (int x = 0; x < 4; ++x) {
    const vec3 w = weight(spmm.entries[spmm.texels[static_cast<size_t>(4 + x)].first_entry]);
    EXPECT_EQ(w, vec3(0.25f * static_cast<float>(x), 0.5f, 0));
  }
  Image wide(3000, 1, {"Y"});
  for (float& value : wide.pixels) value = 0.5f;
  const Spmm large = spmm_from_gltf({.base_color_texture = &wide, .metallic = 0, .roughness = 1});
  EXPECT_EQ(large.width, 1024);
  EXPECT_EQ(weight(large.entries[77777]), vec3(0.5f));
}

TEST(GltfMaterial, ValuesOutOfRangeAreClamped) {
  EXPECT_TRUE(validate(spmm_from_gltf({.base_color = {7, -1, 0.5f}, .metallic = 3, .roughness = -2, .ior = 0}), "f"));
  EXPECT_TRUE(validate(spmm_from_gltf({.metallic = 0.5f, .roughness = 0, .ior = 99}), "f"));
}

}  // namespace
}  // namespace vamp
