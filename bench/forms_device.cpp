#include <algorithm>
#include <ctime>

#include "bench/forms.h"
#include "bench/forms_shared.h"
#include "engine/core/clock.h"
#include "engine/gpu/device.h"
#include "engine/probe/question_row.h"
#include "shaders/spirv.h"

namespace vamp {

using probe::Answer;
using probe::Question;

struct FormProbe::State {
  gpu::Device* device;
  gpu::TypedBuffer<Question> questions;
  gpu::TypedBuffer<Answer> answers;

  gpu::ComputePipeline pipeline(Form form, const Lobe& lobe, uint32_t repeats) {
    const gpu::PipelineDesc desc{.name = "form",
                                 .spirv = spirv::forms_comp(),
                                 .bindings = {{BINDING_QUESTIONS, gpu::BindingType::storage_buffer},
                                              {BINDING_ANSWERS, gpu::BindingType::storage_buffer}},
                                 .push_bytes = sizeof(uint32_t),
                                 .constants = {{SPEC_FORM, static_cast<uint32_t>(form)},
                                               {SPEC_FORM_MODEL, static_cast<uint32_t>(lobe.model)},
                                               {SPEC_FORM_VARIANT, uint32_t{lobe.variant}},
                                               {SPEC_FORM_REPEATS, repeats},
                                               {SPEC_FORM_MODELS, lobe_models_bit(lobe)}}};
    return {*device, desc};
  }

  // Sends the questions and returns the kernel's arguments.
  gpu::DescriptorSet send(const gpu::ComputePipeline& kernel, std::span<const BrdfQuestion> all) {
    if (questions.count() < all.size()) {
      questions = gpu::TypedBuffer<Question>(*device, "questions", all.size());
      answers = gpu::TypedBuffer<Answer>(*device, "answers", all.size());
    }
    std::vector<Question> rows;
    for (const BrdfQuestion& q : all) rows.push_back(probe::question_row(q, true));
    device->upload_rows(questions, 0, rows);
    return {*device, kernel, {{BINDING_QUESTIONS, questions}, {BINDING_ANSWERS, answers}}};
  }

  uint64_t run(const gpu::ComputePipeline& kernel, const gpu::DescriptorSet& set, size_t count) {
    gpu::CommandList list = device->begin("form");
    list.bind(kernel, set);
    list.push(static_cast<uint32_t>(count));
    list.dispatch(static_cast<uint32_t>((count + PROBE_GROUP_SIZE - 1) / PROBE_GROUP_SIZE));
    return device->submit(std::move(list));
  }
};

FormProbe::FormProbe(gpu::Device& device) : state_(std::make_unique<State>(State{.device = &device})) {}
FormProbe::~FormProbe() = default;

std::vector<float> FormProbe::values(Form form, std::span<const BrdfQuestion> questions) {
  const gpu::ComputePipeline kernel = state_->pipeline(form, questions.front().lobe, 1);
  std::vector<float> values;
  constexpr size_t kBatch = 1 << 18;
  for (size_t first = 0; first < questions.size(); first += kBatch) {
    const auto batch = questions.subspan(first, std::min(kBatch, questions.size() - first));
    const gpu::DescriptorSet set = state_->send(kernel, batch);
    const uint64_t done = state_->run(kernel, set, batch.size());
    for (const Answer& answer : state_->device->readback_rows(state_->answers, 0, batch.size(), done)) {
      const size_t i = values.size();
      values.push_back(form == Form::lobe ? pack_lobe(questions[i].lobe).scale * answer.value : answer.value);
    }
  }
  return values;
}

double FormProbe::nanoseconds(Form form, std::span<const BrdfQuestion> questions, int rounds) {
  constexpr uint32_t kRepeats = 64;
  gpu::Device& device = *state_->device;
  const gpu::ComputePipeline kernel = state_->pipeline(form, questions.front().lobe, kRepeats);
  const gpu::DescriptorSet set = state_->send(kernel, questions);
  device.wait(state_->run(kernel, set, questions.size()));  // compiles
  double least = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const std::clock_t cpu = std::clock();
    const Clock::time_point wall = Clock::now();
    device.wait(state_->run(kernel, set, questions.size()));
    const double seconds =
        device.info().is_cpu ? static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC : seconds_since(wall);
    least = std::min(least, seconds);
  }
  return least * 1e9 / (static_cast<double>(questions.size()) * kRepeats);
}

}  // namespace vamp
