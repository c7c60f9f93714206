// The same as the other tests of this folder, with a hundred times as many cases.
#include "engine/brdf/registry.h"
#include "tests/brdf/device.h"
#include "tests/brdf/draws.h"
#include "tests/brdf/errors.h"
#include "tests/brdf/fuzz_run.h"

namespace vamp {
namespace {

class Long : public test::OnTheDevice {};

TEST_F(Long, AMillionDrawsFollowTheDensity) { test::expect_all_draws_follow_their_densities(*probe, 1'000'000, 16); }

TEST_F(Long, AHundredMillionPatternsGiveNumbersOnTheCpu) { test::expect_numbers_on_the_cpu(100'000'000, 3); }

TEST_F(Long, AHundredMillionPatternsGiveNumbersOnTheDevice) {
  test::expect_numbers_on_the_device(*device, 100'000'000, 4);
}

TEST_F(Long, MillionsOfHardQuestionsStayWithinTheirBudgets) {
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      const auto questions = hard_questions(model.model, v, 5, 2000, 1200);
      const auto truths = truths_of(questions);
      test::expect_within(questions, truths, test::cpu_values(questions), test::cpu_budget(model.model, v));
      test::expect_within(questions, truths, test::device_values(*probe, questions), test::gpu_budget(model.model, v));
    }
  }
}

}  // namespace
}  // namespace vamp
