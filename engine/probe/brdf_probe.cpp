#include "engine/probe/brdf_probe.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/gpu/device.h"
#include "engine/probe/question_row.h"
#include "shaders/shared/probe.h"
#include "shaders/spirv.h"

namespace vamp {

using probe::Answer;
using probe::Question;

namespace {

// Questions of one dispatch: large enough to fill a device, small enough for a few megabytes.
constexpr size_t kBatch = 1 << 16;

}  // namespace

struct BrdfProbe::State {
  gpu::Device* device;
  gpu::TypedBuffer<Question> questions;
  gpu::TypedBuffer<Answer> answers;
  std::map<std::pair<uint32_t, uint32_t>, gpu::ComputePipeline> pipelines;  // by work and models

  const gpu::ComputePipeline& pipeline(uint32_t work, uint32_t models) {
    const auto found = pipelines.find({work, models});
    if (found != pipelines.end()) return found->second;
    const gpu::PipelineDesc desc{.name = "brdf probe",
                                 .spirv = spirv::brdf_probe_comp(),
                                 .bindings = {{BINDING_QUESTIONS, gpu::BindingType::storage_buffer},
                                              {BINDING_ANSWERS, gpu::BindingType::storage_buffer}},
                                 .push_bytes = sizeof(uint32_t),
                                 .constants = {{SPEC_PROBE_WORK, work}, {SPEC_PROBE_MODELS, models}}};
    return pipelines.emplace(std::pair(work, models), gpu::ComputePipeline(*device, desc)).first->second;
  }

  // Calls take(index, answer) for each question in order.
  template <class Take>
  void ask(std::span<const BrdfQuestion> all, uint32_t work, uint32_t models, const Take& take) {
    const gpu::ComputePipeline& kernel = pipeline(work, models);
    std::vector<Question> rows;
    for (size_t first = 0; first < all.size(); first += kBatch) {
      const auto batch = all.subspan(first, std::min(kBatch, all.size() - first));
      if (questions.count() < batch.size()) {
        questions = gpu::TypedBuffer<Question>(*device, "brdf questions", batch.size());
        answers = gpu::TypedBuffer<Answer>(*device, "brdf answers", batch.size());
      }
      rows.clear();
      for (const BrdfQuestion& q : batch) rows.push_back(probe::question_row(q, work == PROBE_LOBE));
      device->upload_rows(questions, 0, rows);
      const gpu::DescriptorSet set(*device, kernel, {{BINDING_QUESTIONS, questions}, {BINDING_ANSWERS, answers}});
      gpu::CommandList list = device->begin("brdf probe");
      list.bind(kernel, set);
      list.push(static_cast<uint32_t>(batch.size()));
      list.dispatch(static_cast<uint32_t>((batch.size() + PROBE_GROUP_SIZE - 1) / PROBE_GROUP_SIZE));
      const std::vector<Answer> got = device->readback_rows(answers, 0, batch.size(), device->submit(std::move(list)));
      for (size_t i = 0; i < got.size(); ++i) take(first + i, got[i]);
    }
  }
};

BrdfProbe::BrdfProbe(gpu::Device& device) : state_(std::make_unique<State>(State{.device = &device})) {}
BrdfProbe::~BrdfProbe() = default;
BrdfProbe::BrdfProbe(BrdfProbe&&) noexcept = default;
BrdfProbe& BrdfProbe::operator=(BrdfProbe&&) noexcept = default;

std::vector<BrdfValue> BrdfProbe::values(std::span<const BrdfQuestion> questions) {
  std::vector<BrdfValue> values(questions.size());
  state_->ask(questions, PROBE_EVAL, 0, [&](size_t i, const Answer& a) { values[i] = {a.value, a.pdf}; });
  return values;
}

std::vector<float> BrdfProbe::lobe_values(std::span<const BrdfQuestion> questions, uint32_t models) {
  std::vector<float> values(questions.size());
  state_->ask(questions, PROBE_LOBE, models,
              [&](size_t i, const Answer& a) { values[i] = pack_lobe(questions[i].lobe).scale * a.value; });
  return values;
}

std::vector<BrdfDraw> BrdfProbe::draws(std::span<const BrdfQuestion> questions) {
  std::vector<BrdfDraw> draws(questions.size());
  state_->ask(questions, PROBE_SAMPLE, 0, [&](size_t i, const Answer& a) {
    draws[i] = {a.wi, a.pdf, a.value, a.valid != 0};
  });
  return draws;
}

}  // namespace vamp
