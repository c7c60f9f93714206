#include "engine/brdf/lobe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/brdf/kernel.h"

namespace vamp {
namespace {

constexpr double kUnitSlack = 2e-6;  // of the squared length

// 0 for what is no direction.
dvec3 unit_direction(dvec3 w) {
  const double length2 = glm::dot(w, w);
  if (std::abs(length2 - 1) <= kUnitSlack) return w;
  return length2 > 0 && std::isfinite(length2) ? w / std::sqrt(length2) : dvec3(0);
}

// Whether turning wi and wo together about the normal changes the lobe.
bool is_anisotropic(const Lobe& lobe) {
  const auto& p = lobe.params;
  switch (lobe.model) {
    case Model::ward:
      return p[1] != p[2];
    case Model::lafortune:
      return p[1] != p[2];
    case Model::ashikhmin_shirley:
      return p[2] != p[3];
    default:
      return false;
  }
}

}  // namespace

vec3 unit_direction(vec3 w) { return vec3(unit_direction(dvec3(w))); }

double fcos(const Lobe& lobe, dvec3 wi, dvec3 wo) {
  const dvec3 i = unit_direction(wi), o = unit_direction(wo);
  return i.z > 0 && o.z > 0 ? brdf_f64::eval(lobe, i, o) : 0;
}

float fcos(const Lobe& lobe, vec3 wi, vec3 wo) {
  const vec3 i = unit_direction(wi), o = unit_direction(wo);
  return i.z > 0 && o.z > 0 ? brdf_f32::eval(lobe, i, o) : 0;
}

float lobe_value(const PackedLobe& lobe, vec3 wi, vec3 wo) {
  return lobe.scale * brdf_f32::packed(lobe.tag, lobe.k, wi, wo);
}

double lobe_value(const PackedLobe& lobe, dvec3 wi, dvec3 wo) {
  return lobe.scale * brdf_f64::packed(lobe.tag, lobe.k, wi, wo);
}

LobeSample sample_lobe(const Lobe& lobe, dvec3 wo, double u0, double u1) {
  LobeSample s;
  s.valid = brdf_f64::sample(lobe, wo, u0, u1, s.wi, s.pdf, s.weight);
  return s;
}

LobeSample sample_lobe(const Lobe& lobe, vec3 wo, float u0, float u1) {
  LobeSample s;
  vec3 wi(0);
  float pdf = 0, weight = 0;
  s.valid = brdf_f32::sample(lobe, wo, u0, u1, wi, pdf, weight);
  s.wi = dvec3(wi);
  s.pdf = pdf;
  s.weight = weight;
  return s;
}

double lobe_pdf(const Lobe& lobe, dvec3 wi, dvec3 wo) { return brdf_f64::pdf(lobe, wi, wo); }
float lobe_pdf(const Lobe& lobe, vec3 wi, vec3 wo) { return brdf_f32::pdf(lobe, wi, wo); }

float lobe_albedo(const Lobe& lobe, float cos_theta_o) {
  // The sampler turns the lobe into a smooth weight on the square; midpoints there are the quadrature.
  constexpr int kSide = 24;
  const double oz = std::clamp(static_cast<double>(cos_theta_o), 1e-4, 1.0);
  const double so = std::sqrt(1 - oz * oz);
  const int azimuths = is_anisotropic(lobe) ? 4 : 1;
  double sum = 0;
  for (int a = 0; a < azimuths; ++a) {
    const double phi = std::numbers::pi / 8 * (2 * a + 1) / 2;  // by symmetry a quarter turn is enough
    const dvec3 wo(so * std::cos(phi), so * std::sin(phi), oz);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const LobeSample s = sample_lobe(lobe, wo, (x + 0.5) / kSide, (y + 0.5) / kSide);
        if (s.valid) sum += s.weight;
      }
    }
  }
  return static_cast<float>(sum / (azimuths * kSide * kSide));
}

}  // namespace vamp
