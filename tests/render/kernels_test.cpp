// Whatever kernels a picture goes through, generic or specialised, made on the queue or beside it, it has the same
// bytes.
#include <chrono>
#include <thread>

#include "engine/render/session.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class KernelsTest : public test::EditedPicture {
 protected:
  void expect_generic_gives_the_same(const Project& project, const char* what) {
    Renderer any(*device);
    any.use_generic_kernels_alone();
    show(any, project);
    any.set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
    const std::vector<float> have = finish(any, 9), want = fresh(project, 9);
    EXPECT_TRUE(test::same_bytes(want, have)) << what;
  }
};

TEST_F(KernelsTest, GenericOnesGiveTheBitsOfSpecialisedOnes) {
  // Lambert and Cook-Torrance without a residual; then all models, a mirror, other lights and another way of blending.
  Project project = test::two_materials();
  for (PartState& part : project.parts) part.material = project.parts.front().material;
  expect_generic_gives_the_same(project, "plain materials");
  project = test::two_materials();
  project.materials.back().edits.residual_terms = 1;
  project.materials[project.materials.size() - 2].edits.residual_strength = 0;
  project.lights.front().type = LightType::point;
  expect_generic_gives_the_same(project, "all models, one term, a point light");
  project.parts[0].mirror_f0 = 0.4f;
  project.settings.tap = TexelTap::four;
  project.lights.front().type = LightType::spot;
  expect_generic_gives_the_same(project, "mirror, four taps, a spot light");
  project.settings.tap = TexelTap::stochastic;
  project.lights.front().type = LightType::sphere;
  project.lights.front().radius = 0.2f;
  project.lights.resize(5, project.lights.front());
  for (size_t i = 0; i < project.lights.size(); ++i) project.lights[i].center.x = static_cast<float>(i) - 2;
  expect_generic_gives_the_same(project, "drawn spheres");
}

TEST_F(KernelsTest, APictureWhoseKernelsArriveMeanwhileIsTheFreshOne) {
  Project project = test::two_materials();
  project.settings.max_samples = 20;
  const std::vector<PartState> dressed = project.parts;
  for (PartState& part : project.parts) part.material = project.parts.front().material;
  RenderSession session(*device, std::make_shared<const Project>(project), kWidth, kHeight);
  const auto shown = [&](auto reached) {
    const auto next = std::make_shared<const Project>(project);
    session.set_project(next, "");
    for (int i = 0; i < 12000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(10))) {
      const RenderStatus status = session.status();
      if (!status.error.empty()) return false;
      if (status.project == next && reached(status)) return true;
    }
    return false;
  };
  // Other models, one more light, a mirror and an edit, each as soon as the one before is seen.
  project.parts = dressed;
  ASSERT_TRUE(shown([](const RenderStatus& status) { return status.samples >= 1; }));
  project.lights.push_back(project.lights.front());
  project.lights.back().center.x = -1;
  project.lights.back().type = LightType::sphere;
  ASSERT_TRUE(shown([](const RenderStatus& status) { return status.samples >= 5; }));
  project.parts[0].mirror_f0 = 0.3f;
  ASSERT_TRUE(shown([](const RenderStatus& status) { return status.samples >= 2; }));
  BasisEdit edit;
  edit.psi = 0.5f;
  project.materials.back().edits.set({0, 1}, edit);
  ASSERT_TRUE(shown([](const RenderStatus& status) { return status.finished; }));
  int width = 0, height = 0;
  uint32_t samples = 0;
  EXPECT_TRUE(test::same_bytes(fresh(project, 20), session.linear_picture(width, height, samples)));
  EXPECT_EQ(samples, 20u);
}

}  // namespace
}  // namespace vamp
