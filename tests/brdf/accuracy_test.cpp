// How near the float text comes to the double text on the same float inputs, and the double text to the papers.
#include <gtest/gtest.h>

#include "engine/brdf/kernel.h"
#include "tests/brdf/errors.h"
#include "tests/brdf/lobes.h"
#include "tests/brdf/published.h"

namespace vamp {
namespace {

using test::lobes_of_width;

constexpr double kWidths[] = {0.0, 0.25, 0.5, 0.75, 1.0};

double relative(double value, double truth) { return std::abs(value - truth) / std::max(std::abs(truth), 1e-300); }

// Lafortune's exponent multiplies a rounding that a half vector does not have.
double core_budget(const Lobe& lobe) { return lobe.model == Model::lafortune ? 1e-4 : 5e-6; }

// Two models cross zero in the open hemisphere: there only the size of their terms can be a measure.
double cancellation(const Lobe& lobe, vec3 wi, double top) {
  if (lobe.model == Model::lafortune) return 2e-7 * top;
  if (lobe.model == Model::oren_nayar && lobe.variant == kOrenNayarFull) return 2e-6 * lobe.params[0] * wi.z;
  return 0;
}

TEST(Accuracy, ElementaryFunctionsAreGoodToTwoRoundings) {
  Directions random(1);
  for (int i = 0; i < 200000; ++i) {
    const float a = static_cast<float>(std::pow(10.0, -20 + 32 * random.uniform()));
    const float b = static_cast<float>(std::pow(10.0, -4 + 4 * random.uniform()));
    EXPECT_LE(relative(brdf_f32::log2_ratio(a, b), brdf_f64::log2_ratio(a, b)), 4e-7) << a << " " << b;
    const float x = static_cast<float>(-115 + 230 * random.uniform());
    EXPECT_LE(relative(brdf_f32::exp2(x), brdf_f64::exp2(x)), 2e-7) << x;
  }
  EXPECT_EQ(brdf_f32::exp2(0), 1.0f);
  EXPECT_EQ(brdf_f32::log2_ratio(0, 0.3f), 0.0f);
}

TEST(Accuracy, DoubleFormsEqualThePapers) {
  Directions random(2);
  for (double width : kWidths) {
    for (const Lobe& lobe : lobes_of_width(width)) {
      for (int i = 0; i < 200; ++i) {
        const dvec3 wo = random.grazing(0.02, 1);
        const LobeSample s = sample_lobe(lobe, wo, random.uniform(), random.uniform());
        const dvec3 wi = s.valid && (i & 1) ? glm::normalize(s.wi) : random.grazing(0.02, 1);
        const double truth = test::published_fcos(lobe, wi, wo);
        EXPECT_LE(std::abs(fcos(lobe, wi, wo) - truth), 2e-9 * std::abs(truth) + 1e-30)
            << words_of(lobe) << " truth " << truth;
      }
    }
  }
}

TEST(Accuracy, EveryVariantStaysWithinItsBudgetOnHardQuestions) {
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      const auto questions = hard_questions(model.model, v, 3, 100, 600);
      const test::Counted counted = test::expect_within(questions, truths_of(questions), test::cpu_values(questions),
                                                        test::cpu_budget(model.model, v));
      EXPECT_GT(counted.core, 5000u) << model.name;
      EXPECT_GT(counted.grazing, 2000u) << model.name;
    }
  }
}

TEST(Accuracy, LobeCodeEqualsItsModelTimesTheWindow) {
  Directions random(5);
  for (double width : kWidths) {
    for (const Lobe& lobe : lobes_of_width(width)) {
      const PackedLobe packed = pack_lobe(lobe);
      const bool uncut = lobe.model == Model::lambert || lobe.model == Model::oren_nayar;
      for (int i = 0; i < 2000; ++i) {
        const vec3 wo = rounded(random.grazing(1e-4, 1));
        const LobeSample s =
            sample_lobe(lobe, wo, static_cast<float>(random.uniform()), static_cast<float>(random.uniform()));
        const vec3 wi = rounded(s.valid && (i & 1) ? s.wi : random.grazing(1e-4, 1));
        const double window = uncut ? 1 : std::clamp(wo.z / 0.03, 0.0, 1.0);
        const double model = window * brdf_f64::eval(lobe, dvec3(wi), dvec3(wo));
        const double top = window * std::abs(brdf_f64::eval(lobe, dvec3(-wo.x, -wo.y, wo.z), dvec3(wo)));
        const double slack = 1e-12 * top + cancellation(lobe, wi, top);
        // k is stored in float: a rounding of it moves the exponent by 80 of them at most.
        EXPECT_LE(std::abs(lobe_value(packed, dvec3(wi), dvec3(wo)) - model), 1e-4 * std::abs(model) + slack)
            << words_of(lobe);
        EXPECT_LE(std::abs(lobe_value(packed, wi, wo) - model), 1e-4 * std::abs(model) + slack)
            << words_of(lobe) << " wi " << wi.x << " " << wi.y << " " << wi.z << " wo " << wo.x << " " << wo.y << " "
            << wo.z;
      }
    }
  }
}

TEST(Accuracy, LobeCodeIsExactInItsCore) {
  Directions random(6);
  for (double width : kWidths) {
    for (const Lobe& lobe : lobes_of_width(width)) {
      const PackedLobe packed = pack_lobe(lobe);
      double worst = 0;
      for (int i = 0; i < 2000; ++i) {
        const vec3 wo = rounded(random.grazing(0.174, 1));
        const LobeSample s = sample_lobe(lobe, dvec3(wo), random.uniform(), 0.999 * random.uniform());
        if (!s.valid || s.wi.z < 0.05) continue;
        const vec3 wi = rounded(s.wi);
        const double truth = brdf_f64::eval(lobe, dvec3(wi), dvec3(wo));
        if (truth < 1e-3 * brdf_f64::eval(lobe, dvec3(-wo.x, -wo.y, wo.z), dvec3(wo))) continue;
        worst = std::max(worst, relative(lobe_value(packed, wi, wo), truth));
      }
      EXPECT_LE(worst, core_budget(lobe)) << words_of(lobe);
    }
  }
}

}  // namespace
}  // namespace vamp
