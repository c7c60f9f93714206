#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <set>

#include "engine/core/log.h"
#include "engine/core/progress.h"
#include "engine/scene/gltf_accessor.h"
#include "engine/scene/gltf_check.h"
#include "engine/scene/gltf_file.h"
#include "engine/scene/gltf_material.h"
#include "engine/scene/gltf_objects.h"
#include "engine/scene/mesh.h"
#include "engine/scene/part_names.h"
#include "engine/scene/scene.h"

namespace vamp {
namespace {

constexpr size_t kMaxTriangles = 30000000;
constexpr size_t kMaxVertices = 60000000;
// Beyond this a float no longer resolves a millimetre, nor does squaring it stay far from overflow.
constexpr double kMaxCoordinate = 1e9;

class Importer {
 public:
  Importer(const GltfFile& gltf, const tinygltf::Model& model, Progress* progress)
      : gltf_(gltf),
        model_(model),
        source_{model, gltf.buffers, gltf.file},
        progress_(progress),
        scene_(std::make_shared<Scene>()) {}

  Result<std::shared_ptr<const Scene>> run() {
    scene_->file = gltf_.file;
    scene_->generator = model_.asset.generator;
    stage("Reading textures", 0.1f);
    VAMP_TRY(materials_, read_materials(gltf_, model_, *scene_, [this](std::string text) { say(std::move(text)); }));
    std::vector<std::string> material_names;
    for (const SurfaceMaterial& m : materials_) material_names.push_back(m.name);
    names_.emplace(material_names);
    say_left_out();
    VAMP_CHECK_STATUS(walk_scene());
    VAMP_CHECK_STATUS(join_meshes());
    VAMP_CHECK_STATUS(place_cameras());
    VAMP_CHECK_STATUS(read_extras());
    return scene_;
  }

 private:
  struct Instance {
    int node;
    glm::dmat4 world;
  };

  void say(std::string text) {
    spdlog::info("{}: {}", gltf_.file, text);
    scene_->notes.push_back(std::move(text));
  }
  void stage(const char* label, float fraction) {
    if (progress_ == nullptr) return;
    progress_->stage(label);
    progress_->fraction(fraction);
  }
  Status go_on() const {
    if (progress_ != nullptr && progress_->cancelled())
      return fail(ErrorKind::interrupted, gltf_.file, "", "the model whole", "stopped by the user");
    return {};
  }

  void say_left_out() {
    for (const char* key : {"animations", "skins"})
      if (gltf_.json.contains(key) && !gltf_.json[key].empty()) say(fmt::format("{} are left out", key));
    if (std::find(model_.extensionsUsed.begin(), model_.extensionsUsed.end(), "KHR_materials_variants") !=
        model_.extensionsUsed.end())
      say("material variants are left out: the default ones are shown");
  }

  // The scene that the file shows: `scene`, else the first, else every root node.
  std::vector<int> root_nodes() {
    const int number = model_.defaultScene >= 0 ? model_.defaultScene : 0;
    if (static_cast<size_t>(number) < model_.scenes.size()) {
      scene_->name = model_.scenes[static_cast<size_t>(number)].name;
      if (model_.scenes.size() > 1) say(fmt::format("{} scenes, number {} is shown", model_.scenes.size(), number));
      return model_.scenes[static_cast<size_t>(number)].nodes;
    }
    std::vector<bool> child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes)
      for (const int c : node.children) child[static_cast<size_t>(c)] = true;
    std::vector<int> roots;
    for (size_t i = 0; i < child.size(); ++i)
      if (!child[i]) roots.push_back(static_cast<int>(i));
    return roots;
  }

  Status walk_scene() {
    std::vector<Instance> open;
    for (const int root : root_nodes()) open.push_back({root, glm::dmat4(1.0)});
    std::reverse(open.begin(), open.end());
    std::vector<Instance> visits;
    while (!open.empty()) {
      const Instance parent = open.back();
      open.pop_back();
      const tinygltf::Node& node = model_.nodes[static_cast<size_t>(parent.node)];
      const glm::dmat4 world = parent.world * local_matrix(node);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) open.push_back({*child, world});
      visits.push_back({parent.node, world});
    }
    VAMP_CHECK_STATUS(check_total(visits));
    for (size_t i = 0; i < visits.size(); ++i) {
      stage("Reading meshes", 0.2f + 0.6f * static_cast<float>(i) / static_cast<float>(visits.size()));
      VAMP_CHECK_STATUS(read_node(visits[i].node, model_.nodes[static_cast<size_t>(visits[i].node)], visits[i].world));
      VAMP_CHECK_STATUS(go_on());
    }
    return {};
  }

