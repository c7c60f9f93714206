// Damaged and hostile models: one clear line with the place, never a crash, never a file outside the folder.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/scene/load_glb.h"

namespace vamp {
namespace {

using test::GlbBuilder;
using testing::HasSubstr;

GlbBuilder good() {
  GlbBuilder b;
  b.add(test::box(vec3(1)), b.material("leather"));
  return b;
}

// The error of a model made wrong by `spoil`; its message has one line and names the file.
std::string refusal_of(const std::function<void(GlbBuilder&)>& spoil, const std::string& name = "model.glb") {
  GlbBuilder b = good();
  spoil(b);
  const auto scene = test::load(b, name);
  if (scene) return "(loaded)";
  EXPECT_EQ(scene.error().kind, ErrorKind::bad_input);
  const std::string message = scene.error().message();
  EXPECT_THAT(message, HasSubstr(name));
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message;
}

std::string refusal_of_bytes(std::span<const std::byte> bytes, const std::string& name = "model.glb") {
  const test::TempFolder folder;
  EXPECT_TRUE(write_file_atomically(folder / name, bytes));
  const auto scene = load_scene(folder / name);
  return scene ? "(loaded)" : scene.error().message();
}

std::string refusal_of_text(const std::string& text, const std::string& name = "model.gltf") {
  return refusal_of_bytes(std::as_bytes(std::span(text)), name);
}

TEST(HostileGltf, MissingFileFolderAndEmptyFileAreRefused) {
  const auto missing = load_scene("/nonexistent/shoe.glb");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::bad_input);
  const auto folder = load_scene("/tmp");
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().message(), HasSubstr("folder"));
  EXPECT_THAT(refusal_of_text(""), HasSubstr("a glTF model"));
  EXPECT_THAT(refusal_of_text("\x89PNG\r\n"), HasSubstr("a glTF model"));
}

TEST(HostileGltf, EveryTruncationOfAGlbIsRefused) {
  const std::vector<std::byte> whole = good().glb();
  const test::TempFolder folder;
  for (size_t size = 0; size < whole.size(); size += size < 64 ? 1 : 37) {
    ASSERT_TRUE(write_file_atomically(folder / "cut.glb", std::span(whole).first(size)));
    const auto scene = load_scene(folder / "cut.glb");
    ASSERT_FALSE(scene) << size;
    ASSERT_EQ(scene.error().kind, ErrorKind::bad_input) << size;
  }
}

TEST(HostileGltf, FlippedBytesNeverCrash) {
  const std::vector<std::byte> whole = good().glb();
  const test::TempFolder folder;
  uint32_t state = 1;
  for (int i = 0; i < 400; ++i) {
    std::vector<std::byte> bytes = whole;
    for (int k = 0; k < 3; ++k) {
      state = state * 1664525u + 1013904223u;
      bytes[(state >> 8) % bytes.size()] = static_cast<std::byte>(state >> 24);
    }
    ASSERT_TRUE(write_file_atomically(folder / "bits.glb", bytes));
    const auto scene = load_scene(folder / "bits.glb");
    if (!scene) continue;
    for (const vec3& p : (*scene)->positions) {
      ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
    }
  }
}

TEST(HostileGltf, GlbChunksMustFitTheFile) {
  std::vector<std::byte> bytes = good().glb();
  bytes[12] = bytes[13] = bytes[14] = bytes[15] = std::byte{0xff};
  EXPECT_THAT(refusal_of_bytes(bytes), HasSubstr("chunk at byte 12"));
  bytes = good().glb();
  bytes[4] = std::byte{1};
  EXPECT_THAT(refusal_of_bytes(bytes), HasSubstr("version 2"));
}

TEST(HostileGltf, AHundredThousandNestedExtrasAreRefused) {
  const std::string deep(100000, '[');
  EXPECT_THAT(refusal_of_text(R"({"asset":{"version":"2.0"},"extras":)" + deep + std::string(100000, ']') + "}"),
              HasSubstr("nesting"));
}

TEST(HostileGltf, OtherVersionsAreRefused) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["asset"]["version"] = "1.0"; }), HasSubstr("asset.version"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json().erase("asset"); }), HasSubstr("asset"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["asset"]["minVersion"] = "2.1"; }), HasSubstr("minVersion"));
}

TEST(HostileGltf, UnknownRequiredExtensionsAreNamed) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
              HasSubstr("KHR_draco_mesh_compression"));
}

TEST(HostileGltf, PathsThatLeaveTheFolderAreRefused) {
  for (const char* uri :
       {"../secret.bin", "/etc/passwd", "file:///etc/passwd", "http://example.com/a.bin", "..%2Fsecret.bin",
        "%2e%2e/secret.bin", ".", "", "a\\..\\b", "a%00b", "%zz", "data:text/plain,abc"}) {
    const std::string message =
        refusal_of_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":")" +
                        (std::string(uri) == "a\\..\\b" ? std::string("a\\\\..\\\\b") : std::string(uri)) + "\"}]}");
    EXPECT_THAT(message, HasSubstr("buffers[0]")) << uri;
  }
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
                b.json()["textures"] = Json::array({Json{{"source", 0}}});
                b.json()["images"] = Json::array({Json{{"uri", "../../etc/passwd"}}});
              }),
              HasSubstr("images[0].uri"));
}

