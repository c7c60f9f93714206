#include "engine/fit/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace vamp::fit {
namespace {

double tilt_of(const Basis& basis) {
  return std::acos(std::clamp(double{basis.normal.z}, -1.0, 1.0)) * 180 / std::numbers::pi;
}

// Where the frame leans in the picture of the texture: u runs to the right, and phi = 90 degrees points up.
std::string lean_of(const Basis& basis) {
  const double tilt = tilt_of(basis);
  if (tilt < 7) return "";
  constexpr const char* kWays[] = {"right", "up right", "up", "up left", "left", "down left", "down", "down right"};
  const double phi = std::atan2(double{basis.normal.y}, double{basis.normal.x}) * 4 / std::numbers::pi;
  const auto way = static_cast<size_t>((static_cast<int>(std::lround(phi)) + 8) % 8);
  return fmt::format(", leaning {}{}", tilt > 35 ? "far " : "", kWays[way]);
}

const char* breadth(double width) { return width < 0.16 ? "sharp" : width < 0.32 ? "satin" : "broad"; }

// Width of the half-vector lobe that an exponent stands for.
double width_of(double exponent) { return std::sqrt(2 / (exponent + 2)); }

std::string look_of(const Basis& basis) {
  const auto& p = basis.lobe.params;
  const auto stretched = [](double a, double b) { return std::max(a, b) > 1.6 * std::min(a, b); };
  switch (basis.lobe.model) {
    case Model::lambert:
      return "matte";
    case Model::oren_nayar:
      return "dusty";
    case Model::blinn_phong:
      return fmt::format("{} highlight", breadth(width_of(double{p[1]})));
    case Model::ward:
      return fmt::format("{} {}", breadth(std::sqrt(double{p[1]} * double{p[2]})),
                         stretched(double{p[1]}, double{p[2]}) ? "sheen" : "gloss");
    case Model::cook_torrance:
      return fmt::format("{} {}", breadth(double{p[1]}), p[2] < 0.12f ? "coat" : "gloss");
    case Model::lafortune:
      return fmt::format("{} {}", breadth(width_of(double{p[4]})),
                         p[1] + p[2] > 0.3f ? "glow back to the light" : "glow");
    case Model::ashikhmin_shirley: {
      const double u = width_of(double{p[2]}), v = width_of(double{p[3]});
      return fmt::format("{} {}", breadth(std::sqrt(u * v)), stretched(u, v) ? "brushed sheen" : "brushed gloss");
    }
  }
  return "function";
}

// The same word again gets a number.
std::string unique(const std::string& name, std::map<std::string, int>& seen) {
  const int count = ++seen[name];
  return count == 1 ? name : fmt::format("{} {}", name, count);
}

std::string colour_name(vec3 linear) {
  const float high = std::max({linear.x, linear.y, linear.z}), low = std::min({linear.x, linear.y, linear.z});
  const float light = 0.2126f * linear.x + 0.7152f * linear.y + 0.0722f * linear.z;
  const char* level = light < 0.02f ? "very dark " : light < 0.08f ? "dark " : light > 0.45f ? "light " : "";
  if (high <= 0 || (high - low) / high < 0.18f)
    return light < 0.01f ? "black" : light > 0.6f ? "white" : fmt::format("{}grey", level);
  // Hue in sixths of the circle, from red over yellow.
  const float span = high - low;
  float hue = high == linear.x   ? (linear.y - linear.z) / span
              : high == linear.y ? 2 + (linear.z - linear.x) / span
                                 : 4 + (linear.x - linear.y) / span;
  if (hue < 0) hue += 6;
  const bool warm = hue < 0.9f || hue > 5.7f;
  if (warm && light < 0.2f && (high - low) / high < 0.93f && hue > 0.12f && hue < 0.9f)
    return fmt::format("{}brown", level);
  const char* name = hue < 0.15f || hue > 5.7f ? "red"
                     : hue < 0.6f              ? "orange"
                     : hue < 1.2f              ? "yellow"
                     : hue < 2.6f              ? "green"
                     : hue < 3.4f              ? "cyan"
                     : hue < 4.4f              ? "blue"
                                               : "purple";
  return fmt::format("{}{}", level, name);
}

}  // namespace

bool is_filler(const Basis& basis, const LobeLimits& limits) {
  if (basis.lobe.model == Model::lambert) return tilt_of(basis) > 70;
  if (basis.lobe.model == Model::lafortune && tilt_of(basis) > 55 && basis.lobe.params[4] < 20) return true;
  return bounds_hit(basis, limits) > 0;
}

void name_functions(std::vector<Basis>& dictionary, const LobeLimits& limits) {
  std::map<std::string, int> seen;
  for (Basis& basis : dictionary)
    basis.name = unique(is_filler(basis, limits) ? "filler" : look_of(basis) + lean_of(basis), seen);
}

std::vector<Cluster> name_clusters(const std::vector<vec3>& colours) {
  std::map<std::string, int> seen;
  std::vector<Cluster> clusters;
  for (const vec3& colour : colours) clusters.push_back({unique(colour_name(colour), seen)});
  return clusters;
}

}  // namespace vamp::fit
