#include "engine/fit/quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <thread>

#include "engine/core/jobs.h"
#include "engine/fit/pictures.h"
#include "engine/fit/represent.h"
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

// The representations of one texel in their order, each built on the one before: functions, mean, terms; SVD ranks.
class Stack {
 public:
  Stack(const SpmmValues& spmm, const Rows& directions, const Rows& coordinates, std::vector<size_t> ranks,
        const SimpleModels& simple, const Pairs& pairs)
      : spmm_(spmm),
        directions_(directions),
        coordinates_(coordinates),
        ranks_(std::move(ranks)),
        simple_(simple),
        simple_columns_(simple.columns_at(pairs)) {}

  size_t count() const { return static_cast<size_t>(spmm_.terms() + 2) + ranks_.size() + 2; }

  // see(index, values) for every representation.
  template <class See>
  void texel(size_t texel, std::vector<float>& row, const See& see) const {
    size_t index = 0;
    spmm_.functions(texel, row.data());
    see(index++, row);
    for (int k = 0; k <= spmm_.terms(); ++k) {
      spmm_.add_residual(texel, k, row.data());
      see(index++, row);
    }
    std::fill(row.begin(), row.end(), 0.f);
    size_t done = 0;
    for (const size_t rank : ranks_) {
      add_combinations(coordinates_.row(texel) + done, 1, directions_.row(done), rank - done, directions_.length,
                       row.data());
      done = rank;
      see(index++, row);
    }
    simple_.blinn_phong(texel, simple_columns_, row.data());
    see(index++, row);
    simple_.srf(texel, simple_columns_, row.data());
    see(index++, row);
  }

 private:
  const SpmmValues& spmm_;
  const Rows& directions_;
  const Rows& coordinates_;
  std::vector<size_t> ranks_;
  const SimpleModels& simple_;
  Rows simple_columns_;
};

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

double nanoseconds_of(const Spmm& spmm) {
  const EditedTables rows = edited_tables(spmm, {});
  DirectionTables directions;
  if (!spmm.residual.records.empty())
    if (auto found = triangulate(spmm.residual.directions, "")) directions = std::move(*found);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  constexpr int kCount = 20000;
  double sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kCount; ++i) {
    const auto direction = [&] {
      const double z = 0.3 + 0.7 * uniform(random), phi = 6.283185307179586 * uniform(random), s = std::sqrt(1 - z * z);
      return dvec3(s * std::cos(phi), s * std::sin(phi), z);
    };
    const int x = static_cast<int>(uniform(random) * spmm.width), y = static_cast<int>(uniform(random) * spmm.height);
    sum += evaluate(spmm, rows, kMaxResidualTerms, directions, x, y, direction(), direction()).x;
  }
  const double took = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  return std::isfinite(sum) ? took / kCount : 0;
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

  // Truncated SVDs, that of the material's bytes among them.
  const uint64_t bytes = bytes_on_gpu(spmm), each_rank = 2 * (texels + source.values());
  const size_t equal = std::clamp<size_t>(static_cast<size_t>(bytes / each_rank), 1, options.max_rank);
  std::vector<size_t> ranks = options.ranks;
  ranks.push_back(equal);
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  const Coordinates svd = find_coordinates(
      source, {.rank = ranks.back(), .power_iterations = 2, .sample = std::min<size_t>(texels, 8192)}, worker);
  if (worker.cancelled()) return JobQueue::cancelled_error();
  for (size_t& rank : ranks) rank = std::min(rank, svd.directions.count);
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());

  VAMP_TRY(const SpmmValues model, SpmmValues::make(spmm, pairs));
  VAMP_TRY(const Rows directions, resampled_directions(svd, source, pairs));
  const SimpleModels simple(source, worker);
  const Stack stack(model, directions, svd.coordinates, ranks, simple, pairs);
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
  quality.nanoseconds = nanoseconds_of(spmm);

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

  const uint64_t without_residual = spmm.texels.size() * 8 + spmm.entries.size() * 8 + spmm.dictionary.size() * 48;
  const uint64_t a_table = spmm.clusters.size() * source.values() * 2;
  for (size_t i = 0; i < stack.count(); ++i) {
    Representation r;
    const int terms = static_cast<int>(i) - 1;  // of a material: -1 functions alone, 0 the mean
    if (terms <= model.terms()) {
      r.name = terms < 0    ? "functions"
               : terms == 0 ? "with mean"
                            : fmt::format("with {} term{}", terms, terms == 1 ? "" : "s");
      r.bytes = without_residual;
      if (terms >= 0)
        r.bytes += a_table * static_cast<uint64_t>(terms + 1) + spmm.texels.size() * 2 * static_cast<uint64_t>(terms);
    } else if (const size_t other = i - static_cast<size_t>(model.terms() + 2); other < ranks.size()) {
      r.name = fmt::format("svd rank {}", ranks[other]);
      r.bytes = each_rank * ranks[other];
    } else {
      // Halves: two colours and an exponent, or three shapes.
      const bool srf = other > ranks.size();
      r.name = srf ? "srf" : "blinn-phong";
      r.bytes = spmm.texels.size() * (srf ? 18 : 14);
    }
    const PairErrors& errors = sums[0][i];
    r.uniform = relative(errors, [](size_t) { return 1.0; });
    r.weighted = relative(errors, [&](size_t p) { return std::pow(double{weighted.roots()[p]}, 2); });
    if (any_new)
      r.held_out =
          relative(errors, [&](size_t p) { return new_view[p / lights] || new_light[p % lights] ? 1.0 : 0.0; });
    for (const auto& [angle, views] : rings)
      r.rings.push_back(relative(errors, [&, &ring = views](size_t p) {
        return std::binary_search(ring.begin(), ring.end(), p / lights) ? 1.0 : 0.0;
      }));
    r.negative = static_cast<double>(errors.negative) / static_cast<double>(texels * values);
    pictures.compare(i, r.psnr, r.mssim, r.half_psnr, r.half_mssim);
    quality.representations.push_back(std::move(r));
  }
  return quality;
}

}  // namespace vamp::fit
