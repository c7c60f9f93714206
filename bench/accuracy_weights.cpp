// Weights as floats, halves and bytes: errors of the sums that they make, and what a sum costs.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "bench/accuracy.h"
#include "bench/material.h"
#include "bench/series.h"
#include "bench/weights_shared.h"
#include "engine/core/half.h"
#include "engine/gpu/device.h"
#include "engine/material/spmm.h"
#include "engine/probe/hard_questions.h"
#include "shaders/spirv.h"

namespace vamp {
namespace {

constexpr uint32_t kPixels = 1 << 18, kFunctions = 6;
constexpr float kMost = 1;                // the largest weight
constexpr float kByte = kMost / 65025.f;  // 255^2

struct Entry {
  uint32_t basis = 0;
  vec3 weight{0};
};

struct Packed {
  std::vector<uint32_t> words;
  std::vector<vec3> weights;  // as they are read back
};

uint32_t half(float value) { return half_from_float(value); }
float back(uint32_t bits) { return float_from_half(static_cast<uint16_t>(bits)); }
uint32_t root_byte(float w) { return static_cast<uint32_t>(std::lround(std::sqrt(w / kByte))); }

Packed pack(uint32_t form, const std::vector<Entry>& entries) {
  Packed packed;
  for (const auto& [basis, w] : entries) {
    if (form == WEIGHTS_FLOAT) {
      packed.words.insert(packed.words.end(), {basis, std::bit_cast<uint32_t>(w.r), std::bit_cast<uint32_t>(w.g),
                                               std::bit_cast<uint32_t>(w.b)});
      packed.weights.push_back(w);
    } else if (form == WEIGHTS_HALF) {
      packed.words.insert(packed.words.end(), {basis | half(w.r) << 16, half(w.g) | half(w.b) << 16});
      packed.weights.emplace_back(back(half(w.r)), back(half(w.g)), back(half(w.b)));
    } else {
      const uvec3 bytes(root_byte(w.r), root_byte(w.g), root_byte(w.b));
      packed.words.push_back(basis | bytes.r << 8 | bytes.g << 16 | bytes.b << 24);
      packed.weights.push_back(kByte * vec3(bytes * bytes));
    }
  }
  return packed;
}

// Random weights over three decades, as fits have them.
std::vector<Entry> any_entries(size_t bases) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> decade(-3, 0);
  std::vector<Entry> entries;
  for (uint32_t i = 0; i < kPixels * kFunctions; ++i) {
    const auto weight = [&] { return kMost * std::pow(10.f, decade(random)); };
    const auto basis = static_cast<uint32_t>(random() % bases);
    const float r = weight(), g = weight(), b = weight();
    entries.push_back({basis, vec3(r, g, b)});
  }
  return entries;
}

// Relative errors of a pixel's sums, in double, for weights as they are read back.
RegionErrors errors_of(const std::vector<PackedLobe>& lobes, const std::vector<Entry>& entries, const Packed& packed) {
  RegionErrors errors;
  Directions random(2);
  for (size_t pixel = 0; pixel < 20000; ++pixel) {
    const dvec3 wi = random.hemisphere(), wo = random.hemisphere();
    dvec3 sum(0), truth(0);
    for (size_t e = pixel * kFunctions; e < (pixel + 1) * kFunctions; ++e) {
      const double value = lobe_value(lobes[entries[e].basis], wi, wo);
      sum += dvec3(packed.weights[e]) * value;
      truth += dvec3(entries[e].weight) * value;
    }
    for (int c = 0; c < 3; ++c)
      if (truth[c] > 1e-9) {
        const double error = std::abs(sum[c] - truth[c]) / truth[c];
        errors.all.push_back(static_cast<float>(error));
        errors.worst = std::max(errors.worst, error);
      }
  }
  return errors;
}

class Kernel {
 public:
  Kernel(gpu::Device& device, uint32_t form, const Packed& packed, const gpu::TexelView& bases)
      : device_(device),
        entries_(device, "weights", packed.words.size(), gpu::Usage::uniform_texel),
        sums_(device, "sums", kPixels) {
    constexpr VkFormat kFormats[] = {VK_FORMAT_R32G32B32A32_UINT, VK_FORMAT_R32G32_UINT, VK_FORMAT_R32_UINT};
    device.upload_rows(entries_, 0, packed.words);
    view_ = gpu::TexelView(device, entries_, kFormats[form]);
    pipeline_ = gpu::ComputePipeline(device, {.name = "weights",
                                              .spirv = spirv::weights_comp(),
                                              .bindings = {{BINDING_WEIGHT_ENTRIES, gpu::BindingType::uniform_texel},
                                                           {BINDING_WEIGHT_BASES, gpu::BindingType::uniform_texel},
                                                           {BINDING_WEIGHT_SUMS, gpu::BindingType::storage_buffer}},
                                              .push_bytes = sizeof(weights::WeightsPush),
                                              .constants = {{SPEC_WEIGHTS, form}}});
    set_ = gpu::DescriptorSet(
        device, pipeline_,
        {{BINDING_WEIGHT_ENTRIES, view_}, {BINDING_WEIGHT_BASES, bases}, {BINDING_WEIGHT_SUMS, sums_}});
  }

