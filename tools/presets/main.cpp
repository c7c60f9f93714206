// make_presets FOLDER [NAME ...] [--looks FOLDER]: builds the shipped presets from their mesostructures into FOLDER.
// The same program makes the same bytes. --looks also writes pictures to judge a material by.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/image/save.h"
#include "engine/material/preset.h"
#include "tools/presets/fit.h"
#include "tools/presets/noise.h"
#include "tools/presets/swatch.h"

namespace vamp::presets {
namespace {

struct Recipe {
  Surface (*make)(uint32_t seed);
  std::string title;
  std::vector<std::string> tags;
  std::string words;
  double ball_mm;
};

const std::map<std::string, Recipe>& recipes() {
  static const std::map<std::string, Recipe> list = {
      {"calf",
       {make_calf,
        "Full-grain calf, cognac",
        {"leather", "calf", "grain", "brown"},
        "aniline-dyed full-grain calf: plates, creases, hair pores, a thin dielectric finish",
        34}},
      {"twill",
       {make_twill,
        "Wool twill 2/2, grey heather",
        {"textile", "wool", "twill", "grey"},
        "2/2 wool twill of dark warp and light weft, 20 yarns per cm, heather fibres",
        22}}};
  return list;
}

// How a material behaves as a whole: albedo seen at an angle, and how often a sample is below zero.
void report(const Spmm& spmm, const Swatch& swatch) {
  for (const double degrees : {0.0, 45.0, 75.0, 85.0}) {
    const double t = degrees * 3.14159265358979 / 180;
    dvec3 sum(0);
    int negative = 0;
    constexpr int kSamples = 20000;
    for (int i = 0; i < kSamples; ++i) {
      const double z = hash01(i, 0, 77), phi = 6.28318530717959 * hash01(i, 1, 77), s = std::sqrt(1 - z * z);
      const double turn = 6.28318530717959 * hash01(i, 4, 77);
      const dvec3 value =
          swatch.value(hash01(i, 2, 77) * 100, hash01(i, 3, 77) * 100, {s * std::cos(phi), s * std::sin(phi), z},
                       {std::sin(t) * std::cos(turn), std::sin(t) * std::sin(turn), std::cos(t)});
      sum += value * 6.28318530717959;
      negative += std::min({value.x, value.y, value.z}) < -1e-3 ? 1 : 0;
    }
    sum /= kSamples;
    fmt::print("  albedo at {:2.0f} deg: {:.3f} {:.3f} {:.3f}, negative {:.2f} %\n", degrees, sum.x, sum.y, sum.z,
               100.0 * negative / kSamples);
  }
  fmt::print("  {:.2f} functions a texel, {} clusters, {} functions, {:.2f} MiB on the GPU\n",
             static_cast<double>(spmm.entries.size()) / static_cast<double>(spmm.texels.size()), spmm.clusters.size(),
             spmm.dictionary.size(), static_cast<double>(bytes_on_gpu(spmm)) / (1 << 20));
}

Status build(const std::string& name, const Recipe& recipe, const fs::path& folder, const fs::path& looks) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  constexpr uint32_t kSeed = 20;
  const Surface surface = recipe.make(kSeed);
  const Goniometer goniometer(surface);
  fmt::print("{}: mesostructure and goniometer {:.1f} s\n", name, seconds());
  const ParametricFit parametric = fit_parametric(surface, goniometer, 3);
  fmt::print("  weights {:.1f} s, parametric error {:.1f} %\n", seconds(), 100 * parametric.error);
  const ResidualFit residual = fit_residual(surface, goniometer, parametric);
  fmt::print("  residual {:.1f} s\n", seconds());

  Preset preset;
  preset.name = recipe.title;
  preset.tags = recipe.tags;
  preset.provenance = "Made by tools/presets (" + name + ", seed " + std::to_string(kSeed) + "): synthetic, " +
                      recipe.words + ". Virtual goniometer, 81 x 81 directions, one bounce.";
  preset.licence = "CC0-1.0";
  const auto fit = std::make_shared<Spmm>(bake(surface, parametric, residual));
  preset.fit = fit;
  const Swatch swatch(*fit);
  VAMP_TRY(preset.thumbnail_png, encode_png(swatch.ball(256, recipe.ball_mm)));
  const fs::path path = folder / (name + ".vamp");
  VAMP_CHECK_STATUS(save_preset(preset, path));
  fmt::print("  {}: {} bytes, {:.1f} s\n", path.string(), fs::file_size(path), seconds());
  report(*fit, swatch);
  if (looks.empty()) return {};
  fs::create_directories(looks);
  VAMP_CHECK_STATUS(save_png(looks / (name + "_ball.png"), swatch.ball(512, recipe.ball_mm)));
  for (const double light : {25.0, 55.0, 75.0})
    VAMP_CHECK_STATUS(save_png(looks / fmt::format("{}_patch_{:.0f}.png", name, light),
                               swatch.patch(512, surface.mm, 30, light, 15)));
  return {};
}

}  // namespace
}  // namespace vamp::presets

int main(int argc, char** argv) {
  using namespace vamp;
  std::vector<std::string> words(argv + 1, argv + argc);
  fs::path folder, looks;
  std::vector<std::string> names;
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--looks" && i + 1 < words.size())
      looks = words[++i];
    else if (folder.empty())
      folder = words[i];
    else
      names.push_back(words[i]);
  }
  if (folder.empty()) {
    fmt::print(stderr, "make_presets FOLDER [calf] [twill] [--looks FOLDER]\n");
    return 2;
  }
  for (const auto& [name, recipe] : presets::recipes()) {
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    const Status status = presets::build(name, recipe, folder, looks);
    if (!status) {
      fmt::print(stderr, "{}\n", status.error().message());
      return static_cast<int>(status.error().kind);
    }
  }
  return 0;
}
