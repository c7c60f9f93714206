#include "bench/fit_figures.h"

#include <fmt/format.h>

#include "engine/core/files.h"
#include "engine/fit/fit.h"
#include "engine/fit/quality.h"

namespace vamp {
namespace {

// Changes whenever the figures mean something else, so that old ones are not taken.
constexpr int kVersion = 3;
constexpr int kManyBases = 192;  // as good as no limit: what is left of 64 texels' lobes without repeats

Json number(double value) { return json_number(static_cast<float>(value)); }

class Fitter {
 public:
  Fitter(const FitData& data, int threads, Progress& progress) : data_(data), threads_(threads), progress_(progress) {}

  Result<Spmm> fit(fit::FitOptions options) {
    options.threads = threads_;
    VAMP_TRY(fit::FitResult result, fit::fit_spmm(data_.measured, options, &progress_));
    return std::move(result.spmm);
  }

  Result<fit::Quality> quality(const Spmm& spmm, bool between, bool curves) {
    fit::QualityOptions options;
    options.ranks = curves ? std::vector<size_t>{4, 8, 10, 16, 32, 64} : std::vector<size_t>{8};
    options.shared = curves ? std::vector<size_t>{4, 8, 16, 32} : std::vector<size_t>{};
    options.max_rank = curves ? 160 : 8;
    options.threads = threads_;
    return fit::measure_quality(spmm, data_.measured, between ? &data_.between : nullptr, options, &progress_);
  }

  // All representations beside a fit, by both measurements.
  Result<Json> curve(const Spmm& spmm) {
    VAMP_TRY(const fit::Quality on, quality(spmm, false, true));
    VAMP_TRY(const fit::Quality off, quality(spmm, true, true));
    Json rows = Json::array();
    for (size_t i = 0; i < on.representations.size(); ++i) {
      const fit::Representation &a = on.representations[i], &b = off.representations[i];
      rows.push_back({{"name", a.name},
                      {"kib", a.bytes / 1024},
                      {"ns", number(a.nanoseconds)},
                      {"measured", number(a.uniform)},
                      {"between", number(b.uniform)},
                      {"mssim", number(b.half_mssim)}});
    }
    return rows;
  }

  // The error of one representation of a fit, and of the spatial reflectance field beside it.
  Result<Json> point(const Spmm& spmm, const char* name) {
    VAMP_TRY(const fit::Quality on, quality(spmm, false, false));
    Json found;
    for (const fit::Representation& r : on.representations)
      if (r.name == name || r.name == "srf") found[r.name == name ? "fit" : "srf"] = {{"measured", number(r.uniform)}};
    return found;
  }

  // A fit without the 45 degree ring: its error on that ring and on the directions used.
  Result<Json> ring(const Spmm& spmm) {
    VAMP_TRY(const fit::Quality on, quality(spmm, false, false));
    for (const fit::Representation& r : on.representations)
      if (r.name == "with 4 terms" && r.held_out) return Json{{"ring", number(*r.held_out)}, {"used", number(*r.seen)}};
    return Json{};
  }

 private:
  const FitData& data_;
  int threads_;
  Progress& progress_;
};

}  // namespace

Result<Json> fit_figures(const FitMaterial& material, const FitDataOptions& options, int threads, Progress& progress) {
  const fs::path path = options.cache / fmt::format("{}.json", material.name);
  const Json key = {{"version", kVersion}, {"size", options.size}, {"samples", options.samples}};
  Json figures;
  if (const auto text = read_text(path, 1 << 20))
    if (auto old = parse_json(*text, path.string()); old && old->contains("key") && (*old)["key"] == key)
      figures = std::move(*old);
  if (figures.contains(options.all ? "any" : "small_curve")) return figures;

  VAMP_TRY(const FitData data, fit_data(material, options, progress));
  Fitter fitter(data, threads, progress);
  figures["key"] = key;
  figures["noise"] = number(data.noise);
  figures["noise_between"] = number(data.noise_between);
  figures["tilt"] = number(data.tilt);
  // Each part is kept as soon as it is there.
  const auto part = [&](Json& into, const std::string& name, const fit::FitOptions& fit, const auto& judge) -> Status {
    if (into.contains(name)) return {};
    VAMP_TRY(const Spmm spmm, fitter.fit(fit));
    VAMP_TRY(into[name], judge(spmm));
    return write_text_atomically(path, print_json(figures));
  };
  const fit::FitOptions usual{.clusters = kFitClusters};
  VAMP_CHECK_STATUS(part(figures, "curve", usual, [&](const Spmm& spmm) { return fitter.curve(spmm); }));
  VAMP_CHECK_STATUS(part(figures, "small_curve", {.clusters = kSmallFitClusters},
                         [&](const Spmm& spmm) { return fitter.curve(spmm); }));
  if (!options.all) return figures;
  fit::FitOptions few = usual, few_any = usual, any = usual, ring = usual;
  few.functions = few_any.functions = 3;
  few.slack = few_any.slack = 0;
  few.terms = few_any.terms = -1;
  any.bases = few_any.bases = kManyBases;
  ring.left_out = {45};
  const auto alone = [&](const Spmm& spmm) { return fitter.point(spmm, "functions"); };
  VAMP_CHECK_STATUS(part(figures, "few", few, alone));
  VAMP_CHECK_STATUS(part(figures, "ring", ring, [&](const Spmm& spmm) { return fitter.ring(spmm); }));
  VAMP_CHECK_STATUS(part(figures, "few_any", few_any, alone));
  VAMP_CHECK_STATUS(part(figures, "any", any, [&](const Spmm& spmm) { return fitter.point(spmm, "with 4 terms"); }));
  return figures;
}

}  // namespace vamp
