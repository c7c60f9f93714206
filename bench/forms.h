#pragma once
// One BRDF in several forms, on the device and on the CPU: its values, and what an evaluation costs.
#include <memory>
#include <span>
#include <vector>

#include "engine/probe/brdf_probe.h"

namespace vamp {

enum class Form : uint32_t {
  none,      // the loop around an evaluation alone
  robust,    // shaders/brdf/<model>.glsl
  textbook,  // bench/textbook/textbook.glsl
  lobe       // what pictures are shaded with, specialised for the model
};

// fcos by the float build of a form; one model and variant in all questions.
std::vector<float> cpu_values(Form form, std::span<const BrdfQuestion> questions);

// Nanoseconds of one core for one evaluation, the loop around it included: the least of `rounds` runs over the
// questions. Processor time, so that other programs do not count.
double cpu_nanoseconds(Form form, std::span<const BrdfQuestion> questions, int rounds);

// The same on the device. All throw MachineError.
class FormProbe {
 public:
  explicit FormProbe(gpu::Device& device);
  ~FormProbe();
  FormProbe(const FormProbe&) = delete;
  FormProbe& operator=(const FormProbe&) = delete;

  std::vector<float> values(Form form, std::span<const BrdfQuestion> questions);
  // On a device that is no CPU, nanoseconds of the device for one evaluation, by the clock.
  double nanoseconds(Form form, std::span<const BrdfQuestion> questions, int rounds);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vamp
