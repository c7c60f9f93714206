#include "engine/acquire/acquire.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>

#include "engine/acquire/parallel.h"
#include "engine/acquire/texel.h"
#include "engine/core/progress.h"

namespace vamp::acquire {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kBetweenSaves(20);

// In the provenance until the errors are known; the same number of characters each.
constexpr std::string_view kUnknown = "median ........ worst ........";
std::string known(const Report& report) {
  return fmt::format("median {:8.6f} worst {:8.6f}", std::min(report.median_error, 9.0),
                     std::min(report.worst_error, 9.0));
}

BtfInfo info_of(const Mesostructure& structure, const Options& options) {
  BtfInfo info;
  info.width = info.height = static_cast<uint32_t>(options.size);
  info.views = info.lights = options.directions;
  info.mm_per_texel = static_cast<float>(structure.mm / options.size);
  info.synthetic = true;
  info.name = structure.name;
  info.provenance = fmt::format(
      "Synthetic: path-traced by vamp's virtual goniometer, no camera, no registration error. Texels lie on the mean "
      "height. Relative standard error of a texel's values: {}. Job: {}",
      kUnknown, options.job.dump());
  info.licence = "CC0-1.0";
  return info;
}

std::vector<vec3> directions_of(const DirectionSet& set) {
  std::vector<vec3> directions;
  for (const dvec3& direction : set.directions) directions.emplace_back(direction);
  return directions;
}

Report summary(std::vector<float> errors) {
  Report report;
  if (errors.empty()) return report;
  std::sort(errors.begin(), errors.end());
  report.median_error = static_cast<double>(errors[errors.size() / 2]);
  report.worst_error = static_cast<double>(errors.back());
  report.mean_error = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
  return report;
}

// Rows of a BTF run downwards, against the y axis of its directions.
size_t place_of_row(size_t row, const BtfInfo& info) { return info.height - 1 - row; }

// What has been done, beside the unfinished file.
struct State {
  fs::path path;
  Json job;
  std::vector<uint8_t> rows;  // 1: done
  std::vector<float> errors;  // of each texel

  Status save() const {
    Json done = Json::array(), values = Json::array();
    const size_t width = errors.size() / rows.size();
    for (size_t y = 0; y < rows.size(); ++y) {
      if (rows[y] == 0) continue;
      done.push_back(y);
      for (size_t x = 0; x < width; ++x) values.push_back(json_number(errors[y * width + x]));
    }
    Json json;
    json["job"] = job;
    json["rows"] = std::move(done);
    json["errors"] = std::move(values);
    return write_text_atomically(path, print_json(json));
  }

  // False, and nothing done, when there is none of this job.
  bool load() {
    const auto text = read_text(path, uint64_t{1} << 30);
    if (!text) return false;
    const auto json = parse_json(*text, path.string());
    if (!json || !json->is_object() || !json->contains("job") || (*json)["job"] != job) return false;
    const JsonReader reader(*json, path.string());
    const size_t width = errors.size() / rows.size();
    const JsonReader done = reader.member("rows"), values = reader.member("errors");
    const size_t count = done.size(rows.size());
    if (values.size(errors.size()) != count * width) return false;
    State loaded = *this;
    for (size_t i = 0; i < count; ++i) {
      const auto y = static_cast<size_t>(done.element(i).integer(0, static_cast<int64_t>(rows.size()) - 1));
      loaded.rows[y] = 1;
      for (size_t x = 0; x < width; ++x) loaded.errors[y * width + x] = values.element(i * width + x).number(0, 1e6f);
    }
    if (!reader.status()) return false;
    *this = std::move(loaded);
    return true;
  }
};

void tell_errors(Btf& btf, const Report& report) {
  std::string provenance = btf.info().provenance;
  const size_t at = provenance.find(kUnknown);
  // Work that was stopped just before it got its name knows them already.
  if (at == std::string::npos) return;
  btf.set_provenance(provenance.replace(at, kUnknown.size(), known(report)));
}

}  // namespace