  // Instances and shared accessors multiply what a small file holds: counted before memory is spent.
  Status check_total(const std::vector<Instance>& visits) const {
    size_t triangles = 0;
    size_t vertices = 0;
    for (const Instance& visit : visits) {
      const int mesh = model_.nodes[static_cast<size_t>(visit.node)].mesh;
      if (mesh < 0) continue;
      for (const tinygltf::Primitive& p : model_.meshes[static_cast<size_t>(mesh)].primitives) {
        const int position = attribute(p, "POSITION");
        if (position < 0) continue;
        const size_t count = accessor_count(source_, position);
        const size_t corners = p.indices >= 0 ? accessor_count(source_, p.indices) : count;
        triangles += p.mode > TINYGLTF_MODE_TRIANGLES ? corners : corners / 3;
        vertices += count;
        if (triangles > kMaxTriangles || vertices > kMaxVertices)
          return fail(
              ErrorKind::bad_input, gltf_.file, fmt::format("meshes[{}]", mesh),
              fmt::format("at most {} triangles and {} vertices with all instances", kMaxTriangles, kMaxVertices),
              "more");
      }
    }
    return {};
  }

  Status read_node(int number, const tinygltf::Node& node, const glm::dmat4& world) {
    if (node.camera >= 0) cameras_.push_back({number, world});
    const JsonReader json = JsonReader(gltf_.json, gltf_.file).member("nodes").element(static_cast<size_t>(number));
    if (node.extensions.contains("KHR_lights_punctual")) {
      const JsonReader extension = json.member("extensions").member("KHR_lights_punctual");
      if (extension.has("light")) {
        const auto index = static_cast<int>(extension.member("light").integer(0, INT32_MAX));
        Light light = read_punctual_light(model_, index, world);
        if (light.name.empty()) light.name = node.name;
        scene_->lights.push_back(std::move(light));
      }
    }
    if (json.has("extras") && json.member("extras").has("vamp_light")) {
      VAMP_TRY(Light light, read_vamp_light(json.member("extras").member("vamp_light"), world, node.name));
      scene_->lights.push_back(std::move(light));
    }
    if (node.mesh < 0) return {};
    const tinygltf::Mesh& mesh = model_.meshes[static_cast<size_t>(node.mesh)];
    for (size_t i = 0; i < mesh.primitives.size(); ++i)
      VAMP_CHECK_STATUS(read_primitive(node.mesh, i, mesh.primitives[i], world));
    return {};
  }

  int attribute(const tinygltf::Primitive& p, const char* name) const {
    const auto found = p.attributes.find(name);
    return found == p.attributes.end() ? -1 : found->second;
  }

  Status read_primitive(int mesh_number, size_t number, const tinygltf::Primitive& p, const glm::dmat4& world) {
    const std::string place = fmt::format("meshes[{}].primitives[{}]", mesh_number, number);
    const int mode = p.mode < 0 ? TINYGLTF_MODE_TRIANGLES : p.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES || attribute(p, "POSITION") < 0) {
      say(fmt::format("{}: {} left out", place,
                      mode < TINYGLTF_MODE_TRIANGLES ? "points and lines are" : "a primitive without positions is"));
      return {};
    }
    if (!p.targets.empty()) say(fmt::format("{}: morph targets are left out", place));

    const size_t vertices = accessor_count(source_, attribute(p, "POSITION"));
    Mesh mesh;
    VAMP_TRY(mesh.positions, read_vec3(source_, attribute(p, "POSITION")));
    std::vector<uint32_t> indices(p.indices >= 0 ? 0 : vertices);
    for (size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<uint32_t>(i);
    if (p.indices >= 0) {
      VAMP_TRY(indices, read_indices(source_, p.indices, static_cast<uint32_t>(vertices)));
    }
    mesh.triangles = triangles_of(indices, mode);
    if (attribute(p, "NORMAL") >= 0) {
      VAMP_TRY(mesh.normals, read_vec3(source_, attribute(p, "NORMAL")));
    }
    if (attribute(p, "TEXCOORD_0") >= 0) {
      VAMP_TRY(mesh.uvs, read_vec2(source_, attribute(p, "TEXCOORD_0")));
    }
    // Tangents belong to the file's normals and UVs; without these they mean nothing.
    if (attribute(p, "TANGENT") >= 0 && !mesh.normals.empty() && !mesh.uvs.empty()) {
      VAMP_TRY(mesh.tangents, read_vec4(source_, attribute(p, "TANGENT")));
    }
    VAMP_CHECK_STATUS(to_world(mesh, world, place));
    complete(mesh, place);
    if (mesh.triangles.empty()) return {};
    add(std::move(mesh), p.material, attribute(p, "TEXCOORD_0") < 0);
    return {};
  }

