#include "bench/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bench/fit_figures.h"
#include "engine/core/check.h"

namespace vamp {
namespace {

const vec3 kBlue(0.12f, 0.35f, 0.75f), kGreen(0.15f, 0.55f, 0.25f), kGrey(0.45f), kRed(0.8f, 0.2f, 0.15f), kGrid(0.88f);

constexpr double kNone = -1;  // a figure that is not there

std::string percent(double value) { return fmt::format("{:.1f}", 100 * value); }

double value(const Json& row, const char* key) { return row[key].get<double>(); }

const Json& named(const Json& rows, std::string_view name) {
  for (const Json& row : rows)
    if (row["name"] == name) return row;
  CHECK(false);
}

// What is asked of the fits: each as a figure of a material and the most or least that it may be.
struct Bar {
  std::string what;
  std::function<double(const Json&)> of;
  const char* asked;
  bool percent = false;
};

const Json& usual(const Json& figures) { return figures["curve"]; }

double over_svd10(const Json& figures, const char* key) {
  return value(named(usual(figures), "with 4 terms"), key) / value(named(usual(figures), "svd rank 10"), key);
}

// The error of a truncated SVD of so many KiB, between those that were made; errors fall as powers of bytes.
double svd_of(const Json& rows, double kib, const char* key) {
  const Json *below = nullptr, *above = nullptr;
  for (const Json& row : rows) {
    if (!row["name"].get<std::string>().starts_with("svd")) continue;
    if (value(row, "kib") <= kib) below = &row;
    if (value(row, "kib") >= kib && above == nullptr) above = &row;
  }
  if (below == nullptr || above == nullptr || below == above) return value(below != nullptr ? *below : *above, key);
  const double along = std::log(kib / value(*below, "kib")) / std::log(value(*above, "kib") / value(*below, "kib"));
  return std::exp(std::lerp(std::log(value(*below, key)), std::log(value(*above, key)), along));
}

// A representation's error over that of a truncated SVD of the same bytes.
double over_equal_bytes(const Json& rows, const char* name, const char* key) {
  const Json& ours = named(rows, name);
  return value(ours, key) / svd_of(rows, value(ours, "kib"), key);
}

std::vector<Bar> bars() {
  const auto few = [](const char* which) {
    return [which](const Json& f) {
      return f.contains(which) ? value(f[which]["fit"], "measured") / value(f[which]["srf"], "measured") : kNone;
    };
  };
  return {
      {"4 terms / SVD of rank 10, measured", [](const Json& f) { return over_svd10(f, "measured"); }, "< 1"},
      {"4 terms / SVD of rank 10, between", [](const Json& f) { return over_svd10(f, "between"); }, "< 1"},
      {"4 terms / SVD of equal bytes, between",
       [](const Json& f) { return over_equal_bytes(usual(f), "with 4 terms", "between"); }, ""},
      {fmt::format("the same with {} clusters", kSmallFitClusters),
       [](const Json& f) { return over_equal_bytes(f["small_curve"], "with 4 terms", "between"); },
       "1.35 on four, 1.5 on all"},
      {"shared residual of 32 terms / SVD of equal bytes, between",
       [](const Json& f) { return over_equal_bytes(usual(f), "shared 32", "between"); }, "< 1 on two"},
      {"3 functions of many / SRF", few("few_any"), "0.8"},
      {"3 functions of 32 / SRF", few("few"), "0.9"},
      {"MSSIM at two texels a pixel", [](const Json& f) { return value(named(usual(f), "with 4 terms"), "mssim"); },
       "0.96 on four, 0.93 on all"},
      {"error between the directions, %",
       [](const Json& f) { return value(named(usual(f), "with 4 terms"), "between"); }, "25; 12 shallow or fine", true},
      {"noise of the measurement, %", [](const Json& f) { return value(f, "noise"); }, "", true},
      {"noise between, %", [](const Json& f) { return value(f, "noise_between"); }, "", true},
      {"32 bases / many",
       [](const Json& f) {
         return f.contains("any")
                    ? value(named(usual(f), "with 4 terms"), "measured") / value(f["any"]["fit"], "measured")
                    : kNone;
       },
       "1.08"},
      {"left-out ring / directions used",
       [](const Json& f) { return f.contains("ring") ? value(f["ring"], "ring") / value(f["ring"], "used") : kNone; },
       "1.3"},
  };
}

// Six panels of curves: errors between the directions, by `key` in logarithms from `low` to `high`.
Figure panels(const std::vector<const FitMaterial*>& materials, const std::vector<Json>& all, const char* key,
              const char* unit, double low, double high) {
  constexpr float kWidth = 300, kHeight = 230;
  const float bottom = kHeight * static_cast<float>((all.size() + 2) / 3);
  Figure figure(static_cast<int>(3 * kWidth), static_cast<int>(bottom) + 42);
  for (size_t i = 0; i < all.size(); ++i) {
    const vec2 corner(kWidth * static_cast<float>(i % 3), kHeight * static_cast<float>(i / 3));
    // Each panel ends at the SRF's error, the largest but for rounding.
    const double most = std::ceil(10.5 * value(named(usual(all[i]), "srf"), "between")) / 10;
    const auto at = [&](double x, double y) {
      const double along = std::log(std::clamp(x, low, high) / low) / std::log(high / low);
      return corner +
             vec2(44 + 240 * static_cast<float>(along), 200 - 165 * static_cast<float>(std::min(y / most, 1.0)));
    };
    for (int k = 0; k <= 4; ++k) {
      const double y = most * k / 4;
      figure.line({at(low, y), at(high, y)}, kGrid);
      figure.words(at(low, y) - vec2(6, 0), fmt::format("{:.3g} %", 100 * y), 10, Anchor::right);
    }
    for (double x = low; x <= high * 1.001; x *= 4)
      figure.words(at(x, 0) + vec2(0, 14), fmt::format("{:g}", x), 10, Anchor::middle);
    figure.words(corner + vec2(44, 16), materials[i]->name, 12, Anchor::left);
    const auto draw = [&](const Json& rows, std::string_view prefix, vec3 colour) {
      std::vector<vec2> points;
      for (const Json& row : rows)
        if (row["name"].get<std::string>().starts_with(prefix) && value(row, key) > 0)
          points.push_back(at(value(row, key), value(row, "between")));
      for (const vec2 p : points) figure.area(p - 2.f, vec2(4), colour);
      if (points.size() > 1) figure.line(std::move(points), colour, 1.4f);
    };
    for (const char* curve : {"small_curve", "curve"}) {
      Json material = Json::array();
      for (const Json& row : all[i][curve])
        if (const auto each = row["name"].get<std::string>(); each == "functions" || each.starts_with("with"))
          material.push_back(row);
      draw(material, "", kBlue);
    }
    draw(usual(all[i]), "svd", kGrey);
    draw(usual(all[i]), "shared", kGreen);
    draw(usual(all[i]), "srf", kRed);
  }
  const float line = bottom + 12;
  figure.words({20, line}, fmt::format("relative RMSE between the measured directions, by {}", unit), 11, Anchor::left);
  const std::pair<std::string, vec3> kinds[] = {
      {fmt::format("functions, mean, 1 to 4 terms, with {} and with {} clusters", kSmallFitClusters, kFitClusters),
       kBlue},
      {"shared residual", kGreen},
      {"truncated SVD", kGrey},
      {"SRF", kRed}};
  float x = 20;
  for (const auto& [name, colour] : kinds) {
    figure.area({x, line + 14}, vec2(8), colour);
    figure.words({x + 12, line + 18}, name, 11, Anchor::left);
    x += 30 + 5.4f * static_cast<float>(name.size());
  }
  return figure;
}

Result<std::vector<const FitMaterial*>> chosen(const FitBench& options) {
  std::vector<const FitMaterial*> found;
  std::string names;
  for (const FitMaterial& material : fit_materials()) {
    const auto& asked = options.materials;
    if (asked.empty() || std::find(asked.begin(), asked.end(), material.name) != asked.end())
      found.push_back(&material);
    names += fmt::format("{}{}", names.empty() ? "" : ", ", material.name);
  }
  if (found.size() == (options.materials.empty() ? fit_materials().size() : options.materials.size())) return found;
  return fail(ErrorKind::usage, "", "--materials", "some of " + names,
              fmt::format("{}", fmt::join(options.materials, ", ")));
}

}  // namespace

Result<FitCurves> bench_fit(const FitBench& options, Progress& progress) {
  VAMP_TRY(const std::vector<const FitMaterial*> materials, chosen(options));
  std::vector<Json> all;
  for (const FitMaterial* material : materials) {
    VAMP_TRY(Json figures, fit_figures(*material, options.data, options.threads, progress));
    all.push_back(std::move(figures));
  }
  Report report(
      "fit",
      fmt::format(
          "Synthetic: {0} x {0} texels, {1} paths a texel and view, {2} between the directions; {3} "
          "clusters, as vamp fit has them, or {4} where these are named. Errors are relative RMSE, all pairs alike.",
          options.data.size, options.data.samples, kPathsBetween * options.data.samples, kFitClusters,
          kSmallFitClusters));
  std::vector<std::string> heads = {"figure (asked for)"};
  for (const FitMaterial* material : materials)
    heads.push_back(fmt::format("{}{}", material->name, material->judged ? "" : " (not judged)"));
  report.table(heads);
  std::vector<std::string> tilts = {"mean tilt of the surface, degrees"};
  for (const Json& figures : all) tilts.push_back(fmt::format("{:.0f}", value(figures, "tilt")));
  report.row(std::move(tilts));
  for (const Bar& bar : bars()) {
    std::vector<std::string> cells = {*bar.asked != 0 ? fmt::format("{} ({})", bar.what, bar.asked) : bar.what};
    for (const Json& figures : all)
      if (const double found = bar.of(figures); found == kNone)
        cells.emplace_back("-");
      else
        cells.push_back(bar.percent ? percent(found) : fmt::format("{:.3f}", found));
    report.row(std::move(cells));
  }
  // Each representation of the usual fit: error measured / between, and MSSIM.
  heads.front() = "representation, KiB of the first material; measured / between, %; MSSIM";
  report.table(heads);
  for (size_t i = 0; i < usual(all.front()).size(); ++i) {
    const Json& first = usual(all.front())[i];
    std::vector<std::string> cells = {
        fmt::format("{}, {} KiB", first["name"].get<std::string>(), first["kib"].get<int>())};
    for (const Json& figures : all) {
      const Json& rows = usual(figures);
      if (i >= rows.size() || rows[i]["name"] != first["name"]) {
        cells.emplace_back("-");
        continue;
      }
      cells.push_back(fmt::format("{} / {}; {:.3f}", percent(value(rows[i], "measured")),
                                  percent(value(rows[i], "between")), value(rows[i], "mssim")));
    }
    report.row(std::move(cells));
  }
  for (size_t i = 0; i < all.size(); ++i) report.data()[materials[i]->name] = all[i];
  return FitCurves{std::move(report), panels(materials, all, "kib", "KiB", 64, 8192),
                   panels(materials, all, "ns", "nanoseconds of an evaluation on one core", 64, 8192)};
}

}  // namespace vamp
