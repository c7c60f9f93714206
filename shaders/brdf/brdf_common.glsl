// What the seven models share. Every file of this folder is GLSL 450 and, behind engine/brdf/kernel.inc, C++ in float
// and in double: no swizzles, literals through REAL, outputs through OUT, choices through SELECT.
//
// The contract. Local frame with the normal at +z; unit vectors that point away from the surface, `wi` to the light,
// `wo` to the viewer, both above the horizon.
//   <model>_eval    fcos = f * cos(wi), 1/sr; no horizon cuts, no windows
//   <model>_sample  from u in [0,1)^2: wi, its density per solid angle and weight = fcos / pdf; false when the draw
//                   fell below the horizon, which counts as a sample of value 0
//   <model>_pdf     the density of that sampler
// `variant` counts as in engine/brdf/lobe.h.
//
// Everything is written in the un-normalised half vector S = wi + wo: cos(wo, h) is |S| / 2 and tan^2 of the half angle
// (Sx^2 + Sy^2) / Sz^2 with full relative precision. A normalised h loses 3 to 4 digits of a sharp highlight, because
// h.z near 1 is rounded to 6e-8 and the exponent multiplies that.
#ifndef BRDF_COMMON_GLSL
#define BRDF_COMMON_GLSL

#ifndef BRDF_CPP
#define real float
#define REAL(x) x
#define OUT(T) out T
#define SELECT(condition, yes, no) mix(no, yes, condition)
#define PRECISE precise
#endif

#define BRDF_PI REAL(3.14159265358979324)
#define BRDF_LOG2E REAL(1.44269504088896341)
#define BRDF_LN2 REAL(0.693147180559945309)
// A cosine never counts as less than this; far below what any scene shows, far above where squares underflow.
#define BRDF_MIN_COS REAL(1e-12)
// exp(-80): beyond it a highlight is 0. Still a normal float; without the cut 1 / Sz^4 would bring the tail back.
#define BRDF_MAX_EXPONENT REAL(115.4)

// ---- Elementary functions. GLSL promises log2 near 1 only to an absolute 2^-21 and pow through it: an exponent of 1e5
// would lose 2 %. These are good to 2e-7 relative everywhere, and the same bits wherever floats are IEEE. The double
// build takes the C++ library's.
#ifndef BRDF_DOUBLE
// log2((a + b) / b), a >= 0, b > 1e-37, with the relative precision of a: a power of two is taken out of the ratio so
// that |s| <= 0.2, then atanh(s) by three terms (Chebyshev, 1.3e-8).
real brdf_log2_ratio(real a, real b) {
  int e = (floatBitsToInt(a + b) - floatBitsToInt(b) + 0x400000) >> 23;
  real scaled = intBitsToFloat(floatBitsToInt(b) + (e << 23));
  real s = (a + (b - scaled)) / (a + b + scaled);
  real s2 = s * s;
  PRECISE real result =
      real(e) +
      s * (REAL(2.88539008) + s2 * (REAL(0.961797505) + s2 * (REAL(0.576735243) + s2 * REAL(0.433466666))));
  return result;
}

// 2^x for |x| <= 126: Chebyshev, 5e-9, exactly 1 at 0.
real brdf_exp2(real x) {
  real whole = floor(x + REAL(0.5));
  real f = x - whole;
  real p =
      REAL(1.0) +
      f * (REAL(0.693147188) +
           f * (REAL(0.240226508) +
                f * (REAL(0.0555035711) + f * (REAL(0.00961808256) + f * (REAL(0.00133908634) + f * REAL(0.000154531629))))));
  PRECISE real result = p * intBitsToFloat((int(whole) + 127) << 23);
  return result;
}

// e^x - 1, 0 <= x <= 80.
real brdf_expm1(real x) {
  real series =
      x * (REAL(1.0) +
           x * (REAL(0.5) +
                x * (REAL(0.166666667) +
                     x * (REAL(0.0416666667) + x * (REAL(0.00833333333) + x * (REAL(0.00138888889) + x * REAL(0.000198412698)))))));
  real direct = brdf_exp2(min(x * BRDF_LOG2E, REAL(125.0))) - REAL(1.0);
  return SELECT(x < REAL(0.5), series, direct);
}

