#include "engine/probe/hard_questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/brdf/kernel.h"
#include "engine/brdf/registry.h"
#include "engine/core/check.h"

namespace vamp {
namespace {

constexpr double kHorizon = 1e-6;  // the smallest cosine asked about
constexpr double kBlack = 1e-12;   // 1/sr; no picture shows digits of what is darker
constexpr double kCos80 = 0.17364817766693;

// The end of a range that budgets are promised for.
float longest(const ParameterRow& row) {
  if (row.name == "n" && row.max > 1e5f) return 1e5f;
  return row.name == "ks" ? 10.0f : row.max;
}

float any_value(const ParameterRow& row, Directions& random) {
  const double pick = random.uniform();
  if (pick < 0.1) return row.min;
  if (pick < 0.2) return longest(row);
  return std::min(longest(row), from_slider(row, static_cast<float>(random.uniform())));
}

Lobe any_lobe(Model model, uint8_t variant, Directions& random) {
  Lobe lobe = default_lobe(model, variant);
  for (const ParameterRow& row : model_row(model).parameters) {
    if (row.belongs_to(variant)) lobe.params[row.slot] = any_value(row, random);
  }
  // What is black everywhere has no relative error.
  if (lobe.params[0] == 0 && model != Model::ashikhmin_shirley) lobe.params[0] = 1;
  return lobe;
}

dvec3 tilted(dvec3 w, double angle, Directions& random) {
  const double phi = random.azimuth();
  const dvec3 moved = glm::normalize(w + angle * dvec3(std::cos(phi), std::sin(phi), random.uniform() - 0.5));
  return moved.z >= kHorizon ? moved : w;
}

dvec3 viewer(int kind, Directions& random) {
  switch (kind % 6) {
    case 0:
      return random.grazing(kHorizon, kCos80);
    case 1:
      return tilted({0, 0, 1}, std::pow(10.0, -8 * random.uniform()), random);
    case 2: {
      const double c = 0.05 + 0.95 * random.uniform(), s = std::sqrt(1 - c * c);
      return random.uniform() < 0.5 ? dvec3(s, 0, c) : dvec3(0, -s, c);
    }
    default:
      return random.grazing(kCos80, 1);
  }
}

dvec3 light(int kind, const Lobe& lobe, dvec3 wo, Directions& random) {
  const dvec3 mirror(-wo.x, -wo.y, wo.z);
  switch (kind % 9) {
    case 0:
      return tilted(mirror, std::pow(10.0, -8 * random.uniform()), random);
    case 1:
      return tilted(wo, std::pow(10.0, -8 * random.uniform()), random);
    case 2:
      return random.grazing(kHorizon, kCos80);
    case 3:
      return random.hemisphere();
    case 4: {
      // At a right angle about the normal, nearly: there the horizontal parts' product vanishes.
      const dvec3 w = random.grazing(kHorizon, 1);
      const double turn = std::atan2(wo.y, wo.x) + std::numbers::pi / 2 + std::pow(10.0, -8 * random.uniform());
      return random.at(w.z, turn);
    }
    default: {
      // Out to where the lobe has fallen to 1e-12; nearer to its peak where that lies below the horizon.
      for (double decades = 12; decades > 0.5; decades *= 0.7) {
        const LobeSample s = sample_lobe(lobe, wo, random.uniform(), 1 - std::pow(10.0, -decades * random.uniform()));
        if (s.valid && s.wi.z >= kHorizon) return s.wi;
      }
      return random.hemisphere();
    }
  }
}

// f where the lobe is brightest for this viewer, near enough: at the mirror direction, at Lafortune's axis, or beside
// the highlight where Fresnel's factor rises faster than the highlight falls.
double brightest(const Lobe& lobe, vec3 wo) {
  const dvec3 mirror(-wo.x, -wo.y, wo.z);
  double top = std::abs(brdf_f64::eval(lobe, mirror, dvec3(wo))) / mirror.z;
  if (lobe.model == Model::lafortune) {
    const auto& p = lobe.params;
    const dvec3 axis(p[1] * wo.x, p[2] * wo.y, p[3] * wo.z);
    const double length = glm::length(axis);
    if (length > 0 && axis.z > kHorizon * length)
      top = std::max(top, brdf_f64::eval(lobe, axis / length, dvec3(wo)) * length / axis.z);
  }
  const bool fresnel = lobe.model == Model::ashikhmin_shirley
                           ? lobe.params[0] < 0.02f
                           : lobe.model == Model::cook_torrance && lobe.params[2] < 0.02f;
  for (int k = 0; fresnel && k < 36; ++k) {
    const LobeSample s = sample_lobe(lobe, dvec3(wo), (k % 4) / 4.0, 1 - std::pow(10.0, -0.7 * (k / 4) - 0.3));
    if (s.valid && s.wi.z > kHorizon) top = std::max(top, s.weight * s.pdf / s.wi.z);
  }
  return top;
}

// Oren and Nayar's full model crosses zero, where relative errors mean nothing: there Lambert's value is the measure.
double least_measure(const BrdfQuestion& q) {
  const bool crosses = q.lobe.model == Model::oren_nayar && q.lobe.variant == kOrenNayarFull;
  return crosses ? static_cast<double>(q.lobe.params[0] * q.wi.z) / std::numbers::pi : 0;
}

}  // namespace

std::string words_of(const Lobe& lobe) {
  const ModelRow& row = model_row(lobe.model);
  std::string words = fmt::format("{}/{}", row.name, row.variants[lobe.variant].name);
  for (float p : lobe.params) words += fmt::format(" {}", p);
  return words;
}

[[gnu::noinline]] vec3 rounded(dvec3 w) {
  return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
}

std::string_view name_of(ErrorRegion region) {
  constexpr std::string_view kNames[] = {"core", "grazing", "tail", "deep"};
  return kNames[static_cast<size_t>(region)];
}

std::vector<BrdfQuestion> hard_questions(Model model, uint8_t variant, uint32_t seed, int lobes, int pairs) {
  Directions random(seed);
  std::vector<BrdfQuestion> questions;
  for (int l = 0; l < lobes; ++l) {
    const Lobe lobe = any_lobe(model, variant, random);
    for (int i = 0; i < pairs; ++i) {
      const vec3 wo = rounded(viewer(i, random));
      const vec3 wi = rounded(light(i / 6, lobe, dvec3(wo), random));
      if (wi.z > 0 && wo.z > 0) questions.push_back({lobe, wi, wo});
    }
  }
  return questions;
}

std::vector<Truth> truths_of(std::span<const BrdfQuestion> questions) {
  std::vector<Truth> truths;
  truths.reserve(questions.size());
  for (const BrdfQuestion& q : questions) {
    const double fcos = brdf_f64::eval(q.lobe, dvec3(q.wi), dvec3(q.wo));
    const double f = std::abs(fcos) / q.wi.z, top = std::max(f, brightest(q.lobe, q.wo));
    const bool beyond = q.wi.z < kCos80 || q.wo.z < kCos80;
    const ErrorRegion region = f < 1e-12 * top  ? ErrorRegion::deep
                               : f < 1e-3 * top ? ErrorRegion::tail
                               : beyond         ? ErrorRegion::grazing
                                                : ErrorRegion::core;
    const double measure = region == ErrorRegion::deep ? top * q.wi.z : std::max(std::abs(fcos), least_measure(q));
    truths.push_back({fcos, measure, region});
  }
  return truths;
}

double RegionErrors::quantile(double q) const {
  if (all.empty()) return 0;
  std::vector<float> sorted = all;
  const auto place = static_cast<std::ptrdiff_t>(q * static_cast<double>(sorted.size() - 1) + 0.5);
  std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
  return double{sorted[static_cast<size_t>(place)]};
}

std::array<RegionErrors, 4> errors_of(std::span<const Truth> truths, std::span<const float> fcos) {
  CHECK(truths.size() == fcos.size());
  std::array<RegionErrors, 4> errors;
  for (size_t i = 0; i < truths.size(); ++i) {
    const Truth& truth = truths[i];
    const double off = std::abs(double{fcos[i]} - truth.fcos);
    if (std::abs(truth.fcos) < kBlack && off < kBlack) continue;
    const double error = std::isfinite(off) ? off / truth.measure : std::numeric_limits<double>::infinity();
    RegionErrors& region = errors[static_cast<size_t>(truth.region)];
    region.all.push_back(static_cast<float>(error));
    if (error > region.worst) {
      region.worst = error;
      region.where = i;
    }
  }
  return errors;
}

}  // namespace vamp
