// Prints the table of docs/brdf.md: errors of the float build and of the device against the double build on the same
// floats, by region.
#include <fmt/format.h>

#include "engine/brdf/kernel.h"
#include "engine/brdf/registry.h"
#include "engine/gpu/device.h"
#include "tests/brdf/errors.h"

namespace {

using namespace vamp;

void print_row(const std::string& name, const char* form, const test::Errors& e) {
  fmt::print("| {} | {} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |\n", name, form, e.core.error, e.grazing.error,
             e.tail.error, e.deep.error);
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
  fmt::print("| model and variant | where | core | grazing | tail | deep |\n|---|---|---|---|---|---|\n");
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      const std::string name = fmt::format("{}/{}", model.name, model.variants[v].name);
      std::vector<BrdfQuestion> questions = test::hard_questions(model.model, v, 1, 1000, 1000);
      std::vector<float> values;
      for (const auto& [lobe, wi, wo, u] : questions) values.push_back(brdf_f32::eval(lobe, wi, wo));
      print_row(name, "CPU", test::errors_of(questions, values));
      values.clear();
      for (const BrdfValue& value : probe.values(questions)) values.push_back(value.fcos);
      print_row(name, "device", test::errors_of(questions, values));
      // The code that pictures are shaded with has a window below a cosine of 0.03, and knows where Lafortune's sum
      // crosses 0 no better than its terms: with n < 2 the edge of the lobe has no digits.
      std::erase_if(questions, [](const BrdfQuestion& q) {
        return q.wo.z < 0.03f || (q.lobe.model == Model::lafortune && q.lobe.params[4] < 2);
      });
      print_row(name, "device, lobe code", test::errors_of(questions, probe.lobe_values(questions)));
    }
  }
  return 0;
}
