// The random sequences of replay_test.cpp and weights_test.cpp, some thousands of them.
#include "engine/render/trace_path.h"
#include "tests/render/edit_sequences.h"

namespace vamp {
namespace {

class Long : public test::EditedPicture {};

TEST_F(Long, ThousandsOfSequencesOfEditsEndInTheFreshPicture) {
  for (uint32_t seed = 0; seed < 3000; ++seed) {
    const bool mirror = seed % 5 == 4;
    const uint64_t histories[] = {0, 80 << 10, 8 << 20};
    run({.history = histories[seed % 3],
         .mirror = mirror ? 0.5f : 0.0f,
         .weights = seed % 4 != 0,
         .moves = seed % 7 < 3,
         .seed = 1000 + seed});
    if (HasFailure()) break;
  }
  // Enough of them were answered from sums to tell.
  EXPECT_GT(recombined, 500u);
  if (!trace_paths(device->info()).chosen().ray_queries) {
    EXPECT_GT(trees, 500u);
  }
}

}  // namespace
}  // namespace vamp
