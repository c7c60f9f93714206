// The device computes what the C++ float build of the same text computes.
#include "engine/brdf/kernel.h"
#include "tests/brdf/device.h"
#include "tests/brdf/errors.h"
#include "tests/brdf/lobes.h"

namespace vamp {
namespace {

using test::lobes_of_width;

// Lights near the highlight, as many for each variant and width.
std::vector<BrdfQuestion> questions() {
  std::vector<BrdfQuestion> all;
  Directions random(1);
  for (double width : {0.0, 0.5, 1.0}) {
    for (const Lobe& lobe : lobes_of_width(width)) {
      for (int i = 0; i < 200; ++i) {
        const vec3 wo = rounded(random.grazing(i % 2 ? 1e-3 : 0.17, 1));
        const LobeSample s = sample_lobe(lobe, dvec3(wo), random.uniform(), random.uniform());
        const vec3 wi = rounded(s.valid ? s.wi : random.grazing(1e-3, 1));
        const auto u = [&] { return static_cast<float>(random.uniform()) * 0.999f; };
        all.push_back({lobe, wi, wo, vec2(u(), u())});
      }
    }
  }
  return all;
}

double relative(double a, double b) { return std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-30}); }

class BrdfOnTheDevice : public test::OnTheDevice {};

TEST_F(BrdfOnTheDevice, EqualsTheCpuBuildOfTheSameText) {
  const std::vector<BrdfQuestion> all = questions();
  const std::vector<BrdfValue> values = probe->values(all);
  const std::vector<float> lobes = probe->lobe_values(all);
  size_t same = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    const auto& [lobe, wi, wo, u] = all[i];
    const float value = brdf_f32::eval(lobe, wi, wo), shaded = lobe_value(pack_lobe(lobe), wi, wo);
    same += values[i].fcos == value && lobes[i] == shaded;
    EXPECT_LE(relative(values[i].fcos, value), 3e-5) << words_of(lobe);
    EXPECT_LE(relative(lobes[i], shaded), 3e-5) << words_of(lobe);
    EXPECT_LE(relative(values[i].pdf, lobe_pdf(lobe, wi, wo)), 3e-5) << words_of(lobe);
  }
  RecordProperty("same_bits_percent", static_cast<int>(100 * same / all.size()));
}

TEST_F(BrdfOnTheDevice, EveryVariantStaysWithinItsBudgetOnHardQuestions) {
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      const auto questions = hard_questions(model.model, v, 4, 100, 600);
      test::expect_within(questions, truths_of(questions), test::device_values(*probe, questions),
                          test::gpu_budget(model.model, v));
    }
  }
}

TEST_F(BrdfOnTheDevice, DrawsWhatTheCpuDraws) {
  const std::vector<BrdfQuestion> all = questions();
  const std::vector<BrdfDraw> draws = probe->draws(all);
  for (size_t i = 0; i < all.size(); ++i) {
    const auto& [lobe, wi, wo, u] = all[i];
    const LobeSample s = sample_lobe(lobe, wo, u.x, u.y);
    ASSERT_EQ(draws[i].valid, s.valid) << words_of(lobe);
    if (!s.valid) continue;
    EXPECT_LE(glm::length(dvec3(draws[i].wi) - s.wi), 1e-6) << words_of(lobe);
    EXPECT_LE(relative(draws[i].weight, s.weight), 1e-4) << words_of(lobe);
  }
}

TEST_F(BrdfOnTheDevice, SpecialisedKernelsGiveTheSameBits) {
  const std::vector<BrdfQuestion> all = questions();
  const std::vector<float> everything = probe->lobe_values(all);
  for (uint32_t mask : {1u, 2u, 4u, 8u, 16u, 32u, 64u, 127u, 1088u}) {
    const std::vector<float> some = probe->lobe_values(all, mask);
    for (size_t i = 0; i < all.size(); ++i) {
      if ((lobe_models_bit(all[i].lobe) & ~mask) != 0) continue;
      EXPECT_EQ(some[i], everything[i]) << words_of(all[i].lobe) << " with models " << mask;
    }
  }
}

}  // namespace
}  // namespace vamp
