// A kernel that knows fewer models gives the same bits for those it knows. The lobe's text is compiled here once for
// each set of models.
#include <gtest/gtest.h>

#include <bit>

#include "engine/brdf/glsl_in_cpp.h"
#include "engine/brdf/kernel.h"
#include "tests/brdf/lobes.h"

namespace vamp::specialised {
using namespace glsl;
using real = float;
using glm::dot;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "shaders/brdf/models.glsl"

#define LOBE_MODELS 1u
namespace mask_1 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 3u
namespace mask_3 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 4u
namespace mask_4 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 8u
namespace mask_8 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 16u
namespace mask_16 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 32u
namespace mask_32 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 64u
namespace mask_64 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 127u
namespace mask_127 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 128u
namespace mask_128 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 256u
namespace mask_256 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 528u
namespace mask_528 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 1024u
namespace mask_1024 {
#include "shaders/brdf/lobe.glsl"
}
#undef LOBE_GLSL
#undef LOBE_MODELS
#define LOBE_MODELS 1088u
namespace mask_1088 {
#include "shaders/brdf/lobe.glsl"
}
}  // namespace vamp::specialised

namespace vamp {
namespace {

struct Kernel {
  uint32_t mask;
  float (*eval)(uint32_t, vec4, vec3, vec3);
};

TEST(Specialisation, FewerModelsGiveTheSameBits) {
  using namespace specialised;
  const Kernel kernels[] = {
      {1, mask_1::lobe_eval},       {3, mask_3::lobe_eval},     {4, mask_4::lobe_eval},
      {8, mask_8::lobe_eval},       {16, mask_16::lobe_eval},   {32, mask_32::lobe_eval},
      {64, mask_64::lobe_eval},     {127, mask_127::lobe_eval}, {128, mask_128::lobe_eval},
      {256, mask_256::lobe_eval},   {528, mask_528::lobe_eval}, {1024, mask_1024::lobe_eval},
      {1088, mask_1088::lobe_eval},
  };
  Directions random(7);
  for (const Lobe& lobe : test::lobes_of_width(0.6)) {
    const uint32_t needed = lobe_models_bit(lobe);
    const PackedLobe packed = pack_lobe(lobe);
    int served = 0;
    for (const Kernel& kernel : kernels) {
      if ((needed & ~kernel.mask) != 0) continue;
      ++served;
      for (int i = 0; i < 500; ++i) {
        const vec3 wo = rounded(random.grazing(1e-3, 1));
        const LobeSample s = sample_lobe(lobe, dvec3(wo), random.uniform(), random.uniform());
        const vec3 wi = rounded(s.valid ? s.wi : random.grazing(1e-3, 1));
        const float all = brdf_f32::packed(packed.tag, packed.k, wi, wo);
        const float some = kernel.eval(packed.tag, {packed.k[0], packed.k[1], packed.k[2], packed.k[3]}, wi, wo);
        ASSERT_EQ(std::bit_cast<uint32_t>(all), std::bit_cast<uint32_t>(some)) << words_of(lobe) << " " << kernel.mask;
      }
    }
    EXPECT_GE(served, 1) << words_of(lobe);
  }
}

}  // namespace
}  // namespace vamp
