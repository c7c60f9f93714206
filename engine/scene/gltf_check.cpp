#include "engine/scene/gltf_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "engine/scene/gltf_file.h"

namespace vamp {
namespace {

constexpr size_t kMaxObjects = 1000000;  // of one kind
constexpr int64_t kMaxElements = 100000000;
constexpr int64_t kMaxZeroElements = 1000000;  // of an accessor without bytes behind it
constexpr float kHuge = 1e30f;
constexpr int kMaxNodeDepth = 256;

// Extensions that a file may require: what they say is used, or leaving it out does no harm.
constexpr std::array<std::string_view, 16> kKnownExtensions = {"KHR_texture_transform",
                                                               "KHR_mesh_quantization",
                                                               "KHR_lights_punctual",
                                                               "KHR_materials_specular",
                                                               "KHR_materials_ior",
                                                               "KHR_materials_variants",
                                                               "KHR_materials_clearcoat",
                                                               "KHR_materials_sheen",
                                                               "KHR_materials_transmission",
                                                               "KHR_materials_volume",
                                                               "KHR_materials_emissive_strength",
                                                               "KHR_materials_anisotropy",
                                                               "KHR_materials_iridescence",
                                                               "KHR_materials_unlit",
                                                               "KHR_xmp_json_ld",
                                                               "MSFT_lod"};

int64_t component_bytes(int64_t type) {
  switch (type) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

const std::map<std::string, int64_t> kTypes = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                               {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};

struct View {
  int64_t length = 0;
  int64_t stride = 0;
};
struct Accessor {
  int64_t count = 0, component = 0;
  std::string type;
  bool normalized = false;
};

class Checker {
 public:
  explicit Checker(const GltfFile& gltf) : gltf_(gltf), root_(gltf.json, gltf.file) {}

  Status run() {
    // In the order of the references, so that each step may trust the one before; the first error ends the check.
    using Step = void (Checker::*)();
    for (const Step step :
         {&Checker::extensions, &Checker::views, &Checker::accessors, &Checker::images, &Checker::materials,
          &Checker::meshes, &Checker::cameras, &Checker::lights, &Checker::nodes, &Checker::scenes}) {
      (this->*step)();
      VAMP_CHECK_STATUS(root_.status());
    }
    return {};
  }

 private:
  // Calls each(reader, index) for every element of the member array `key`, while nothing is wrong.
  template <class Each>
  size_t each(const JsonReader& parent, std::string_view key, Each each_element) {
    if (!parent.has(key)) return 0;
    const JsonReader array = parent.member(key);
    const size_t count = array.size(kMaxObjects);
    for (size_t i = 0; i < count && root_.status(); ++i) each_element(array.element(i), i);
    return count;
  }
  static int64_t integer_or(const JsonReader& parent, std::string_view key, int64_t otherwise, int64_t low,
                            int64_t high) {
    return parent.has(key) ? parent.member(key).integer(low, high) : otherwise;
  }
  static void number_if(const JsonReader& parent, std::string_view key, float low, float high) {
    if (parent.has(key)) parent.member(key).number(low, high);
  }
  static void numbers_if(const JsonReader& parent, std::string_view key, size_t count, float low, float high) {
    if (!parent.has(key)) return;
    const JsonReader array = parent.member(key);
    if (const size_t found = array.size(16); found != count) {
      array.refuse(fmt::format("{} numbers", count), std::to_string(found));
      return;
    }
    for (size_t i = 0; i < count; ++i) array.element(i).number(low, high);
  }
  // An index below `count`; -1 when the member is missing.
  static int64_t index_if(const JsonReader& parent, std::string_view key, size_t count) {
    if (!parent.has(key)) return -1;
    if (count == 0) {
      parent.member(key).refuse("no index, for there is nothing to point at", "an index");
      return -1;
    }
    return parent.member(key).integer(0, static_cast<int64_t>(count) - 1);
  }

  void extensions() {
    each(root_, "extensionsRequired", [](const JsonReader& name, size_t) {
      const std::string text = name.text(256);
      if (std::find(kKnownExtensions.begin(), kKnownExtensions.end(), text) == kKnownExtensions.end())
        name.refuse("an extension that this program knows; export without it", text);
    });
  }

  void views() {
    each(root_, "bufferViews", [&](const JsonReader& view, size_t) {
      const int64_t buffer = view.has("buffer") ? index_if(view, "buffer", gltf_.buffers.size()) : -1;
      if (buffer < 0) {
        view.refuse("a buffer", "none");
        return;
      }
      const auto size = static_cast<int64_t>(gltf_.buffers[static_cast<size_t>(buffer)].size());
      const int64_t offset = integer_or(view, "byteOffset", 0, 0, size);
      const int64_t length = view.member("byteLength").integer(1, size - offset);
      const int64_t stride = integer_or(view, "byteStride", 0, 4, 252);
      if (stride % 4 != 0) view.member("byteStride").refuse("a multiple of 4", std::to_string(stride));
      views_.push_back({length, stride});
    });
  }

  // `count` elements of `bytes` each, from byteOffset on, must lie in the view. Reads bufferView and byteOffset.
  void check_run(const JsonReader& place, int64_t count, int64_t bytes, bool may_stride) {
    const int64_t number = index_if(place, "bufferView", views_.size());
    if (number < 0) return;
    const View& view = views_[static_cast<size_t>(number)];
    const int64_t offset = integer_or(place, "byteOffset", 0, 0, view.length);
    const int64_t stride = may_stride && view.stride > 0 ? view.stride : bytes;
    if (stride < bytes) place.refuse(fmt::format("a stride of at least {} bytes", bytes), std::to_string(stride));
    const int64_t end = offset + stride * (count - 1) + bytes;  // below 2^37, see kMaxElements
    if (end > view.length)
      place.refuse(fmt::format("elements inside the {} bytes of its buffer view", view.length),
                   fmt::format("{} elements up to byte {}", count, end));
  }

  void accessors() {
    each(root_, "accessors", [&](const JsonReader& accessor, size_t) {
      Accessor a;
      a.component = accessor.member("componentType").integer(5120, 5126);
      a.count = accessor.member("count").integer(1, kMaxElements);
      a.type = accessor.member("type").text(16);
      a.normalized = accessor.has("normalized") && accessor.member("normalized").boolean();
      const auto type = kTypes.find(a.type);
      if (component_bytes(a.component) == 0)
        accessor.member("componentType").refuse("5120, 5121, 5122, 5123, 5125 or 5126", std::to_string(a.component));
      if (type == kTypes.end()) accessor.member("type").refuse("SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4", a.type);
      if (!root_.status()) return;
      const int64_t bytes = component_bytes(a.component) * type->second;
      if (accessor.has("bufferView"))
        check_run(accessor, a.count, bytes, true);
      else if (a.count > kMaxZeroElements)
        accessor.refuse(fmt::format("a buffer view, or at most {} zeros", kMaxZeroElements), std::to_string(a.count));
      if (accessor.has("sparse")) sparse(accessor.member("sparse"), a.count, bytes);
      accessors_.push_back(a);
    });
  }

  void sparse(const JsonReader& part, int64_t accessor_count, int64_t bytes) {
    const int64_t count = part.member("count").integer(1, accessor_count);
    const JsonReader indices = part.member("indices");
    const int64_t component = indices.member("componentType").integer(5121, 5125);
    if (component != 5121 && component != 5123 && component != 5125)
      indices.member("componentType").refuse("5121, 5123 or 5125", std::to_string(component));
    for (const auto& place : {indices, part.member("values")})
      if (!place.has("bufferView")) place.refuse("a buffer view", "none");
    if (!root_.status()) return;
    check_run(indices, count, component_bytes(component), false);
    check_run(part.member("values"), count, bytes, false);
  }

  void images() {
    images_ = each(root_, "images", [&](const JsonReader& image, size_t) {
      if (image.has("uri") == image.has("bufferView")) image.refuse("either a uri or a buffer view", "both or neither");
      index_if(image, "bufferView", views_.size());
    });
    samplers_ = each(root_, "samplers", [](const JsonReader& sampler, size_t) {
      for (const char* key : {"wrapS", "wrapT"}) {
        const int64_t wrap = integer_or(sampler, key, 10497, 0, 65535);
        if (wrap != 10497 && wrap != 33071 && wrap != 33648)
          sampler.member(key).refuse("10497, 33071 or 33648", std::to_string(wrap));
      }
    });
    textures_ = each(root_, "textures", [&](const JsonReader& texture, size_t) {
      index_if(texture, "source", images_);
      index_if(texture, "sampler", samplers_);
    });
  }

  void texture_if(const JsonReader& parent, std::string_view key) {
    if (!parent.has(key)) return;
    const JsonReader info = parent.member(key);
    if (!info.has("index")) info.refuse("an index", "none");
    index_if(info, "index", textures_);
    integer_or(info, "texCoord", 0, 0, 1000);
    number_if(info, "scale", -1e6f, 1e6f);
    if (!info.has("extensions") || !info.member("extensions").has("KHR_texture_transform")) return;
    const JsonReader transform = info.member("extensions").member("KHR_texture_transform");
    numbers_if(transform, "offset", 2, -1e6f, 1e6f);
    numbers_if(transform, "scale", 2, -1e6f, 1e6f);
    number_if(transform, "rotation", -1e4f, 1e4f);
  }

  void materials() {
    // Exporters write 1.0000001 now and then.
    constexpr float kOne = 1.001f;
    materials_ = each(root_, "materials", [&](const JsonReader& material, size_t) {
      if (material.has("name")) material.member("name").text();
      if (material.has("pbrMetallicRoughness")) {
        const JsonReader pbr = material.member("pbrMetallicRoughness");
        numbers_if(pbr, "baseColorFactor", 4, 0, kOne);
        number_if(pbr, "metallicFactor", 0, kOne);
        number_if(pbr, "roughnessFactor", 0, kOne);
        texture_if(pbr, "baseColorTexture");
        texture_if(pbr, "metallicRoughnessTexture");
      }
      for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) texture_if(material, key);
      numbers_if(material, "emissiveFactor", 3, 0, 1e6f);
      number_if(material, "alphaCutoff", 0, 1e6f);
      if (material.has("doubleSided")) material.member("doubleSided").boolean();
      if (!material.has("alphaMode")) return;
      const std::string mode = material.member("alphaMode").text(16);
      if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        material.member("alphaMode").refuse("OPAQUE, MASK or BLEND", mode);
    });
  }

  // An attribute's accessor: its type, and one element for each vertex.
  void attribute(const JsonReader& attributes, const std::string& name, std::string_view type, int64_t vertices) {
    const int64_t number = index_if(attributes, name, accessors_.size());
    if (number < 0) return;
    const Accessor& a = accessors_[static_cast<size_t>(number)];
    const JsonReader place = attributes.member(name);
    if (a.type != type) place.refuse(fmt::format("an accessor of type {}", type), a.type);
    if (a.component == 5125) place.refuse("floats or integers of 8 or 16 bits", "32-bit integers");
    if (a.count != vertices)
      place.refuse(fmt::format("{} elements, as POSITION has", vertices), std::to_string(a.count));
  }

  void primitive(const JsonReader& p) {
    integer_or(p, "mode", 4, 0, 6);
    index_if(p, "material", materials_);
    const JsonReader attributes = p.member("attributes");
    if (attributes.has("POSITION")) {
      const int64_t position = index_if(attributes, "POSITION", accessors_.size());
      if (!root_.status()) return;
      const int64_t vertices = accessors_[static_cast<size_t>(position)].count;
      attribute(attributes, "POSITION", "VEC3", vertices);
      attribute(attributes, "NORMAL", "VEC3", vertices);
      attribute(attributes, "TANGENT", "VEC4", vertices);
      attribute(attributes, "TEXCOORD_0", "VEC2", vertices);
    }
    const int64_t indices = index_if(p, "indices", accessors_.size());
    if (indices < 0) return;
    const Accessor& a = accessors_[static_cast<size_t>(indices)];
    if (a.type != "SCALAR" || a.normalized || (a.component != 5121 && a.component != 5123 && a.component != 5125))
      p.member("indices").refuse("unsigned integers, SCALAR", fmt::format("{} of type {}", a.component, a.type));
  }

  void meshes() {
    meshes_ = each(root_, "meshes", [&](const JsonReader& mesh, size_t) {
      const size_t count = each(mesh, "primitives", [&](const JsonReader& p, size_t) { primitive(p); });
      if (count == 0) mesh.refuse("at least one primitive", "none");
    });
  }

  void cameras() {
    cameras_ = each(root_, "cameras", [](const JsonReader& camera, size_t) {
      const std::string type = camera.member("type").text(32);
      if (type == "perspective")
        camera.member("perspective").member("yfov").number(1e-3f, 3.1415f);
      else if (type != "orthographic")
        camera.member("type").refuse("perspective or orthographic", type);
    });
  }

  void lights() {
    if (!root_.has("extensions") || !root_.member("extensions").has("KHR_lights_punctual")) return;
    const JsonReader extension = root_.member("extensions").member("KHR_lights_punctual");
    lights_ = each(extension, "lights", [](const JsonReader& light, size_t) {
      const std::string type = light.member("type").text(32);
      if (type != "point" && type != "spot" && type != "directional")
        light.member("type").refuse("point, spot or directional", type);
      numbers_if(light, "color", 3, 0, 1e6f);
      number_if(light, "intensity", 0, kHuge);
      if (!light.has("spot")) return;
      number_if(light.member("spot"), "innerConeAngle", 0, std::numbers::pi_v<float> / 2);
      number_if(light.member("spot"), "outerConeAngle", 0, std::numbers::pi_v<float> / 2 + 1e-4f);
    });
  }

  void node(const JsonReader& n, size_t i) {
    if (n.has("matrix") && (n.has("translation") || n.has("rotation") || n.has("scale")))
      n.refuse("either a matrix or translation, rotation and scale", "both");
    numbers_if(n, "matrix", 16, -kHuge, kHuge);
    numbers_if(n, "translation", 3, -kHuge, kHuge);
    numbers_if(n, "rotation", 4, -2, 2);
    numbers_if(n, "scale", 3, -kHuge, kHuge);
    index_if(n, "mesh", meshes_);
    index_if(n, "camera", cameras_);
    if (n.has("extensions") && n.member("extensions").has("KHR_lights_punctual"))
      index_if(n.member("extensions").member("KHR_lights_punctual"), "light", lights_);
    each(n, "children", [&](const JsonReader& child, size_t) {
      const auto number = static_cast<size_t>(child.integer(0, static_cast<int64_t>(parent_.size()) - 1));
      if (!root_.status()) return;
      if (number == i)
        child.refuse("another node", "the node itself");
      else if (parent_[number] >= 0)
        child.refuse("a node with one parent",
                     fmt::format("node {}, also a child of node {}", number, parent_[number]));
      parent_[number] = static_cast<int64_t>(i);
    });
  }

  void nodes() {
    if (!root_.has("nodes")) return;
    parent_.assign(root_.member("nodes").size(kMaxObjects), -1);
    each(root_, "nodes", [&](const JsonReader& n, size_t i) { node(n, i); });
    // With one parent each, only a loop or a very deep chain needs more steps to the root than this.
    for (size_t i = 0; i < parent_.size() && root_.status(); ++i) {
      int depth = 0;
      for (int64_t at = static_cast<int64_t>(i); at >= 0 && depth <= kMaxNodeDepth; ++depth)
        at = parent_[static_cast<size_t>(at)];
      if (depth > kMaxNodeDepth)
        root_.member("nodes").element(i).refuse(fmt::format("a node at most {} deep and not in a loop", kMaxNodeDepth),
                                                "a longer chain of parents");
    }
  }

  void scenes() {
    const size_t count = each(root_, "scenes", [&](const JsonReader& scene, size_t) {
      std::set<int64_t> seen;
      each(scene, "nodes", [&](const JsonReader& place, size_t) {
        if (parent_.empty()) {
          place.refuse("no node, for there are none", "an index");
          return;
        }
        const int64_t number = place.integer(0, static_cast<int64_t>(parent_.size()) - 1);
        if (parent_[static_cast<size_t>(number)] >= 0)
          place.refuse("a root node", fmt::format("node {}, a child", number));
        if (!seen.insert(number).second) place.refuse("each node once", fmt::format("node {} again", number));
      });
    });
    index_if(root_, "scene", count);
  }

  const GltfFile& gltf_;
  JsonReader root_;
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::vector<int64_t> parent_;
  size_t images_ = 0, samplers_ = 0, textures_ = 0, materials_ = 0, meshes_ = 0, cameras_ = 0, lights_ = 0;
};

}  // namespace

Status check_gltf(const GltfFile& gltf) { return Checker(gltf).run(); }

}  // namespace vamp
