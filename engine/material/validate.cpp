#include <fmt/format.h>

#include <cmath>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"
#include "engine/material/spmm.h"

namespace vamp {
namespace {

constexpr size_t kMaxRows = size_t{1} << 20;  // clusters * functions: 48 MiB of rows
constexpr size_t kMaxName = 256;

bool finite_half(uint32_t bits) { return (bits & 0x7c00u) != 0x7c00u; }
bool finite_halves(uint32_t two) { return finite_half(two) && finite_half(two >> 16); }

std::string number(double value) { return fmt::format("{}", value); }

Status check_dictionary(const Spmm& spmm, std::string_view file) {
  for (size_t i = 0; i < spmm.dictionary.size(); ++i) {
    const Basis& basis = spmm.dictionary[i];
    const std::string place = fmt::format("basis[{}]", i);
    const auto refuse = [&](std::string_view member, std::string_view expected, const std::string& found) {
      return fail(ErrorKind::bad_input, file, place + "." + std::string(member), expected, found);
    };
    VAMP_CHECK_STATUS(validate(basis.lobe, file, place));
    if (basis.name.size() > kMaxName) return refuse("name", "at most 256 bytes", std::to_string(basis.name.size()));
    const dvec3 n(basis.normal);
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (!(std::abs(length - 1) < 1e-3)) return refuse("normal", "a unit vector", "length " + number(length));
    if (!(n.z > 0)) return refuse("normal", "z above 0", number(n.z));
    if (!std::isfinite(basis.psi)) return refuse("psi", "a finite angle", number(double{basis.psi}));
  }
  return {};
}

Status check_texels(const Spmm& spmm, std::string_view file) {
  for (size_t i = 0; i < spmm.texels.size(); ++i) {
    const tables::Texel& texel = spmm.texels[i];
    const auto refuse = [&](std::string_view member, const std::string& expected, const std::string& found) {
      const size_t width = static_cast<size_t>(spmm.width);
      return fail(ErrorKind::bad_input, file, fmt::format("texel ({}, {}).{}", i % width, i / width, member), expected,
                  found);
    };
    const uint32_t cluster = texel.cluster_count & 0xffu, count = texel.cluster_count >> 8 & 0xffu;
    if (cluster >= spmm.clusters.size())
      return refuse("cluster", fmt::format("below {}", spmm.clusters.size()), std::to_string(cluster));
    if (texel.cluster_count >> 16 != 0)
      return refuse("cluster and count", "16 bits", std::to_string(texel.cluster_count));
    if (uint64_t{texel.first_entry} + count > spmm.entries.size())
      return refuse("entries", fmt::format("within {}", spmm.entries.size()),
                    fmt::format("{} + {}", texel.first_entry, count));
    if (!finite_halves(texel.coefficients01) || !finite_halves(texel.coefficients23))
      return refuse("coefficients", "finite numbers", "NaN or infinity");
  }
  for (size_t i = 0; i < spmm.entries.size(); ++i) {
    const tables::Entry& entry = spmm.entries[i];
    const std::string place = fmt::format("entry[{}]", i);
    if ((entry.basis_red & 0xffffu) >= spmm.dictionary.size())
      return fail(ErrorKind::bad_input, file, place + ".basis", fmt::format("below {}", spmm.dictionary.size()),
                  std::to_string(entry.basis_red & 0xffffu));
    if (!finite_half(entry.basis_red >> 16) || !finite_halves(entry.green_blue))
      return fail(ErrorKind::bad_input, file, place + ".weight", "finite numbers", "NaN or infinity");
  }
  return {};
}

Status check_residual(const Spmm& spmm, std::string_view file) {
  const Residual& residual = spmm.residual;
  if (residual.terms < 0 || residual.terms > kMaxResidualTerms)
    return fail(ErrorKind::bad_input, file, "residual.terms", "0 to 4", std::to_string(residual.terms));
  if (residual.records.empty()) return {};
  const size_t count = residual.directions.size();
  if (count == 0 || count > kMaxDirections)
    return fail(ErrorKind::bad_input, file, "residual.directions", fmt::format("1 to {}", kMaxDirections),
                std::to_string(count));
  for (size_t i = 0; i < count; ++i) {
    const dvec3 w(residual.directions[i]);
    const double length = std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
    if (!(std::abs(length - 1) < 1e-3) || !(w.z >= 0))
      return fail(ErrorKind::bad_input, file, fmt::format("residual.directions[{}]", i),
                  "a unit vector above the horizon", fmt::format("({}, {}, {})", w.x, w.y, w.z));
  }
  if (residual.records.size() != spmm.clusters.size() * count * count)
    return fail(ErrorKind::bad_input, file, "residual", fmt::format("{} records", spmm.clusters.size() * count * count),
                std::to_string(residual.records.size()));
  for (size_t i = 0; i < residual.records.size(); ++i)
    for (const uint32_t two : residual.records[i].halves)
      if (!finite_halves(two))
        return fail(
            ErrorKind::bad_input, file,
            fmt::format("residual of cluster {}, view {}, light {}", i / (count * count), i / count % count, i % count),
            "finite numbers", "NaN or infinity");
  return {};
}

}  // namespace

Status validate(const Spmm& spmm, std::string_view file) {
  const auto range = [&](std::string_view what, size_t value, size_t low, size_t high) -> Status {
    if (value >= low && value <= high) return {};
    return fail(ErrorKind::bad_input, file, what, fmt::format("{} to {}", low, high), std::to_string(value));
  };
  if (spmm.width < 1 || spmm.height < 1 || spmm.width > kMaxTexelSide || spmm.height > kMaxTexelSide)
    return fail(ErrorKind::bad_input, file, "texels", fmt::format("sides from 1 to {}", kMaxTexelSide),
                fmt::format("{} x {}", spmm.width, spmm.height));
  if (!(spmm.mm_per_texel >= 1e-6f && spmm.mm_per_texel <= 1e6f))
    return fail(ErrorKind::bad_input, file, "mm per texel", "from 1e-6 to 1e6", number(double{spmm.mm_per_texel}));
  const size_t texels = static_cast<size_t>(spmm.width) * static_cast<size_t>(spmm.height);
  VAMP_CHECK_STATUS(range("texel count", spmm.texels.size(), texels, texels));
  VAMP_CHECK_STATUS(range("clusters", spmm.clusters.size(), 1, kMaxClusters));
  VAMP_CHECK_STATUS(range("basis", spmm.dictionary.size(), 1, kMaxBases));
  VAMP_CHECK_STATUS(range("clusters times functions", spmm.clusters.size() * spmm.dictionary.size(), 1, kMaxRows));
  VAMP_CHECK_STATUS(range("entry count", spmm.entries.size(), 0, texels * 255));
  for (size_t i = 0; i < spmm.clusters.size(); ++i)
    VAMP_CHECK_STATUS(range(fmt::format("clusters[{}].name length", i), spmm.clusters[i].name.size(), 0, kMaxName));
  VAMP_CHECK_STATUS(check_dictionary(spmm, file));
  VAMP_CHECK_STATUS(check_texels(spmm, file));
  return check_residual(spmm, file);
}

}  // namespace vamp
