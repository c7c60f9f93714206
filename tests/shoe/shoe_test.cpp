// The default scene as committed: is it a whole shoe, measured in mm, and what the generator makes?
#include "tools/shoe/shoe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <numbers>

#include "engine/core/files.h"
#include "engine/core/json.h"

namespace vamp::shoe {
namespace {

constexpr const char* kScene = "scenes/derby.glb";
constexpr uint64_t kLimit = 8u << 20;  // the repository's limit for the default scene

// The file as glTF's specification lays it out, read without the generator's help.
struct Glb {
  Json json;
  std::vector<std::byte> bytes, binary;
  std::map<std::string, Mesh> parts;  // metres and UV as stored
};

template <class T>
std::vector<T> values_of(const Glb& glb, const Json& index, size_t components) {
  const Json& accessor = glb.json["accessors"][index.get<size_t>()];
  const Json& view = glb.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  std::vector<T> values(accessor["count"].get<size_t>() * components);
  EXPECT_EQ(view["byteLength"].get<size_t>(), values.size() * sizeof(T));
  EXPECT_LE(view["byteOffset"].get<size_t>() + values.size() * sizeof(T), glb.binary.size());
  std::memcpy(values.data(), glb.binary.data() + view["byteOffset"].get<size_t>(), values.size() * sizeof(T));
  return values;
}

Mesh mesh_of(const Glb& glb, const Json& primitive) {
  Mesh mesh;
  const Json& attributes = primitive["attributes"];
  const auto p = values_of<float>(glb, attributes["POSITION"], 3);
  const auto n = values_of<float>(glb, attributes["NORMAL"], 3);
  const auto t = values_of<float>(glb, attributes["TEXCOORD_0"], 2);
  for (size_t i = 0; i < p.size() / 3; ++i) {
    mesh.positions.emplace_back(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    mesh.normals.emplace_back(n[3 * i], n[3 * i + 1], n[3 * i + 2]);
    mesh.uvs.emplace_back(t[2 * i], t[2 * i + 1]);
  }
  if (glb.json["accessors"][primitive["indices"].get<size_t>()]["componentType"] == 5123) {
    const auto small = values_of<uint16_t>(glb, primitive["indices"], 1);
    mesh.indices.assign(small.begin(), small.end());
  } else {
    mesh.indices = values_of<uint32_t>(glb, primitive["indices"], 1);
  }
  return mesh;
}

uint32_t word(const std::vector<std::byte>& bytes, size_t at) {
  uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

Glb read_scene() {
  Glb glb;
  auto bytes = read_file(kScene, kLimit);
  if (!bytes) {
    ADD_FAILURE() << bytes.error().message();
    return glb;
  }
  glb.bytes = std::move(*bytes);
  const size_t json_size = word(glb.bytes, 12);
  const auto* text = reinterpret_cast<const char*>(glb.bytes.data() + 20);
  auto json = parse_json({text, json_size}, kScene);
  if (!json) {
    ADD_FAILURE() << json.error().message();
    return glb;
  }
  glb.json = std::move(*json);
  glb.binary.assign(glb.bytes.begin() + std::ptrdiff_t(20 + json_size + 8), glb.bytes.end());
  for (const Json& mesh : glb.json["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      const std::string name = glb.json["materials"][primitive["material"].get<size_t>()]["name"];
      glb.parts[name].append(mesh_of(glb, primitive));
    }
  }
  return glb;
}

const Glb& scene() {
  static const Glb glb = read_scene();
  return glb;
}

bool is_floor(const std::string& name) { return name == "Studio floor"; }

struct Triangle {
  Vec3 a, b, c;
  Vec2 ua, ub, uc;
  double area() const { return 0.5 * glm::length(glm::cross(b - a, c - a)); }
  double uv_area() const { return 0.5 * ((ub.x - ua.x) * (uc.y - ua.y) - (ub.y - ua.y) * (uc.x - ua.x)); }
};

std::vector<Triangle> triangles_of(const Mesh& m) {
  std::vector<Triangle> list;
  for (size_t t = 0; t < m.indices.size(); t += 3) {
    const uint32_t i = m.indices[t], j = m.indices[t + 1], k = m.indices[t + 2];
    list.push_back({m.positions[i], m.positions[j], m.positions[k], m.uvs[i], m.uvs[j], m.uvs[k]});
  }
  return list;
}

// The share of a part's area for which `holds` says yes.
double area_share(const Mesh& mesh, const std::function<bool(const Triangle&)>& holds) {
  double all = 0.0, good = 0.0;
  for (const Triangle& t : triangles_of(mesh)) {
    all += t.area();
    if (holds(t)) good += t.area();
  }
  return good / all;
}

TEST(DefaultScene, IsWhatTheGeneratorMakes) {
  EXPECT_TRUE(to_glb(make_shoe_scene()) == scene().bytes) << "run make_shoe " << kScene;
}

TEST(DefaultScene, HasThePartsOfADerby) {
  std::vector<std::string> names;
  for (const auto& [name, mesh] : scene().parts) names.push_back(name);
  EXPECT_THAT(names,
              testing::UnorderedElementsAre("Vamp", "Toe cap", "Quarter", "Heel counter", "Tongue", "Collar", "Lining",
                                            "Insole", "Pull tab", "Eyelets", "Laces", "Lace tips", "Stitching", "Welt",
                                            "Midsole", "Outsole", "Heel block", "Top piece", "Studio floor"));
}

TEST(DefaultScene, IsOfTheTriangleClassItClaims) {
  size_t triangles = 0;
  for (const auto& [name, mesh] : scene().parts) triangles += is_floor(name) ? 0 : mesh.triangles();
  EXPECT_GE(triangles, 50'000u);
  EXPECT_LE(triangles, 250'000u);
}

TEST(DefaultScene, IsAsLongAsAShoeAndStandsOnTheFloor) {
  Vec3 low(1e9), high(-1e9);
  for (const auto& [name, mesh] : scene().parts) {
    if (is_floor(name)) continue;
    for (const Vec3& p : mesh.positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  EXPECT_NEAR(high.x - low.x, 0.300, 0.006);
  EXPECT_NEAR(high.z - low.z, 0.108, 0.006);
  EXPECT_NEAR(high.y, 0.135, 0.015);
  EXPECT_GE(low.y, 0.0);
  EXPECT_LE(low.y, 0.0005);
}

TEST(DefaultScene, IndicesStayInRangeAndTrianglesHaveArea) {
  for (const auto& [name, mesh] : scene().parts) {
    EXPECT_LT(*std::max_element(mesh.indices.begin(), mesh.indices.end()), mesh.positions.size()) << name;
    for (const Triangle& t : triangles_of(mesh)) ASSERT_GT(t.area(), 0.0) << name;
  }
}

TEST(DefaultScene, NormalsAreUnitAndPointOutOfTheirFaces) {
  for (const auto& [name, mesh] : scene().parts) {
    for (const Vec3& n : mesh.normals) ASSERT_NEAR(glm::length(n), 1.0, 1e-6) << name;
    double all = 0.0, good = 0.0;
    for (size_t t = 0; t < mesh.indices.size(); t += 3) {
      const Vec3& a = mesh.positions[mesh.indices[t]];
      const Vec3 face = glm::cross(mesh.positions[mesh.indices[t + 1]] - a, mesh.positions[mesh.indices[t + 2]] - a);
      const double size = glm::length(face);
      double least = 1.0;
      for (size_t k = 0; k < 3; ++k) least = std::min(least, glm::dot(face, mesh.normals[mesh.indices[t + k]]) / size);
      all += size;
      if (least > 0.5) good += size;
    }
    EXPECT_GT(good / all, 0.995) << name;
  }
}

// Small turned and tied parts are too short for a pattern to show; the rest has to carry a material evenly.
bool is_small(const std::string& name) { return name == "Eyelets" || name == "Lace tips" || name == "Stitching"; }

TEST(DefaultScene, AUvUnitIsAHundredMillimetresInEveryPart) {
  for (const auto& [name, mesh] : scene().parts) {
    double area = 0.0, uv_area = 0.0;
    for (const Triangle& t : triangles_of(mesh)) {
      area += t.area();
      uv_area += std::abs(t.uv_area());
    }
    EXPECT_NEAR(kMmPerUnit * std::sqrt(area / uv_area), kMmPerUv, 0.001 * kMmPerUv) << name;
    const auto near = [](const Triangle& t) {
      const double stretch = kMmPerUv / kMmPerUnit * std::sqrt(std::abs(t.uv_area()) / t.area());
      return stretch > 1 / 1.2 && stretch < 1.2;
    };
    EXPECT_GT(area_share(mesh, near), is_small(name) ? 0.85 : 0.95) << name;
  }
}

TEST(DefaultScene, UvsAreNeitherMirroredNorDegenerate) {
  for (const auto& [name, mesh] : scene().parts) {
    EXPECT_GT(area_share(mesh, [](const Triangle& t) { return t.uv_area() > 0; }), 0.9999) << name;
  }
}

// Rows of a node's rotation: its local axes in the scene.
struct Node {
  Vec3 at, x, y, z;
};

Node node_named(const std::string& name) {
  for (const Json& node : scene().json["nodes"]) {
    if (node["name"] != name) continue;
    const auto t = node["translation"].get<std::vector<double>>();
    const auto q = node["rotation"].get<std::vector<double>>();
    const Vec3 v(q[0], q[1], q[2]);
    const auto turn = [&](const Vec3& p) { return p + 2.0 * glm::cross(v, glm::cross(v, p) + q[3] * p); };
    return {{t[0], t[1], t[2]}, turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1})};
  }
  ADD_FAILURE() << "no node " << name;
  return {};
}

TEST(DefaultScene, TheCameraShowsTheWholeShoeOverMostOfThePicturesWidth) {
  const Node camera = node_named("Camera");
  const Json& lens = scene().json["cameras"][0]["perspective"];
  const double tangent = std::tan(0.5 * lens["yfov"].get<double>());
  const double aspect = lens["aspectRatio"].get<double>();
  Vec2 low(1e9), high(-1e9);
  for (const auto& [name, mesh] : scene().parts) {
    if (is_floor(name)) continue;
    for (const Vec3& p : mesh.positions) {
      const Vec3 d = p - camera.at;
      const double depth = -glm::dot(d, camera.z);
      const Vec2 seen = Vec2(glm::dot(d, camera.x) / aspect, glm::dot(d, camera.y)) / (depth * tangent);
      low = glm::min(low, seen);
      high = glm::max(high, seen);
    }
  }
  EXPECT_NEAR(0.5 * (high.x - low.x), 0.78, 0.04);
  EXPECT_GT(std::min({low.x, low.y, -high.x, -high.y}), -0.95);
}

// Irradiance by a midpoint sum over each rectangle; radiance = power / (pi area).
TEST(DefaultScene, TheFloorIsMidGreyUnderKeyAndFill) {
  double irradiance = 0.0;
  int lights = 0;
  for (const Json& json : scene().json["nodes"]) {
    if (!json.contains("extras")) continue;
    const Json& light = json["extras"]["vamp_light"];
    EXPECT_EQ(light["type"], "rect");
    const Node node = node_named(json["name"].get<std::string>());
    const double width = light["width"].get<double>(), height = light["height"].get<double>();
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps * kSteps; ++i) {
      const double u = (i % kSteps + 0.5) / kSteps - 0.5, v = (i / kSteps + 0.5) / kSteps - 0.5;
      const Vec3 to = node.at + u * width * node.x + v * height * node.y;
      const double square = glm::dot(to, to);
      const double cosines = to.y * glm::dot(to, node.z) / square;
      EXPECT_GT(cosines, 0.0) << "shines away from the shoe";
      irradiance += light["power"].get<double>() / std::numbers::pi * cosines / square / (kSteps * kSteps);
    }
    ++lights;
  }
  EXPECT_EQ(lights, 2);
  const Json& materials = scene().json["materials"];
  const auto floor =
      std::find_if(materials.begin(), materials.end(), [](const Json& m) { return is_floor(m["name"]); });
  ASSERT_NE(floor, materials.end());
  const double albedo = (*floor)["pbrMetallicRoughness"]["baseColorFactor"][0].get<double>();
  const Json& extras = scene().json["scenes"][0]["extras"];
  const double radiance = albedo * (irradiance / std::numbers::pi + extras["vamp_ambient"][0].get<double>());
  EXPECT_GT(radiance, 0.2);
  EXPECT_LT(radiance, 0.4);
  EXPECT_GT(extras["vamp_ao_radius"].get<double>(), 0.0);
}

}  // namespace
}  // namespace vamp::shoe
