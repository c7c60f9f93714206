#include "engine/fit/cost.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>

#include "engine/core/half.h"
#include "engine/material/directions.h"
#include "engine/material/tables.h"

namespace vamp::fit {
namespace {

constexpr int kCount = 20000, kRounds = 3;

// Processor time of this thread: what else runs does not count.
double thread_nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// The mean time of work(texel, wi, wo), which returns a number, over random texels and directions; the least of some
// rounds, since caches are shared with what else runs.
template <class Work>
double mean_nanoseconds(size_t texels, const Work& work) {
  struct Question {
    size_t texel;
    dvec3 wi, wo;
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto direction = [&] {
    const double z = 0.3 + 0.7 * uniform(random), phi = 2 * std::numbers::pi * uniform(random);
    const double s = std::sqrt(1 - z * z);
    return dvec3(s * std::cos(phi), s * std::sin(phi), z);
  };
  std::vector<Question> questions;
  for (int i = 0; i < kCount; ++i) questions.push_back({random() % texels, direction(), direction()});
  double sum = 0, least = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    const double start = thread_nanoseconds();
    for (const Question& q : questions) sum += work(q.texel, q.wi, q.wo);
    least = std::min(least, thread_nanoseconds() - start);
  }
  return std::isfinite(sum) ? least / kCount : 0;
}

DirectionTables tables_of(const std::vector<vec3>& directions) {
  if (directions.empty()) return {};
  auto found = triangulate(directions, "");
  return found ? std::move(*found) : DirectionTables{};
}

}  // namespace

double nanoseconds_of_material(const Spmm& spmm, int terms) {
  Spmm alone;
  if (terms < 0) alone = spmm, alone.residual = {};
  const Spmm& material = terms < 0 ? alone : spmm;
  const EditedTables rows = edited_tables(material, {});
  const DirectionTables directions = tables_of(material.residual.directions);
  const auto width = static_cast<size_t>(spmm.width);
  return mean_nanoseconds(spmm.texels.size(), [&](size_t texel, dvec3 wi, dvec3 wo) {
    return evaluate(material, rows, std::max(terms, 0), directions, static_cast<int>(texel % width),
                    static_cast<int>(texel / width), wi, wo)
        .x;
  });
}

double nanoseconds_of_tables(const std::vector<vec3>& directions, size_t texels, size_t rank) {
  const DirectionTables places = tables_of(directions);
  const size_t n = directions.size();
  // Numbers do not change the time; a record holds all terms of a pair.
  const std::vector<Half> records(n * n * rank * 3, half_from_float(0.25f)),
      coordinates(texels * rank, half_from_float(0.5f));
  return mean_nanoseconds(texels, [&](size_t texel, dvec3 wi, dvec3 wo) {
    const auto views = find_direction(places, vec3(wo)), lights = find_direction(places, vec3(wi));
    vec3 sum(0);
    for (size_t v = 0; v < 3; ++v)
      for (size_t l = 0; l < 3; ++l) {
        const size_t pair = static_cast<size_t>(views.slot[v]) * n + static_cast<size_t>(lights.slot[l]);
        const Half* record = records.data() + pair * rank * 3;
        vec3 value(0);
        for (size_t k = 0; k < rank; ++k) {
          const float factor = float_from_half(coordinates[texel * rank + k]);
          for (int c = 0; c < 3; ++c) value[c] += factor * float_from_half(record[3 * k + static_cast<size_t>(c)]);
        }
        sum += views.weight[v] * lights.weight[l] * value;
      }
    return double{sum.x + sum.y + sum.z};
  });
}

}  // namespace vamp::fit
