#include "engine/fit/quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <thread>

#include "engine/core/jobs.h"
#include "engine/fit/cost.h"
#include "engine/fit/pictures.h"
#include "engine/fit/represent.h"
#include "engine/fit/shared_residual.h"
#include "engine/fit/simple.h"

namespace vamp::fit {
namespace {

constexpr size_t kBlock = 64;  // texels looked at by one piece of work

// Sums over texels of what one representation is off, pair by pair.
struct PairErrors {
  std::vector<double> squares;
  size_t negative = 0;
};

bool measured(const std::vector<vec3>& directions, vec3 w) {
  return std::any_of(directions.begin(), directions.end(),
                     [&](vec3 d) { return d.x * w.x + d.y * w.y + d.z * w.z > 1 - 1e-6f; });
}

double degrees(vec3 w) { return std::acos(std::clamp(double{w.z}, -1.0, 1.0)) * 180 / 3.14159265358979324; }

// What is compared with the measurement, texel by texel, in the order of the report.
struct Candidates {
  const SpmmValues& spmm;
  const Rows &svd_rows, &svd_coordinates;
  std::vector<size_t> ranks;
  const Rows &shared_rows, &shared_coordinates;
  std::vector<size_t> shared;
  const SimpleModels& simple;
  Rows simple_columns;

  size_t count() const { return static_cast<size_t>(spmm.terms() + 2) + ranks.size() + shared.size() + 2; }

