// Wool twill 2/2: warp yarns of dark and weft yarns of light heather wool, diagonal ribs, plied fibres, a little fuzz.
// 16 x 16 mm, 32 yarns each way.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/presets/noise.h"
#include "tools/presets/surface.h"

namespace vamp::presets {
namespace {

constexpr double kMm = 16;
constexpr int kYarns = 32;
constexpr double kPitch = kMm / kYarns;       // mm
constexpr double kHalfWidth = 0.66 * kPitch;  // yarns press together
constexpr double kHalfHeight = 0.135;         // mm
constexpr double kCrimp = 0.075;              // mm: how far a yarn rises and sinks

// One point of one yarn. `along` runs with the yarn, `across` from -1 to 1 over its width; both in its own terms.
struct YarnPoint {
  double height = -1e9;
  double across = 0, along = 0;  // along in mm
  double rise = 0;               // slope of its centre line
  int64_t index = 0;
  bool warp = false;
};

// 2/2 twill: over two, under two, each yarn one step further.
double crimp(double phase) {
  // A rounded square wave of period 4.
  const double c = std::cos(phase * std::numbers::pi / 2);
  return std::tanh(1.6 * c) / std::tanh(1.6);
}

YarnPoint yarn_at(double position, double along, bool warp, uint32_t seed) {
  // position, along in pitches. The nearest of three yarns by height.
  YarnPoint best;
  const auto middle = static_cast<int64_t>(std::floor(position));
  for (int64_t i = middle - 1; i <= middle + 1; ++i) {
    const int64_t index = ((i % kYarns) + kYarns) % kYarns;
    const double t = along / kYarns, lane = (static_cast<double>(index) + 0.5) / kYarns;
    const double sway = 0.10 * noise(t, lane, 9, kYarns, seed + (warp ? 1 : 2));
    const double thick = 1 + 0.10 * noise(t, lane, 11, kYarns, seed + (warp ? 3 : 4)) +
                         0.10 * (hash01(index, warp ? 0 : 1, seed + 5) - 0.5);
    const double across = (position - (static_cast<double>(i) + 0.5) - sway) * kPitch / (kHalfWidth * thick);
    if (std::abs(across) >= 1) continue;
    // Warp i lies over weft j where (i - j) mod 4 is 0 or 1; the weft is the mirror image.
    const double phase = warp ? along - static_cast<double>(i) : static_cast<double>(i) - along;
    const double shift = warp ? 0.0 : -2.0;
    const double z = kCrimp * crimp(phase + shift);
    const double round = std::sqrt(1 - across * across);
    // Two plies, twisted: a shallow groove that runs obliquely over the yarn.
    const double twist = std::sin(2 * std::numbers::pi * (along / 1.6) + 2.6 * across + 7 * hash01(index, 2, seed));
    const double height = z + kHalfHeight * thick * round + 0.010 * twist * round;
    if (height <= best.height) continue;
    best = {height, across, along * kPitch, 0, index, warp};
    best.rise = kCrimp * (crimp(phase + shift + 0.05) - crimp(phase + shift - 0.05)) / (0.1 * kPitch) * (warp ? 1 : -1);
  }
  return best;
}

YarnPoint weave_at(double u, double v, uint32_t seed) {
  const double x = u * kYarns, y = v * kYarns;
  const YarnPoint warp = yarn_at(x, y, true, seed), weft = yarn_at(y, x, false, seed);
  return warp.height > weft.height ? warp : weft;
}

// Streaks along the fibres: value of the stray fibre at a point, -1 to 1.
double streak(double u, double v, bool warp, int fine, uint32_t seed) {
  const double lean = 0.012 * noise(u, v, 24, 24, seed);
  return warp ? noise(u + lean, v, fine, fine / 5, seed + 1) : noise(u, v + lean, fine / 5, fine, seed + 2);
}

std::vector<Basis> dictionary() {
  constexpr const char* kSides[4] = {"east", "north", "west", "south"};
  std::vector<Basis> list;
  list.push_back(tilted_basis("body", Model::lambert, {1}, 0, 0));
  for (int i = 0; i < 4; ++i)
    list.push_back(tilted_basis(fmt::format("wool {}", kSides[i]), Model::oren_nayar, {1, 0.52f}, 24, 90 * i));
  for (int i = 0; i < 4; ++i)
    list.push_back(tilted_basis(fmt::format("wool steep {}", kSides[i]), Model::oren_nayar, {1, 0.52f}, 48, 90 * i));
  // Fibres: narrow along, wide across.
  list.push_back(tilted_basis("warp sheen", Model::ward, {1, 0.34f, 0.62f}, 0, 0, 90));
  list.push_back(tilted_basis("warp sheen east", Model::ward, {1, 0.34f, 0.62f}, 30, 0, 90));
  list.push_back(tilted_basis("warp sheen west", Model::ward, {1, 0.34f, 0.62f}, 30, 180, 90));
  list.push_back(tilted_basis("weft sheen", Model::ward, {1, 0.34f, 0.62f}, 0, 0, 0));
  list.push_back(tilted_basis("weft sheen north", Model::ward, {1, 0.34f, 0.62f}, 30, 90, 0));
  list.push_back(tilted_basis("weft sheen south", Model::ward, {1, 0.34f, 0.62f}, 30, 270, 0));
  list.push_back(tilted_basis("warp fibre", Model::ashikhmin_shirley, {0.05f, 0, 14, 3}, 0, 0, 90));
  list.push_back(tilted_basis("weft fibre", Model::ashikhmin_shirley, {0.05f, 0, 14, 3}, 0, 0, 0));
  list.push_back(tilted_basis("halo", Model::cook_torrance, {1, 0.8f, 0.02f}, 0, 0));
  list.push_back(tilted_basis("fuzz", Model::lafortune, {1, 0.9f, 0.9f, 0.55f, 2}, 0, 0));
  list.push_back(tilted_basis("nap", Model::oren_nayar, {1, 0.9f}, 0, 0));
  list.push_back(tilted_basis("lustre", Model::blinn_phong, {1, 5}, 0, 0));
  return list;
}

}  // namespace

Surface make_twill(uint32_t seed) {
  Surface s;
  s.name = "twill";
  s.mm = kMm;
  s.fibres = true;
  s.sigma = 0.5f;
  s.fuzz = 0.38f;
  s.dictionary = dictionary();
  s.height.resize(static_cast<size_t>(kFineSide) * kFineSide);
  for (int y = 0; y < kFineSide; ++y)
    for (int x = 0; x < kFineSide; ++x) {
      const double u = (x + 0.5) / kFineSide, v = (y + 0.5) / kFineSide;
      const YarnPoint p = weave_at(u, v, seed);
      double height = std::max(p.height, -0.10);
      height += 0.011 * streak(u, v, p.warp, 160, seed + 20) + 0.006 * noise(u, v, 200, 200, seed + 21);
      s.height[static_cast<size_t>(y * kFineSide + x)] = static_cast<float>(height);
    }
  const std::vector<vec3> normals = texel_normals(s);

  for (const char* yarn : {"warp", "weft"})
    for (const char* part : {"crown", "rise", "fall", "flank one", "flank two"})
      s.clusters.push_back({fmt::format("{} {}", yarn, part)});
  s.clusters.push_back({"warp crossing"});
  s.clusters.push_back({"weft crossing"});
  s.clusters.push_back({"gap"});
  s.clusters[3].name = "warp flank west", s.clusters[4].name = "warp flank east";
  s.clusters[8].name = "weft flank south", s.clusters[9].name = "weft flank north";

  // The lowest texels lie in the gaps between yarns, the next where one yarn dives below another.
  std::vector<double> heights;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) heights.push_back(weave_at((x + 0.5) / kSide, (y + 0.5) / kSide, seed).height);
  std::sort(heights.begin(), heights.end());
  const double gap = heights[heights.size() / 25], crossing = heights[heights.size() / 6];

  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double u = (x + 0.5) / kSide, v = (y + 0.5) / kSide;
      const YarnPoint p = weave_at(u, v, seed);
      // Heather: each fibre its own shade, a few of them strangers; each yarn a little its own.
      const double shade = 0.30 * streak(u, v, p.warp, 120, seed + 30) + 0.16 * streak(u, v, p.warp, 60, seed + 31) +
                           0.16 * (hash01(p.index, p.warp ? 4 : 5, seed + 32) - 0.5) +
                           0.10 * noise(u, v, 3, 3, seed + 33);
      const double stranger = smoothstep(0.55, 0.8, streak(u, v, p.warp, 90, seed + 34));
      const dvec3 warp(0.084, 0.085, 0.094), weft(0.250, 0.227, 0.192);
      const dvec3 other = p.warp ? dvec3(0.21, 0.20, 0.20) : dvec3(0.13, 0.10, 0.075);
      const dvec3 colour = (p.warp ? warp : weft) * (1 - 0.7 * stranger) + other * (0.7 * stranger);
      Skin skin;
      skin.albedo = vec3(colour * std::max(1 + shade, 0.4));
      skin.gloss = 0.028f;
      skin.along = 0.32f, skin.across = 0.6f;
      // Twist turns fibres by about 20 degrees against the yarn.
      const double turn = 0.35 + 0.15 * noise(u, v, 40, 40, seed + 35);
      skin.tangent = static_cast<float>(p.warp ? std::numbers::pi / 2 - turn : -turn);
      s.skin.push_back(skin);

      const vec3 n = normals[static_cast<size_t>(y * kSide + x)];
      const auto first = static_cast<uint8_t>(p.warp ? 0 : 5);
      uint8_t cluster;
      if (p.height < gap)
        cluster = 12;
      else if (p.height < crossing)
        cluster = p.warp ? 10 : 11;
      else if (std::abs(p.across) > 0.45)
        cluster = static_cast<uint8_t>(first + (p.across < 0 ? 3 : 4));
      else {
        const float lean = p.warp ? n.y : n.x;
        cluster = static_cast<uint8_t>(first + (lean < -0.16f ? 1 : lean > 0.16f ? 2 : 0));
      }
      s.cluster.push_back(cluster);
    }
  return s;
}

}  // namespace vamp::presets
