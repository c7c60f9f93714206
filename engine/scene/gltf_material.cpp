#include "engine/scene/gltf_material.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <map>

#include "engine/image/load.h"
#include "engine/scene/gltf_file.h"

namespace vamp {
namespace {

constexpr int kMaxTextureSide = 2048;

float unit(double x) { return static_cast<float>(std::clamp(x, 0.0, 1.0)); }

Wrap wrap_of(int code) {
  return code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::clamp
         : code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror
                                                         : Wrap::repeat;
}

class MaterialReader {
 public:
  MaterialReader(const GltfFile& gltf, const tinygltf::Model& model, Scene& scene, const Say& say)
      : gltf_(gltf), model_(model), scene_(scene), say_(say) {}

  Result<SurfaceMaterial> read(size_t index) {
    const tinygltf::Material& source = model_.materials[index];
    const JsonReader json = JsonReader(gltf_.json, gltf_.file).member("materials").element(index);
    SurfaceMaterial m;
    m.name = source.name;
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    for (int k = 0; k < 4; ++k) m.base_color[k] = unit(pbr.baseColorFactor[static_cast<size_t>(k)]);
    m.metallic = unit(pbr.metallicFactor);
    m.roughness = unit(pbr.roughnessFactor);
    m.normal_scale = static_cast<float>(source.normalTexture.scale);
    m.alpha_cutoff = static_cast<float>(source.alphaCutoff);
    m.double_sided = source.doubleSided;
    if (source.alphaMode == "MASK") m.alpha_mode = AlphaMode::mask;
    if (source.alphaMode == "BLEND") m.alpha_mode = AlphaMode::blend;
    if (m.alpha_mode == AlphaMode::blend) say_(fmt::format("material \"{}\": blended alpha is shown opaque", m.name));
    for (int k = 0; k < 3 && source.emissiveFactor.size() == 3; ++k)
      m.emissive[k] = static_cast<float>(source.emissiveFactor[static_cast<size_t>(k)]);
    if (m.emissive != vec3(0)) say_(fmt::format("material \"{}\": emission is left out", m.name));

    const auto part = [&](std::string_view key) { return json.has(key) ? json.member(key) : JsonReader(kEmpty, ""); };
    const JsonReader pbr_json = part("pbrMetallicRoughness");
    VAMP_CHECK_STATUS(slot(pbr_json, "baseColorTexture", ColourSpace::srgb, m.base_color_texture));
    VAMP_CHECK_STATUS(slot(pbr_json, "metallicRoughnessTexture", ColourSpace::linear, m.metallic_roughness_texture));
    VAMP_CHECK_STATUS(slot(json, "normalTexture", ColourSpace::linear, m.normal_texture));
    if (m.normal_texture.texture >= 0) say_(fmt::format("material \"{}\": its normal map is left out", m.name));
    read_extensions(json, m);
    VAMP_CHECK_STATUS(json.status());
    return m;
  }

 private:
  static inline const Json kEmpty = Json::object();

  void read_extensions(const JsonReader& json, SurfaceMaterial& m) {
    if (!json.has("extensions")) return;
    const JsonReader extensions = json.member("extensions");
    for (const std::string& name : extensions.keys(100)) {
      const JsonReader e = extensions.member(name);
      if (name == "KHR_materials_specular") {
        if (e.has("specularFactor")) m.specular = e.member("specularFactor").number(0, 1.001f);
        if (e.has("specularColorFactor"))
          for (size_t k = 0; k < 3; ++k)
            m.specular_color[static_cast<int>(k)] = e.member("specularColorFactor").element(k).number(0, 1e4f);
        if (e.has("specularTexture") || e.has("specularColorTexture"))
          say_(fmt::format("material \"{}\": textures of KHR_materials_specular are left out", m.name));
      } else if (name == "KHR_materials_ior") {
        if (e.has("ior")) m.ior = e.member("ior").number(0, 1e4f);
      } else {
        say_(fmt::format("material \"{}\": {} is left out", m.name, name));
      }
    }
  }