TEST(HostileGltf, ALinkOutOfTheFolderIsRefused) {
  const test::TempFolder folder;
  fs::create_symlink("/etc/passwd", folder / "mesh.bin");
  ASSERT_TRUE(write_text_atomically(folder / "m.gltf",
                                    R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"mesh.bin"}]})"));
  const auto scene = load_scene(folder / "m.gltf");
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("inside"));
}

TEST(HostileGltf, MissingAndShortBuffersAreRefused) {
  EXPECT_THAT(refusal_of_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"none.bin"}]})"),
              HasSubstr("an existing file"));
  EXPECT_THAT(refusal_of_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":5,"uri":"data:x;base64,AAAA"}]})"),
              HasSubstr("byteLength"));
  EXPECT_THAT(refusal_of_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":5}]})"), HasSubstr("buffers[0]"));
}

TEST(HostileGltf, BufferViewsMustLieInTheirBuffer) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["bufferViews"][0]["byteLength"] = 9999999; }),
              HasSubstr("bufferViews[0].byteLength"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["bufferViews"][0]["byteOffset"] = -4; }),
              HasSubstr("bufferViews[0].byteOffset"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["bufferViews"][0]["byteOffset"] = 18446744073709551615u; }),
              HasSubstr("bufferViews[0].byteOffset"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["bufferViews"][0]["buffer"] = 777; }),
              HasSubstr("bufferViews[0].buffer"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["bufferViews"][0]["byteStride"] = 6; }),
              HasSubstr("multiple of 4"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["bufferViews"][0]["byteStride"] = 4; }), HasSubstr("stride"));
}

TEST(HostileGltf, AccessorsMustLieInTheirView) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][0]["count"] = 4294967295u; }),
              HasSubstr("accessors[0].count"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][0]["count"] = 25; }), HasSubstr("accessors[0]"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][0]["byteOffset"] = 12; }),
              HasSubstr("accessors[0]"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][0]["bufferView"] = 99; }),
              HasSubstr("accessors[0].bufferView"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][0]["componentType"] = 5124; }),
              HasSubstr("componentType"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][0]["type"] = "VEC5"; }), HasSubstr("VEC5"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["accessors"][0].erase("bufferView");
                b.json()["accessors"][0]["count"] = 90000000;
              }),
              HasSubstr("zeros"));
}

TEST(HostileGltf, SparseAccessorsAreCheckedToo) {
  const auto sparse = [](uint32_t place, int count) {
    return refusal_of([=](GlbBuilder& b) {
      const std::vector<uint32_t> where = {place, place};
      const std::vector<vec3> what(2, vec3(0));
      const int places = b.view(std::as_bytes(std::span(where)));
      const int values = b.view(std::as_bytes(std::span(what)));
      b.json()["accessors"][0]["sparse"] = {{"count", count},
                                            {"indices", {{"bufferView", places}, {"componentType", 5125}}},
                                            {"values", {{"bufferView", values}}}};
    });
  };
  EXPECT_THAT(sparse(24, 1), HasSubstr("sparse"));
  EXPECT_THAT(sparse(3, 2), HasSubstr("rising"));
  EXPECT_THAT(sparse(3, 3), HasSubstr("sparse"));
}

TEST(HostileGltf, IndicesBeyondTheVerticesAreRefused) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                const std::vector<uint32_t> indices = {0, 1, 24};
                b.json()["meshes"][0]["primitives"][0]["indices"] = b.accessor_of(indices, 5125, "SCALAR");
              }),
              HasSubstr("an index below 24"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["meshes"][0]["primitives"][0]["indices"] = 0; }),
              HasSubstr("indices"));
}

TEST(HostileGltf, NumbersThatAreNotFiniteAreNamedWithTheirPlace) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    GlbBuilder b;
    test::Shape s = test::box(vec3(1));
    s.positions[5].y = bad;
    b.add(s);
    const auto scene = test::load(b);
    ASSERT_FALSE(scene);
    EXPECT_THAT(scene.error().message(), HasSubstr("element 5"));
  }
  GlbBuilder b;
  test::Shape s = test::box(vec3(1));
  s.uvs[2].x = std::numeric_limits<float>::quiet_NaN();
  b.add(s);
  EXPECT_FALSE(test::load(b));
}

