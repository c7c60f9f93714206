// One question to a BRDF and its answer, as passes/brdf_probe.comp reads and writes them. Scalar layout, 4-byte members.
#ifdef __cplusplus
#pragma once
#include "engine/core/vec.h"
namespace vamp::probe {
using uint = std::uint32_t;
#endif

#define BINDING_QUESTIONS 0
#define BINDING_ANSWERS 1

#define SPEC_PROBE_WORK 0    // constant_id: what is asked, one of PROBE_*
#define SPEC_PROBE_MODELS 1  // LOBE_* bits of PROBE_LOBE
#define PROBE_EVAL 0         // the model's own file: fcos and the sampler's density
#define PROBE_LOBE 1         // the lobe code that pictures are shaded with
#define PROBE_SAMPLE 2       // a draw

#define PROBE_GROUP_SIZE 64

struct Question {
  vec3 wi;
  uint model;
  vec3 wo;
  uint variant;
  float p0, p1, p2, p3, p4, p5;  // in the papers' order
  float u0, u1;                  // of PROBE_SAMPLE
  float k0, k1, k2, k3;          // of PROBE_LOBE: the packed lobe
  uint tag;
};

struct Answer {
  float value;  // fcos; of PROBE_LOBE without the packed lobe's scale; of PROBE_SAMPLE the weight fcos / pdf
  float pdf;
  vec3 wi;      // of PROBE_SAMPLE
  uint valid;   // 0: the draw fell below the horizon
};

#ifdef __cplusplus
static_assert(sizeof(Question) == 84 && sizeof(Answer) == 24);
}  // namespace vamp::probe
#endif
