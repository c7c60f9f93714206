// `vamp brdf plot`: a lobe as curves about the viewer or as the slice of half and difference angles.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "app/commands/brdf.h"
#include "engine/image/figure.h"
#include "app/commands/option_values.h"
#include "engine/brdf/registry.h"
#include "engine/core/files.h"
#include "engine/image/save.h"

namespace vamp {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr vec3 kGrid(0.85f), kBelow(0.93f);
constexpr vec3 kCurves[] = {{0.12f, 0.35f, 0.65f}, {0.80f, 0.37f, 0.08f}, {0.18f, 0.52f, 0.28f},
                            {0.62f, 0.16f, 0.22f}, {0.42f, 0.30f, 0.60f}, {0.35f, 0.35f, 0.35f}};

struct Options {
  LobeWords lobe;
  std::string out = "brdf.svg", kind = "polar", on, theta = "0,30,60", phi_d = "90", decades = "4";
};

std::string title_of(const Lobe& lobe) {
  const ModelRow& model = model_row(lobe.model);
  std::string title = fmt::format("{} / {}", model.name, model.variants[lobe.variant].name);
  for (const ParameterRow& row : model.parameters)
    if (row.belongs_to(lobe.variant))
      title += fmt::format("   {} {:g}", row.name, lobe.params[row.slot] * row.display_factor());
  return title;
}

double f_of(const BrdfEngine::Value& value, const BrdfQuestion& question) {
  return value.fcos == 0 ? 0 : value.fcos / static_cast<double>(question.wi.z);
}

// Position of a value between the darkest decade shown and the brightest value.
float share(double f, double top, float decades) {
  if (!(f > 0)) return 0;
  return std::clamp(1 + static_cast<float>(std::log10(f / top)) / decades, 0.0f, 1.0f);
}

// Signed angles in the plane of incidence, finer about the mirror direction, where highlights may be sharp.
std::vector<double> light_angles(double theta) {
  std::vector<double> angles;
  for (int i = -899; i <= 899; ++i) angles.push_back(0.1 * i);
  for (int i = -200; i <= 200; ++i) {
    const double angle = -theta + std::copysign(std::pow(std::abs(i) / 200.0, 3) * 5, i);
    if (std::abs(angle) < 89.95) angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

struct Curve {
  double theta;
  std::vector<double> angles, values;
};

// f in the plane of incidence against the light's angle: radius is the logarithm of f, the viewer a ray on the right.
Figure polar_figure(const Lobe& lobe, BrdfEngine& engine, const std::vector<double>& thetas, float decades) {
  std::vector<Curve> curves;
  double top = 0;
  for (const double theta : thetas) {
    Curve curve{theta, light_angles(theta), {}};
    std::vector<BrdfQuestion> questions;
    for (const double angle : curve.angles)
      questions.push_back({lobe, direction_at(std::abs(angle), angle < 0 ? 180 : 0), direction_at(theta, 0)});
    const auto values = engine.values(questions);
    for (size_t i = 0; i < values.size(); ++i) curve.values.push_back(f_of(values[i], questions[i]));
    top = std::max(top, *std::max_element(curve.values.begin(), curve.values.end()));
    curves.push_back(std::move(curve));
  }
  if (!(top > 0)) top = 1;

  constexpr float kRadius = 330;
  constexpr vec2 kCentre(400, 400);
  const auto at = [&](double angle, float radius) {
    return kCentre + kRadius * radius * vec2(std::sin(angle * kDegree), -std::cos(angle * kDegree));
  };
  Figure figure(800, 470);
  const auto arc = [&](float radius) {
    std::vector<vec2> points;
    for (int i = -90; i <= 90; i += 2) points.push_back(at(i, radius));
    return points;
  };
  for (int d = 0; static_cast<float>(d) < decades; ++d) {
    const float radius = 1 - static_cast<float>(d) / decades;
    figure.line(arc(radius), kGrid);
    figure.words(kCentre + vec2(kRadius * radius, 14), fmt::format("{:.2g}", top * std::pow(10.0, -d)), 11,
                 Anchor::middle);
  }
  for (int angle = -90; angle <= 90; angle += 30) {
    figure.line({kCentre, at(angle, 1)}, kGrid);
    figure.words(at(angle, 1.06f), fmt::format("{}", std::abs(angle)), 12, Anchor::middle);
  }
  for (size_t c = 0; c < curves.size(); ++c) {
    const vec3 colour = kCurves[c % std::size(kCurves)];
    std::vector<vec2> points;
    for (size_t i = 0; i < curves[c].angles.size(); ++i)
      points.push_back(at(curves[c].angles[i], share(curves[c].values[i], top, decades)));
    figure.line(std::move(points), colour, 1.8f);
    figure.line({at(curves[c].theta, 0.96f), at(curves[c].theta, 1.02f)}, colour, 4);
    figure.words(vec2(16, 52 + 20 * static_cast<float>(c)), fmt::format("viewer at {:g} degrees", curves[c].theta), 13,
                 Anchor::left, colour);
  }
  figure.words(vec2(16, 22), title_of(lobe), 14, Anchor::left);
  figure.words(vec2(400, 448), "f in 1/sr by the light's angle in the plane of incidence, degrees; logarithmic", 12,
               Anchor::middle);
  return figure;
}

// Dark blue over red to light yellow, equally bright steps.
vec3 heat(float t) {
  constexpr vec3 kStops[] = {{0.04f, 0.03f, 0.14f},
                             {0.33f, 0.06f, 0.43f},
                             {0.73f, 0.22f, 0.33f},
                             {0.96f, 0.55f, 0.14f},
                             {0.99f, 0.96f, 0.70f}};
  const float x = std::clamp(t, 0.0f, 1.0f) * 4;
  const int i = std::min(3, static_cast<int>(x));
  return glm::mix(kStops[i], kStops[i + 1], x - static_cast<float>(i));
}

// Light and viewer by Rusinkiewicz's angles (1998), degrees: h at (theta_h, 0), the difference vector at (theta_d,
// phi_d) about it.
BrdfQuestion rusinkiewicz(const Lobe& lobe, double theta_h, double theta_d, double phi_d) {
  const double ch = std::cos(theta_h * kDegree), sh = std::sin(theta_h * kDegree);
  const double cd = std::cos(theta_d * kDegree), sd = std::sin(theta_d * kDegree);
  const double x = sd * std::cos(phi_d * kDegree), y = sd * std::sin(phi_d * kDegree);
  const auto turned = [&](double dx, double dy) { return vec3(dvec3(ch * dx + sh * cd, dy, -sh * dx + ch * cd)); };
  return {lobe, turned(x, y), turned(-x, -y)};
}

// The slice of f over theta_h (by its square root, which opens the highlight) and theta_d.
Figure slice_figure(const Lobe& lobe, BrdfEngine& engine, double phi_d, float decades) {
  constexpr int kSide = 120;
  constexpr vec2 kCorner(70, 50);
  constexpr float kCell = 4;
  std::vector<BrdfQuestion> questions;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      questions.push_back(rusinkiewicz(lobe, 90 * std::pow((x + 0.5) / kSide, 2), 90 * (1 - (y + 0.5) / kSide), phi_d));
  const auto values = engine.values(questions);
  // Towards grazing many lobes grow without end: beyond 75 degrees they do not set the scale.
  double top = 0;
  for (size_t i = kSide * kSide / 6; i < values.size(); ++i) top = std::max(top, f_of(values[i], questions[i]));
  if (!(top > 0)) top = 1;

  Figure figure(700, 610);
  for (size_t i = 0; i < values.size(); ++i) {
    const BrdfQuestion& q = questions[i];
    const vec2 place(static_cast<float>(i % kSide), static_cast<float>(i / kSide));
    const bool below = q.wi.z <= 0 || q.wo.z <= 0;
    figure.area(kCorner + kCell * place, vec2(kCell), below ? kBelow : heat(share(f_of(values[i], q), top, decades)));
  }
  const float side = kSide * kCell;
  for (const int degrees : {0, 5, 15, 30, 45, 60, 90})
    figure.words(kCorner + vec2(side * std::sqrt(static_cast<float>(degrees) / 90), side + 14),
                 fmt::format("{}", degrees), 12, Anchor::middle);
  for (int degrees = 0; degrees <= 90; degrees += 15)
    figure.words(kCorner + vec2(-8, side * (1 - static_cast<float>(degrees) / 90)), fmt::format("{}", degrees), 12,
                 Anchor::right);
  for (int i = 0; i < 96; ++i)
    figure.area(kCorner + vec2(side + 30, side * static_cast<float>(i) / 96), vec2(18, side / 96),
                heat(1 - static_cast<float>(i) / 95));
  for (int d = 0; static_cast<float>(d) <= decades; ++d)
    figure.words(kCorner + vec2(side + 54, side * static_cast<float>(d) / decades),
                 fmt::format("{:.2g}", top * std::pow(10.0, -d)), 12, Anchor::left);
  figure.words(vec2(16, 22), title_of(lobe), 14, Anchor::left);
  figure.words(kCorner + vec2(side / 2, side + 38),
               fmt::format("theta_h, by its root; up: theta_d; phi_d {:g}; degrees; f in 1/sr", phi_d), 12,
               Anchor::middle);
  return figure;
}

Status plot(const Options& options, const CommonOptions& common) {
  const fs::path path(options.out);
  const bool png = path.extension() == ".png";
  if (!png && path.extension() != ".svg")
    return fail(ErrorKind::usage, "", "--out", "a name that ends in .svg or .png", "\"" + options.out + "\"");
  VAMP_TRY(const Lobe lobe, lobe_of(options.lobe));
  VAMP_TRY(const std::vector<double> thetas, angles_option(options.theta, "--theta"));
  if (thetas.empty()) return fail(ErrorKind::usage, "", "--theta", "at least one angle", "none");
  VAMP_TRY(const float phi_d, number_option(options.phi_d, "--phi-d", 0, 180));
  VAMP_TRY(const float decades, number_option(options.decades, "--decades", 1, 12));
  VAMP_TRY(BrdfEngine engine, BrdfEngine::open(options.on, common));
  const Figure figure = options.kind == "polar" ? polar_figure(lobe, engine, thetas, decades)
                                                : slice_figure(lobe, engine, static_cast<double>(phi_d), decades);
  if (!png) return write_text_atomically(path, figure.svg());
  VAMP_TRY(const Image picture, figure.picture());
  VAMP_TRY(const std::vector<std::byte> bytes, encode_png(picture, {.space = ColourSpace::linear}));
  return write_file_atomically(path, bytes);
}

}  // namespace

void add_brdf_plot(CLI::App& brdf, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = brdf.add_subcommand("plot", "Draw a lobe as polar curves or as a slice of half angles");
  add_lobe_words(*verb, options->lobe, true);
  verb->add_option("--out", options->out, "The drawing: .svg or .png")->type_name("FILE")->capture_default_str();
  verb->add_option("--kind", options->kind, "Curves in the plane of incidence, or f over theta_h and theta_d")
      ->type_name("polar|slice")
      ->check(CLI::IsMember({"polar", "slice"}).description(""))
      ->capture_default_str();
  verb->add_option("--theta", options->theta, "polar: the viewers' angles from the normal")
      ->type_name("DEGREES")
      ->capture_default_str();
  verb->add_option("--phi-d", options->phi_d, "slice: the difference vector's azimuth")
      ->type_name("DEGREES")
      ->capture_default_str();
  verb->add_option("--decades", options->decades, "Powers of ten below the brightest value")
      ->type_name("N")
      ->capture_default_str();
  add_engine_option(*verb, options->on);
  verb->callback([options, &common, &action] { action = [options, &common] { return plot(*options, common); }; });
}

}  // namespace vamp
