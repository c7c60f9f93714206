// Laws that hold for any parameters and directions; a counterexample is shrunk to a short one.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>

#include "engine/brdf/kernel.h"
#include "tests/brdf/lobes.h"

namespace vamp {
namespace {

// RapidCheck reads its settings from the environment; whoever set them there keeps them.
const int fixed = ::setenv("RC_PARAMS", "seed=20261122 max_success=3000", 0);

// From `low` to below `high`, evenly from the first case on.
template <class T>
T within(T low, T high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

double share() { return within(0, 1000001) * 1e-6; }

// Any variant of any model, each parameter anywhere in its row.
Lobe any_lobe() {
  const ModelRow& model = models()[within<size_t>(0, kModelCount)];
  const auto variant = static_cast<uint8_t>(within<size_t>(0, model.variants.size()));
  Lobe lobe = default_lobe(model.model, variant);
  for (const ParameterRow& row : model.parameters)
    if (row.belongs_to(variant)) lobe.params[row.slot] = from_slider(row, static_cast<float>(share()));
  return lobe;
}

dvec3 any_direction() {
  const double z = std::pow(10.0, -4 * share()), phi = 2 * std::numbers::pi * share(), s = std::sqrt(1 - z * z);
  return {s * std::cos(phi), s * std::sin(phi), z};
}

void holds(const std::function<void()>& law) {
  EXPECT_EQ(fixed, 0);
  EXPECT_TRUE(rc::check(law));
}

TEST(Properties, ExchangingLightAndViewerChangesNothing) {
  holds([] {
    const Lobe lobe = any_lobe();
    const dvec3 wi = any_direction(), wo = any_direction();
    const double there = fcos(lobe, wi, wo) / wi.z, back = fcos(lobe, wo, wi) / wo.z;
    // Oren-Nayar full crosses zero; raw Lafortune multiplies roundings by its exponent.
    const double slack = lobe.model == Model::oren_nayar ? 1e-9 / std::min(wi.z, wo.z) : 1e-30;
    RC_ASSERT(std::abs(there - back) <= 1e-8 * std::max(std::abs(there), std::abs(back)) + slack);
  });
}

TEST(Properties, TurningIsotropicLobesChangesNothing) {
  holds([] {
    Lobe lobe = any_lobe();
    if (lobe.model == Model::ward || lobe.model == Model::lafortune) lobe.params[2] = lobe.params[1];
    if (lobe.model == Model::ashikhmin_shirley) lobe.params[3] = lobe.params[2];
    const dvec3 wi = any_direction(), wo = any_direction();
    const double turn = 2 * std::numbers::pi * share(), c = std::cos(turn), s = std::sin(turn);
    const auto turned = [&](dvec3 w) { return dvec3(c * w.x - s * w.y, s * w.x + c * w.y, w.z); };
    const double before = fcos(lobe, wi, wo), after = fcos(lobe, turned(wi), turned(wo));
    // Turning rounds to 1e-16, which an exponent of 1e5 and a tail of 80 e-folds multiply.
    RC_ASSERT(std::abs(before - after) <= 1e-7 * std::max(std::abs(before), std::abs(after)) + 1e-9 * wi.z);
  });
}

TEST(Properties, MirroringBothDirectionsAtAnAxisChangesNothing) {
  holds([] {
    const Lobe lobe = any_lobe();
    const vec3 wi = rounded(any_direction()), wo = rounded(any_direction());
    RC_ASSERT(fcos(lobe, wi, wo) == fcos(lobe, vec3(-wi.x, wi.y, wi.z), vec3(-wo.x, wo.y, wo.z)));
    RC_ASSERT(fcos(lobe, wi, wo) == fcos(lobe, vec3(wi.x, -wi.y, wi.z), vec3(wo.x, -wo.y, wo.z)));
  });
}

TEST(Properties, WeightTimesDensityIsTheValue) {
  holds([] {
    const Lobe lobe = any_lobe();
    const dvec3 wo = any_direction();
    const LobeSample s = sample_lobe(lobe, wo, share() * 0.999999, share() * 0.999999);
    RC_PRE(s.valid);
    const double value = brdf_f64::eval(lobe, s.wi, wo);
    RC_PRE(value < 1e30);  // absurd raw Lafortune peaks are held at 4e34
    RC_ASSERT(s.pdf == brdf_f64::pdf(lobe, s.wi, wo));
    RC_ASSERT(std::abs(s.weight * s.pdf - value) <= 1e-5 * std::abs(value) + 1e-12);
    RC_ASSERT(std::abs(glm::length(s.wi) - 1) <= 1e-9);
  });
}

TEST(Properties, AKernelSpecialisedForALobeNeedsNoMoreThanItsBits) {
  holds([] {
    const Lobe lobe = any_lobe();
    RC_ASSERT(lobe_models_bit(lobe) != 0u);
    RC_ASSERT(validate(lobe, "", "").has_value());
    const PackedLobe packed = pack_lobe(lobe);
    for (float k : packed.k) RC_ASSERT(std::isfinite(k));
    RC_ASSERT(std::isfinite(packed.scale) && packed.scale >= 0);
  });
}

TEST(Properties, ASliderComesBackToItsPlace) {
  holds([] {
    const ModelRow& model = models()[within<size_t>(0, kModelCount)];
    const ParameterRow& row = model.parameters[within<size_t>(0, model.parameters.size())];
    const auto position = static_cast<float>(share());
    const float value = from_slider(row, position);
    RC_ASSERT(value >= row.min && value <= row.max);
    RC_ASSERT(std::abs(to_slider(row, value) - position) <= 2e-4f);
  });
}

}  // namespace
}  // namespace vamp