  Status slot(const JsonReader& parent, std::string_view key, ColourSpace space, TextureSlot& out) {
    if (!parent.has(key)) return {};
    const JsonReader info = parent.member(key);
    int64_t coordinates = info.has("texCoord") ? info.member("texCoord").integer(0, 1000) : 0;
    const auto index = static_cast<size_t>(info.member("index").integer(0, INT32_MAX));
    VAMP_CHECK_STATUS(info.status());
    if (info.has("extensions") && info.member("extensions").has("KHR_texture_transform")) {
      const JsonReader t = info.member("extensions").member("KHR_texture_transform");
      for (int k = 0; k < 2; ++k) {
        const auto at = static_cast<size_t>(k);
        if (t.has("offset")) out.offset[k] = t.member("offset").element(at).number(-1e6f, 1e6f);
        if (t.has("scale")) out.scale[k] = t.member("scale").element(at).number(-1e6f, 1e6f);
      }
      if (t.has("rotation")) out.rotation = t.member("rotation").number(-1e4f, 1e4f);
      if (t.has("texCoord")) coordinates = t.member("texCoord").integer(0, 1000);
    }
    if (coordinates != 0)
      say_(fmt::format("{}: TEXCOORD_{} is left out, TEXCOORD_0 is used", info.path(), coordinates));
    const tinygltf::Texture& texture = model_.textures[index];
    if (texture.source < 0) {
      say_(fmt::format("{}: the texture has no PNG or JPEG image and is left out", info.path()));
      return {};
    }
    if (texture.sampler >= 0) {
      const tinygltf::Sampler& sampler = model_.samplers[static_cast<size_t>(texture.sampler)];
      out.wrap_u = wrap_of(sampler.wrapS);
      out.wrap_v = wrap_of(sampler.wrapT);
    }
    VAMP_TRY(out.texture, texture_of(static_cast<size_t>(texture.source), space));
    return info.status();
  }

  // The scene's texture for an image of the file, decoded at its first use.
  Result<int32_t> texture_of(size_t image, ColourSpace space) {
    const auto key = std::make_pair(image, space);
    if (const auto found = loaded_.find(key); found != loaded_.end()) return found->second;
    const JsonReader json = JsonReader(gltf_.json, gltf_.file).member("images").element(image);
    std::vector<std::byte> own;
    std::span<const std::byte> bytes;
    std::string name = json.has("name") ? json.member("name").text() : std::string();
    if (json.has("uri")) {
      const std::string uri = json.member("uri").text(kMaxModelBytes);
      VAMP_TRY(own, read_uri(uri, gltf_.folder, gltf_.file, json.path() + ".uri"));
      bytes = own;
      if (name.empty() && !uri.starts_with("data:")) name = uri;
    } else {
      const auto number = static_cast<size_t>(json.member("bufferView").integer(0, INT32_MAX));
      const tinygltf::BufferView& view = model_.bufferViews[number];
      bytes = gltf_.buffers[static_cast<size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
    }
    VAMP_CHECK_STATUS(json.status());
    if (name.empty()) name = fmt::format("image {}", image);
    auto decoded = decode_image(bytes, gltf_.file, space);
    if (!decoded) {
      Error error = decoded.error();
      error.place = json.path() + (error.place.empty() ? "" : ": " + error.place);
      return tl::unexpected(std::move(error));
    }
    if (std::max(decoded->width, decoded->height) > kMaxTextureSide) {
      const auto [width, height] = size_within(decoded->width, decoded->height, kMaxTextureSide);
      say_(fmt::format("texture \"{}\": {} x {} pixels averaged down to {} x {}", name, decoded->width, decoded->height,
                       width, height));
      *decoded = downsampled(*decoded, width, height);
    }
    scene_.textures.push_back({name, std::make_shared<const Image>(std::move(*decoded))});
    return loaded_[key] = static_cast<int32_t>(scene_.textures.size() - 1);
  }

  const GltfFile& gltf_;
  const tinygltf::Model& model_;
  Scene& scene_;
  const Say& say_;
  std::map<std::pair<size_t, ColourSpace>, int32_t> loaded_;
};

}  // namespace

Result<std::vector<SurfaceMaterial>> read_materials(const GltfFile& gltf, const tinygltf::Model& model, Scene& scene,
                                                    const Say& say) {
  MaterialReader reader(gltf, model, scene, say);
  std::vector<SurfaceMaterial> materials;
  for (size_t i = 0; i < model.materials.size(); ++i) {
    VAMP_TRY(SurfaceMaterial material, reader.read(i));
    materials.push_back(std::move(material));
  }
  return materials;
}

}  // namespace vamp
