// The device computes what the C++ float build of the same text computes.
#include <gtest/gtest.h>

#include <array>

#include "engine/brdf/kernel.h"
#include "engine/gpu/device.h"
#include "shaders/spirv.h"
#include "tests/brdf/lobes.h"

namespace vamp {
namespace {

using test::Directions;
using test::lobes_of_width;
using test::name_of;
using test::rounded;

// probe.comp has the same.
struct Probe {
  float wi[3];
  uint32_t tag;
  float wo[3];
  int32_t model;
  float k[4];
  int32_t variant;
  float p[6];
  float u0, u1;
  float lobe, value, density;
  float drawn[3];
  int32_t valid;
  float pdf, weight;
  float unused[2];
};
static_assert(sizeof(Probe) == 128);

vec3 vector(const float w[3]) { return {w[0], w[1], w[2]}; }

struct Case {
  Lobe lobe;
  PackedLobe packed;
};

class BrdfOnTheDevice : public testing::Test {
 protected:
  void SetUp() override {
    auto made = gpu::Device::create({});
    ASSERT_TRUE(made) << made.error().message();
    device_ = std::move(*made);
  }

  std::vector<Probe> run(const std::vector<Probe>& probes, uint32_t mask) {
    const gpu::TypedBuffer<Probe> buffer(*device_, "probes", probes.size());
    device_->upload_rows(buffer, 0, probes);
    const gpu::ComputePipeline pipeline(*device_, {.name = "brdf probe",
                                                   .spirv = spirv::probe_comp(),
                                                   .bindings = {{0, gpu::BindingType::storage_buffer}},
                                                   .push_bytes = 0,
                                                   .constants = {{0, mask}}});
    const gpu::DescriptorSet set(*device_, pipeline, {{0, buffer}});
    gpu::CommandList list = device_->begin("brdf probe");
    list.bind(pipeline, set);
    list.dispatch(static_cast<uint32_t>((probes.size() + 63) / 64));
    return device_->readback_rows(buffer, 0, probes.size(), device_->submit(std::move(list)));
  }

  std::unique_ptr<gpu::Device> device_;
};

// Lights near the highlight, as many for each variant and width.
void make_probes(std::vector<Case>& cases, std::vector<Probe>& probes) {
  Directions random(1);
  for (double width : {0.0, 0.5, 1.0}) {
    for (const Lobe& lobe : lobes_of_width(width)) {
      const PackedLobe packed = pack_lobe(lobe);
      for (int i = 0; i < 200; ++i) {
        const vec3 wo = rounded(random.grazing(i % 2 ? 1e-3 : 0.17, 1));
        const LobeSample s = sample_lobe(lobe, dvec3(wo), random.uniform(), random.uniform());
        const vec3 wi = rounded(s.valid ? s.wi : random.grazing(1e-3, 1));
        Probe probe{.wi = {wi.x, wi.y, wi.z},
                    .tag = packed.tag,
                    .wo = {wo.x, wo.y, wo.z},
                    .model = static_cast<int32_t>(lobe.model),
                    .k = {packed.k[0], packed.k[1], packed.k[2], packed.k[3]},
                    .variant = lobe.variant,
                    .p = {},
                    .u0 = static_cast<float>(random.uniform()) * 0.999f,
                    .u1 = static_cast<float>(random.uniform()) * 0.999f};
        std::copy(lobe.params.begin(), lobe.params.end(), probe.p);
        cases.push_back({lobe, packed});
        probes.push_back(probe);
      }
    }
  }
}

double relative(double a, double b) { return std::abs(a - b) / std::max({std::abs(a), std::abs(b), 1e-30}); }

TEST_F(BrdfOnTheDevice, EqualsTheCpuBuildOfTheSameText) {
  std::vector<Case> cases;
  std::vector<Probe> probes;
  make_probes(cases, probes);
  const std::vector<Probe> results = run(probes, 2047);
  size_t same = 0;
  for (size_t i = 0; i < probes.size(); ++i) {
    const Probe& r = results[i];
    const Lobe& lobe = cases[i].lobe;
    const vec3 wi = vector(r.wi), wo = vector(r.wo);
    const float value = brdf_f32::eval(lobe, wi, wo), packed = brdf_f32::packed(r.tag, r.k, wi, wo);
    same += r.value == value && r.lobe == packed;
    EXPECT_LE(relative(r.value, value), 3e-5) << name_of(lobe);
    EXPECT_LE(relative(r.lobe, packed), 3e-5) << name_of(lobe);
    EXPECT_LE(relative(r.density, lobe_pdf(lobe, wi, wo)), 3e-5) << name_of(lobe);
    const LobeSample s = sample_lobe(lobe, wo, r.u0, r.u1);
    EXPECT_EQ(r.valid != 0, s.valid) << name_of(lobe);
    if (s.valid) {
      EXPECT_LE(glm::length(dvec3(vector(r.drawn)) - s.wi), 1e-6) << name_of(lobe);
    }
  }
  RecordProperty("same_bits_percent", static_cast<int>(100 * same / probes.size()));
}

TEST_F(BrdfOnTheDevice, StaysWithinTheCoreBudgetOfTheOracle) {
  std::vector<Case> cases;
  std::vector<Probe> probes;
  make_probes(cases, probes);
  const std::vector<Probe> results = run(probes, 2047);
  for (size_t i = 0; i < probes.size(); ++i) {
    const Probe& r = results[i];
    const vec3 wi = vector(r.wi), wo = vector(r.wo);
    if (wi.z < 0.174f || wo.z < 0.174f) continue;
    const Lobe& lobe = cases[i].lobe;
    const double truth = brdf_f64::eval(lobe, dvec3(wi), dvec3(wo));
    if (truth < 1e-3 * brdf_f64::eval(lobe, dvec3(-wo.x, -wo.y, wo.z), dvec3(wo))) continue;
    const double budget = lobe.model == Model::lafortune ? 1e-4 : 3e-5;
    EXPECT_LE(relative(r.value, truth), budget) << name_of(lobe);
    EXPECT_LE(relative(static_cast<double>(cases[i].packed.scale) * r.lobe, truth), budget) << name_of(lobe);
  }
}

TEST_F(BrdfOnTheDevice, SpecialisedKernelsGiveTheSameBits) {
  std::vector<Case> cases;
  std::vector<Probe> probes;
  make_probes(cases, probes);
  const std::vector<Probe> all = run(probes, 2047);
  for (uint32_t mask : {1u, 2u, 4u, 8u, 16u, 32u, 64u, 127u, 1088u}) {
    const std::vector<Probe> some = run(probes, mask);
    for (size_t i = 0; i < probes.size(); ++i) {
      if ((lobe_models_bit(cases[i].lobe) & ~mask) != 0) continue;
      EXPECT_EQ(some[i].lobe, all[i].lobe) << name_of(cases[i].lobe) << " with models " << mask;
    }
  }
}

}  // namespace
}  // namespace vamp
