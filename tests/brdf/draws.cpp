#include "tests/brdf/draws.h"

#include <gtest/gtest.h>

#include <random>

#include "shaders/shared/random.h"
#include "tests/brdf/chi_square.h"
#include "tests/brdf/lobes.h"

namespace vamp::test {

void expect_draws_follow_the_density(BrdfProbe& probe, const Lobe& lobe, vec3 wo, uint32_t seed, size_t draws,
                                     int fine) {
  CellsOfDraws cells(lobe, wo, fine);
  EXPECT_LE(cells.integral(), 1.003) << words_of(lobe);
  std::mt19937 bits(seed);
  const auto uniform = [&bits] { return random::random_float(static_cast<uint32_t>(bits())); };
  std::vector<BrdfQuestion> questions(draws, {.lobe = lobe, .wo = wo});
  for (BrdfQuestion& q : questions) {
    q.u.x = uniform();
    q.u.y = uniform();
  }
  for (const BrdfDraw& draw : probe.draws(questions)) cells.count(dvec3(draw.wi), draw.valid);
  EXPECT_LE(cells.deviations(), kChiSquareDeviations)
      << words_of(lobe) << " viewed from " << wo.x << " " << wo.y << " " << wo.z;
}

void expect_all_draws_follow_their_densities(BrdfProbe& probe, size_t draws, int fine) {
  Directions random(31);
  uint32_t seed = 1;
  for (double width : {0.0, 0.4, 0.7, 1.0}) {
    for (const Lobe& lobe : lobes_of_width(width)) {
      // A highlight and a base in one: no chart is broad for both where the highlight is sharp. Its parts are tested.
      const bool mixed = lobe.model == Model::ashikhmin_shirley && lobe.variant == kAshikhminShirleyFull;
      if (mixed && width < 0.7) continue;
      for (double theta : {10.0, 50.0, 80.0})
        expect_draws_follow_the_density(probe, lobe, rounded(random.at_angle(theta)), seed++, draws, fine);
    }
  }
  EXPECT_LE(seed, 480u);  // what the bound was made for
}

}  // namespace vamp::test
