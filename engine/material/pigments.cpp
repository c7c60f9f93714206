#include "engine/material/pigments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "engine/core/half.h"
#include "engine/material/frame.h"
#include "engine/material/reflectance.h"
#include "engine/material/residual_follow.h"

namespace vamp {
namespace {

// How much a cluster's map of colours is drawn to that of all clusters, to what is said of each named colour, and to a
// mere factor where all these leave it open: shares of the sums of squares. Measured by `vamp bench edits`.
constexpr double kToAll = 1e-2, kToNamed = 1, kToFactor = 1e-5;

// Colours as non-negative mixtures of others. With non-negative amounts, some three colours or fewer are always as near
// as all (Caratheodory), and those are solved in advance: each set is a matrix.
class Mixtures {
 public:
  explicit Mixtures(const PigmentChange& change) {
    std::vector<dvec3> colours = {dvec3(change.from)};
    for (const vec3 colour : change.staying) colours.emplace_back(colour);
    const size_t n = colours.size();
    for (size_t i = 0; i < n; ++i) {
      add(colours, {i}, dvec3(change.to));
      for (size_t j = i + 1; j < n; ++j) {
        add(colours, {i, j}, dvec3(change.to));
        for (size_t k = j + 1; k < n; ++k) add(colours, {i, j, k}, dvec3(change.to));
      }
    }
  }

  // A colour as the nearest mixture.
  struct Mixture {
    double amount = 0;  // of `from`
    dvec3 moves{0};     // what the exchange adds
    dvec3 left{0};      // of the colour, beside the mixture
  };
  Mixture of(const dvec3& colour) const {
    Mixture found{.left = colour};
    for (const Set& set : sets_) {
      const dvec3 amounts = set.amounts * colour;
      if (amounts.x < 0 || amounts.y < 0 || amounts.z < 0) continue;
      const dvec3 left = colour - set.colours * amounts;
      if (!(dot(left, left) < dot(found.left, found.left))) continue;
      found = {set.has_from ? amounts.x : 0, set.moves * amounts.x, left};
    }
    return found;
  }

  // What becomes of a colour.
  dvec3 changed(const dvec3& colour) const {
    const dvec3 moves = of(colour).moves;
    return moves == dvec3(0) ? colour : clamp(colour + moves, dvec3(0), dvec3(double{kHalfMax}));
  }

 private:
  struct Set {
    glm::dmat3 amounts{0}, colours{0};  // least squares, and what it mixes; the first amount is that of `from`
    bool has_from = false;
    dvec3 moves{0};  // what one of `from` adds: to - from
  };

  void add(const std::vector<dvec3>& colours, const std::vector<size_t>& places, const dvec3& to) {
    Set set;
    for (size_t i = 0; i < places.size(); ++i) set.colours[static_cast<int>(i)] = colours[places[i]];
    glm::dmat3 gram = transpose(set.colours) * set.colours;
    for (int i = static_cast<int>(places.size()); i < 3; ++i) gram[i][i] = 1;
    double scale = 1;
    for (int i = 0; i < 3; ++i) scale *= gram[i][i];
    if (!(determinant(gram) > 1e-9 * scale)) return;  // one is a mixture of the others
    set.amounts = inverse(gram) * transpose(set.colours);
    // `from` is colour 0 and always first.
    set.has_from = places.front() == 0;
    if (set.has_from) set.moves = to - colours[0];
    sets_.push_back(set);
  }

  std::vector<Set> sets_;
};

// The linear map that comes nearest to what became of colours.
struct ColourMap {
  glm::dmat3 squares{0}, products{0};  // of colours with themselves; of what they became with them

  void add(const dvec3& before, const dvec3& after, double weight) {
    squares += weight * outerProduct(before, before);
    products += weight * outerProduct(after, before);
  }
  void add(const ColourMap& other, double weight) {
    squares += weight * other.squares;
    products += weight * other.products;
  }
  double size() const { return squares[0][0] + squares[1][1] + squares[2][2]; }

