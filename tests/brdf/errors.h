#pragma once
// How large the errors of engine/probe/hard_questions.h may be.
#include "engine/probe/hard_questions.h"

namespace vamp::test {

// The largest relative errors by region, in the float build on the CPU and on any device.
struct Budget {
  double core, grazing, tail = 1e-4, deep = 1e-12;
};
Budget cpu_budget(Model model, uint8_t variant);
Budget gpu_budget(Model model, uint8_t variant);

// That answers to hard questions stay within a budget, and how many counted in the core and at grazing.
struct Counted {
  size_t core, grazing;
};
Counted expect_within(std::span<const BrdfQuestion> questions, std::span<const Truth> truths,
                      std::span<const float> fcos, const Budget& budget);

// One float build's answers.
std::vector<float> cpu_values(std::span<const BrdfQuestion> questions);
std::vector<float> device_values(BrdfProbe& probe, std::span<const BrdfQuestion> questions);

}  // namespace vamp::test