// The angle of (cosine c, sine s), both >= 0; Abramowitz and Stegun 4.4.49, 2e-8.
real brdf_angle(real s, real c) {
  real x = min(s, c) / max(max(s, c), REAL(1e-30));
  real x2 = x * x;
  real p = REAL(-0.0161657367) + x2 * REAL(0.0028662257);
  p = REAL(0.0429096138) + x2 * p;
  p = REAL(-0.0752896400) + x2 * p;
  p = REAL(0.1065626393) + x2 * p;
  p = REAL(-0.1420889944) + x2 * p;
  p = REAL(0.1999355085) + x2 * p;
  p = REAL(-0.3333314528) + x2 * p;
  real angle = x + x * (x2 * p);
  return SELECT(s > c, REAL(1.57079632679) - angle, angle);
}

// cos and sin of 2 pi u, u in [0,1): by quadrants, 1e-7; GLSL promises only an absolute 2^-11.
vec2 brdf_unit_circle(real u) {
  real quadrant = floor(REAL(4.0) * u + REAL(0.5));
  real a = (REAL(4.0) * u - quadrant) * REAL(1.57079632679);
  real a2 = a * a;
  real s = a * (REAL(1.0) -
                a2 * (REAL(0.166666667) - a2 * (REAL(0.00833333333) - a2 * (REAL(0.000198412698) - a2 * REAL(2.75573e-6)))));
  real c = REAL(1.0) -
           a2 * (REAL(0.5) - a2 * (REAL(0.0416666667) - a2 * (REAL(0.00138888889) - a2 * REAL(2.48015873e-5))));
  int turn = int(quadrant) & 3;
  bool swap = (turn & 1) != 0;
  real x = SELECT(swap, s, c);
  real y = SELECT(swap, c, s);
  return vec2(SELECT(turn == 1 || turn == 2, -x, x), SELECT(turn >= 2, -y, y));
}

// ---- Sums of products that cancel, with the precision of their result (Ogita, Rump and Oishi 2005, "Accurate sum and dot
// product"). A rounded sum or product and what the rounding took: Knuth's, and Dekker's with halves of 12 bits.
vec2 brdf_two_sum(real a, real b) {
  PRECISE real sum = a + b;
  PRECISE real part = sum - a;
  PRECISE real rest = (a - (sum - part)) + (b - part);
  return vec2(sum, rest);
}

vec2 brdf_two_product(real a, real b) {
  real a_high = intBitsToFloat(floatBitsToInt(a) & -4096);
  real b_high = intBitsToFloat(floatBitsToInt(b) & -4096);
  PRECISE real a_low = a - a_high;
  PRECISE real b_low = b - b_high;
  PRECISE real product = a * b;
  PRECISE real rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
  return vec2(product, rest);
}

// a b + c d
real brdf_sum_of_products(real a, real b, real c, real d) {
  vec2 p = brdf_two_product(a, b);
  vec2 q = brdf_two_product(c, d);
  vec2 sum = brdf_two_sum(p.x, q.x);
  PRECISE real result = sum.x + (sum.y + (p.y + q.y));
  return result;
}

// a.x b.x c.x + a.y b.y c.y + a.z b.z c.z
real brdf_sum_of_triple_products(vec3 a, vec3 b, vec3 c) {
  vec2 x = brdf_two_product(a.x, b.x);
  vec2 y = brdf_two_product(a.y, b.y);
  vec2 z = brdf_two_product(a.z, b.z);
  vec2 p = brdf_two_product(x.x, c.x);
  vec2 q = brdf_two_product(y.x, c.y);
  vec2 r = brdf_two_product(z.x, c.z);
  vec2 first = brdf_two_sum(p.x, q.x);
  vec2 sum = brdf_two_sum(first.x, r.x);
  PRECISE real rest = (p.y + x.y * c.x) + (q.y + y.y * c.y) + (r.y + z.y * c.z);
  PRECISE real result = sum.x + (sum.y + first.y + rest);
  return result;
}
#endif

