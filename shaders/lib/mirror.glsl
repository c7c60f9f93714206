// Mirror reflection of a part: one bounce along the shading normal, Schlick's Fresnel. F90 falls to 0 with F0 below 2 %
// (Lagarde & de Rousiers 2014), so that a part whose mirror is switched off has none at grazing angles either.

float mirror_f0(uint part) { return uintBitsToFloat(texelFetch(part_texels, int(part) * PART_ROW_TEXELS + 5).x); }

Ray mirror_ray(Ray ray, SurfacePoint point) {
  vec3 d = ray.direction - 2.0 * dot(ray.direction, point.normal) * point.normal;
  // A reflection below the face is lifted onto it: the same place is seen, not the inside of the part.
  float below = min(dot(d, point.face), 0.0);
  return Ray(leave_surface(point), normalize(d - (1.01 * below) * point.face));
}

float mirror_fresnel(float f0, float cosine) {
  float x = 1.0 - clamp(cosine, 0.0, 1.0);
  float x2 = x * x;
  return f0 + (min(50.0 * f0, 1.0) - f0) * x2 * x2 * x;
}
