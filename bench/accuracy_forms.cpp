#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/accuracy.h"
#include "bench/forms.h"
#include "engine/brdf/registry.h"
#include "engine/gpu/device.h"
#include "engine/probe/hard_questions.h"

namespace vamp {
namespace {

using Errors = std::array<RegionErrors, 4>;

// Whose errors stand in a row of the tables.
struct Machine {
  Errors robust, textbook, lobe;
  double robust_ns = 0, textbook_ns = 0, lobe_ns = 0;
};

struct Measured {
  std::string name;
  bool usual = false;  // the model's default variant
  size_t questions = 0;
  Machine cpu, device;
};

// What the code that pictures are shaded with does not promise, beside its window below a cosine of 0.03: it knows
// where Lafortune's sum crosses 0 no better than its terms, so that with n < 4 the edge of the lobe has no digits; and
// a raw lobe whose peak is beyond 1e20 ends 35 decades below it.
bool beyond_lobe_code(const BrdfQuestion& q) {
  if (q.wo.z < 0.03f) return true;
  if (q.lobe.model != Model::lafortune) return false;
  const auto& p = q.lobe.params;
  const float top = std::max({std::abs(p[1]), std::abs(p[2]), std::abs(p[3])});
  return p[4] < 4 || (q.lobe.variant == kLafortuneRaw && std::abs(p[4] * std::log10(top)) > 20);
}

Measured measure(FormProbe& probe, const ModelRow& model, uint8_t variant, const AccuracyBench& options) {
  Measured m;
  m.name = fmt::format("{}/{}", model.name, model.variants[variant].name);
  m.usual = variant == model.default_variant;
  std::vector<BrdfQuestion> questions = hard_questions(model.model, variant, 1, options.lobes, options.pairs);
  m.questions = questions.size();
  std::vector<Truth> truths = truths_of(questions);
  m.cpu.robust = errors_of(truths, cpu_values(Form::robust, questions));
  m.cpu.textbook = errors_of(truths, cpu_values(Form::textbook, questions));
  m.device.robust = errors_of(truths, probe.values(Form::robust, questions));
  m.device.textbook = errors_of(truths, probe.values(Form::textbook, questions));

  size_t kept = 0;
  for (size_t i = 0; i < questions.size(); ++i)
    if (!beyond_lobe_code(questions[i])) {
      questions[kept] = questions[i];
      truths[kept++] = truths[i];
    }
  questions.resize(kept);
  truths.resize(kept);
  m.cpu.lobe = errors_of(truths, cpu_values(Form::lobe, questions));
  m.device.lobe = errors_of(truths, probe.values(Form::lobe, questions));

  // What every form pays for the loop about it is not theirs.
  const std::span<const BrdfQuestion> few(questions.data(), std::min<size_t>(questions.size(), 1 << 14));
  const auto cpu = [&](Form form) { return cpu_nanoseconds(form, few, options.rounds); };
  const auto device = [&](Form form) { return probe.nanoseconds(form, few, options.rounds); };
  const double cpu_loop = cpu(Form::none), device_loop = device(Form::none);
  m.cpu.robust_ns = cpu(Form::robust) - cpu_loop;
  m.cpu.textbook_ns = cpu(Form::textbook) - cpu_loop;
  m.cpu.lobe_ns = cpu(Form::lobe) - cpu_loop;
  m.device.robust_ns = device(Form::robust) - device_loop;
  m.device.textbook_ns = device(Form::textbook) - device_loop;
  m.device.lobe_ns = device(Form::lobe) - device_loop;
  return m;
}

std::string words_of(const RegionErrors& errors) {
  if (errors.all.empty()) return "-";
  return fmt::format("{:.0e} / {:.0e} / {:.1e}", errors.quantile(0.5), errors.quantile(0.999), errors.worst);
}

void add_errors(const std::vector<Measured>& all, ErrorRegion region, Report& report) {
  const auto at = static_cast<size_t>(region);
  report.table({fmt::format("{}: median / 99.9 % / max", name_of(region)), "CPU robust", "CPU textbook",
                "device robust", "device textbook", "device lobe code"});
  for (const Measured& m : all)
    report.row({m.name, words_of(m.cpu.robust[at]), words_of(m.cpu.textbook[at]), words_of(m.device.robust[at]),
                words_of(m.device.textbook[at]), words_of(m.device.lobe[at])});
}

void add_costs(const std::vector<Measured>& all, Report& report) {
  report.table({"ns an evaluation", "CPU robust", "CPU textbook", "device robust", "device textbook",
                "device lobe code, this model alone"});
  const auto ns = [](double value) { return fmt::format("{:.1f}", value); };
  for (const Measured& m : all)
    report.row({m.name, ns(m.cpu.robust_ns), ns(m.cpu.textbook_ns), ns(m.device.robust_ns), ns(m.device.textbook_ns),
                ns(m.device.lobe_ns)});
}

// JSON has no infinite numbers.
Json number_of(double error) { return std::isfinite(error) ? Json(error) : Json(nullptr); }

Json json_of(const Errors& errors) {
  Json json = Json::object();
  for (const ErrorRegion region : kErrorRegions) {
    const RegionErrors& e = errors[static_cast<size_t>(region)];
    json[std::string(name_of(region))] = {{"count", e.all.size()},
                                          {"median", number_of(e.quantile(0.5))},
                                          {"p999", number_of(e.quantile(0.999))},
                                          {"max", number_of(e.worst)}};
  }
  return json;
}

Json json_of(const Machine& m) {
  return {{"robust", {{"errors", json_of(m.robust)}, {"ns", m.robust_ns}}},
          {"textbook", {{"errors", json_of(m.textbook)}, {"ns", m.textbook_ns}}},
          {"lobe_code", {{"errors", json_of(m.lobe)}, {"ns", m.lobe_ns}}}};
}

// Error of the core at 99.9 % over cost, logarithmic: the robust form a dot, the textbook's a ring, a line between
// them.
Figure plot(const std::vector<Measured>& all) {
  constexpr float kLeft = 70, kTop = 50, kWidth = 340, kHeight = 330, kGap = 90;
  constexpr double kLeast = 1e-8, kMost = 1;  // of errors; what is beyond stands on the frame
  constexpr double kFastest = 0.1;            // ns; what is faster likewise
  constexpr vec3 kGrid(0.85f);
  constexpr vec3 kColours[] = {{0.35f, 0.35f, 0.35f}, {0.62f, 0.45f, 0.20f}, {0.12f, 0.35f, 0.65f},
                               {0.80f, 0.37f, 0.08f}, {0.18f, 0.52f, 0.28f}, {0.62f, 0.16f, 0.22f},
                               {0.42f, 0.30f, 0.60f}};
  double slowest = 1, fastest = 1e9;
  for (const Measured& m : all)
    for (const double ns : {m.cpu.robust_ns, m.cpu.textbook_ns, m.device.robust_ns, m.device.textbook_ns})
      slowest = std::max(slowest, ns), fastest = std::min(fastest, std::max(ns, kFastest));
  const double low = std::floor(std::log10(fastest)), high = std::ceil(std::log10(slowest));
  Figure figure(2 * static_cast<int>(kLeft + kWidth) + 40, 470);
  const auto panel = [&](float left, const char* title, const Machine Measured::*machine) {
    const auto at = [&](double ns, double error) {
      const double x = (std::log10(std::max(ns, kFastest)) - low) / (high - low);
      const double y = std::log10(std::clamp(error, kLeast, kMost) / kLeast) / std::log10(kMost / kLeast);
      return vec2(left + kWidth * static_cast<float>(x), kTop + kHeight * static_cast<float>(1 - y));
    };
    for (int d = 0; d <= 8; ++d) {
      const double error = kLeast * std::pow(10.0, d);
      figure.line({at(std::pow(10, low), error), at(std::pow(10, high), error)}, kGrid);
      figure.words(at(std::pow(10, low), error) - vec2(8, 0), fmt::format("{:.0e}", error), 11, Anchor::right);
    }
    for (double d = low; d <= high; ++d) {
      const double ns = std::pow(10, d);
      figure.line({at(ns, kLeast), at(ns, kMost)}, kGrid);
      figure.words(at(ns, kLeast) + vec2(0, 14), fmt::format("{:g}", ns), 11, Anchor::middle);
    }
    figure.words(vec2(left + kWidth / 2, kTop - 16), title, 13, Anchor::middle);
    figure.words(vec2(left + kWidth / 2, kTop + kHeight + 34), "ns an evaluation", 12, Anchor::middle);
    size_t colour = 0;
    for (const Measured& m : all) {
      if (!m.usual) continue;
      const Machine& on = m.*machine;
      const auto core = static_cast<size_t>(ErrorRegion::core);
      const vec2 robust = at(on.robust_ns, on.robust[core].quantile(0.999));
      const vec2 textbook = at(on.textbook_ns, on.textbook[core].quantile(0.999));
      const vec3 c = kColours[colour++ % std::size(kColours)];
      figure.line({robust, textbook}, c, 1);
      figure.area(robust - 4.0f, vec2(8), c);
      for (const float side : {-4.0f, 4.0f}) {
        figure.line({textbook + vec2(-4, side), textbook + vec2(4, side)}, c, 2);
        figure.line({textbook + vec2(side, -4), textbook + vec2(side, 4)}, c, 2);
      }
      if (left < kLeft + 1)
        figure.words(vec2(kLeft + 110 * static_cast<float>(colour - 1), kTop + kHeight + 66),
                     m.name.substr(0, m.name.find('/')), 11, Anchor::left, c);
    }
  };
  panel(kLeft, "CPU, float build", &Measured::cpu);
  panel(kLeft + kWidth + kGap, "device", &Measured::device);
  figure.words(vec2(16, 16), "Error of fcos in the core, 99.9 %, by cost: robust form filled, textbook form open", 13,
               Anchor::left);
  return figure;
}

}  // namespace

Plot measure_forms(gpu::Device& device, const AccuracyBench& options, Report& report) {
  FormProbe probe(device);
  std::vector<Measured> all;
  for (const ModelRow& model : models())
    for (uint8_t v = 0; v < model.variants.size(); ++v) all.push_back(measure(probe, model, v, options));
  for (const ErrorRegion region : kErrorRegions) add_errors(all, region, report);
  add_costs(all, report);
  Json& json = report.data()["forms"] = Json::object();
  for (const Measured& m : all)
    json[m.name] = {{"questions", m.questions}, {"cpu", json_of(m.cpu)}, {"device", json_of(m.device)}};
  return {"forms", plot(all)};
}

}  // namespace vamp
