// Full-grain calf leather, cognac: rounded plates between creases, fine secondary creases, hair pores, a slight wrinkle
// flow; dyed, burnished, with a thin dielectric finish. 40 x 40 mm.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/presets/noise.h"
#include "tools/presets/surface.h"

namespace vamp::presets {
namespace {

constexpr double kMm = 40;
constexpr int kPlates = 25;       // cells across: plates of about 1.6 mm
constexpr int kFineCreases = 57;  // cells of the secondary creases
constexpr int kPores = 430;
constexpr const char* kCompass[6] = {"east", "north-east", "north-west", "west", "south-west", "south-east"};

struct Grain {
  CellPoint plate;
  double height = 0;  // mm
  double crease = 0;  // 1 on the floor of a crease
  double pore = 0;    // 1 in the middle of a pore
};

struct Pore {
  double u, v, radius;  // period, mm
};

// Hairs stand in short rows of two or three, as on calf, leaning with the flow.
std::vector<Pore> pores(uint32_t seed) {
  std::vector<Pore> list;
  for (int i = 0; list.size() < kPores; ++i) {
    const double u = hash01(i, 0, seed), v = hash01(i, 1, seed);
    const int row = 1 + static_cast<int>(3 * hash01(i, 2, seed));
    const double angle = 0.5 + 0.8 * noise(u, v, 3, 3, seed + 1);
    for (int k = 0; k < row; ++k) {
      const double along = (0.42 + 0.12 * hash01(i, 3 + k, seed)) / kMm * k;
      list.push_back(
          {u + along * std::cos(angle), v + along * std::sin(angle), 0.075 + 0.045 * hash01(i, 9 + k, seed)});
    }
  }
  return list;
}

Grain grain_at(double u, double v, const std::vector<Pore>& holes, uint32_t seed) {
  Grain g;
  // Wander bends the borders; the flow draws plates out along one diagonal.
  const double wander = 0.015;
  const double wu = u + wander * fractal(u, v, 9, 9, 3, seed + 11), wv = v + wander * fractal(u, v, 9, 9, 3, seed + 12);
  const double flow = 0.55 + 0.5 * noise(u, v, 2, 2, seed + 13);
  g.plate = cells(wu, wv, kPlates, kPlates, 0.95, 1.14, flow, seed + 14);
  const CellPoint fine =
      cells(wu + 0.004 * noise(u, v, 40, 40, seed + 15), wv, kFineCreases, kFineCreases, 0.95, 1.2, flow, seed + 16);

  const double cell_mm = kMm / kPlates, fine_mm = kMm / kFineCreases;
  const double edge = std::max(g.plate.edge, 0.0) * cell_mm;
  // Some creases are deep, some almost closed.
  const double depth = std::clamp(0.62 + 0.75 * noise(u, v, 21, 21, seed + 17), 0.12, 1.1);
  const double own = hash01(g.plate.id, 0, seed + 18);
  const double dome = 1 - std::exp(-std::pow(edge / 0.27, 1.2));
  const double tilt = 0.035 *
                      ((hash01(g.plate.id, 1, seed + 18) - 0.5) * g.plate.from_site.x +
                       (hash01(g.plate.id, 2, seed + 18) - 0.5) * g.plate.from_site.y) *
                      cell_mm;
  g.height = 0.105 * depth * dome + 0.022 * (own - 0.5) * dome + tilt * dome;
  const double fine_edge = std::max(fine.edge, 0.0) * fine_mm;
  g.height +=
      0.030 * (1 - std::exp(-fine_edge / 0.12)) * std::clamp(0.55 + 0.8 * noise(u, v, 16, 16, seed + 19), 0.05, 1.2);
  g.crease = (1 - smoothstep(0.03, 0.19, edge)) * std::clamp(0.1 + 0.9 * depth, 0.0, 1.0);

  // Wrinkles: shallow folds across the flow.
  const double fold = noise(u + 0.02 * noise(u, v, 5, 5, seed + 20), v, 4, 9, seed + 21);
  g.height +=
      0.075 * (1 - std::abs(fold)) * (0.5 + 0.5 * noise(u, v, 3, 3, seed + 22)) + 0.05 * noise(u, v, 5, 5, seed + 23);
  g.height += 0.005 * noise(u, v, 128, 128, seed + 24);

  for (const Pore& hole : holes) {
    double du = u - hole.u, dv = v - hole.v;
    du -= std::round(du), dv -= std::round(dv);
    const double r = std::hypot(du, dv) * kMm / hole.radius;
    if (r < 3) g.pore = std::max(g.pore, std::exp(-r * r));
  }
  g.height -= 0.07 * g.pore;
  return g;
}

std::vector<Basis> dictionary() {
  std::vector<Basis> list;
  list.push_back(tilted_basis("body", Model::lambert, {1}, 0, 0));
  for (int i = 0; i < 6; ++i)
    list.push_back(tilted_basis(fmt::format("body {}", kCompass[i]), Model::oren_nayar, {1, 0.26f}, 27, 60 * i));
  list.push_back(tilted_basis("finish", Model::cook_torrance, {1, 0.18f, 0.05f}, 0, 0));
  for (int i = 0; i < 6; ++i)
    list.push_back(
        tilted_basis(fmt::format("finish {}", kCompass[i]), Model::cook_torrance, {1, 0.18f, 0.05f}, 13, 60 * i));
  list.push_back(tilted_basis("finish soft", Model::cook_torrance, {1, 0.36f, 0.05f}, 0, 0));
  list.push_back(tilted_basis("clear coat", Model::blinn_phong, {1, 70}, 0, 0));
  list.push_back(tilted_basis("grain sheen along", Model::ward, {1, 0.24f, 0.5f}, 0, 0, 35));
  list.push_back(tilted_basis("grain sheen across", Model::ward, {1, 0.24f, 0.5f}, 0, 0, 125));
  list.push_back(tilted_basis("wax", Model::ashikhmin_shirley, {0.05f, 0, 18, 18}, 0, 0));
  for (int i = 0; i < 4; ++i) {
    const char* side[4] = {"east", "north", "west", "south"};
    list.push_back(
        tilted_basis(fmt::format("crease edge {}", side[i]), Model::lafortune, {1, 0.5f, 0.5f, 1, 3}, 42, 90 * i));
  }
  return list;
}

}  // namespace

Surface make_calf(uint32_t seed) {
  Surface s;
  s.name = "calf";
  s.mm = kMm;
  s.sigma = 0.17f;
  s.fuzz = 0.0f;
  s.dictionary = dictionary();
  const std::vector<Pore> holes = pores(seed);
  s.height.resize(static_cast<size_t>(kFineSide) * kFineSide);
  std::vector<Grain> grains(s.height.size());
  for (int y = 0; y < kFineSide; ++y)
    for (int x = 0; x < kFineSide; ++x) {
      const auto i = static_cast<size_t>(y * kFineSide + x);
      grains[i] = grain_at((x + 0.5) / kFineSide, (y + 0.5) / kFineSide, holes, seed);
      s.height[i] = static_cast<float>(grains[i].height);
    }
  const std::vector<vec3> normals = texel_normals(s);

  for (const char* name : {"plate", "plate light", "plate dark", "wrinkle"}) s.clusters.push_back({name});
  for (const char* way : kCompass) s.clusters.push_back({fmt::format("slope {}", way)});
  for (const char* name : {"crease along", "crease across", "crease rim", "pore"}) s.clusters.push_back({name});
  enum : uint8_t { kPlate, kLight, kDark, kWrinkle, kSlope, kAlong = 10, kAcross, kRim, kPore };

  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double u = (x + 0.5) / kSide, v = (y + 0.5) / kSide;
      Grain g;  // mean over the texel
      for (int j = 0; j < kFine; ++j)
        for (int i = 0; i < kFine; ++i) {
          const Grain& f = grains[static_cast<size_t>((y * kFine + j) * kFineSide + x * kFine + i)];
          g.plate = f.plate;
          g.crease += f.crease / (kFine * kFine);
          g.pore += f.pore / (kFine * kFine);
        }
      const vec3 n = normals[static_cast<size_t>(y * kSide + x)];
      // Aniline dye: deeper and redder in creases, clouded, each plate a little its own; tops burnished.
      const double cloud = 0.5 * fractal(u, v, 3, 3, 3, seed + 31), own = hash01(g.plate.id, 5, seed + 32) - 0.5;
      const double tone = 1 + 0.13 * cloud + 0.12 * own + 0.05 * noise(u, v, 90, 90, seed + 33);
      const double dark = std::clamp(0.58 * g.crease + 0.55 * g.pore, 0.0, 0.85);
      const dvec3 light(0.300, 0.102, 0.028), deep(0.080, 0.021, 0.007);
      Skin skin;
      skin.albedo = vec3((light * (1 - dark) + deep * dark) * tone);
      skin.gloss = static_cast<float>(1.25 * (1.0 - 0.5 * g.crease - 0.6 * g.pore) *
                                      std::clamp(1.0 + 0.25 * fractal(u, v, 6, 6, 2, seed + 34), 0.5, 1.4));
      skin.f0 = 0.05f;
      skin.along = skin.across =
          static_cast<float>(std::clamp(0.17 + 0.12 * g.crease + 0.045 * noise(u, v, 11, 11, seed + 35), 0.14, 0.4));
      s.skin.push_back(skin);

      const double slope = std::hypot(double{n.x}, double{n.y}), azimuth = std::atan2(double{n.y}, double{n.x});
      uint8_t cluster;
      if (g.pore > 0.3)
        cluster = kPore;
      else if (g.crease > 0.62)
        cluster = slope > 0.27 ? kRim : std::abs(std::sin(azimuth - 0.55)) > 0.707 ? kAlong : kAcross;
      else if (slope > 0.17)
        cluster =
            static_cast<uint8_t>(kSlope + (static_cast<int>(std::round(azimuth / (std::numbers::pi / 3))) + 6) % 6);
      else if (slope > 0.10)
        cluster = kWrinkle;
      else
        cluster = tone > 1.055 ? kLight : tone < 0.945 ? kDark : kPlate;
      s.cluster.push_back(cluster);
    }
  return s;
}

}  // namespace vamp::presets
