#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "editor/model/recent.h"
#include "editor/model/settings.h"
#include "engine/acquire/height_map.h"
#include "engine/core/hash.h"
#include "engine/image/load.h"
#include "engine/image/metadata.h"
#include "engine/image/save.h"
#include "engine/material/preset.h"
#include "engine/project/job.h"
#include "engine/project/project_file.h"
#include "engine/scene/environment.h"
#include "engine/scene/scene.h"
#include "tests/hostile/format.h"
#include "tests/image/encoders.h"
#include "tests/image/pictures.h"
#include "tests/material/small_spmm.h"
#include "tests/project/small_project.h"

namespace vamp::test {
namespace {

template <class T>
uint64_t hash_of(const std::vector<T>& values) {
  return hash64(std::as_bytes(std::span(values)));
}

// Presets.

Preset sound_preset() {
  Preset preset = small_preset("calf");
  preset.fit = std::make_shared<const Spmm>(small_spmm());
  BasisEdit edit;
  edit.gain = {0.5f, 1, 2};
  preset.edits.set({1, 2}, edit);
  preset.edits.cluster_names[0] = "grain";
  return preset;
}

std::string unsound(const Preset& preset) {
  const Status valid = validate(*preset.fit, "fit");
  return valid ? "" : valid.error().message();
}

std::string text_of_tables(const Spmm& fit) {
  return fmt::format("{:x} {:x} {:x}", hash_of(fit.texels), hash_of(fit.entries), hash_of(fit.residual.records));
}

Result<Loaded> load_zipped_preset(const fs::path& folder) {
  VAMP_TRY(const Preset preset, load_preset(folder / "a.vamp"));
  std::string text = preset.name + preset.licence + text_of_tables(*preset.fit);
  for (const auto& [key, edit] : preset.edits.bases)
    text += fmt::format(" {} {} {} {}", key.cluster, key.basis, edit.gain.x, edit.gain.z);
  for (const Basis& basis : preset.fit->dictionary)
    text += fmt::format(" {} {} {}", basis.name, basis.normal.x, basis.psi);
  return Loaded{unsound(preset), text};
}

Result<Loaded> load_preset_folder(const fs::path& folder) {
  VAMP_TRY(const Preset preset, load_preset(folder / "preset"));
  return Loaded{unsound(preset), text_of_tables(*preset.fit)};
}

void write_preset_folder(const fs::path& folder) { EXPECT_TRUE(save_preset(sound_preset(), folder / "preset")); }

// Projects, in whatever they are kept.

void write_project_parts(const fs::path& folder) {
  write_model(folder / "shoe.glb");
  EXPECT_TRUE(save_preset(small_preset("calf"), folder / "calf.vamp"));
}

Project sound_project(const fs::path& folder) {
  write_project_parts(folder);
  Project project = open_scene(folder / "shoe.glb").value();
  assign_preset(project, 0, load_preset(folder / "calf.vamp").value(), (folder / "calf.vamp").string());
  BasisEdit edit;
  edit.mute = true;
  project.materials.back().edits.set({1, 1}, edit);
  return project;
}

Result<Loaded> checked(Result<Project> project) {
  if (!project) return tl::unexpected(project.error());
  const Status valid = validate(*project, "project");
  return Loaded{valid ? "" : valid.error().message(), ""};
}

void write_project(const fs::path& folder) { EXPECT_TRUE(save_project(sound_project(folder), folder / "a.vampproj")); }
Result<Loaded> load_a_project(const fs::path& folder) { return checked(load_project(folder / "a.vampproj")); }

void write_job(const fs::path& folder) {
  const Job job{.project = sound_project(folder),
                .width = 64,
                .height = 48,
                .samples = 16,
                .noise_goal = 0.05f,
                .device = "a device",
                .driver = "a driver"};
  EXPECT_TRUE(write_text_atomically(folder / "job.json", job_to_text(job, folder).value()));
}
Result<Loaded> load_job(const fs::path& folder) {
  const fs::path file = folder / "job.json";
  VAMP_TRY(const std::string text, read_text(file, 1 << 24));
  VAMP_TRY(const Job job, job_from_text(text, folder, file.string()));
  if (job.width == 0 || job.height == 0 || job.samples == 0) return Loaded{"a picture of nothing", ""};
  return checked(job.project);
}

// Models: what the kernels read must be finite and inside its arrays.

Result<Loaded> load_model(const fs::path& file) {
  VAMP_TRY(const std::shared_ptr<const Scene> scene, load_scene(file));
  for (const vec3& p : scene->positions)
    if (!std::isfinite(p.x + p.y + p.z)) return Loaded{"a place that is not finite", ""};
  for (const uvec3& triangle : scene->triangles)
    for (int i = 0; i < 3; ++i)
      if (triangle[i] >= scene->positions.size()) return Loaded{"a corner that is not there", ""};
  for (const uint32_t part : scene->triangle_part)
    if (part >= scene->parts.size()) return Loaded{"a part that is not there", ""};
  return Loaded{};
}

// Pictures.

Result<Loaded> load_picture(const fs::path& file, bool sealed) {
  VAMP_TRY(const Image image, load_image(file));
  for (const float value : image.pixels)
    if (!std::isfinite(value)) return Loaded{"a value that is not finite", ""};
  return Loaded{"", sealed ? fmt::format("{:x}", hash_of(image.pixels)) : ""};
}

Image picture() { return testing::noise_image(16, 8, {"R", "G", "B"}, 5); }

void write_encoded(const fs::path& file, const char* format) {
  const auto bytes = testing::oiio_encoded(format, OIIO::ImageSpec(16, 8, 3, OIIO::TypeDesc::FLOAT), picture().pixels);
  EXPECT_TRUE(write_file_atomically(file, bytes));
}

Result<Loaded> load_sky(const fs::path& folder) {
  VAMP_TRY(const auto sky, load_environment(folder / "a.hdr"));
  for (const vec4& texel : sky->texels)
    if (!(std::isfinite(texel.x + texel.y + texel.z + texel.w) && texel.w >= 0)) return Loaded{"a wild texel", ""};
  for (const Environment::Cell& cell : sky->cells)
    if (cell.other >= sky->cells.size()) return Loaded{"a cell that is not there", ""};
  return Loaded{};
}

Result<Loaded> load_texts(const fs::path& folder) {
  VAMP_TRY(const Metadata texts, read_metadata(folder / "a.png"));
  std::string all;
  for (const auto& [key, value] : texts) all += key + "=" + value + ";";
  return Loaded{"", all};
}

// What the program keeps for itself never stops it: damage is told and defaults serve.

Result<Loaded> load_own_settings(const fs::path& folder) {
  const Settings settings = load_settings(folder / "settings.json").settings;
  const bool sound = (settings.ui_scale == 0 || (settings.ui_scale >= 0.5f && settings.ui_scale <= 4)) &&
                     settings.window.width > 0 && settings.window.height > 0;
  return Loaded{sound ? "" : "settings out of range", ""};
}

Result<Loaded> load_recent(const fs::path& folder) {
  const bool sound = RecentFiles(folder / "recent.json").list().size() <= RecentFiles::kMost;
  return Loaded{sound ? "" : "more files than it keeps", ""};
}

}  // namespace

std::vector<Format> program_formats() {
  return {
      {"PresetZip", "a.vamp", [](const fs::path& f) { EXPECT_TRUE(save_preset(sound_preset(), f / "a.vamp")); },
       load_zipped_preset},
      {"PresetJson", "preset/material.json", write_preset_folder, load_preset_folder},
      {"PresetTables", "preset/tables.bin", write_preset_folder, load_preset_folder},
      {"ProjectFile", "a.vampproj", write_project, load_a_project},
      {"ModelOfAProject", "shoe.glb", write_project, load_a_project},
      {"PresetOfAProject", "calf.vamp", write_project, load_a_project},
      {"Job", "job.json", write_job, load_job},
      {"Glb", "a.glb", [](const fs::path& f) { write_model(f / "a.glb"); },
       [](const fs::path& f) { return load_model(f / "a.glb"); }},
      {"Gltf", "a.gltf", [](const fs::path& f) { write_model(f / "a.gltf"); },
       [](const fs::path& f) { return load_model(f / "a.gltf"); }},
      {"Png", "a.png", [](const fs::path& f) { EXPECT_TRUE(save_png(f / "a.png", picture())); },
       [](const fs::path& f) { return load_picture(f / "a.png", true); }},
      {"Exr", "a.exr", [](const fs::path& f) { EXPECT_TRUE(save_exr(f / "a.exr", picture())); },
       [](const fs::path& f) { return load_picture(f / "a.exr", false); }},
      {"Jpeg", "a.jpg", [](const fs::path& f) { write_encoded(f / "a.jpg", "jpeg"); },
       [](const fs::path& f) { return load_picture(f / "a.jpg", false); }},
      {"Hdr", "a.hdr", [](const fs::path& f) { write_encoded(f / "a.hdr", "hdr"); },
       [](const fs::path& f) { return load_picture(f / "a.hdr", false); }},
      {"Sky", "a.hdr", [](const fs::path& f) { write_encoded(f / "a.hdr", "hdr"); }, load_sky},
      {"TextsOfAPicture", "a.png",
       [](const fs::path& f) {
         PngOptions options;
         options.metadata = {{"vamp:job", std::string(300, '{')}, {"Title", "calf"}};
         EXPECT_TRUE(save_png(f / "a.png", picture(), options));
       },
       load_texts},
      {"HeightMap", "a.png", [](const fs::path& f) { EXPECT_TRUE(save_png(f / "a.png", picture())); },
       [](const fs::path& f) -> Result<Loaded> {
         VAMP_TRY(const auto structure, acquire::load_height_map(f / "a.png", ""));
         return Loaded{structure == nullptr ? "nothing" : "", ""};
       }},
      {"SettingsFile", "settings.json",
       [](const fs::path& f) { EXPECT_TRUE(save_settings(Settings{}, f / "settings.json")); }, load_own_settings},
      {"RecentList", "recent.json",
       [](const fs::path& f) { EXPECT_TRUE(RecentFiles(f / "recent.json").add(f / "a.vampproj")); }, load_recent},
  };
}

}  // namespace vamp::test
