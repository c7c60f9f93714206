#include "tests/brdf/published.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vamp::test {
namespace {

using Real = long double;
constexpr Real kPi = std::numbers::pi_v<Real>;

struct Geometry {
  Real ix, iy, iz, ox, oy, oz, hx, hy, hz, oh;
};

Geometry geometry(dvec3 wi, dvec3 wo) {
  Geometry g{wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, 0, 0, 0, 0};
  const Real li = std::sqrt(g.ix * g.ix + g.iy * g.iy + g.iz * g.iz),
             lo = std::sqrt(g.ox * g.ox + g.oy * g.oy + g.oz * g.oz);
  g.ix /= li, g.iy /= li, g.iz /= li, g.ox /= lo, g.oy /= lo, g.oz /= lo;
  const Real x = g.ix + g.ox, y = g.iy + g.oy, z = g.iz + g.oz, length = std::sqrt(x * x + y * y + z * z);
  g.hx = x / length, g.hy = y / length, g.hz = z / length;
  g.oh = g.ox * g.hx + g.oy * g.hy + g.oz * g.hz;
  return g;
}

Real oren_nayar(bool full, Real rho, Real sigma, const Geometry& g) {
  const Real s2 = sigma * sigma, ti = std::acos(g.iz), to = std::acos(g.oz);
  const Real alpha = std::max(ti, to), beta = std::min(ti, to);
  const Real c = std::cos(std::atan2(g.iy, g.ix) - std::atan2(g.oy, g.ox));
  const Real c1 = 1 - 0.5L * s2 / (s2 + 0.33L);
  if (!full) {
    const Real b = 0.45L * s2 / (s2 + 0.09L);
    return rho / kPi * g.iz * (c1 + b * std::max<Real>(0, c) * std::sin(alpha) * std::tan(beta));
  }
  const Real c2 = 0.45L * s2 / (s2 + 0.09L) * (std::sin(alpha) - (c >= 0 ? 0 : std::pow(2 * beta / kPi, 3.0L)));
  const Real c3 = 0.125L * s2 / (s2 + 0.09L) * std::pow(4 * alpha * beta / (kPi * kPi), 2.0L);
  const Real l1 =
      rho / kPi * g.iz * (c1 + c * c2 * std::tan(beta) + (1 - std::abs(c)) * c3 * std::tan((alpha + beta) / 2));
  const Real l2 = 0.17L * rho * rho / kPi * g.iz * s2 / (s2 + 0.13L) * (1 - c * std::pow(2 * beta / kPi, 2.0L));
  return l1 + l2;
}

Real schlick(Real f0, Real c) { return f0 + (1 - f0) * std::pow(1 - c, 5.0L); }

Real fresnel(Real eta, Real c) {
  const Real g = std::sqrt(eta * eta - 1 + c * c);
  const Real a = (g - c) / (g + c), b = (c * (g + c) - 1) / (c * (g - c) + 1);
  return 0.5L * a * a * (1 + b * b);
}

Real ward(uint8_t variant, Real ks, Real ax, Real ay, const Geometry& g) {
  const Real tan2 = (g.hx * g.hx / (ax * ax) + g.hy * g.hy / (ay * ay)) / (g.hz * g.hz);
  const Real gauss = ks * std::exp(-tan2) / (4 * kPi * ax * ay);
  if (variant == kWard1992) return gauss / std::sqrt(g.iz * g.oz) * g.iz;
  if (variant == kWardDuer) return gauss / (g.iz * g.oz) * g.iz;
  return gauss / (g.oh * g.oh * std::pow(g.hz, 4.0L)) * g.iz;
}

Real cook_torrance(uint8_t variant, Real ks, Real m, Real f0_or_ior, const Geometry& g) {
  const bool exact = variant == kCookTorranceModernExact || variant == kCookTorrance1982Exact;
  const Real f = exact ? fresnel(f0_or_ior, g.oh) : schlick(f0_or_ior, g.oh);
  const Real beckmann = std::exp(-(1 - g.hz * g.hz) / (g.hz * g.hz * m * m)) / (m * m * std::pow(g.hz, 4.0L));
  const Real shadow = std::min<Real>({1, 2 * g.hz * g.oz / g.oh, 2 * g.hz * g.iz / g.oh});
  const Real constant = variant == kCookTorranceNganSchlick   ? kPi * kPi
                        : variant >= kCookTorrance1982Schlick ? kPi
                                                              : 4 * kPi;
  return ks * f * beckmann * shadow / (constant * g.iz * g.oz) * g.iz;
}

Real lafortune(uint8_t variant, Real ks, Real cx, Real cy, Real cz, Real n, const Geometry& g) {
  const Real sum = cx * g.ix * g.ox + cy * g.iy * g.oy + cz * g.iz * g.oz;
  if (sum <= 0) return 0;
  if (variant == kLafortuneRaw) return ks * std::pow(sum, n) * g.iz;
  const Real top = std::max({std::abs(cx), std::abs(cy), std::abs(cz)});
  return ks * (n + 2) / (2 * kPi) * std::pow(sum / top, n) * g.iz;
}

Real ashikhmin_shirley(uint8_t variant, Real rs, Real rd, Real nu, Real nv, const Geometry& g) {
  Real f = 0;
  if (variant != kAshikhminShirleyDiffuse) {
    const Real exponent = (nu * g.hx * g.hx + nv * g.hy * g.hy) / (g.hx * g.hx + g.hy * g.hy);
    f += std::sqrt((nu + 1) * (nv + 1)) / (8 * kPi) * std::pow(g.hz, exponent) * schlick(rs, g.oh) /
         (g.oh * std::max(g.iz, g.oz));
  }
  if (variant != kAshikhminShirleySpecular) {
    f += 28 / (23 * kPi) * rd * (1 - rs) * (1 - std::pow(1 - g.iz / 2, 5.0L)) * (1 - std::pow(1 - g.oz / 2, 5.0L));
  }
  return f * g.iz;
}

Real blinn_phong(uint8_t variant, Real ks, Real n, const Geometry& g) {
  const Real norms[] = {1, (n + 2) * (n + 4) / (8 * kPi * (std::pow(2.0L, -n / 2) + n)), (n + 2) / (2 * kPi),
                        (n + 8) / (8 * kPi)};
  return ks * norms[variant] * std::pow(g.hz, n) * g.iz;
}

}  // namespace

double published_fcos(const Lobe& lobe, dvec3 wi, dvec3 wo) {
  const Geometry g = geometry(wi, wo);
  const auto& p = lobe.params;
  const uint8_t v = lobe.variant;
  switch (lobe.model) {
    case Model::lambert:
      return static_cast<double>(p[0] / kPi * g.iz);
    case Model::oren_nayar:
      return static_cast<double>(oren_nayar(v == kOrenNayarFull, p[0], p[1], g));
    case Model::blinn_phong:
      return static_cast<double>(blinn_phong(v, p[0], p[1], g));
    case Model::ward:
      return static_cast<double>(ward(v, p[0], p[1], p[2], g));
    case Model::cook_torrance:
      return static_cast<double>(cook_torrance(v, p[0], p[1], p[2], g));
    case Model::lafortune:
      return static_cast<double>(lafortune(v, p[0], p[1], p[2], p[3], p[4], g));
    case Model::ashikhmin_shirley:
      return static_cast<double>(ashikhmin_shirley(v, p[0], p[1], p[2], p[3], g));
  }
  return 0;
}

}  // namespace vamp::test
