#pragma once
// The shader text of shaders/brdf built for C++ twice: in float, the twin of what the GPU runs, and in double, its
// oracle. Directions are taken as they come; engine/brdf/lobe.h is the face with checks and cuts.
#include "engine/brdf/lobe.h"

namespace vamp::brdf_f32 {
float eval(const Lobe& lobe, vec3 wi, vec3 wo);
float pdf(const Lobe& lobe, vec3 wi, vec3 wo);
bool sample(const Lobe& lobe, vec3 wo, float u0, float u1, vec3& wi, float& pdf, float& weight);
float packed(uint32_t tag, const float k[4], vec3 wi, vec3 wo);
float fresnel_exact(float ior, float cosine);
float schlick(float f0, float cosine);
float log2_ratio(float a, float b);
float exp2(float x);
}  // namespace vamp::brdf_f32

namespace vamp::brdf_f64 {
double eval(const Lobe& lobe, dvec3 wi, dvec3 wo);
double pdf(const Lobe& lobe, dvec3 wi, dvec3 wo);
bool sample(const Lobe& lobe, dvec3 wo, double u0, double u1, dvec3& wi, double& pdf, double& weight);
double packed(uint32_t tag, const float k[4], dvec3 wi, dvec3 wo);
double fresnel_exact(double ior, double cosine);
double schlick(double f0, double cosine);
double log2_ratio(double a, double b);
double exp2(double x);
}  // namespace vamp::brdf_f64
