#include "tests/project/small_project.h"

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "tests/scene/glb_builder.h"

namespace vamp::test {

void write_model(const std::filesystem::path& path) {
  GlbBuilder builder;
  builder.add(box({0.1f, 0.05f, 0.2f}), builder.material("vamp", {0.6f, 0.3f, 0.1f, 1}, 0, 0.5f));
  builder.add(box({0.1f, 0.02f, 0.25f}), builder.material("sole", {0.1f, 0.1f, 0.1f, 1}), {0, -0.05f, 0});
  builder.add(box({0.02f, 0.02f, 0.02f}), builder.material("lace", {0.9f, 0.9f, 0.9f, 1}), {0, 0.05f, 0});
  builder.write(path);
}

std::shared_ptr<const Spmm> small_fit(float brightness) {
  auto fit = std::make_shared<Spmm>();
  fit->width = fit->height = 4;
  fit->clusters = {{"grain"}, {"pore"}};
  fit->dictionary = {{"body", default_lobe(Model::lambert), {0, 0, 1}, 0},
                     {"finish", default_lobe(Model::cook_torrance), {0, 0, 1}, 0},
                     {"sheen", default_lobe(Model::ashikhmin_shirley), {0, 0, 1}, 0.25f}};
  const uint32_t weight = half_from_float(brightness);
  for (uint32_t texel = 0; texel < 16; ++texel) {
    const auto first = static_cast<uint32_t>(fit->entries.size());
    for (uint32_t basis = 0; basis < 3; ++basis) fit->entries.push_back({basis | weight << 16, weight | weight << 16});
    fit->texels.push_back({first, (texel % 2) | 3u << 8, 0, 0});
  }
  return fit;
}

Preset small_preset(const std::string& name, float brightness) {
  Preset preset;
  preset.name = name;
  preset.tags = {"leather", "test"};
  preset.licence = "CC0-1.0";
  preset.fit = small_fit(brightness);
  return preset;
}

Project small_project() {
  auto scene = std::make_shared<Scene>();
  scene->name = "three triangles";
  for (const char* name : {"vamp", "sole", "lace"}) {
    const auto first = static_cast<uint32_t>(scene->positions.size());
    const auto part = static_cast<uint32_t>(scene->parts.size());
    for (const vec3& corner : {vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)}) {
      scene->positions.push_back(corner + vec3(static_cast<float>(part), 0, 0));
      scene->normals.emplace_back(0, 0, 1);
      scene->tangents.emplace_back(1, 0, 0, 1);
      scene->uvs.emplace_back(corner.x, corner.y);
    }
    scene->triangles.emplace_back(first, first + 1, first + 2);
    scene->triangle_part.push_back(part);
    scene->parts.emplace_back();
    scene->parts.back().name = name;
    scene->parts.back().material.name = name;
  }
  finish_scene(*scene);
  Project project = make_project(scene, "");
  assign_preset(project, 0, small_preset("calf"), "shipped:presets/calf.vamp");
  return project;
}

}  // namespace vamp::test
