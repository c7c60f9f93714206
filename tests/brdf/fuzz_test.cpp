// Nothing is NaN, infinite, or negative where the model forbids it, whatever the bits of the directions.
#include <limits>

#include "tests/brdf/device.h"
#include "tests/brdf/fuzz_run.h"
#include "tests/brdf/lobes.h"

namespace vamp {
namespace {

class Fuzzing : public test::OnTheDevice {};

TEST_F(Fuzzing, GivesNumbersOnTheCpu) { test::expect_numbers_on_the_cpu(2'000'000, 1); }

TEST_F(Fuzzing, GivesNumbersOnTheDevice) { test::expect_numbers_on_the_device(*device, 5'000'000, 2); }

// What no direction can be: the face of the library answers 0.
TEST(Directions, ThatAreNoneGiveZero) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const vec3 fine(0, 0.6f, 0.8f);
  for (const Lobe& lobe : test::lobes_of_width(0.5)) {
    for (const vec3 bad : {vec3(nan, 0, 1), vec3(0, nan, 0.5f), vec3(0, 0, nan), vec3(infinity, 0, 1),
                           vec3(0, 0, infinity), vec3(0, -infinity, infinity), vec3(0)}) {
      EXPECT_EQ(fcos(lobe, bad, fine), 0) << words_of(lobe);
      EXPECT_EQ(fcos(lobe, fine, bad), 0) << words_of(lobe);
      EXPECT_EQ(fcos(lobe, dvec3(bad), dvec3(fine)), 0) << words_of(lobe);
    }
    // Of any length, huge or denormal, a direction is one.
    for (float length : {1e-40f, 1e-30f, 1e30f, 3e38f}) {
      const float value = fcos(lobe, length * vec3(0, 0, 1), fine), truth = fcos(lobe, vec3(0, 0, 1), fine);
      EXPECT_EQ(value, truth) << words_of(lobe) << " " << length;
    }
  }
}

}  // namespace
}  // namespace vamp