// 2^-q, q >= 0, cut to 0 at BRDF_MAX_EXPONENT.
real brdf_falloff(real q) {
  real value = brdf_exp2(-min(q, BRDF_MAX_EXPONENT));
  return SELECT(q < BRDF_MAX_EXPONENT, value, REAL(0.0));
}

// -ln(1 - u), u in [0,1): exact where u is small.
real brdf_minus_log1m(real u) { return BRDF_LN2 * brdf_log2_ratio(u, REAL(1.0) - u); }

// log2 of any x > 0, with relative precision near 1.
real brdf_log2(real x) {
  real big = max(x, REAL(1.0));
  real small = max(min(x, REAL(1.0)), REAL(1e-30));
  return brdf_log2_ratio(big - REAL(1.0), REAL(1.0)) - brdf_log2_ratio(REAL(1.0) - small, small);
}

// ---- The half vector.
struct BrdfHalf {
  real iz, oz;  // cosines, guarded
  real x2, y2;  // squares of S
  real z, z2;
  real s2;  // |S|^2
  real oh;    // cos(wo, h) = cos(wi, h) = |S| / 2
  real loss;  // 1 - oh
};

// 1 - cos(wo, h) from oh = cos(wo, h): |wi - wo|^2 / 4 is its square's complement, and does not cancel near the normal,
// where Schlick's fifth power would make much of a rounding.
real brdf_cosine_loss(vec3 wi, vec3 wo, real oh) {
  real x = wi.x - wo.x;
  real y = wi.y - wo.y;
  real z = wi.z - wo.z;
  return REAL(0.25) * (x * x + y * y + z * z) / (REAL(1.0) + oh);
}

BrdfHalf brdf_half(vec3 wi, vec3 wo) {
  BrdfHalf h;
  h.iz = max(wi.z, REAL(0.0));
  h.oz = max(wo.z, BRDF_MIN_COS);
  real x = wi.x + wo.x;
  real y = wi.y + wo.y;
  h.x2 = x * x;
  h.y2 = y * y;
  h.z = h.iz + h.oz;
  h.z2 = h.z * h.z;
  h.s2 = h.x2 + h.y2 + h.z2;
  h.oh = REAL(0.5) * sqrt(h.s2);
  h.loss = brdf_cosine_loss(wi, wo, h.oh);
  return h;
}

// log2(1 + tan^2 theta_h) = -2 log2(h.z)
real brdf_log2_secant2(BrdfHalf h) { return brdf_log2_ratio(h.x2 + h.y2, h.z2); }

// `wo` mirrored at the direction (x, y, 1), which need not be a unit vector.
vec3 brdf_mirror(vec3 wo, real x, real y) {
  real k = REAL(2.0) * (wo.x * x + wo.y * y + wo.z) / (x * x + y * y + REAL(1.0));
  return vec3(k * x - wo.x, k * y - wo.y, k - wo.z);
}

// Schlick 1994, eq. 15, of the loss 1 - cos.
real brdf_schlick(real f0, real loss) {
  real x2 = loss * loss;
  return f0 + (REAL(1.0) - f0) * (x2 * x2 * loss);
}

// Unpolarised Fresnel reflection of a dielectric (Cook and Torrance 1982), with k = (ior - 1)(ior + 1) and d = g - c
// written as k / (g + c), which does not cancel. 1 beyond the critical angle (ior < 1).
real brdf_fresnel_exact(real k, real c) {
  real g2 = k + c * c;
  real p = max(sqrt(max(g2, REAL(0.0))) + c, REAL(1e-20));
  real d = k / p;
  real ratio = d / p;
  real other = (c * p - REAL(1.0)) / max(c * d + REAL(1.0), REAL(1e-20));
  real f = REAL(0.5) * ratio * ratio * (REAL(1.0) + other * other);
  return SELECT(k < REAL(0.0) && g2 <= REAL(0.0), REAL(1.0), min(f, REAL(1.0)));
}

// ---- Cosine-weighted directions, the sampler of the diffuse models.
vec3 brdf_cosine_direction(vec2 u) {
  real r2 = u.x;
  real r = sqrt(r2);
  vec2 c = brdf_unit_circle(u.y);
  return vec3(r * c.x, r * c.y, sqrt(max(REAL(1.0) - r2, REAL(1e-14))));
}

#endif
