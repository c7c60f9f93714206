#include "tests/brdf/fuzz_run.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/brdf/kernel.h"
#include "engine/gpu/device.h"
#include "shaders/spirv.h"
#include "tests/brdf/fuzz.h"
#include "tests/brdf/lobes.h"

namespace vamp::test {
namespace {

using fuzz::FuzzCase;
using fuzz::FuzzFailure;
using fuzz::FuzzLobe;

// Parameters inside their rows, the ends among them, a thousand sets over all variants.
std::vector<Lobe> any_lobes() {
  Directions random(99);
  std::vector<Lobe> lobes;
  for (int round = 0; round < 64; ++round) {
    for (Lobe lobe : lobes_of_width(0.5)) {
      for (const ParameterRow& row : model_row(lobe.model).parameters) {
        if (!row.belongs_to(lobe.variant)) continue;
        lobe.params[row.slot] = from_slider(row, static_cast<float>(1.4 * random.uniform() - 0.2));
        // Plain factors are at their best at 1: a raw fit's peak times 1e4 may pass the largest float.
        if (row.name == "ks") lobe.params[row.slot] = 1;
      }
      lobes.push_back(lobe);
    }
  }
  return lobes;
}

bool may_be_negative(const Lobe& lobe) { return lobe.model == Model::oren_nayar && lobe.variant == kOrenNayarFull; }

std::string text(const Lobe& lobe, const FuzzFailure& f) {
  return words_of(lobe) + " case " + std::to_string(f.index) + " shaded " + std::to_string(f.shaded) + " value " +
         std::to_string(f.value) + " pdf " + std::to_string(f.pdf) + " weight " + std::to_string(f.weight);
}

bool fine_on_the_cpu(const Lobe& lobe, const PackedLobe& packed, const FuzzCase& c, FuzzFailure& f) {
  const bool negative = may_be_negative(lobe);
  f.shaded = brdf_f32::packed(packed.tag, packed.k, c.wi, c.wo);
  bool fine = std::isfinite(f.shaded) && (f.shaded >= 0 || negative);
  if (c.wo.z > 0 && c.wi.z > 0) {
    f.value = brdf_f32::eval(lobe, c.wi, c.wo);
    f.pdf = brdf_f32::pdf(lobe, c.wi, c.wo);
    fine = fine && std::isfinite(f.value) && (f.value >= 0 || negative) && std::isfinite(f.pdf) && f.pdf >= 0;
  }
  if (c.wo.z > 0) {
    vec3 drawn(0);
    float pdf = 0;
    const bool valid = brdf_f32::sample(lobe, c.wo, c.u.x, c.u.y, drawn, pdf, f.weight);
    fine = fine && (!valid || (std::isfinite(f.weight) && std::isfinite(pdf) &&
                               std::isfinite(drawn.x + drawn.y + drawn.z) && drawn.z > 0));
  }
  return fine;
}

}  // namespace

void expect_numbers_on_the_cpu(uint64_t count, uint32_t seed) {
  const std::vector<Lobe> lobes = any_lobes();
  std::vector<PackedLobe> packed;
  for (const Lobe& lobe : lobes) packed.push_back(pack_lobe(lobe));
  int failures = 0;
  for (uint64_t i = 0; i < count && failures < 16; ++i) {
    const size_t l = i % lobes.size();
    FuzzFailure f{.index = static_cast<uint32_t>(i)};
    const FuzzCase c = fuzz::fuzz_case(f.index, seed);
    if (fine_on_the_cpu(lobes[l], packed[l], c, f)) continue;
    ++failures;
    ADD_FAILURE() << text(lobes[l], f) << " wi " << c.wi.x << " " << c.wi.y << " " << c.wi.z << " wo " << c.wo.x << " "
                  << c.wo.y << " " << c.wo.z;
  }
}

void expect_numbers_on_the_device(gpu::Device& device, uint64_t count, uint32_t seed) {
  const std::vector<Lobe> lobes = any_lobes();
  std::vector<FuzzLobe> rows;
  for (const Lobe& lobe : lobes) {
    const PackedLobe packed = pack_lobe(lobe);
    const auto& p = lobe.params;
    rows.push_back({static_cast<uint32_t>(lobe.model), lobe.variant, packed.tag, may_be_negative(lobe) ? 1u : 0u, p[0],
                    p[1], p[2], p[3], p[4], p[5], packed.k[0], packed.k[1], packed.k[2], packed.k[3]});
  }
  const gpu::TypedBuffer<FuzzLobe> lobe_buffer(device, "fuzz lobes", rows.size());
  device.upload_rows(lobe_buffer, 0, rows);
  const gpu::Buffer failures(device, {.name = "fuzz failures", .bytes = 4 + FUZZ_KEPT * sizeof(FuzzFailure)});
  const gpu::ComputePipeline pipeline(device, {.name = "brdf fuzz",
                                               .spirv = spirv::fuzz_comp(),
                                               .bindings = {{FUZZ_LOBES, gpu::BindingType::storage_buffer},
                                                            {FUZZ_FAILURES, gpu::BindingType::storage_buffer}},
                                               .push_bytes = sizeof(fuzz::FuzzPush)});
  const gpu::DescriptorSet set(device, pipeline, {{FUZZ_LOBES, lobe_buffer}, {FUZZ_FAILURES, failures}});
  gpu::CommandList clear = device.begin();
  clear.fill(failures, 0);
  uint64_t last = device.submit(std::move(clear));
  constexpr uint32_t kGroups = 16384, kDispatch = kGroups * 64;
  for (uint64_t first = 0; first < count; first += kDispatch) {
    gpu::CommandList list = device.begin();
    list.bind(pipeline, set);
    list.push(fuzz::FuzzPush{static_cast<uint32_t>(first), seed, static_cast<uint32_t>(rows.size())});
    list.dispatch(kGroups);
    last = device.submit(std::move(list));
  }
  uint32_t failed = 0;
  device.readback(failures, 0, std::as_writable_bytes(std::span(&failed, 1)), last);
  EXPECT_EQ(failed, 0u);
  std::vector<FuzzFailure> kept(std::min(failed, FUZZ_KEPT));
  if (kept.empty()) return;
  device.readback(failures, 4, std::as_writable_bytes(std::span(kept)), last);
  for (const FuzzFailure& f : kept) {
    ADD_FAILURE() << text(lobes[f.lobe], f) << " wi " << f.wi.x << " " << f.wi.y << " " << f.wi.z << " wo " << f.wo.x
                  << " " << f.wo.y << " " << f.wo.z;
  }
}

}  // namespace vamp::test
