// What a model in a file becomes in the scene.
#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/core/progress.h"
#include "engine/image/save.h"
#include "tests/scene/load_glb.h"

namespace vamp {
namespace {

using test::box;
using test::GlbBuilder;
using test::loaded;
using test::plane;
using test::Shape;
using testing::Contains;
using testing::HasSubstr;

vec3 face_normal(const Scene& s, size_t triangle) {
  const uvec3 t = s.triangles[triangle];
  return glm::normalize(glm::cross(s.positions[t.y] - s.positions[t.x], s.positions[t.z] - s.positions[t.x]));
}

double area(const Scene& s) {
  double sum = 0;
  for (const Part& part : s.parts) sum += part.area;
  return sum;
}

TEST(GltfImport, ABoxHasItsAreaBoundsAndScale) {
  GlbBuilder b;
  b.add(box(vec3(2, 2, 2)), b.material("leather", vec4(0.5f, 0.25f, 0.125f, 1), 0.25f, 0.75f), vec3(1, 2, 3));
  const auto s = loaded(b);
  ASSERT_EQ(s->parts.size(), 1u);
  EXPECT_EQ(s->triangles.size(), 12u);
  EXPECT_EQ(s->positions.size(), 24u);
  EXPECT_EQ(s->parts[0].name, "leather");
  EXPECT_EQ(s->find_part("leather"), 0);
  EXPECT_EQ(s->find_part("nothing"), -1);
  EXPECT_EQ(s->parts[0].material.base_color, vec4(0.5f, 0.25f, 0.125f, 1));
  EXPECT_FLOAT_EQ(s->parts[0].material.metallic, 0.25f);
  EXPECT_FLOAT_EQ(s->parts[0].material.roughness, 0.75f);
  EXPECT_NEAR(s->parts[0].area, 24, 1e-5);
  EXPECT_NEAR(s->parts[0].uv_area, 6, 1e-5);
  // sqrt(24 / 6) units of 1000 mm.
  EXPECT_NEAR(s->parts[0].mm_per_uv, 2000, 1e-2);
  EXPECT_EQ(s->bounds.lo, vec3(0, 1, 2));
  EXPECT_EQ(s->bounds.hi, vec3(2, 3, 4));
  EXPECT_TRUE(s->notes.empty()) << s->notes[0];
}

TEST(GltfImport, TheJsonFormWithDataUriGivesTheSameScene) {
  GlbBuilder b;
  b.add(test::sphere(1, 40), b.material("a"));  // over 4 KiB of base64
  const auto glb = loaded(b);
  const auto gltf = loaded(b, "model.gltf");
  EXPECT_EQ(glb->positions, gltf->positions);
  EXPECT_EQ(glb->triangles, gltf->triangles);
  EXPECT_EQ(glb->tangents, gltf->tangents);
}

TEST(GltfImport, BuffersAndImagesBesideTheFileAreRead) {
  const test::TempFolder folder;
  GlbBuilder b;
  Shape s = plane(1, 1);
  const int material = b.material("a");
  b.json()["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  b.json()["textures"] = Json::array({Json{{"source", 0}}});
  b.json()["images"] = Json::array({Json{{"uri", "my%20picture.png"}}});
  b.add(s, material);
  Image image(2, 1, {"R", "G", "B"});
  image.pixels = {1, 0, 0, 0, 1, 0};
  ASSERT_TRUE(save_png(folder / "my picture.png", image));
  ASSERT_TRUE(write_file_atomically(folder / "mesh.bin", b.buffer()));
  b.json()["buffers"] = Json::array({Json{{"byteLength", b.buffer().size()}, {"uri", "mesh.bin"}}});
  ASSERT_TRUE(write_text_atomically(folder / "model.gltf", b.json().dump()));
  const auto scene = load_scene(folder / "model.gltf");
  ASSERT_TRUE(scene) << scene.error().message();
  ASSERT_EQ((*scene)->textures.size(), 1u);
  EXPECT_EQ((*scene)->parts[0].material.base_color_texture.texture, 0);
  const Image& read = *(*scene)->textures[0].image;
  EXPECT_EQ(read.width, 2);
  EXPECT_FLOAT_EQ(read.at(1, 0, 1), 1);
}

TEST(GltfImport, TransformsOfParentsApplyFromTheRootDown) {
  GlbBuilder b;
  const int mesh = b.mesh(plane(2, 2));
  // The child turns its plane upright (+Y to +Z), the parent scales by 3 and moves.
  const float h = std::sqrt(0.5f);
  b.json()["nodes"] = Json::array({Json{{"children", {1}}, {"translation", {10, 0, 0}}, {"scale", {3, 3, 3}}},
                                   Json{{"mesh", mesh}, {"rotation", {h, 0, 0, h}}, {"translation", {0, 1, 0}}}});
  b.json()["scenes"][0]["nodes"] = {0};
  const auto s = loaded(b);
  EXPECT_NEAR(glm::length(s->bounds.lo - vec3(7, 0, 0)), 0, 1e-5f);
  EXPECT_NEAR(glm::length(s->bounds.hi - vec3(13, 6, 0)), 0, 1e-5f);
  for (const vec3& n : s->normals) EXPECT_NEAR(n.z, 1, 1e-6f);
  EXPECT_NEAR(face_normal(*s, 0).z, 1, 1e-6f);
}

TEST(GltfImport, ANegativeScaleKeepsFacesOutwardAndFlipsTheBitangent) {
  GlbBuilder b;
  const int mesh = b.mesh(box(vec3(2)));
  b.node(Json{{"mesh", mesh}, {"scale", {-1, 1, 1}}});
  const auto s = loaded(b);
  for (size_t i = 0; i < s->triangles.size(); ++i) {
    const uvec3 t = s->triangles[i];
    EXPECT_GT(glm::dot(face_normal(*s, i), s->positions[t.x]), 0);
    EXPECT_NEAR(glm::dot(face_normal(*s, i), s->normals[t.x]), 1, 1e-5f);
    EXPECT_EQ(s->tangents[t.x].w, -1);
  }
}

TEST(GltfImport, NormalsFollowTheInverseTransposeOfUnevenScales) {
  GlbBuilder b;
  Shape s;
  s.positions = {{0, 0, 0}, {1, -1, 0}, {0, 0, -1}};
  s.normals = std::vector<vec3>(3, glm::normalize(vec3(1, 1, 0)));
  s.uvs = {{0, 0}, {1, 0}, {0, 1}};
  const int mesh = b.mesh(s);
  b.node(Json{{"mesh", mesh}, {"scale", {1, 4, 1}}});
  const auto scene = loaded(b);
  EXPECT_NEAR(std::abs(glm::dot(scene->normals[0], face_normal(*scene, 0))), 1, 1e-6f);
}

TEST(GltfImport, MatricesAreColumnMajor) {
  GlbBuilder b;
  const int mesh = b.mesh(plane(2, 2));
  b.node(Json{{"mesh", mesh}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}});
  EXPECT_EQ(loaded(b)->bounds.center(), vec3(5, 6, 7));
}

TEST(GltfImport, StripsAndFansGiveTheSameSquareAsAList) {
  for (const int mode : {5, 6}) {
    GlbBuilder b;
    Shape s;
    s.mode = mode;
    if (mode == 5)
      s.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    else
      s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    s.indices = {0, 1, 2, 3};
    b.add(s);
    const auto scene = loaded(b);
    ASSERT_EQ(scene->triangles.size(), 2u);
    EXPECT_NEAR(area(*scene), 1, 1e-6);
    for (size_t i = 0; i < 2; ++i) EXPECT_NEAR(face_normal(*scene, i).z, 1, 1e-6f) << "mode " << mode;
  }
}

TEST(GltfImport, PointsAndLinesAreLeftOutAndSaidSo) {
  GlbBuilder b;
  b.add(plane(1, 1));
  Shape lines;
  lines.positions = {{0, 0, 0}, {1, 0, 0}};
  lines.mode = 1;
  b.add(lines);
  const auto s = loaded(b);
  EXPECT_EQ(s->triangles.size(), 2u);
  EXPECT_THAT(s->notes, Contains(HasSubstr("points and lines are left out")));
}

TEST(GltfImport, WithoutIndicesVerticesAreTakenInOrder) {
  GlbBuilder b;
  Shape s;
  s.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  b.add(s);
  const auto scene = loaded(b);
  EXPECT_EQ(scene->triangles.size(), 2u);
  EXPECT_NEAR(area(*scene), 1, 1e-6);
}

TEST(GltfImport, MissingNormalsAreFlat) {
  GlbBuilder b;
  Shape s = box(vec3(1));
  s.normals.clear();
  b.add(s);
  const auto scene = loaded(b);
  EXPECT_EQ(scene->positions.size(), 36u);
  for (size_t i = 0; i < scene->triangles.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(glm::dot(scene->normals[scene->triangles[i][k]], face_normal(*scene, i)), 1, 1e-6f);
  EXPECT_THAT(scene->notes, Contains(HasSubstr("no normals, shaded flat")));
}

TEST(GltfImport, MissingUvsAreProjectedWithAHundredMillimetresPerUv) {
  GlbBuilder b;
  Shape s = box(vec3(0.2f, 0.3f, 0.4f));
  s.uvs.clear();
  b.add(s, b.material("bare"));
  const auto scene = loaded(b);
  EXPECT_TRUE(scene->parts[0].uv_generated);
  EXPECT_FLOAT_EQ(scene->parts[0].mm_per_uv, 100);
  // In each triangle a step of 100 mm is a step of one UV, and the picture is not mirrored.
  for (const uvec3& t : scene->triangles) {
    EXPECT_NEAR(glm::length(scene->positions[t.y] - scene->positions[t.x]) * 10,
                glm::length(scene->uvs[t.y] - scene->uvs[t.x]), 1e-5f);
    EXPECT_EQ(scene->tangents[t.x].w, 1);
  }
  EXPECT_THAT(scene->notes, Contains(HasSubstr("box projection with 100 mm per UV")));
}

TEST(GltfImport, DegenerateTrianglesAreDroppedAndCounted) {
  GlbBuilder b;
  Shape s = plane(1, 1);
  s.indices.insert(s.indices.end(), {0, 0, 1, 2, 2, 2});
  s.positions.insert(s.positions.end(), {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  s.normals.resize(7, vec3(0, 1, 0));
  s.uvs.resize(7, vec2(0));
  s.indices.insert(s.indices.end(), {4, 5, 6});
  b.add(s);
  const auto scene = loaded(b);
  EXPECT_EQ(scene->triangles.size(), 2u);
  EXPECT_THAT(scene->notes, Contains(HasSubstr("3 triangles without area are left out")));
}

TEST(GltfImport, PrimitivesThatShareAMaterialNameAreOnePart) {
  GlbBuilder b;
  const int sole = b.material("sole");
  const int upper = b.material("upper");
  const int sole_again = b.material("sole", vec4(1, 0, 0, 1));
  b.add(plane(1, 1), sole);
  b.add(plane(1, 1), upper, vec3(0, 1, 0));
  b.add(plane(1, 1), sole_again, vec3(0, 2, 0));
  const auto s = loaded(b);
  ASSERT_EQ(s->parts.size(), 2u);
  EXPECT_EQ(s->parts[0].name, "sole");
  EXPECT_EQ(s->parts[0].triangle_count, 4u);
  EXPECT_EQ(s->parts[1].first_triangle, 4u);
  EXPECT_TRUE(std::is_sorted(s->triangle_part.begin(), s->triangle_part.end()));
  EXPECT_EQ(s->parts[0].bounds.hi.y, 2);
  EXPECT_THAT(s->notes, Contains(HasSubstr("several materials are named \"sole\"")));
}

TEST(GltfImport, PartsWithoutANameGetOneOfTheirOwn) {
  GlbBuilder b;
  b.add(plane(1, 1), b.material(""));
  b.add(plane(1, 1), b.material("Part 1"), vec3(0, 1, 0));
  b.add(plane(1, 1), b.material("Default"), vec3(0, 2, 0));
  b.add(plane(1, 1), -1, vec3(0, 3, 0));
  b.add(plane(1, 1), b.material("  \n "), vec3(0, 4, 0));
  const auto s = loaded(b);
  std::vector<std::string> names;
  for (const Part& part : s->parts) names.push_back(part.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Part 2", "Part 1", "Default", "Default 2", "Part 3"}));
}

TEST(GltfImport, QuantisedAttributesAreReadWithTheirScale) {
  GlbBuilder b;
  const std::vector<int16_t> positions = {0, 0, 0, 0, 32767, 0, 0, 0, 0, 0, -32768, 0};
  const std::vector<int8_t> normals = {0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0};
  const std::vector<uint16_t> uvs = {0, 0, 65535, 0, 0, 65535};
  const std::vector<uint8_t> indices = {0, 1, 2};
  Json attributes = {{"POSITION", b.accessor(b.view(std::as_bytes(std::span(positions)), 8), 5122, 3, "VEC3", true)},
                     {"NORMAL", b.accessor(b.view(std::as_bytes(std::span(normals)), 4), 5120, 3, "VEC3", true)},
                     {"TEXCOORD_0", b.accessor(b.view(std::as_bytes(std::span(uvs)), 4), 5123, 3, "VEC2", true)}};
  const int index = b.accessor(b.view(std::as_bytes(std::span(indices))), 5121, 3, "SCALAR");
  b.json()["meshes"] =
      Json::array({Json{{"primitives", Json::array({Json{{"attributes", attributes}, {"indices", index}}})}}});
  b.json()["extensionsRequired"] = {"KHR_mesh_quantization"};
  b.node(0);
  const auto s = loaded(b);
  ASSERT_EQ(s->positions.size(), 3u);
  EXPECT_EQ(s->positions[1], vec3(1, 0, 0));
  EXPECT_EQ(s->positions[2], vec3(0, 0, -1));
  EXPECT_EQ(s->uvs[2], vec2(0, 1));
  EXPECT_EQ(s->normals[0], vec3(0, 1, 0));
}

TEST(GltfImport, SparseAccessorsReplaceElements) {
  GlbBuilder b;
  Shape shape = plane(2, 2);
  b.add(shape);
  const std::vector<uint16_t> where = {1, 3};
  const std::vector<vec3> what = {{9, 0, -1}, {9, 0, 1}};
  const int places = b.view(std::as_bytes(std::span(where)));
  const int values = b.view(std::as_bytes(std::span(what)));
  b.json()["accessors"][0]["sparse"] = {{"count", 2},
                                        {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                                        {"values", {{"bufferView", values}}}};
  EXPECT_EQ(loaded(b)->bounds.hi.x, 9);
}

TEST(GltfImport, CamerasAndLightsComeWithTheirNodes) {
  GlbBuilder b;
  b.add(box(vec3(2)));
  b.json()["cameras"] = Json::array(
      {Json{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}},
       Json{{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0.1}}}}});
  b.json()["extensionsUsed"] = {"KHR_lights_punctual"};
  b.json()["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({Json{{"type", "point"}, {"intensity", 683}, {"color", {1, 0.5, 0.25}}},
                   Json{{"type", "spot"}, {"intensity", 1}, {"spot", {{"outerConeAngle", 0.5}}}},
                   Json{{"type", "directional"}, {"intensity", 1366}}});
  b.node(Json{{"camera", 0}, {"name", "front"}, {"translation", {0, 0, 10}}});
  b.node(Json{{"camera", 1}, {"name", "plan"}});
  for (int i = 0; i < 3; ++i)
    b.node(
        Json{{"name", "lamp"}, {"translation", {0, 4, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  const auto s = loaded(b);
  ASSERT_EQ(s->cameras.size(), 1u);
  EXPECT_EQ(s->cameras[0].name, "front");
  EXPECT_EQ(s->cameras[0].eye, vec3(0, 0, 10));
  EXPECT_NEAR(glm::length(s->cameras[0].target), 0, 1e-5f);
  EXPECT_NEAR(s->cameras[0].fov_degrees, 0.5 * 180 / std::numbers::pi, 1e-3);
  EXPECT_THAT(s->notes, Contains(HasSubstr("orthographic")));
  ASSERT_EQ(s->lights.size(), 3u);
  // 683 cd are 1 W / sr.
  EXPECT_NEAR(light_intensity(s->lights[0]).x, 1, 1e-5f);
  EXPECT_NEAR(light_intensity(s->lights[0]).z, 0.25f, 1e-5f);
  EXPECT_EQ(s->lights[1].type, LightType::spot);
  EXPECT_NEAR(s->lights[1].outer_degrees, 28.6479f, 1e-3f);
  EXPECT_NEAR(light_intensity(s->lights[2]).x, 2, 1e-5f);
  EXPECT_EQ(light_frame(s->lights[2]).n, vec3(0, 0, -1));
}

TEST(GltfImport, AreaLightsAndAmbientComeFromExtras) {
  GlbBuilder b;
  b.add(box(vec3(2)));
  const float h = std::sqrt(0.5f);
  // -Z turned to -Y; X stays.
  b.node(Json{
      {"translation", {0, 3, 0}},
      {"rotation", {-h, 0, 0, h}},
      {"scale", {2, 2, 2}},
      {"extras",
       {{"vamp_light",
         {{"type", "rect"}, {"width", 1}, {"height", 0.5}, {"power", 40}, {"color", {1, 1, 0.5}}, {"name", "key"}}}}}});
  b.json()["scenes"][0]["extras"] = {{"vamp_ambient", {0.1, 0.2, 0.3}}, {"vamp_ao_radius", 0.5}};
  const auto s = loaded(b);
  ASSERT_EQ(s->lights.size(), 1u);
  const Light& light = s->lights[0];
  EXPECT_EQ(light.name, "key");
  EXPECT_EQ(light.type, LightType::rect);
  EXPECT_NEAR(light.size.x, 2, 1e-5f);
  EXPECT_NEAR(light.size.y, 1, 1e-5f);
  const LightFrame frame = light_frame(light);
  EXPECT_NEAR(glm::length(frame.n - vec3(0, -1, 0)), 0, 1e-5f);
  EXPECT_NEAR(glm::length(frame.u - vec3(1, 0, 0)), 0, 1e-5f);
  EXPECT_EQ(s->ambient, vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(s->ao_radius, 0.5f);
}

TEST(GltfImport, ExtensionsOfMaterialsAreReadOrNoted) {
  GlbBuilder b;
  const int m = b.material("fabric");
  b.json()["materials"][0]["extensions"] = {
      {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0}}}},
      {"KHR_materials_ior", {{"ior", 1.4}}},
      {"KHR_materials_sheen", Json::object()}};
  b.json()["materials"][0]["alphaMode"] = "MASK";
  b.json()["materials"][0]["alphaCutoff"] = 0.25;
  b.json()["materials"][0]["doubleSided"] = true;
  b.add(plane(1, 1), m);
  const auto s = loaded(b);
  const SurfaceMaterial& material = s->parts[0].material;
  EXPECT_FLOAT_EQ(material.specular, 0.5f);
  EXPECT_EQ(material.specular_color, vec3(1, 0.5f, 0));
  EXPECT_FLOAT_EQ(material.ior, 1.4f);
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_FLOAT_EQ(material.alpha_cutoff, 0.25f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_THAT(s->notes, Contains(HasSubstr("KHR_materials_sheen is left out")));
}

TEST(GltfImport, WhatIsReadButNotShownIsNoted) {
  const test::TempFolder folder;
  GlbBuilder b;
  b.add(plane(1, 1), b.material("lamp"));
  Json& material = b.json()["materials"][0];
  material["emissiveFactor"] = {1, 0.5, 0};
  material["alphaMode"] = "BLEND";
  material["normalTexture"] = {{"index", 0}};
  b.json()["textures"] = Json::array({Json{{"source", 0}}});
  b.json()["images"] = Json::array({Json{{"uri", "bumps.png"}}});
  ASSERT_TRUE(save_png(folder / "bumps.png", Image(2, 2, {"R", "G", "B"})));
  b.write(folder / "lamp.glb");
  const auto scene = load_scene(folder / "lamp.glb");
  ASSERT_TRUE(scene) << scene.error().message();
  for (const char* what : {"emission", "blended alpha", "normal map"})
    EXPECT_THAT((*scene)->notes, Contains(HasSubstr(what))) << what;
}

TEST(GltfImport, ACancelledLoadIsInterrupted) {
  const test::TempFolder folder;
  GlbBuilder b;
  b.add(box(vec3(1)));
  b.write(folder / "model.glb");
  Progress progress;
  progress.cancel();
  const auto scene = load_scene(folder / "model.glb", &progress);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().kind, ErrorKind::interrupted);
}

TEST(GltfImport, AMillionTrianglesLoad) {
  GlbBuilder b;
  b.add(plane(1, 1, 708));
  const auto s = loaded(b);
  EXPECT_EQ(s->triangles.size(), 708u * 708 * 2);
  EXPECT_NEAR(area(*s), 1, 1e-3);
}

}  // namespace
}  // namespace vamp
