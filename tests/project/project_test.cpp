#include "engine/project/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "engine/project/fit_checksum.h"
#include "engine/project/limits.h"
#include "engine/project/studio.h"
#include "tests/project/small_project.h"

namespace vamp {
namespace {

using test::small_preset;
using test::small_project;
using testing::HasSubstr;

TEST(Project, OfAModelWithoutLightsAndCamerasIsSeenInANeutralStudio) {
  const Project project = small_project();
  EXPECT_EQ(project.lights.size(), 2u);
  EXPECT_EQ(project.ambient, vec3(kStudioAmbient));
  EXPECT_EQ(project.background, vec3(kStudioBackground));
  EXPECT_TRUE(project.cameras.empty());
  const vec3 view = glm::normalize(project.camera.target - project.camera.eye);
  const vec3 to_model = glm::normalize(project.scene->bounds.center() - project.camera.eye);
  EXPECT_GT(glm::dot(view, to_model), 0.99f);
  EXPECT_TRUE(validate(project, "test"));
}

TEST(Project, OfAModelWithLightsCamerasAndExtrasStartsFromThem) {
  auto scene = std::make_shared<Scene>(*small_project().scene);
  scene->lights.resize(1);
  scene->lights[0].name = "own";
  scene->cameras = {{"front", {0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 30}};
  scene->ao_radius = 0.25f;
  const Project project = make_project(scene, "");
  ASSERT_EQ(project.lights.size(), 1u);
  EXPECT_EQ(project.lights[0].name, "own");
  EXPECT_EQ(project.ambient, vec3(0));
  EXPECT_EQ(project.background, vec3(0));
  EXPECT_EQ(project.camera.eye, vec3(0, 0, 3));
  ASSERT_EQ(project.cameras.size(), 1u);
  EXPECT_EQ(project.cameras[0].name, "front");
  EXPECT_EQ(project.settings.ao_radius, 0.25f);
}

TEST(Project, AmbientAloneIsALightToo) {
  auto scene = std::make_shared<Scene>(*small_project().scene);
  scene->ambient = vec3(1);
  const Project project = make_project(scene, "");
  EXPECT_TRUE(project.lights.empty());
  EXPECT_EQ(project.ambient, vec3(1));
}

TEST(AssignPreset, SharesTheInstanceThatAlreadyHoldsItAndDropsWhatNoPartShows) {
  Project project = small_project();
  EXPECT_EQ(project.materials.size(), 3u);
  assign_preset(project, 1, small_preset("calf"), "shipped:presets/calf.vamp");
  EXPECT_EQ(project.materials.size(), 2u);
  EXPECT_EQ(project.parts[0].material, project.parts[1].material);
  assign_preset(project, 2, small_preset("twill", 0.25f), "shipped:presets/twill.vamp");
  EXPECT_EQ(project.materials.size(), 2u);
  EXPECT_EQ(project.materials[static_cast<size_t>(project.parts[2].material)].name, "twill");
  EXPECT_TRUE(validate(project, "test"));
}

TEST(AssignPreset, PutsItAsItWasSavedBesideAnEditedOne) {
  Project project = small_project();
  project.materials[static_cast<size_t>(project.parts[0].material)].edits.set({0, 0}, {.gain = vec3(2)});
  const MaterialInstance edited = project.materials[static_cast<size_t>(project.parts[0].material)];
  assign_preset(project, 1, small_preset("calf"), "shipped:presets/calf.vamp");
  EXPECT_EQ(project.materials[static_cast<size_t>(project.parts[0].material)], edited);
  const MaterialInstance& saved = project.materials[static_cast<size_t>(project.parts[1].material)];
  EXPECT_EQ(saved.edits, small_preset("calf").edits);
  EXPECT_EQ(saved.fit, edited.fit);  // one table for both
  EXPECT_NE(saved.name, edited.name);
}

TEST(AssignPreset, TakesAnotherInstanceWhenThePresetHasChangedOnDisk) {
  Project project = small_project();
  assign_preset(project, 1, small_preset("calf", 0.9f), "shipped:presets/calf.vamp");
  EXPECT_NE(project.parts[0].material, project.parts[1].material);
}

TEST(MakeUniqueMaterial, CopiesOnlyWhatIsShared) {
  Project project = small_project();
  const int alone = project.parts[0].material;
  EXPECT_EQ(make_unique_material(project, 0), alone);
  share_material(project, 1, alone);
  const int copy = make_unique_material(project, 1);
  EXPECT_NE(copy, project.parts[0].material);
  const MaterialInstance& original = project.materials[static_cast<size_t>(project.parts[0].material)];
  EXPECT_EQ(project.materials[static_cast<size_t>(copy)].fit, original.fit);
  EXPECT_NE(project.materials[static_cast<size_t>(copy)].name, original.name);
  EXPECT_TRUE(validate(project, "test"));
}

TEST(AssignOwnMaterial, BringsTheModelsOwnBack) {
  Project project = small_project();
  assign_own_material(project, 0);
  const MaterialInstance& own = project.materials[static_cast<size_t>(project.parts[0].material)];
  EXPECT_TRUE(own.preset.empty());
  EXPECT_EQ(own.model_part, "vamp");
  EXPECT_EQ(own.fit->clusters.size(), 1u);
  EXPECT_EQ(project.materials.size(), 3u);
}

TEST(FindPart, PrefersTheExactName) {
  Project project = small_project();
  EXPECT_EQ(find_part(project, "sole"), 1);
  EXPECT_EQ(find_part(project, "SOLE"), 1);
  EXPECT_EQ(find_part(project, "heel"), -1);
  project.parts[0].name = "Sole";
  EXPECT_EQ(find_part(project, "Sole"), 0);
  EXPECT_EQ(find_part(project, "sole"), 1);
}

TEST(Validate, RefusesWhatTheRendererCannotTake) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<const char*, void (*)(Project&)>> wrongs = {
      {"lights", [](Project& p) { p.lights.resize(kMaxLights + 1); }},
      {"lights[0].power", [](Project& p) { p.lights[0].power = -1; }},
      {"lights[1].size", [](Project& p) { p.lights[1].size.x = 0; }},
      {"parts[1].material", [](Project& p) { p.parts[1].material = 99; }},
      {"parts", [](Project& p) { p.parts.pop_back(); }},
      {"mirror_f0", [](Project& p) { p.parts[0].mirror_f0 = 1.5f; }},
      {"parts[2].offset", [](Project& p) { p.parts[2].place.offset.z = 1e8f; }},
      {"parts[2].turn", [](Project& p) { p.parts[2].place.turn.y = std::numeric_limits<float>::quiet_NaN(); }},
      {"camera.fov", [](Project& p) { p.camera.fov_degrees = 0; }},
      {"max_samples", [](Project& p) { p.settings.max_samples = 0; }},
      {"noise_goal", [](Project& p) { p.settings.noise_goal = -1; }},
      {"exposure", [](Project& p) { p.display.exposure = 100; }},
      {"basis 9",
       [](Project& p) {
         p.materials[2].edits.bases[{0, 9}].mute = true;
       }},
  };
  for (const auto& [place, spoil] : wrongs) {
    Project project = small_project();
    spoil(project);
    const Status status = validate(project, "test");
    ASSERT_FALSE(status) << place;
    EXPECT_THAT(status.error().message(), HasSubstr(place));
  }
  Project project = small_project();
  project.ambient.y = nan;
  EXPECT_FALSE(validate(project, "test"));
}

TEST(FitChecksum, FollowsWhatIsRenderedAndNotNames) {
  Spmm fit = *test::small_fit();
  const std::string before = fit_checksum(fit);
  fit.dictionary[0].name = "another word";
  EXPECT_EQ(fit_checksum(fit), before);
  fit.entries[3].green_blue ^= 1;
  EXPECT_NE(fit_checksum(fit), before);
  fit = *test::small_fit();
  fit.dictionary[1].lobe.params[1] += 0.001f;
  EXPECT_NE(fit_checksum(fit), before);
}

}  // namespace
}  // namespace vamp
