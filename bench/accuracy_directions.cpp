// Values between measured directions: a table of a known reflectance, read as a residual is.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/accuracy.h"
#include "engine/brdf/registry.h"
#include "engine/core/check.h"
#include "engine/core/direction_set.h"
#include "engine/material/directions.h"
#include "engine/probe/hard_questions.h"

namespace vamp {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kPairs = 40000;

// Diffuse 0.3 under a highlight of 0.05.
struct Known {
  Lobe matte = default_lobe(Model::lambert), gloss = default_lobe(Model::cook_torrance);
  explicit Known(float m) {
    matte.params[0] = 0.3f;
    gloss.params[1] = m;
    gloss.params[2] = 0.05f;
  }
  double operator()(dvec3 wi, dvec3 wo) const { return fcos(matte, wi, wo) + fcos(gloss, wi, wo); }
};

class Table {
 public:
  Table(const Known& known, const DirectionSet& set) : count_(set.size()) {
    std::vector<vec3> directions;
    for (const dvec3& w : set.directions) directions.emplace_back(w);
    auto tables = triangulate(directions, set.name);
    CHECK(tables);
    tables_ = std::move(*tables);
    last_ring_ = double{last_ring_cosine(directions)};
    for (const dvec3& view : set.directions)
      for (const dvec3& light : set.directions) values_.push_back(known(light, view));
  }

  double operator()(dvec3 wi, dvec3 wo) const {
    const auto views = find_direction(tables_, wo), lights = find_direction(tables_, wi);
    double sum = 0;
    for (size_t v = 0; v < 3; ++v)
      for (size_t l = 0; l < 3; ++l)
        sum += views.weight[v] * lights.weight[l] *
               values_[static_cast<size_t>(views.slot[v]) * count_ + static_cast<size_t>(lights.slot[l])];
    return sum * std::min(1.0, wi.z / last_ring_);
  }

 private:
  size_t count_;
  DirectionTables tables_;
  double last_ring_ = 0;
  std::vector<double> values_;
};

// Root of the mean squared error over that of the values themselves.
struct RelativeError {
  double off = 0, all = 0;
  void add(double value, double truth) {
    off += (value - truth) * (value - truth);
    all += truth * truth;
  }
  double value() const { return all > 0 ? std::sqrt(off / all) : 0; }
};

struct Row {
  std::string name;
  RelativeError inside, beyond;
  std::array<RelativeError, 18> by_angle;  // of the light, bins of 5 degrees; viewers inside
};

Row measure(const Known& known, const DirectionSet& set, std::string name) {
  const Table table(known, set);
  const double last = std::cos(75 * kDegree);
  Row row{std::move(name), {}, {}, {}};
  Directions random(1);
  for (int i = 0; i < kPairs; ++i) {
    const dvec3 wi = random.hemisphere(), wo = random.hemisphere();
    const double value = table(wi, wo), truth = known(wi, wo);
    (std::min(wi.z, wo.z) >= last ? row.inside : row.beyond).add(value, truth);
    const auto bin = static_cast<size_t>(std::acos(wi.z) / (5 * kDegree));
    if (wo.z >= last) row.by_angle[std::min<size_t>(bin, 17)].add(value, truth);
  }
  return row;
}

Figure plot(const std::vector<Row>& rows) {
  constexpr float kLeft = 60, kTop = 50, kWidth = 480, kHeight = 280;
  constexpr vec3 kGrid(0.85f);
  constexpr vec3 kColours[] = {{0.12f, 0.35f, 0.65f}, {0.18f, 0.52f, 0.28f}, {0.62f, 0.16f, 0.22f},
                               {0.55f, 0.70f, 0.90f}, {0.60f, 0.80f, 0.62f}, {0.90f, 0.60f, 0.60f}};
  Figure figure(760, 390);
  const auto at = [](double degrees, double error) {
    return vec2(kLeft + kWidth * static_cast<float>(degrees / 90),
                kTop + kHeight * static_cast<float>(1 - std::clamp(error, 0.0, 1.0)));
  };
  for (int p = 0; p <= 100; p += 20) {
    figure.line({at(0, p / 100.0), at(90, p / 100.0)}, kGrid);
    figure.words(at(0, p / 100.0) - vec2(8, 0), fmt::format("{} %", p), 11, Anchor::right);
  }
  for (int d = 0; d <= 90; d += 15) figure.words(at(d, 0) + vec2(0, 14), fmt::format("{}", d), 11, Anchor::middle);
  for (size_t r = 0; r < rows.size(); ++r) {
    std::vector<vec2> points;
    for (size_t b = 0; b < 18; ++b) points.push_back(at(5 * static_cast<double>(b) + 2.5, rows[r].by_angle[b].value()));
    const vec3 colour = kColours[r % std::size(kColours)];
    figure.line(std::move(points), colour, 2);
    figure.words(vec2(kLeft + kWidth + 16, kTop + 16 + 20 * static_cast<float>(r)), rows[r].name, 12, Anchor::left,
                 colour);
  }
  figure.words(vec2(16, 20), "Relative RMS error between measured directions, by the light's angle in degrees", 13,
               Anchor::left);
  figure.words(at(45, 0) + vec2(0, 36), "outermost measured ring: 75 degrees", 12, Anchor::middle);
  return figure;
}

}  // namespace

Plot measure_directions(Report& report) {
  std::vector<Row> rows;
  for (const DirectionSet& set : {ubo81(), dome151()})
    for (const float m : {0.5f, 0.3f, 0.2f})
      rows.push_back(measure(Known(m), set, fmt::format("{}, m {:g}", set.name, m)));
  report.table({"directions, width of the highlight", "relative RMS error inside 75 degrees", "a direction beyond"});
  Json& data = report.data()["directions"] = Json::array();
  for (const Row& row : rows) {
    const auto percent = [](double x) { return fmt::format("{:.1f} %", 100 * x); };
    report.row({row.name, percent(row.inside.value()), percent(row.beyond.value())});
    data.push_back({{"set", row.name}, {"inside", row.inside.value()}, {"beyond", row.beyond.value()}});
  }
  return {"directions", plot(rows)};
}

}  // namespace vamp
