#include "tests/brdf/errors.h"

#include <gtest/gtest.h>

#include "engine/brdf/kernel.h"

namespace vamp::test {

Budget cpu_budget(Model model, uint8_t variant) {
  if (model != Model::lafortune) return {5e-6, 2e-5};
  // An exponent of 2e4 makes 1e-4 of two roundings; without normalisation that of the largest C joins them.
  return variant == kLafortuneNormalized ? Budget{1e-4, 1e-4} : Budget{4e-3, 4e-3, 4e-3};
}

Budget gpu_budget(Model model, uint8_t variant) {
  const Budget cpu = cpu_budget(model, variant);
  return {std::max(cpu.core, 3e-5), std::max(cpu.grazing, 1e-4), cpu.tail, cpu.deep};
}

Counted expect_within(std::span<const BrdfQuestion> questions, std::span<const Truth> truths,
                      std::span<const float> fcos, const Budget& budget) {
  const std::array<double, 4> limits = {budget.core, budget.grazing, budget.tail, budget.deep};
  const auto errors = errors_of(truths, fcos);
  for (const ErrorRegion region : kErrorRegions) {
    const RegionErrors& found = errors[static_cast<size_t>(region)];
    const BrdfQuestion& q = questions[found.where];
    EXPECT_LE(found.worst, limits[static_cast<size_t>(region)])
        << name_of(region) << " of " << words_of(q.lobe) << " wi " << q.wi.x << " " << q.wi.y << " " << q.wi.z << " wo "
        << q.wo.x << " " << q.wo.y << " " << q.wo.z << " truth " << truths[found.where].fcos;
  }
  return {errors[0].all.size(), errors[1].all.size()};
}

std::vector<float> cpu_values(std::span<const BrdfQuestion> questions) {
  std::vector<float> values;
  for (const auto& [lobe, wi, wo, u] : questions) values.push_back(brdf_f32::eval(lobe, wi, wo));
  return values;
}

std::vector<float> device_values(BrdfProbe& probe, std::span<const BrdfQuestion> questions) {
  std::vector<float> values;
  for (const BrdfValue& value : probe.values(questions)) values.push_back(value.fcos);
  return values;
}

}  // namespace vamp::test