  void run() {
    gpu::CommandList list = device_.begin("weights");
    list.bind(pipeline_, set_);
    list.push(weights::WeightsPush{kPixels, kFunctions, kByte});
    list.dispatch(kPixels / WEIGHTS_GROUP_SIZE);
    device_.wait(device_.submit(std::move(list)));
  }

 private:
  gpu::Device& device_;
  gpu::TypedBuffer<uint32_t> entries_;
  gpu::TypedBuffer<vec3> sums_;
  gpu::TexelView view_;
  gpu::ComputePipeline pipeline_;
  gpu::DescriptorSet set_;
};

}  // namespace

void measure_weights(gpu::Device& device, const AccuracyBench& options, Report& report) {
  const SpmmPtr material = bench_material({.used = {Model::lambert, Model::oren_nayar, Model::blinn_phong, Model::ward,
                                                    Model::cook_torrance, Model::lafortune, Model::ashikhmin_shirley},
                                           .also_held = {},
                                           .residual = false});
  std::vector<PackedLobe> lobes;
  std::vector<vec4> rows;
  for (const Basis& basis : material->dictionary) {
    lobes.push_back(pack_lobe(basis.lobe));
    const PackedLobe& l = lobes.back();
    rows.emplace_back(l.k[0], l.k[1], l.k[2], l.k[3]);
    rows.emplace_back(l.scale, std::bit_cast<float>(l.tag), 0.f, 0.f);
  }
  gpu::TypedBuffer<vec4> bases(device, "functions", rows.size(), gpu::Usage::uniform_texel);
  device.upload_rows(bases, 0, rows);
  const gpu::TexelView bases_view(device, bases, VK_FORMAT_R32G32B32A32_SFLOAT);

  const std::vector<Entry> entries = any_entries(lobes.size());
  constexpr const char* kNames[] = {"floats", "halves (in use)", "roots in bytes"};
  std::vector<RegionErrors> errors;
  std::vector<Kernel> kernels;
  kernels.reserve(3);
  for (uint32_t form = 0; form < 3; ++form) {
    const Packed packed = pack(form, entries);
    errors.push_back(errors_of(lobes, entries, packed));
    kernels.emplace_back(device, form, packed, bases_view).run();
  }
  std::array<Series, 3> times;
  for (int round = 0; round < options.rounds; ++round)
    for (size_t form = 0; form < 3; ++form) {
      const Stopwatch watch;
      kernels[form].run();
      times[form].add(watch.stop());
    }
  report.table({"weights", "bytes a function", "error of a sum: median", "99.9 %", "max", "ns a function"});
  Json& data = report.data()["weights"] = Json::array();
  constexpr int kBytes[] = {16, 8, 4};
  for (size_t form = 0; form < 3; ++form) {
    const double ns = times[form].cpu() * 1e6 / (double{kPixels} * kFunctions);
    const RegionErrors& e = errors[form];
    report.row({kNames[form], std::to_string(kBytes[form]), fmt::format("{:.1e}", e.quantile(0.5)),
                fmt::format("{:.1e}", e.quantile(0.999)), fmt::format("{:.1e}", e.worst), fmt::format("{:.2f}", ns)});
    data.push_back({{"form", kNames[form]},
                    {"bytes", kBytes[form]},
                    {"median", e.quantile(0.5)},
                    {"p999", e.quantile(0.999)},
                    {"max", e.worst},
                    {"ns", ns}});
  }
}

}  // namespace vamp
