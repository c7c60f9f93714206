#include "engine/fit/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/check.h"
#include "engine/fit/rows.h"

namespace vamp::fit {
namespace {

float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

std::vector<size_t> kept(const DirectionSet& set, const std::vector<double>& left_out, std::vector<vec3>& directions) {
  std::vector<size_t> slots;
  for (size_t i = 0; i < set.size(); ++i) {
    const double theta = angles_of(set[i]).theta * 180 / std::numbers::pi;
    if (std::any_of(left_out.begin(), left_out.end(), [&](double ring) { return std::abs(theta - ring) < 1; }))
      continue;
    slots.push_back(i);
    directions.emplace_back(set[i]);
  }
  return slots;
}

double mean_spacing(const std::vector<vec3>& directions) {
  if (directions.size() < 2) return std::numbers::pi / 12;
  double sum = 0;
  for (size_t i = 0; i < directions.size(); ++i) {
    float nearest = -1;
    for (size_t j = 0; j < directions.size(); ++j)
      if (j != i) nearest = std::max(nearest, dot(directions[i], directions[j]));
    sum += std::acos(std::clamp(double{nearest}, -1.0, 1.0));
  }
  return sum / static_cast<double>(directions.size());
}

}  // namespace

Status check_measurement(const Btf& btf) {
  const BtfInfo& info = btf.info();
  const auto refuse = [&](std::string_view place, std::string_view expected, std::string_view found) {
    return fail(ErrorKind::bad_input, info.name, place, expected, found);
  };
  if (info.colour != BtfColour::rec709)
    return refuse("colour", "reflectance in red, green and blue, which functions can stand for", "signed logarithms");
  if (info.views.size() < 4 || info.lights.size() < 4)
    return refuse("directions",
                  info.views.size() == 1
                      ? "at least 4 views and 4 lights (what is seen from one place, vamp convert makes a .ptm of)"
                      : "at least 4 views and 4 lights",
                  fmt::format("{} and {}", info.views.size(), info.lights.size()));
  if (std::max(info.width, info.height) > static_cast<uint32_t>(kMaxTexelSide))
    return refuse("size", fmt::format("at most {} texels a side", kMaxTexelSide),
                  fmt::format("{} x {}", info.width, info.height));
  return {};
}

bool can_have_residual(const Measurement& measurement) {
  const Pairs& pairs = measurement.pairs();
  return pairs.views == pairs.lights && pairs.views.size() <= static_cast<size_t>(kMaxDirections);
}

std::vector<double> projected_weights(const std::vector<vec3>& directions) {
  // Cells of a fine grid over the projected hemisphere, each given to the nearest direction.
  constexpr int kSide = 256;
  std::vector<double> weights(directions.size());
  double cells = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float px = (static_cast<float>(x) + 0.5f) * 2 / kSide - 1,
                  py = (static_cast<float>(y) + 0.5f) * 2 / kSide - 1;
      const float rest = 1 - px * px - py * py;
      if (rest < 0) continue;
      const vec3 w(px, py, std::sqrt(rest));
      size_t nearest = 0;
      float best = -2;
      for (size_t i = 0; i < directions.size(); ++i)
        if (const float c = dot(w, directions[i]); c > best + 1e-6f) nearest = i, best = c;
      weights[nearest] += 1;
      cells += 1;
    }
  for (double& weight : weights) weight *= std::numbers::pi / cells;
  return weights;
}

Measurement::Measurement(const Btf& btf, double mix, const std::vector<double>& left_out) : btf_(&btf) {
  view_slots_ = kept(btf.info().views, left_out, pairs_.views);
  light_slots_ = kept(btf.info().lights, left_out, pairs_.lights);
  CHECK(!view_slots_.empty() && !light_slots_.empty());
  all_lights_ = light_slots_.size() == btf.light_count();
  const std::vector<double> views = projected_weights(pairs_.views), lights = projected_weights(pairs_.lights);
  const double scale = static_cast<double>(pairs_.count()) / (std::numbers::pi * std::numbers::pi);
  for (const double view : views)
    for (const double light : lights)
      roots_.push_back(static_cast<float>(std::sqrt(mix * view * light * scale + (1 - mix))));
  spacing_ = mean_spacing(pairs_.lights);
}

void Measurement::read(size_t texel, float* out) const {
  const Half* values = btf_->texel(texel).data();
  const size_t lights = light_slots_.size(), pairs = roots_.size();
  for (size_t v = 0; v < view_slots_.size(); ++v) {
    const Half* view = values + view_slots_[v] * btf_->light_count() * 3;
    for (size_t c = 0; c < 3; ++c) {
      float* row = out + c * pairs + v * lights;
      const float* roots = roots_.data() + v * lights;
      if (all_lights_) {
        floats_from_halves(view + c, 3, lights, roots, row);
      } else {
        for (size_t l = 0; l < lights; ++l) row[l] = float_from_half(view[light_slots_[l] * 3 + c]) * roots[l];
      }
    }
  }
}

}  // namespace vamp::fit
