#pragma once
// BRDFs asked on the device: the text of shaders/brdf, run by the thousand for `vamp brdf`, measurements and tests. Its
// CPU counterparts are in engine/brdf/lobe.h.
#include <memory>
#include <span>
#include <vector>

#include "engine/brdf/lobe.h"

namespace vamp {

namespace gpu {
class Device;
}

// Directions as in fcos(), but taken as they come: unit vectors, and both above the horizon where a value is asked for.
struct BrdfQuestion {
  Lobe lobe;
  vec3 wi{0, 0, 1};
  vec3 wo{0, 0, 1};
  vec2 u{0};  // in [0,1)^2, of draws
};

struct BrdfValue {
  float fcos = 0;
  float pdf = 0;  // of the model's sampler
};

struct BrdfDraw {
  vec3 wi{0};
  float pdf = 0;
  float weight = 0;    // fcos / pdf
  bool valid = false;  // false: fell below the horizon, a sample of value 0
};

// Any number of questions; memory stays bounded. All throw MachineError.
class BrdfProbe {
 public:
  // The device must outlive the probe.
  explicit BrdfProbe(gpu::Device& device);
  ~BrdfProbe();
  BrdfProbe(BrdfProbe&&) noexcept;
  BrdfProbe& operator=(BrdfProbe&&) noexcept;

  // Each model by its own file, as fcos(const Lobe&, vec3, vec3) on the CPU.
  std::vector<BrdfValue> values(std::span<const BrdfQuestion> questions);
  // What pictures are shaded with, window and scale included, as lobe_value(const PackedLobe&, vec3, vec3) on the CPU.
  // `models`: the LOBE_* bits that the kernel is specialised for.
  std::vector<float> lobe_values(std::span<const BrdfQuestion> questions, uint32_t models = ~0u);
  // As sample_lobe() on the CPU.
  std::vector<BrdfDraw> draws(std::span<const BrdfQuestion> questions);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vamp