Result<Report> measure(Mesostructure structure, const Options& options, const fs::path& path, Progress& progress) {
  const fs::path part = path.string() + ".part";
  const BtfInfo info = info_of(structure, options);
  State state{part.string() + ".json", options.job, std::vector<uint8_t>(info.height),
              std::vector<float>(info.texel_count())};
  Report report;

  // Go on with what there is, or begin.
  Result<Btf> btf = fail(ErrorKind::failed, "", "", "");
  if (state.load()) {
    btf = Btf::open(part, MapAccess::read_write);
    if (!btf || btf->info().texel_count() != info.texel_count() || btf->values_per_texel() != info.values_per_texel()) {
      btf = fail(ErrorKind::failed, "", "", "");
      std::fill(state.rows.begin(), state.rows.end(), uint8_t{0});
    }
  }
  if (!btf) {
    std::error_code code;
    fs::remove(state.path, code);
    btf = Btf::create(part, info);
    if (!btf) return tl::unexpected(btf.error());
  }
  report.resumed_rows = std::accumulate(state.rows.begin(), state.rows.end(), 0);

  progress.stage("shadows");
  const std::vector<vec3> directions = directions_of(options.directions);
  const Goniometer goniometer(std::move(structure), directions, options.shadows, options.threads, &progress);
  progress.stage("measuring");

  std::mutex mutex;
  Status saved;
  int done = report.resumed_rows;
  auto last_save = Clock::now();
  const auto save = [&]() -> Status {
    VAMP_CHECK_STATUS(btf->flush());
    return state.save();
  };
  const bool finished = parallel(options.threads, static_cast<int>(info.height), [&](int y) {
    const auto row = static_cast<size_t>(y);
    if (state.rows[row] != 0) return true;
    TexelMeter meter(goniometer, directions, options);
    std::vector<float> errors(info.width);
    for (size_t x = 0; x < info.width; ++x) {
      if (progress.cancelled()) return false;
      errors[x] = meter.measure(x, place_of_row(row, info));
      btf->write_texel(row * info.width + x, meter.values());
    }
    const std::lock_guard lock(mutex);
    std::copy(errors.begin(), errors.end(), state.errors.begin() + static_cast<std::ptrdiff_t>(row * info.width));
    state.rows[row] = 1;
    report.paths += static_cast<double>(info.width) * static_cast<double>(directions.size()) * options.samples;
    progress.fraction(static_cast<float>(++done) / static_cast<float>(info.height));
    if (Clock::now() - last_save > kBetweenSaves) {
      saved = save();
      last_save = Clock::now();
    }
    btf->forget(row * info.width, info.width);
    return saved.has_value();
  });
  VAMP_CHECK_STATUS(saved);
  VAMP_CHECK_STATUS(save());
  if (!finished)
    return fail(ErrorKind::interrupted, path.string(), "",
                fmt::format("stopped after {} of {} rows; the same command goes on from there", done, info.height));

  const Report errors = summary(state.errors);
  report.median_error = errors.median_error;
  report.mean_error = errors.mean_error;
  report.worst_error = errors.worst_error;
  tell_errors(*btf, report);
  VAMP_CHECK_STATUS(btf->flush());
  std::error_code code;
  fs::rename(part, path, code);
  if (code) return fail(ErrorKind::io, path.string(), "", "a place for the finished file", code.message());
  fs::remove(state.path, code);
  return report;
}

Result<Btf> measure_in_memory(Mesostructure structure, const Options& options, std::vector<float>& errors) {
  VAMP_TRY(Btf btf, Btf::in_memory(info_of(structure, options)));
  const std::vector<vec3> directions = directions_of(options.directions);
  const Goniometer goniometer(std::move(structure), directions, options.shadows, options.threads);
  const size_t width = btf.info().width;
  errors.assign(btf.texel_count(), 0);
  parallel(options.threads, options.size, [&](int y) {
    TexelMeter meter(goniometer, directions, options);
    for (size_t x = 0; x < width; ++x) {
      const size_t texel = static_cast<size_t>(y) * width + x;
      errors[texel] = meter.measure(x, place_of_row(static_cast<size_t>(y), btf.info()));
      btf.write_texel(texel, meter.values());
    }
    return true;
  });
  tell_errors(btf, summary(errors));
  return btf;
}

}  // namespace vamp::acquire
