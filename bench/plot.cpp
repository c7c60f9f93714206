#include "bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/files.h"

namespace vamp {
namespace {

constexpr vec3 kGrid(0.88f);
constexpr float kWidth = 320, kHeight = 280;  // of a panel
constexpr vec2 kCorner(52, 30), kSize(250, 190);

// Exponents of the decades that hold all points, along one axis.
struct Decades {
  int first = 0, last = 1;
  float share(double value) const {
    return static_cast<float>((std::log10(value) - first) / static_cast<double>(last - first));
  }
};

Decades decades_of(const std::vector<Panel>& panels, double Curve::Point::*axis) {
  double low = 1e300, high = 0;
  for (const Panel& panel : panels)
    for (const Curve& curve : panel.curves)
      for (const Curve::Point p : curve.points)
        if (p.x > 0 && p.y > 0) low = std::min(low, p.*axis), high = std::max(high, p.*axis);
  if (!(high > 0)) return {};
  const int first = static_cast<int>(std::floor(std::log10(low))), last = static_cast<int>(std::ceil(std::log10(high)));
  return {first, std::max(last, first + 1)};
}

void draw_grid(Figure& figure, const Decades& x, const Decades& y, vec2 corner) {
  const auto decade = [](int exponent) {
    return exponent >= -2 && exponent <= 4 ? fmt::format("{:g}", std::pow(10, exponent))
                                           : fmt::format("1e{}", exponent);
  };
  for (int e = x.first; e <= x.last; ++e) {
    const float at = corner.x + kSize.x * x.share(std::pow(10, e));
    figure.line({{at, corner.y}, {at, corner.y + kSize.y}}, kGrid);
    figure.words({at, corner.y + kSize.y + 12}, decade(e), 10, Anchor::middle);
  }
  for (int e = y.first; e <= y.last; ++e) {
    const float at = corner.y + kSize.y * (1 - y.share(std::pow(10, e)));
    figure.line({{corner.x, at}, {corner.x + kSize.x, at}}, kGrid);
    figure.words({corner.x - 5, at}, decade(e), 10, Anchor::right);
  }
}

}  // namespace

Status write_page(Report report, const std::vector<Plot>& plots, const std::string& page) {
  const fs::path folder = fs::path(page).replace_extension();
  std::error_code failure;
  fs::create_directories(folder, failure);
  for (const Plot& plot : plots) {
    VAMP_CHECK_STATUS(write_text_atomically(folder / (plot.name + ".svg"), plot.figure.svg()));
    report.remark(fmt::format("![{0}]({1}/{0}.svg)", plot.name, folder.filename().string()));
  }
  return report.write_into(page);
}

vec3 plot_colour(size_t index) {
  static constexpr std::array<vec3, 7> kColours{{{0.12f, 0.35f, 0.75f},
                                                 {0.80f, 0.37f, 0.08f},
                                                 {0.15f, 0.55f, 0.25f},
                                                 {0.45f, 0.45f, 0.45f},
                                                 {0.60f, 0.20f, 0.60f},
                                                 {0.80f, 0.20f, 0.15f},
                                                 {0.10f, 0.60f, 0.65f}}};
  return kColours[index % kColours.size()];
}

Figure log_panels(const std::vector<Panel>& panels, const std::string& axes) {
  const auto count = static_cast<int>(panels.size());
  const int rows = (count + 2) / 3;
  Figure figure(static_cast<int>(kWidth) * std::min(count, 3), static_cast<int>(kHeight) * rows + 24);
  const Decades x = decades_of(panels, &Curve::Point::x), y = decades_of(panels, &Curve::Point::y);
  for (size_t i = 0; i < panels.size(); ++i) {
    const vec2 corner = kCorner + vec2(kWidth * static_cast<float>(i % 3), kHeight * static_cast<float>(i / 3));
    draw_grid(figure, x, y, corner);
    figure.words(corner - vec2(0, 14), panels[i].title, 12, Anchor::left);
    float right = corner.x;
    for (size_t c = 0; c < panels[i].curves.size(); ++c) {
      const Curve& curve = panels[i].curves[c];
      std::vector<vec2> points;
      for (const Curve::Point p : curve.points)
        if (p.x > 0 && p.y > 0) points.push_back(corner + kSize * vec2(x.share(p.x), 1 - y.share(p.y)));
      for (const vec2 p : points) figure.area(p - 1.5f, vec2(3), plot_colour(c));
      if (points.size() > 1) figure.line(std::move(points), plot_colour(c), 1.4f);
      const vec2 name(right, corner.y + kSize.y + 30);
      figure.area(name - vec2(0, 4), vec2(8), plot_colour(c));
      figure.words(name + vec2(11, 0), curve.name, 10, Anchor::left);
      right += 22 + 5.4f * static_cast<float>(curve.name.size());
    }
  }
  figure.words({12, kHeight * static_cast<float>(rows) + 12}, axes, 11, Anchor::left);
  return figure;
}

}  // namespace vamp
