#include "engine/fit/columns.h"

#include "engine/brdf/glsl_in_cpp.h"
#include "engine/brdf/lobe.h"
#include "engine/core/check.h"
#include "engine/fit/clones.h"

namespace vamp::fit {
namespace {

// By value and with a plain choice, which compilers turn into one instruction for many lanes.
using glsl::floatBitsToInt, glsl::intBitsToFloat, glsl::uint;
using real = float;
inline real min(real a, real b) { return b < a ? b : a; }
inline real max(real a, real b) { return a < b ? b : a; }
inline real clamp(real x, real low, real high) { return min(max(x, low), high); }
inline real abs(real x) { return std::fabs(x); }
inline real floor(real x) { return std::floor(x); }
inline real sqrt(real x) { return std::sqrt(x); }
using glm::dot;
using glm::vec2;
using glm::vec3;
using glm::vec4;

// The shader's text, once for each set of models: the loops below carry only what their model needs.
template <uint32_t kModels>
struct Shader {
#define LOBE_MODELS kModels
#include "shaders/brdf/lobe.glsl"
#undef LOBE_MODELS
};

// Lights in the basis's frame, one array a coordinate.
struct LocalLights {
  std::vector<float> x, y, z;
};

struct Frame {
  vec3 t, b, n;
  // The shortest-arc frame about n (Duff et al. 2017), turned by psi: as in shaders/lib/spmm.glsl.
  Frame(vec3 normal, float psi) : n(normal) {
    const float a = -1 / (1 + n.z), c = n.x * n.y * a;
    const vec3 t0(1 + n.x * n.x * a, c, -n.x), b0(c, 1 + n.y * n.y * a, -n.y);
    const float cos_psi = std::cos(psi), sin_psi = std::sin(psi);
    t = t0 * cos_psi + b0 * sin_psi;
    b = b0 * cos_psi - t0 * sin_psi;
  }
  vec3 local(vec3 w) const { return {dot(t, w), dot(b, w), dot(n, w)}; }
};

// `tag`: a constant wherever the model's path is known, so that its choices are made once.
template <uint32_t kModels>
inline void rows_of(uint32_t tag, const PackedLobe& lobe, const Frame& frame, const Pairs& pairs,
                    const LocalLights& lights, float* out) {
  Shader<kModels> shader;
  const vec4 k(lobe.k[0], lobe.k[1], lobe.k[2], lobe.k[3]);
  const size_t count = lights.x.size();
  const float *x = lights.x.data(), *y = lights.y.data(), *z = lights.z.data();
  for (const vec3& view : pairs.views) {
    const auto seen = shader.lobe_view(tag, k, frame.local(view));
    for (size_t l = 0; l < count; ++l)
      out[l] = lobe.scale * shader.lobe_eval_view(tag, k, vec3(x[l], y[l], z[l]), seen);
    out += count;
  }
}

VAMP_CLONES void all_rows(Model model, const PackedLobe& lobe, const Frame& frame, const Pairs& pairs,
                          const LocalLights& lights, float* out) {
  switch (model) {
    case Model::lambert:
      return rows_of<LOBE_LAMBERT>(LOBE_TAG_DIFFUSE, lobe, frame, pairs, lights, out);
    case Model::oren_nayar:
      return rows_of<LOBE_OREN_NAYAR>(LOBE_TAG_DIFFUSE, lobe, frame, pairs, lights, out);
    case Model::blinn_phong:
      return rows_of<LOBE_BLINN_PHONG>(LOBE_TAG_POWER, lobe, frame, pairs, lights, out);
    case Model::ward:
      return rows_of<LOBE_WARD>(LOBE_TAG_WIDTH, lobe, frame, pairs, lights, out);
    case Model::cook_torrance:
      return rows_of<LOBE_COOK_TORRANCE>(LOBE_TAG_WIDTH | LOBE_TAG_GROOVE, lobe, frame, pairs, lights, out);
    case Model::lafortune:
      return rows_of<LOBE_LAFORTUNE>(LOBE_TAG_LAFORTUNE, lobe, frame, pairs, lights, out);
    case Model::ashikhmin_shirley:
      return rows_of<LOBE_ASHIKHMIN_SHIRLEY>(LOBE_TAG_MAXCOS | LOBE_TAG_POWER, lobe, frame, pairs, lights, out);
  }
}

// Rarer variants, with all of the shader's code.
void rare_rows(const PackedLobe& lobe, const Frame& frame, const Pairs& pairs, const LocalLights& lights, float* out) {
  rows_of<LOBE_EVERYTHING>(lobe.tag, lobe, frame, pairs, lights, out);
}

bool is_usual(const Lobe& lobe) { return lobe_models_bit(lobe) == 1u << static_cast<uint32_t>(lobe.model); }

}  // namespace

void evaluate_column(const Basis& basis, const Pairs& pairs, const float* factor, float* out) {
  const Frame frame(basis.normal, basis.psi);
  LocalLights lights;
  for (const vec3& light : pairs.lights) {
    const vec3 local = frame.local(light);
    lights.x.push_back(local.x), lights.y.push_back(local.y), lights.z.push_back(local.z);
  }
  const PackedLobe packed = pack_lobe(basis.lobe);
  if (is_usual(basis.lobe)) {
    all_rows(basis.lobe.model, packed, frame, pairs, lights, out);
  } else {
    rare_rows(packed, frame, pairs, lights, out);
  }
  if (factor == nullptr) return;
  for (size_t i = 0; i < pairs.count(); ++i) out[i] *= factor[i];
}

}  // namespace vamp::fit