TEST(HostileGltf, AttributesOfTheWrongKindAreRefused) {
  const auto with = [](const char* name, int accessor) {
    return refusal_of([=](GlbBuilder& b) { b.json()["meshes"][0]["primitives"][0]["attributes"][name] = accessor; });
  };
  EXPECT_THAT(with("TEXCOORD_0", 0), HasSubstr("VEC2"));
  EXPECT_THAT(with("NORMAL", 2), HasSubstr("VEC3"));
  EXPECT_THAT(with("POSITION", 1000), HasSubstr("POSITION"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["accessors"][1]["count"] = 12; }), HasSubstr("24 elements"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["meshes"][0]["primitives"][0]["mode"] = 7; }), HasSubstr("mode"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["meshes"][0]["primitives"][0]["material"] = 5; }),
              HasSubstr("material"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["meshes"][0]["primitives"] = Json::array(); }),
              HasSubstr("primitive"));
}

TEST(HostileGltf, NodeGraphsMustBeForests) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["nodes"][0]["children"] = {0}; }), HasSubstr("the node itself"));
  EXPECT_THAT(
      refusal_of([](GlbBuilder& b) {
        b.json()["nodes"] = Json::array({Json{{"children", {1}}}, Json{{"children", {2}}}, Json{{"children", {1}}}});
      }),
      HasSubstr("one parent"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["nodes"] = Json::array({Json{{"mesh", 0}}, Json{{"children", {2}}}, Json{{"children", {1}}}});
              }),
              HasSubstr("loop"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["nodes"] = Json::array();
                for (int i = 0; i < 400; ++i) b.json()["nodes"].push_back(Json{{"children", {i + 1}}});
                b.json()["nodes"].push_back(Json{{"mesh", 0}});
              }),
              HasSubstr("256 deep"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["nodes"][0]["mesh"] = 777; }), HasSubstr("nodes[0].mesh"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["scenes"][0]["nodes"] = {-5}; }), HasSubstr("scenes[0]"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["scenes"][0]["nodes"] = {0, 0}; }), HasSubstr("once"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["scene"] = -5; }), HasSubstr("scene"));
}

TEST(HostileGltf, TransformsAreCheckedForKindAndRange) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) { b.json()["nodes"][0]["scale"] = {1, 2}; }), HasSubstr("3 numbers"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["nodes"][0]["translation"] = {1, 2, "x"};
              }),
              HasSubstr("translation"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["nodes"][0]["translation"] = {1e20, 0, 0};
              }),
              HasSubstr("coordinates up to"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["nodes"][0]["translation"] = {1, 2, 3};
                b.json()["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
              }),
              HasSubstr("both"));
}

TEST(HostileGltf, ASmallFileCannotUnfoldIntoBillionsOfTriangles) {
  GlbBuilder b;
  const int mesh = b.mesh(test::plane(1, 1, 200));  // 80,000 triangles
  for (int i = 0; i < 1000; ++i) b.json()["nodes"].push_back(Json{{"mesh", mesh}});
  // Indices of one accessor used by many primitives of one mesh count as often.
  for (int i = 0; i < 1000; ++i) b.json()["meshes"][0]["primitives"].push_back(b.json()["meshes"][0]["primitives"][0]);
  b.json()["scenes"] = Json::array();
  b.json().erase("scene");
  // Keep what the test itself needs small: the limit is met within the first node.
  b.json()["meshes"][0]["primitives"][0] = b.json()["meshes"][0]["primitives"][1];
  const auto scene = test::load(b);
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message(), HasSubstr("at most 30000000 triangles"));
}

TEST(HostileGltf, AModelWithoutTrianglesIsRefused) {
  EXPECT_THAT(refusal_of_text(R"({"asset":{"version":"2.0"}})"), HasSubstr("a model with triangles"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["nodes"][0]["scale"] = {0, 0, 0};
              }),
              HasSubstr("a model with triangles"));
}

TEST(HostileGltf, DamagedImagesNameTheImage) {
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                const std::vector<uint32_t> junk = {1, 2, 3, 4};
                b.json()["images"] = Json::array(
                    {Json{{"bufferView", b.view(std::as_bytes(std::span(junk)))}, {"mimeType", "image/png"}}});
                b.json()["textures"] = Json::array({Json{{"source", 0}}});
                b.json()["materials"][0]["normalTexture"] = {{"index", 0}};
              }),
              HasSubstr("images[0]"));
  EXPECT_THAT(refusal_of([](GlbBuilder& b) {
                b.json()["materials"][0]["normalTexture"] = {{"index", 3}};
              }),
              HasSubstr("normalTexture"));
}

TEST(HostileGltf, LightsOfOursMustMakeSense) {
  const auto light = [](Json json) {
    return refusal_of([&](GlbBuilder& b) { b.json()["nodes"][0]["extras"]["vamp_light"] = json; });
  };
  EXPECT_THAT(light({{"type", "laser"}}), HasSubstr("rect, disk, sphere or point"));
  EXPECT_THAT(light({{"type", "rect"}, {"width", -1}}), HasSubstr("width"));
  EXPECT_THAT(light({{"type", "rect"}, {"color", {1, 2}}}), HasSubstr("3 numbers"));
  EXPECT_THAT(light({{"type", "rect"}, {"power", "strong"}}), HasSubstr("power"));
  EXPECT_THAT(light(Json::object()), HasSubstr("type"));
}

}  // namespace
}  // namespace vamp
