#pragma once
// Questions that are hard to answer in float, and how far answers are from the double build on the same floats.
#include <span>
#include <string>
#include <vector>

#include "engine/probe/brdf_probe.h"

namespace vamp::test {

// `lobes` sets of parameters over the whole of the rows' ranges, ends included (exponents to 1e5, Lafortune's to 2e4),
// each with `pairs` directions: down the highlight and its tail, at its very peak, near the normal, towards one
// another, along the axes, with one or both at the horizon (cosines to 1e-6), and at random.
std::vector<BrdfQuestion> hard_questions(Model model, uint8_t variant, uint32_t seed, int lobes, int pairs);

// The largest relative errors of fcos by region of f, the brightest for the same viewer being f_max:
//   core     f >= 1e-3 f_max, both directions at most 80 degrees from the normal
//   grazing  f >= 1e-3 f_max, a direction beyond
//   tail     f >= 1e-12 f_max
// and of what is darker still the error in proportion to f_max. Below 1e-12 / sr nothing counts.
struct Errors {
  struct Worst {
    double error = 0;
    std::string where;
    size_t count = 0;
  };
  Worst core, grazing, tail, deep;
};

// One answer a question.
Errors errors_of(std::span<const BrdfQuestion> questions, std::span<const float> fcos);

// What they may be in the float build on the CPU and on any device.
struct Budget {
  double core, grazing, tail = 1e-4, deep = 1e-12;
};
Budget cpu_budget(Model model, uint8_t variant);
Budget gpu_budget(Model model, uint8_t variant);

void expect_within(const Errors& errors, const Budget& budget);

}  // namespace vamp::test