  // see(index, values) for every representation, each built on the one before.
  template <class See>
  void texel(size_t texel, std::vector<float>& row, const See& see) const {
    size_t index = 0;
    const auto add_up = [&](const Rows& rows, const Rows& coordinates, const std::vector<size_t>& counts) {
      size_t done = 0;
      for (const size_t many : counts) {
        add_combinations(coordinates.row(texel) + done, 1, rows.row(done), many - done, rows.length, row.data());
        done = many;
        see(index++, row);
      }
    };
    spmm.functions(texel, row.data());
    see(index++, row);
    for (int k = 0; k <= spmm.terms(); ++k) {
      spmm.add_residual(texel, k, row.data());
      see(index++, row);
    }
    std::fill(row.begin(), row.end(), 0.f);
    add_up(svd_rows, svd_coordinates, ranks);
    if (!shared.empty()) {
      spmm.functions(texel, row.data());
      add_up(shared_rows, shared_coordinates, shared);
    }
    simple.blinn_phong(texel, simple_columns, row.data());
    see(index++, row);
    simple.srf(texel, simple_columns, row.data());
    see(index++, row);
  }
};

// Names, bytes and costs of the same. Halves: two colours and an exponent, or three shapes, of the simple models.
std::vector<Representation> described(const Spmm& spmm, const Candidates& candidates, size_t values) {
  std::vector<Representation> list;
  const size_t texels = spmm.texels.size();
  const uint64_t functions = texels * 8 + spmm.entries.size() * 8 + spmm.dictionary.size() * 48;
  const uint64_t a_table = spmm.clusters.size() * values * 2, each_rank = 2 * (texels + values);
  for (int terms = -1; terms <= candidates.spmm.terms(); ++terms) {
    Representation r;
    r.name = terms < 0    ? "functions"
             : terms == 0 ? "with mean"
                          : fmt::format("with {} term{}", terms, terms == 1 ? "" : "s");
    r.bytes =
        functions + a_table * static_cast<uint64_t>(terms + 1) + texels * 2 * static_cast<uint64_t>(std::max(terms, 0));
    r.nanoseconds = nanoseconds_of_material(spmm, terms);
    list.push_back(std::move(r));
  }
  const double alone = list.front().nanoseconds;
  const auto tables = [&](size_t rank) { return nanoseconds_of_tables(spmm.residual.directions, texels, rank); };
  const bool known = !spmm.residual.directions.empty();
  for (const size_t rank : candidates.ranks)
    list.push_back(
        {.name = fmt::format("svd rank {}", rank), .bytes = each_rank * rank, .nanoseconds = known ? tables(rank) : 0});
  for (const size_t rank : candidates.shared)
    list.push_back({.name = fmt::format("shared {}", rank),
                    .bytes = functions + each_rank * rank,
                    .nanoseconds = known ? alone + tables(rank) : 0});
  list.push_back({.name = "blinn-phong", .bytes = texels * 14});
  list.push_back({.name = "srf", .bytes = texels * 18});
  return list;
}

// The truncated SVD under the material's directions, its rows without their roots, read at the pairs of `at`.
Result<Rows> resampled_directions(const Coordinates& svd, const Measurement& source, const Pairs& at) {
  Rows plain = svd.directions;
  for (size_t k = 0; k < plain.count; ++k)
    for (size_t i = 0; i < plain.length; ++i) plain.row(k)[i] /= source.roots()[i % source.pair_count()];
  return resample(plain, source.pairs().views, at);
}

// Rings of a BTF that a material was not fitted to.
std::vector<double> missing_rings(const Btf& btf, const std::vector<vec3>& directions) {
  std::vector<double> rings;
  for (const dvec3& view : btf.info().views.directions)
    if (!measured(directions, vec3(view))) rings.push_back(degrees(vec3(view)));
  return rings;
}

// What there is room for in these bytes, added to the others; sorted.
void add_equal(std::vector<size_t>& ranks, uint64_t bytes, uint64_t each, size_t most) {
  ranks.push_back(std::clamp<size_t>(static_cast<size_t>(bytes / each), 1, most));
  std::sort(ranks.begin(), ranks.end());
}

void limit(std::vector<size_t>& ranks, size_t most) {
  for (size_t& rank : ranks) rank = std::min(rank, most);
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
}

}  // namespace

Result<Quality> measure_quality(const Spmm& spmm, const Btf& btf, const Btf* against, const QualityOptions& options,
                                Progress* progress) {
  const Btf& truth = against != nullptr ? *against : btf;
  for (const Btf* each : {&btf, &truth}) {
    const BtfInfo& info = each->info();
    if (static_cast<int>(info.width) != spmm.width || static_cast<int>(info.height) != spmm.height)
      return fail(ErrorKind::bad_input, info.name, "size", fmt::format("{} x {} texels", spmm.width, spmm.height),
                  fmt::format("{} x {}", info.width, info.height));
    if (info.colour != BtfColour::rec709)
      return fail(ErrorKind::bad_input, info.name, "colour", "reflectance in red, green and blue", "signed logarithms");
  }
  Worker worker{options.threads, progress};
  if (worker.threads <= 0) worker.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));

  const std::vector<vec3>& own = spmm.residual.directions;
  const Measurement source(btf, 0.5, own.empty() ? std::vector<double>{} : missing_rings(btf, own));
  const Measurement weighted(truth, 0.5), plain(truth, 0);
  const Pairs& pairs = plain.pairs();
  const size_t values = plain.values(), count = plain.pair_count(), texels = plain.texels();

  // Truncated SVDs and residuals of the whole material, those of the material's bytes among them.
  const uint64_t bytes = bytes_on_gpu(spmm), each_rank = 2 * (texels + source.values());
  std::vector<size_t> ranks = options.ranks, shared = options.shared;
  add_equal(ranks, bytes, each_rank, options.max_rank);
  const uint64_t functions_bytes = spmm.texels.size() * 8 + spmm.entries.size() * 8;
  if (!shared.empty()) add_equal(shared, bytes - std::min(bytes, functions_bytes), each_rank, options.max_rank);
  // What the functions leave lies in directions of less energy, so that it needs a longer list of them.
  const size_t most = std::max(ranks.back(), shared.empty() ? 1 : std::min(2 * shared.back(), options.max_rank));
  const Coordinates svd =
      find_coordinates(source, {.rank = most, .power_iterations = 2, .sample = std::min<size_t>(texels, 8192)}, worker);
  if (worker.cancelled()) return JobQueue::cancelled_error();
  limit(ranks, svd.directions.count);
  limit(shared, svd.directions.count);

  VAMP_TRY(const SpmmValues model, SpmmValues::make(spmm, pairs));
  VAMP_TRY(const Rows directions, resampled_directions(svd, source, pairs));
  const SimpleModels simple(source, worker);
  Rows shared_rows, shared_coordinates;
  if (!shared.empty()) {
    const SharedResidual residual(svd, source, spmm);
    shared_rows = residual.rotated(directions);
    shared_coordinates = residual.coordinates();
  }
  const Candidates stack{model,  directions, svd.coordinates,         ranks, shared_rows, shared_coordinates,
                         shared, simple,     simple.columns_at(pairs)};
  Pictures pictures(pairs, static_cast<int>(truth.info().width), static_cast<int>(truth.info().height), stack.count());

  worker.stage("Comparing");
  const size_t blocks = (texels + kBlock - 1) / kBlock;
  // Blocks are summed in a fixed number of groups, in order.
  constexpr size_t kGroups = 16;
  std::vector<std::vector<PairErrors>> sums(kGroups);
  std::vector<std::vector<double>> squares(kGroups, std::vector<double>(count));
  worker.each(kGroups, [&](size_t group) {
    sums[group].assign(stack.count(), {std::vector<double>(count), 0});
    std::vector<float> data(values), row(values);
    for (size_t t = blocks * group / kGroups * kBlock;
         t < std::min(texels, blocks * (group + 1) / kGroups * kBlock) && !worker.cancelled(); ++t) {
      plain.read(t, data.data());
      truth.forget(t, 1);
      for (size_t i = 0; i < values; ++i) squares[group][i % count] += double{data[i]} * double{data[i]};
      pictures.set_truth(t, data.data());
      stack.texel(t, row, [&](size_t index, const std::vector<float>& seen) {
        PairErrors& errors = sums[group][index];
        for (size_t c = 0; c < 3; ++c)
          for (size_t p = 0; p < count; ++p) {
            const float value = seen[c * count + p], difference = std::max(value, 0.f) - data[c * count + p];
            errors.squares[p] += double{difference * difference};
            errors.negative += value < -1e-3f ? 1u : 0u;
          }
        pictures.set(index, t, seen.data());
      });
    }
  });
  if (worker.cancelled()) return JobQueue::cancelled_error();
  for (size_t group = 1; group < kGroups; ++group)
    for (size_t i = 0; i < stack.count(); ++i) {
      for (size_t p = 0; p < count; ++p) sums[0][i].squares[p] += sums[group][i].squares[p];
      sums[0][i].negative += sums[group][i].negative;
    }
  for (size_t group = 1; group < kGroups; ++group)
    for (size_t p = 0; p < count; ++p) squares[0][p] += squares[group][p];

  Quality quality;
  std::map<int, std::vector<size_t>> rings;  // by rounded polar angle of the view
  for (size_t v = 0; v < pairs.views.size(); ++v)
    rings[static_cast<int>(std::lround(degrees(pairs.views[v])))].push_back(v);
  for (const auto& [angle, views] : rings) quality.ring_angles.push_back(angle);
  quality.pictures = pictures.count();
  quality.functions_per_texel = static_cast<double>(spmm.entries.size()) / static_cast<double>(texels);

  const auto relative = [&](const PairErrors& errors, const auto& weight) {
    double error = 0, square = 0;
    for (size_t p = 0; p < count; ++p) {
      const double w = weight(p);
      error += w * errors.squares[p];
      square += w * squares[0][p];
    }
    return square > 0 ? std::sqrt(error / square) : 0.0;
  };
  const size_t lights = pairs.lights.size();
  std::vector<bool> new_view, new_light;
  for (const vec3& w : pairs.views) new_view.push_back(!measured(own.empty() ? source.pairs().views : own, w));
  for (const vec3& w : pairs.lights) new_light.push_back(!measured(own.empty() ? source.pairs().lights : own, w));
  const bool any_new =
      std::count(new_view.begin(), new_view.end(), true) + std::count(new_light.begin(), new_light.end(), true) > 0;

  std::vector<Representation> list = described(spmm, stack, source.values());
  for (size_t i = 0; i < stack.count(); ++i) {
    Representation& r = list[i];
    const PairErrors& errors = sums[0][i];
    r.uniform = relative(errors, [](size_t) { return 1.0; });
    r.weighted = relative(errors, [&](size_t p) { return std::pow(double{weighted.roots()[p]}, 2); });
    if (any_new) {
      const auto is_new = [&](size_t p) { return new_view[p / lights] || new_light[p % lights]; };
      r.held_out = relative(errors, [&](size_t p) { return is_new(p) ? 1.0 : 0.0; });
      r.seen = relative(errors, [&](size_t p) { return is_new(p) ? 0.0 : 1.0; });
    }
    for (const auto& [angle, views] : rings)
      r.rings.push_back(relative(errors, [&, &ring = views](size_t p) {
        return std::binary_search(ring.begin(), ring.end(), p / lights) ? 1.0 : 0.0;
      }));
    r.negative = static_cast<double>(errors.negative) / static_cast<double>(texels * values);
    pictures.compare(i, r.psnr, r.mssim, r.half_psnr, r.half_mssim);
  }
  quality.nanoseconds = list[static_cast<size_t>(model.terms() + 1)].nanoseconds;
  quality.representations = std::move(list);
  return quality;
}

}  // namespace vamp::fit
