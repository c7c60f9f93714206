// Prints the table of docs/brdf.md: errors of the float build and of the device against the double build on the same
// floats, by region.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/brdf/kernel.h"
#include "engine/brdf/registry.h"
#include "engine/gpu/device.h"
#include "tests/brdf/errors.h"

namespace {

using namespace vamp;

using Errors = test::Errors;

// What the code that pictures are shaded with does not promise, beside its window below a cosine of 0.03: it knows where
// Lafortune's sum crosses 0 no better than its terms, so that with n < 4 the edge of the lobe has no digits; and a raw
// lobe whose peak is beyond 1e20 ends 35 decades below it.
bool beyond_lobe_code(const Lobe& lobe) {
  if (lobe.model != Model::lafortune) return false;
  const auto& p = lobe.params;
  const double top = std::max({std::abs(p[1]), std::abs(p[2]), std::abs(p[3])});
  return p[4] < 4 || (lobe.variant == kLafortuneRaw && std::abs(p[4] * std::log10(top)) > 20);
}

std::string cell(const Errors& cpu, const Errors& device, const Errors& lobe, Errors::Worst Errors::*region) {
  return fmt::format("{:.1e} / {:.1e} / {:.1e}", (cpu.*region).error, (device.*region).error, (lobe.*region).error);
}

}  // namespace

int main() {
  auto device = gpu::Device::create();
  if (!device) {
    fmt::print(stderr, "{}\n", device.error().message());
    return static_cast<int>(device.error().kind);
  }
  BrdfProbe probe(**device);
  fmt::print("Device: {}. 1,000 lobes a variant, 1,000 pairs of directions a lobe.\n\n", (*device)->info().name);
  fmt::print("| CPU / device / device, lobe code | core | grazing | tail | deep |\n|---|---|---|---|---|\n");
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      const std::string name = fmt::format("{}/{}", model.name, model.variants[v].name);
      std::vector<BrdfQuestion> questions = test::hard_questions(model.model, v, 1, 1000, 1000);
      std::vector<float> values;
      for (const auto& [lobe, wi, wo, u] : questions) values.push_back(brdf_f32::eval(lobe, wi, wo));
      const Errors cpu = test::errors_of(questions, values);
      values.clear();
      for (const BrdfValue& value : probe.values(questions)) values.push_back(value.fcos);
      const Errors device_errors = test::errors_of(questions, values);
      std::erase_if(questions, [](const BrdfQuestion& q) { return q.wo.z < 0.03f || beyond_lobe_code(q.lobe); });
      const Errors lobe = test::errors_of(questions, probe.lobe_values(questions));
      fmt::print("| {} |", name);
      for (const auto region : {&Errors::core, &Errors::grazing, &Errors::tail, &Errors::deep})
        fmt::print(" {} |", cell(cpu, device_errors, lobe, region));
      fmt::print("\n");
    }
  }
  return 0;
}
