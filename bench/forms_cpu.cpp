// The forms built for C++ as the shaders are for the device.
#include <ctime>

#include "bench/forms.h"
#include "engine/brdf/glsl_in_cpp.h"
#include "engine/brdf/kernel.h"
#include "engine/core/check.h"

namespace vamp {
namespace textbook {
using namespace glsl;
using real = float;
using glm::dot;
using glm::normalize;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using std::acos;
using std::cos;
using std::exp;
using std::pow;
using std::sin;
using std::tan;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "bench/textbook/textbook.glsl"
#pragma GCC diagnostic pop
}  // namespace textbook

namespace {

// Called as brdf_f32::eval is.
[[gnu::noinline]] float textbook_fcos(const Lobe& lobe, vec3 wi, vec3 wo) {
  const auto& p = lobe.params;
  return textbook::textbook_eval(static_cast<int>(lobe.model), lobe.variant, p[0], p[1], p[2], p[3], p[4], wi, wo);
}

float value(Form form, const BrdfQuestion& q, const PackedLobe& packed, vec3 wi) {
  switch (form) {
    case Form::robust:
      return brdf_f32::eval(q.lobe, wi, q.wo);
    case Form::textbook:
      return textbook_fcos(q.lobe, wi, q.wo);
    case Form::lobe:
      return brdf_f32::packed(packed.tag, packed.k, wi, q.wo);
    case Form::none:
      break;
  }
  return wi.x + wi.y * wi.z;
}

std::vector<PackedLobe> packed_lobes(std::span<const BrdfQuestion> questions) {
  std::vector<PackedLobe> lobes;
  for (const BrdfQuestion& q : questions) lobes.push_back(pack_lobe(q.lobe));
  return lobes;
}

}  // namespace

std::vector<float> cpu_values(Form form, std::span<const BrdfQuestion> questions) {
  const std::vector<PackedLobe> lobes = packed_lobes(questions);
  std::vector<float> values;
  for (size_t i = 0; i < questions.size(); ++i)
    values.push_back(value(form, questions[i], lobes[i], questions[i].wi) * (form == Form::lobe ? lobes[i].scale : 1));
  return values;
}

double cpu_nanoseconds(Form form, std::span<const BrdfQuestion> questions, int rounds) {
  constexpr int kRepeats = 16;
  const std::vector<PackedLobe> lobes = packed_lobes(questions);
  double least = 1e300;
  volatile float kept = 0;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t begin = std::clock();
    float sum = 0;
    for (size_t i = 0; i < questions.size(); ++i) {
      const BrdfQuestion& q = questions[i];
      for (int k = 0; k < kRepeats; ++k)
        sum += value(form, q, lobes[i], q.wi + static_cast<float>(k) * vec3(1e-6f, -2e-6f, 1e-6f));
    }
    kept = sum;
    least = std::min(least, static_cast<double>(std::clock() - begin));
  }
  static_cast<void>(kept);
  return least * 1e9 / CLOCKS_PER_SEC / (static_cast<double>(questions.size()) * kRepeats);
}

}  // namespace vamp