  Status to_world(Mesh& mesh, const glm::dmat4& world, const std::string& place) const {
    const glm::dmat3 linear(world);
    const double determinant = glm::determinant(linear);
    // The cofactor matrix turns normals as the inverse transpose does, up to a factor, and exists for flat scales too.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double side = determinant < 0 ? -1.0 : 1.0;
    for (vec3& p : mesh.positions) {
      const dvec3 q(world * glm::dvec4(dvec3(p), 1.0));
      const double largest = std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)});
      if (!(largest <= kMaxCoordinate))
        return fail(ErrorKind::bad_input, gltf_.file, place, fmt::format("coordinates up to {:g}", kMaxCoordinate),
                    fmt::format("{:g}", largest));
      p = vec3(q);
    }
    // Unit length in double first, so that very small scales do not end as zero.
    const auto unit = [](const dvec3& v) {
      const double length = glm::length(v);
      return length > 0 ? vec3(v / length) : vec3(0);
    };
    for (vec3& n : mesh.normals) n = unit(cofactors * dvec3(n) * side);
    for (vec4& t : mesh.tangents) {
      const double hand = (t.w < 0 ? -1.0 : 1.0) * side;
      t = vec4(unit(linear * dvec3(t)), static_cast<float>(hand));
    }
    if (determinant < 0)
      for (uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return {};
  }

  // Fills in what the file left out, and says so.
  void complete(Mesh& mesh, const std::string& place) {
    if (const size_t dropped = drop_degenerate_triangles(mesh); dropped > 0)
      say(fmt::format("{}: {} triangles without area are left out", place, dropped));
    if (mesh.triangles.empty()) return;
    if (mesh.normals.empty()) {
      make_flat_normals(mesh);
      say(fmt::format("{}: no normals, shaded flat", place));
    } else if (const size_t repaired = repair_normals(mesh); repaired > 0) {
      say(fmt::format("{}: {} normals of length zero made from the triangles around", place, repaired));
    }
    if (mesh.uvs.empty()) {
      project_uvs(mesh, scene_->mm_per_unit);
      say(fmt::format("{}: no UVs, box projection with {} mm per UV", place, kGeneratedMmPerUv));
    }
    // A tangent that is zero or along the normal says nothing.
    const auto usable = [&](size_t i) {
      return glm::length(glm::cross(mesh.normals[i], vec3(mesh.tangents[i]))) > 1e-3f;
    };
    bool good = mesh.tangents.size() == mesh.positions.size();
    for (size_t i = 0; good && i < mesh.tangents.size(); ++i) good = usable(i);
    if (!good && !mesh.tangents.empty()) say(fmt::format("{}: some tangents are unusable, all are made anew", place));
    if (!good) {
      make_tangents(mesh);
      return;
    }
    for (size_t i = 0; i < mesh.tangents.size(); ++i) {
      const vec3& n = mesh.normals[i];
      const vec3 t(mesh.tangents[i]);
      mesh.tangents[i] = vec4(glm::normalize(t - n * glm::dot(n, t)), mesh.tangents[i].w);
    }
  }

  void add(Mesh mesh, int material, bool uvs_generated) {
    const std::string& name = names_->of(material);
    const auto [found, is_new] = part_of_name_.try_emplace(name, scene_->parts.size());
    if (is_new) {
      Part part;
      part.name = name;
      // glTF's default material: white, metallic 1, roughness 1; shown as a plain dielectric it is easier to read.
      if (material >= 0)
        part.material = materials_[static_cast<size_t>(material)];
      else
        part.material.metallic = 0;
      scene_->parts.push_back(std::move(part));
      meshes_.emplace_back();
      first_material_.push_back(material);
      all_generated_.push_back(true);
    } else if (first_material_[found->second] != material && said_.insert(name).second) {
      say(fmt::format("several materials are named \"{}\": one part with the first of them", name));
    }
    const size_t part = found->second;
    if (uvs_generated)
      scene_->parts[part].uv_generated = true;
    else
      all_generated_[part] = false;
    meshes_[part].push_back(std::move(mesh));
  }

  // Lays the meshes end to end, part after part.
  Status join_meshes() {
    stage("Joining meshes", 0.85f);
    VAMP_CHECK_STATUS(go_on());
    Scene& s = *scene_;
    size_t vertices = 0;
    size_t triangles = 0;
    for (const auto& list : meshes_)
      for (const Mesh& mesh : list) {
        vertices += mesh.positions.size();
        triangles += mesh.triangles.size();
      }
    if (triangles == 0) return fail(ErrorKind::bad_input, gltf_.file, "", "a model with triangles", "none");
    s.positions.reserve(vertices);
    s.normals.reserve(vertices);
    s.tangents.reserve(vertices);
    s.uvs.reserve(vertices);
    s.triangles.reserve(triangles);
    s.triangle_part.reserve(triangles);
    for (size_t part = 0; part < meshes_.size(); ++part)
      for (Mesh& mesh : meshes_[part]) {
        const uvec3 base(static_cast<uint32_t>(s.positions.size()));
        s.positions.insert(s.positions.end(), mesh.positions.begin(), mesh.positions.end());
        s.normals.insert(s.normals.end(), mesh.normals.begin(), mesh.normals.end());
        s.tangents.insert(s.tangents.end(), mesh.tangents.begin(), mesh.tangents.end());
        s.uvs.insert(s.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
        for (const uvec3& t : mesh.triangles) s.triangles.push_back(t + base);
        s.triangle_part.resize(s.triangles.size(), static_cast<uint32_t>(part));
        mesh = {};
      }
    finish_scene(s);
    for (size_t part = 0; part < s.parts.size(); ++part) {
      Part& p = s.parts[part];
      if (all_generated_[part])
        p.mm_per_uv = kGeneratedMmPerUv;
      else if (!(p.uv_area > 0))
        say(fmt::format("part \"{}\": its UVs have no area, 1 UV counts as {} mm", p.name, p.mm_per_uv));
    }
    return {};
  }

  Status place_cameras() {
    for (const Instance& i : cameras_) {
      const tinygltf::Node& node = model_.nodes[static_cast<size_t>(i.node)];
      std::optional<Camera> camera = read_camera(model_, node.camera, i.world, scene_->bounds);
      if (!camera) {
        say(fmt::format("the orthographic camera of node \"{}\" is left out", node.name));
        continue;
      }
      if (camera->name.empty()) camera->name = node.name;
      scene_->cameras.push_back(std::move(*camera));
    }
    return {};
  }

  Status read_extras() {
    const JsonReader root(gltf_.json, gltf_.file);
    const auto number = static_cast<size_t>(std::max(model_.defaultScene, 0));
    if (number >= model_.scenes.size()) return {};
    const JsonReader scene = root.member("scenes").element(number);
    if (!scene.has("extras")) return {};
    const JsonReader extras = scene.member("extras");
    if (extras.has("vamp_ambient")) {
      const JsonReader ambient = extras.member("vamp_ambient");
      if (ambient.size(16) != 3) ambient.refuse("3 numbers", std::to_string(ambient.size(16)));
      vec3 value(0);
      for (size_t k = 0; k < 3; ++k) value[static_cast<int>(k)] = ambient.element(k).number(0, 1e6f);
      scene_->ambient = value;
    }
    if (extras.has("vamp_ao_radius")) scene_->ao_radius = extras.member("vamp_ao_radius").number(1e-9f, 1e9f);
    return root.status();
  }

  const GltfFile& gltf_;
  const tinygltf::Model& model_;
  GltfSource source_;
  Progress* progress_;
  std::shared_ptr<Scene> scene_;
  std::vector<SurfaceMaterial> materials_;
  std::optional<PartNames> names_;
  std::map<std::string, size_t> part_of_name_;
  std::vector<std::vector<Mesh>> meshes_;  // of each part
  std::vector<int> first_material_;        // of each part
  std::vector<bool> all_generated_;        // of each part: no UVs in the file at all
  std::set<std::string> said_;
  std::vector<Instance> cameras_;
};

}  // namespace

Result<std::shared_ptr<const Scene>> load_scene(const std::filesystem::path& path, Progress* progress) {
  if (progress != nullptr) progress->stage("Reading " + path.filename().string());
  VAMP_TRY(const GltfFile gltf, read_gltf_file(path));
  VAMP_CHECK_STATUS(check_gltf(gltf));
  VAMP_TRY(const tinygltf::Model model, read_objects(gltf));
  return Importer(gltf, model, progress).run();
}

}  // namespace vamp
