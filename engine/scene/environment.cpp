#include "engine/scene/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/image/load.h"

namespace vamp {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMaxWidth = 4096;
constexpr int kMaxHeight = 2048;
// Part of the samples that goes evenly over the sphere, so that no direction has a pdf of zero.
constexpr double kEven = 0.02;
// The sun's disk has some 1e9 in candela per square metre; sums and squares of far more would leave the range of
// floats.
constexpr float kMaxRadiance = 1e12f;

double luminance(const vec4& c) {
  return 0.2126 * static_cast<double>(c.x) + 0.7152 * static_cast<double>(c.y) + 0.0722 * static_cast<double>(c.z);
}

// Solid angle of a texel in `row`: d phi times the difference of the cosines of its edges.
double texel_angle(uint32_t row, uint32_t width, uint32_t height) {
  const double top = std::cos(kPi * row / height);
  const double bottom = std::cos(kPi * (row + 1) / height);
  return 2 * kPi / width * (top - bottom);
}

// Vose 1991, "A linear algorithm for generating random numbers with a given distribution". p sums to 1.
std::vector<Environment::Cell> alias_table(const std::vector<double>& p) {
  const size_t n = p.size();
  std::vector<Environment::Cell> cells(n);
  std::vector<double> scaled(n);
  std::vector<uint32_t> small;
  std::vector<uint32_t> large;
  for (size_t i = 0; i < n; ++i) {
    scaled[i] = p[i] * static_cast<double>(n);
    (scaled[i] < 1 ? small : large).push_back(static_cast<uint32_t>(i));
  }
  while (!small.empty() && !large.empty()) {
    const uint32_t s = small.back();
    const uint32_t l = large.back();
    small.pop_back();
    cells[s] = {static_cast<float>(scaled[s]), l};
    scaled[l] -= 1 - scaled[s];
    if (scaled[l] < 1) {
      large.pop_back();
      small.push_back(l);
    }
  }
  // What is left is 1 but for rounding.
  for (const auto& rest : {small, large})
    for (const uint32_t i : rest) cells[i] = {1.0f, i};
  return cells;
}

vec3 turned_about_y(const vec3& d, float radians) {
  const float c = std::cos(radians);
  const float s = std::sin(radians);
  return {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
}

}  // namespace

Environment::Sample Environment::sample(const vec4& u, float rotation_radians) const {
  const auto count = static_cast<uint32_t>(cells.size());
  uint32_t i = std::min(static_cast<uint32_t>(static_cast<double>(u.x) * count), count - 1);
  if (!(u.y < cells[i].keep)) i = cells[i].other;
  const uint32_t row = i / width;
  const uint32_t column = i % width;
  const double phi = 2 * kPi * ((static_cast<double>(column) + static_cast<double>(u.z)) / width - 0.5);
  const double top = std::cos(kPi * row / height);
  const double bottom = std::cos(kPi * (row + 1) / height);
  const double y = top + (bottom - top) * static_cast<double>(u.w);
  const double r = std::sqrt(std::max(0.0, 1 - y * y));
  const vec3 d(static_cast<float>(r * std::sin(phi)), static_cast<float>(y), static_cast<float>(-r * std::cos(phi)));
  const vec4& texel = texels[i];
  return {turned_about_y(d, rotation_radians), vec3(texel), texel.w};
}

vec4 Environment::lookup(const vec3& direction, float rotation_radians) const {
  const vec3 d = turned_about_y(direction, -rotation_radians);
  const double u = 0.5 + std::atan2(static_cast<double>(d.x), -static_cast<double>(d.z)) / (2 * kPi);
  const double v = std::acos(std::clamp(static_cast<double>(d.y), -1.0, 1.0)) / kPi;
  const uint32_t column = std::min(static_cast<uint32_t>(u * width), width - 1);
  const uint32_t row = std::min(static_cast<uint32_t>(v * height), height - 1);
  return texels[static_cast<size_t>(row) * width + column];
}

Result<std::shared_ptr<const Environment>> make_environment(uint32_t width, uint32_t height, std::vector<vec3> radiance,
                                                            std::string_view file) {
  if (width == 0 || height == 0 || radiance.size() != size_t{width} * height)
    return fail(ErrorKind::bad_input, file, "", "a picture with texels", fmt::format("{} x {}", width, height));
  auto e = std::make_shared<Environment>();
  e->width = width;
  e->height = height;
  e->texels.reserve(radiance.size());
  std::vector<double> weight(radiance.size());
  double sum = 0;
  for (size_t i = 0; i < radiance.size(); ++i) {
    const vec3& c = radiance[i];
    for (int k = 0; k < 3; ++k)
      if (!(c[k] >= 0 && c[k] <= kMaxRadiance))
        return fail(ErrorKind::bad_input, file, fmt::format("texel ({}, {})", i % width, i / width),
                    fmt::format("radiance of 0 to {:g}", kMaxRadiance), fmt::format("{:g}", c[k]));
    e->texels.emplace_back(c, 0.0f);
    weight[i] = luminance(e->texels.back()) * texel_angle(static_cast<uint32_t>(i / width), width, height);
    sum += weight[i];
  }
  e->mean_luminance = sum / (4 * kPi);
  for (size_t i = 0; i < weight.size(); ++i) {
    const double angle = texel_angle(static_cast<uint32_t>(i / width), width, height);
    const double even = angle / (4 * kPi);
    weight[i] = sum > 0 ? (1 - kEven) * weight[i] / sum + kEven * even : even;
    e->texels[i].w = static_cast<float>(weight[i] / angle);
  }
  e->cells = alias_table(weight);
  return e;
}

Result<std::shared_ptr<const Environment>> load_environment(const std::filesystem::path& path) {
  const std::string file = path.string();
  VAMP_TRY(const Image loaded, load_image(path));
  VAMP_TRY(Image image, colour_of(loaded, "", file));
  const double aspect = static_cast<double>(image.width) / image.height;
  if (aspect < 1.9 || aspect > 2.1)
    return fail(ErrorKind::bad_input, file, "", "a lat-long map, twice as wide as high",
                fmt::format("{} x {}", image.width, image.height));
  if (image.width > kMaxWidth || image.height > kMaxHeight)
    image = downsampled(image, std::min(image.width, kMaxWidth), std::min(image.height, kMaxHeight));
  std::vector<vec3> radiance(image.pixel_count());
  for (size_t i = 0; i < radiance.size(); ++i)
    radiance[i] = vec3(image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]);
  return make_environment(static_cast<uint32_t>(image.width), static_cast<uint32_t>(image.height), std::move(radiance),
                          file);
}

}  // namespace vamp
