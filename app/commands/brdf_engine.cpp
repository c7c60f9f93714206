#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <numbers>

#include "app/commands/brdf.h"
#include "app/commands/option_values.h"
#include "engine/brdf/kernel.h"
#include "engine/brdf/registry.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

bool above(vec3 w) { return w.z > 0; }

// What the kernels are asked: unit vectors, both above the horizon. The others' answer is known.
void prepare(std::vector<BrdfQuestion>& questions) {
  for (BrdfQuestion& q : questions) {
    q.wi = unit_direction(q.wi);
    q.wo = unit_direction(q.wo);
  }
}

}  // namespace

BrdfEngine::BrdfEngine(BrdfEngine&&) noexcept = default;
BrdfEngine::~BrdfEngine() = default;

Result<BrdfEngine> BrdfEngine::open(const std::string& on, const CommonOptions& common) {
  BrdfEngine engine;
  engine.build_ = on == "gpu" ? Build::gpu : on == "cpu" ? Build::cpu : Build::oracle;
  if (engine.build_ == Build::gpu) {
    VAMP_TRY(engine.device_, open_device(common));
    engine.probe_ = std::make_unique<BrdfProbe>(*engine.device_);
  }
  return engine;
}

std::vector<BrdfEngine::Value> BrdfEngine::values(std::vector<BrdfQuestion> questions) {
  prepare(questions);
  std::vector<Value> values(questions.size());
  std::vector<BrdfValue> answers;
  if (build_ == Build::gpu) answers = probe_->values(questions);
  for (size_t i = 0; i < questions.size(); ++i) {
    const auto& [lobe, wi, wo, u] = questions[i];
    if (!above(wi) || !above(wo)) continue;
    if (build_ == Build::gpu) {
      values[i] = {answers[i].fcos, answers[i].pdf};
    } else if (build_ == Build::cpu) {
      values[i] = {brdf_f32::eval(lobe, wi, wo), brdf_f32::pdf(lobe, wi, wo)};
    } else {
      values[i] = {brdf_f64::eval(lobe, dvec3(wi), dvec3(wo)), brdf_f64::pdf(lobe, dvec3(wi), dvec3(wo))};
    }
  }
  return values;
}

std::vector<BrdfEngine::Draw> BrdfEngine::draws(std::vector<BrdfQuestion> questions) {
  prepare(questions);
  std::vector<Draw> draws(questions.size());
  std::vector<BrdfDraw> answers;
  if (build_ == Build::gpu) answers = probe_->draws(questions);
  for (size_t i = 0; i < questions.size(); ++i) {
    const auto& [lobe, wi, wo, u] = questions[i];
    if (!above(wo)) continue;
    if (build_ == Build::gpu) {
      draws[i] = {dvec3(answers[i].wi), answers[i].pdf, answers[i].weight, answers[i].valid};
    } else {
      const LobeSample s =
          build_ == Build::cpu ? sample_lobe(lobe, wo, u.x, u.y) : sample_lobe(lobe, dvec3(wo), u.x, u.y);
      draws[i] = {s.wi, s.pdf, s.weight, s.valid};
    }
  }
  return draws;
}

std::string BrdfEngine::print(double value) const {
  // The quotient of two floats may be beyond the largest float: digits are cut, not the range.
  return build_ == Build::oracle ? fmt::format("{}", value) : fmt::format("{:.9g}", value);
}

void add_engine_option(CLI::App& verb, std::string& on) {
  on = "cpu";
  verb.add_option("--on", on, "Where: on the Vulkan device, in C++ float, or in C++ double from the same floats")
      ->type_name("gpu|cpu|double")
      ->check(CLI::IsMember({"gpu", "cpu", "double"}).description(""))
      ->capture_default_str();
}

void add_lobe_words(CLI::App& verb, LobeWords& words, bool required) {
  verb.add_option("model", words.model, "One of `vamp brdf list`, with its usual variant or another: ward/duer")
      ->type_name("MODEL[/VARIANT]")
      ->required(required);
  verb.add_option("parameters", words.parameters, "Parameters as `vamp brdf list` shows them, angles in degrees")
      ->type_name("NAME=VALUE");
}

Result<Lobe> lobe_of(const LobeWords& words) {
  const size_t slash = words.model.find('/');
  const std::string model_name = words.model.substr(0, slash);
  const auto model = find_model(model_name);
  if (!model) return fail(ErrorKind::usage, "", "model", "one of `vamp brdf list`", "\"" + model_name + "\"");
  const ModelRow& row = model_row(*model);
  uint8_t variant = row.default_variant;
  if (slash != std::string::npos) {
    const std::string variant_name = words.model.substr(slash + 1);
    const auto found = find_variant(*model, variant_name);
    if (!found)
      return fail(ErrorKind::usage, "", model_name, "a variant of `vamp brdf list`", "\"" + variant_name + "\"");
    variant = *found;
  }
  Lobe lobe = default_lobe(*model, variant);
  for (const std::string& word : words.parameters) {
    VAMP_TRY(const auto pair, pair_option(word, model_name));
    const ParameterRow* parameter = find_parameter(*model, variant, pair.first);
    if (!parameter)
      return fail(ErrorKind::usage, "", model_name, "a parameter of `vamp brdf list`",
                  fmt::format("\"{}\"", pair.first));
    const float factor = parameter->display_factor();
    VAMP_TRY(const float value, number_option(pair.second, fmt::format("{} {}", model_name, pair.first),
                                              parameter->min * factor, parameter->max * factor));
    lobe.params[parameter->slot] = std::clamp(value / factor, parameter->min, parameter->max);
  }
  return lobe;
}

Result<std::vector<double>> angles_option(const std::string& text, const char* option) {
  std::vector<double> angles;
  for (const std::string_view piece : list_option(text)) {
    VAMP_TRY(const float angle, number_option(piece, option, 0, kMaxTheta));
    angles.push_back(static_cast<double>(angle));
  }
  return angles;
}

vec3 direction_at(double theta, double phi) {
  const double radians = std::numbers::pi / 180, t = theta * radians, p = phi * radians;
  return vec3(dvec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)));
}

}  // namespace vamp