  glm::dmat3 solved() const {
    if (!(size() > 0)) return glm::dmat3(1);
    const double pull = kToFactor * size(), factor = (products[0][0] + products[1][1] + products[2][2]) / size();
    return (products + glm::dmat3(pull * factor)) * inverse(squares + glm::dmat3(pull));
  }
};

double half(uint32_t bits) { return double{float_from_half(static_cast<uint16_t>(bits & 0xffffu))}; }
uint32_t bits_of(double value) { return half_from_float(std::clamp(static_cast<float>(value), -kHalfMax, kHalfMax)); }

struct Weight {
  size_t basis;
  dvec3 colour;
};
Weight weight_of(const tables::Entry& entry) {
  return {entry.basis_red & 0xffffu,
          dvec3(half(entry.basis_red >> 16), half(entry.green_blue), half(entry.green_blue >> 16))};
}

tables::Entry entry_of(const Weight& weight) {
  const auto& [basis, colour] = weight;
  return {static_cast<uint32_t>(basis) | bits_of(colour.x) << 16, bits_of(colour.y) | bits_of(colour.z) << 16};
}

double sum(const dvec3& colour) { return colour.x + colour.y + colour.z; }

// A cluster's map of colours, by which all of it changes: the nearest to what becomes of its weights, each by itself
// (by its function's size), and of the named colours. These keep the map from what is noise in the weights: of a white
// highlight many times as bright as the body, a hundredth of another colour would be left to see.
std::vector<glm::dmat3> colour_maps(const Spmm& spmm, const PigmentChange& change) {
  const Mixtures mixtures(change);
  std::vector<double> sizes;
  for (const Basis& basis : spmm.dictionary) sizes.push_back(lobe_size(basis.lobe));
  std::vector<ColourMap> maps(spmm.clusters.size());
  ColourMap all;
  for (const tables::Texel& texel : spmm.texels) {
    const size_t cluster = texel.cluster_count & 0xffu, count = texel.cluster_count >> 8 & 0xffu;
    for (size_t i = texel.first_entry; i < texel.first_entry + count; ++i) {
      const auto [basis, colour] = weight_of(spmm.entries[i]);
      const dvec3 after = mixtures.changed(colour);
      maps[cluster].add(colour, after, sizes[basis] * sizes[basis]);
      all.add(colour, after, sizes[basis] * sizes[basis]);
    }
  }
  std::vector<glm::dmat3> solved;
  for (ColourMap& map : maps) {
    map.add(all, map.size() > 0 && all.size() > 0 ? kToAll * map.size() / all.size() : 1);
    const double named = kToNamed * map.size();
    const auto add = [&](const dvec3& before, const dvec3& after) {
      if (const double square = dot(before, before); square > 0) map.add(before, after, named / square);
    };
    add(dvec3(change.from), dvec3(change.to));
    for (const vec3 colour : change.staying) add(dvec3(colour), dvec3(colour));
    solved.push_back(map.solved());
  }
  return solved;
}

// Sums over functions of a colour each times what it reflects, [cluster * pairs + pair]; `colours` [cluster * bases +
// basis].
std::vector<vec3> reflected(const Spmm& spmm, const std::vector<dvec3>& colours) {
  const std::vector<vec3>& directions = spmm.residual.directions;
  const size_t bases = spmm.dictionary.size(), pairs = directions.size() * directions.size();
  std::vector<vec3> sums(spmm.clusters.size() * pairs, vec3(0));
  std::vector<double> values(pairs);
  for (size_t j = 0; j < bases; ++j) {
    const Basis& basis = spmm.dictionary[j];
    const BasisFrame frame(dvec3(basis.normal), double{basis.psi});
    const PackedLobe lobe = pack_lobe(basis.lobe);
    for (size_t p = 0; p < pairs; ++p)
      values[p] = lobe_value(lobe, frame.local(dvec3(directions[p % directions.size()])),
                             frame.local(dvec3(directions[p / directions.size()])));
    for (size_t c = 0; c < spmm.clusters.size(); ++c) {
      const dvec3& colour = colours[c * bases + j];
      if (colour == dvec3(0)) continue;
      for (size_t p = 0; p < pairs; ++p) sums[c * pairs + p] += vec3(colour * values[p]);
    }
  }
  return sums;
}

// Mean and terms go by the map; to the mean something is added.
void change_record(tables::ResidualRecord& record, int terms, const glm::dmat3& map, const dvec3& added) {
  std::array<double, 16> values{};
  for (size_t i = 0; i < values.size(); ++i) values[i] = half(record.halves[i / 2] >> (i % 2 * 16));
  for (size_t k = 0; k <= static_cast<size_t>(terms); ++k) {
    dvec3 mapped = map * dvec3(values[3 * k], values[3 * k + 1], values[3 * k + 2]);
    if (k == 0) mapped += added;
    for (size_t c = 0; c < 3; ++c) values[3 * k + c] = mapped[static_cast<int>(c)];
  }
  for (size_t i = 0; i < 8; ++i) record.halves[i] = bits_of(values[2 * i]) | bits_of(values[2 * i + 1]) << 16;
}

}  // namespace

std::vector<dvec3> changed_colours(const std::vector<dvec3>& colours, const PigmentChange& change) {
  const Mixtures mixtures(change);
  std::vector<dvec3> changed;
  for (const dvec3& colour : colours) changed.push_back(mixtures.changed(colour));
  return changed;
}

PigmentShares pigment_shares(const Spmm& spmm, const PigmentChange& change) {
  constexpr double kSeen = 0.01;  // of a texel's light
  const Mixtures mixtures(change);
  std::vector<double> albedos, sizes;
  for (const Basis& basis : spmm.dictionary) {
    albedos.push_back(mean_reflectance(basis, albedo_curve(basis.lobe)));
    sizes.push_back(lobe_size(basis.lobe));
  }
  double light = 0, of_from = 0, square = 0, left = 0;
  size_t seen = 0;
  for (const tables::Texel& texel : spmm.texels) {
    double texel_light = 0, texel_from = 0;
    const size_t count = texel.cluster_count >> 8 & 0xffu;
    for (size_t i = texel.first_entry; i < texel.first_entry + count; ++i) {
      const auto [basis, colour] = weight_of(spmm.entries[i]);
      const Mixtures::Mixture mixture = mixtures.of(colour);
      texel_light += albedos[basis] * sum(colour);
      texel_from += albedos[basis] * std::min(mixture.amount * sum(dvec3(change.from)), sum(colour));
      square += sizes[basis] * sizes[basis] * dot(colour, colour);
      left += sizes[basis] * sizes[basis] * dot(mixture.left, mixture.left);
    }
    light += texel_light;
    of_from += texel_from;
    seen += texel_from > 0 && texel_from >= kSeen * texel_light;
  }
  if (!(light > 0 && square > 0)) return {};
  return {of_from / light, static_cast<double>(seen) / static_cast<double>(spmm.texels.size()),
          std::sqrt(left / square)};
}

Spmm with_pigment(const Spmm& spmm, const PigmentChange& change) {
  const std::vector<glm::dmat3> maps = colour_maps(spmm, change);
  const size_t bases = spmm.dictionary.size();
  Spmm result = spmm;
  // Weights cannot be negative; what that took from a cluster is told by the residual's mean instead.
  std::vector<dvec3> cut(maps.size() * bases, dvec3(0));
  std::vector<double> members(maps.size(), 0);
  for (const tables::Texel& texel : spmm.texels) {
    const size_t cluster = texel.cluster_count & 0xffu, count = texel.cluster_count >> 8 & 0xffu;
    members[cluster] += 1;
    for (size_t i = texel.first_entry; i < texel.first_entry + count; ++i) {
      const auto [basis, colour] = weight_of(spmm.entries[i]);
      const dvec3 mapped = maps[cluster] * colour;
      result.entries[i] = entry_of({basis, clamp(mapped, dvec3(0), dvec3(double{kHalfMax}))});
      cut[cluster * bases + basis] += mapped - weight_of(result.entries[i]).colour;
    }
  }
  if (spmm.residual.records.empty()) return result;
  for (size_t c = 0; c < maps.size(); ++c)
    for (size_t j = 0; j < bases && members[c] > 0; ++j) cut[c * bases + j] /= members[c];
  const std::vector<vec3> added = reflected(spmm, cut);
  const size_t pairs = spmm.residual.directions.size() * spmm.residual.directions.size();
  for (size_t i = 0; i < result.residual.records.size(); ++i)
    change_record(result.residual.records[i], spmm.residual.terms, maps[i / pairs], dvec3(added[i]));
  return result;
}

}  // namespace vamp
