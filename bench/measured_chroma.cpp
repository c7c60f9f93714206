#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <thread>

#include "bench/measured.h"
#include "bench/temporary_folder.h"
#include "engine/brdf/registry.h"
#include "engine/btf/sparse_btf.h"
#include "engine/core/progress.h"
#include "engine/fit/residual.h"

namespace vamp {
namespace {

constexpr uint32_t kSide = 48;
constexpr size_t kClusters = 8, kRank = 32;

std::string percent(double error) { return fmt::format("{:.1f} %", 100 * error); }

// How many floats of the factors come back from a file, and how many of them with other bits.
struct RoundTrip {
  size_t floats = 0, changed = 0;
};

Result<RoundTrip> through_a_file(const FactoredBtf& factors) {
  VAMP_TRY(const TemporaryFolder folder, TemporaryFolder::make());
  VAMP_CHECK_STATUS(write_factored_btf(folder.path() / "a.btf", factors));
  VAMP_TRY(const FactoredBtf read, read_factored_btf(folder.path() / "a.btf"));
  RoundTrip trip;
  const auto compare = [&](const std::vector<float>& a, const std::vector<float>& b) {
    trip.floats += a.size();
    for (size_t i = 0; i < a.size(); ++i)
      trip.changed += i >= b.size() || std::memcmp(&a[i], &b[i], sizeof(float)) != 0 ? 1u : 0u;
  };
  for (size_t c = 0; c < factors.factors.size(); ++c) {
    compare(factors.factors[c].s, read.factors[c].s);
    compare(factors.factors[c].u, read.factors[c].u);
    compare(factors.factors[c].sxv, read.factors[c].sxv);
  }
  return trip;
}

Status measure_one(const std::filesystem::path& folder, const std::string& name, Report& report, Progress& progress) {
  progress.stage("Decoding " + name);
  VAMP_TRY(const SparseBtf sparse, read_sparse_btf(folder / ("Coeffs_BTF_" + name + "_1e-05_U.bin")));
  const TexelRect part{176, 176, kSide, kSide};
  const FactoredBtf factors = factored(sparse, part);
  VAMP_TRY(const RoundTrip trip, through_a_file(factors));
  VAMP_TRY(Btf btf, Btf::in_memory(info_of(sparse, part)));
  VAMP_CHECK_STATUS(decode(factors, btf, name, &progress));

  // No function stands for signed values: everything is residual.
  const fit::Worker worker{static_cast<int>(std::max(1u, std::thread::hardware_concurrency())), &progress};
  const fit::Measurement measurement(btf);
  const fit::Coordinates svd = fit::find_coordinates(measurement, {.rank = kRank}, worker);
  fit::Clustering clustering = fit::k_means(svd.coordinates, kClusters, 1, worker);
  fit::fit_subspaces(svd.coordinates, kMaxResidualTerms, 15, worker, clustering);
  const fit::Design design = fit::make_design({{"matte", default_lobe(Model::lambert), {0, 0, 1}, 0}}, measurement);
  const std::vector<fit::TexelWeights> none(measurement.texels());
  fit::ResidualFit residual =
      fit::find_tables(measurement, design, none, svd.coordinates, clustering, kMaxResidualTerms, worker);
  fit::fit_coefficients(measurement, design, none, clustering, worker, residual);
  if (progress.cancelled()) return {};

  const auto left = [&](double squared) { return std::sqrt(std::max(squared, 0.0) / svd.square); };
  const auto rank = [&](size_t terms) {
    double kept = 0;
    for (size_t t = 0; t < svd.coordinates.count; ++t)
      for (size_t k = 0; k < std::min(terms, svd.coordinates.length); ++k)
        kept += std::pow(double{svd.coordinates.row(t)[k]}, 2);
    return left(svd.square - kept);
  };
  report.row({name, fmt::format("{} of {}", trip.floats - trip.changed, trip.floats), percent(left(residual.errors[1])),
              percent(left(residual.errors[3])), percent(left(residual.errors[5])), percent(rank(8)),
              percent(rank(kRank))});
  report.data()["chroma"].push_back({{"name", name},
                                     {"provenance", sparse.info.provenance},
                                     {"floats", trip.floats},
                                     {"floats_changed", trip.changed},
                                     {"mean", left(residual.errors[1])},
                                     {"terms_2", left(residual.errors[3])},
                                     {"terms_4", left(residual.errors[5])},
                                     {"svd_8", rank(8)},
                                     {"svd_32", rank(kRank)}});
  return {};
}

}  // namespace

Status measure_chroma(const std::filesystem::path& folder, Report& report, Progress& progress) {
  report.table({"signed log-chroma", "factors that DFMF keeps to the bit", "8 clusters, mean", "2 terms", "4 terms",
                "SVD rank 8", "rank 32"});
  report.data()["chroma"] = Json::array();
  for (const char* name : {"felt05", "carpet07"}) VAMP_CHECK_STATUS(measure_one(folder, name, report, progress));
  return {};
}

}  // namespace vamp
