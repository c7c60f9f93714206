// SparseBTF multiplied out, into values or into factors.
#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "engine/btf/sparse_btf.h"
#include "engine/core/check.h"
#include "engine/core/jobs.h"

namespace vamp {
namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Index index(size_t i) { return static_cast<Eigen::Index>(i); }

std::span<const SparseChannel::Atom> atoms_of(const SparseChannel& channel, size_t patch) {
  return std::span(channel.atoms).subspan(patch * channel.atoms_per_patch, channel.atom_count[patch]);
}

// What an atom says of the directions, before the deviation: [view][light].
void write_directions(const SparseChannel& channel, size_t dictionary, const SparseChannel::Atom& atom, float* out) {
  const float* of_light = channel.row(dictionary, 2, atom.index[2]);
  const float* of_view = channel.row(dictionary, 3, atom.index[3]);
  for (size_t v = 0; v < channel.size[3]; ++v)
    for (size_t l = 0; l < channel.size[2]; ++l) *out++ = of_view[v] * of_light[l];
}

// And of a texel of the patch.
float in_texel(const SparseChannel& channel, size_t dictionary, const SparseChannel::Atom& atom, size_t x, size_t y) {
  return atom.weight * channel.row(dictionary, 0, atom.index[0])[x] * channel.row(dictionary, 1, atom.index[1])[y];
}

// Values of a patch, a row a texel (x fastest), without mean and deviation.
Matrix patch_values(const SparseChannel& channel, size_t patch) {
  const auto atoms = atoms_of(channel, patch);
  const size_t dictionary = channel.dictionary[patch];
  const size_t texels = size_t{channel.size[0]} * channel.size[1];
  Matrix spatial(index(texels), index(atoms.size()));
  Matrix angular(index(atoms.size()), index(size_t{channel.size[2]} * channel.size[3]));
  for (size_t a = 0; a < atoms.size(); ++a) {
    write_directions(channel, dictionary, atoms[a], angular.row(index(a)).data());
    for (size_t t = 0; t < texels; ++t)
      spatial(index(t), index(a)) = in_texel(channel, dictionary, atoms[a], t % channel.size[0], t / channel.size[0]);
  }
  return spatial * angular;
}

// The first channel that is there: all have the same patches.
const SparseChannel& any_channel(const SparseBtf& sparse) {
  for (const auto& channel : sparse.channels)
    if (channel) return *channel;
  CHECK(false);
}

// Calls f(patch, x of its first texel, y) for all patches that the part touches.
template <class F>
void for_patches(const SparseChannel& channel, const BtfInfo& info, const TexelRect& part, F f) {
  const uint32_t w = channel.size[0], h = channel.size[1];
  for (uint32_t py = part.y / h; py * h < part.y + part.height; ++py)
    for (uint32_t px = part.x / w; px * w < part.x + part.width; ++px)
      f(size_t{py} * (info.width / w) + px, px * w, py * h);
}

Factors zeros(size_t rows, size_t columns) {
  Factors factors;
  factors.rows = static_cast<uint32_t>(rows);
  factors.columns = static_cast<uint32_t>(columns);
  factors.components = 1;
  factors.s.assign(1, 0);
  factors.u.assign(rows, 0);
  factors.sxv.assign(columns, 0);
  return factors;
}

Factors channel_factors(const SparseBtf& sparse, const SparseChannel& channel, const TexelRect& part) {
  using AngularAtom = std::tuple<uint16_t, uint16_t, uint16_t>;  // dictionary, light, view
  std::map<AngularAtom, size_t> components;
  const auto key_of = [&](size_t patch, const SparseChannel::Atom& atom) {
    return AngularAtom{channel.dictionary[patch], atom.index[2], atom.index[3]};
  };
  for_patches(channel, sparse.info, part, [&](size_t patch, uint32_t, uint32_t) {
    for (const auto& atom : atoms_of(channel, patch)) components.emplace(key_of(patch, atom), components.size() + 1);
  });
  const size_t directions = sparse.mean.size(), texels = size_t{part.width} * part.height;
  Matrix u = Matrix::Zero(index(directions), index(components.size() + 1));
  Matrix sxv = Matrix::Zero(index(texels), index(components.size() + 1));

  u.col(0) = Eigen::Map<const Eigen::VectorXf>(sparse.mean.data(), index(directions));
  sxv.col(0).setOnes();
  const Eigen::Map<const Eigen::VectorXf> deviation(sparse.deviation.data(), index(directions));
  std::vector<float> angular(directions);
  for_patches(channel, sparse.info, part, [&](size_t patch, uint32_t x0, uint32_t y0) {
    const size_t dictionary = channel.dictionary[patch];
    for (const auto& atom : atoms_of(channel, patch)) {
      const auto k = index(components.at(key_of(patch, atom)));
      write_directions(channel, dictionary, atom, angular.data());
      u.col(k) = Eigen::Map<const Eigen::VectorXf>(angular.data(), index(directions)).cwiseProduct(deviation);
      for (uint32_t y = std::max(y0, part.y); y < std::min(y0 + channel.size[1], part.y + part.height); ++y)
        for (uint32_t x = std::max(x0, part.x); x < std::min(x0 + channel.size[0], part.x + part.width); ++x)
          sxv(index(size_t{y - part.y} * part.width + (x - part.x)), k) +=
              in_texel(channel, dictionary, atom, x - x0, y - y0);
    }
  });
  Factors factors;
  factors.rows = static_cast<uint32_t>(directions);
  factors.columns = static_cast<uint32_t>(texels);
  factors.components = static_cast<uint32_t>(u.cols());
  const Eigen::VectorXf norms = u.colwise().norm().cwiseProduct(sxv.colwise().norm());
  factors.s.assign(norms.data(), norms.data() + norms.size());
  factors.u.assign(u.data(), u.data() + u.size());
  factors.sxv.assign(sxv.data(), sxv.data() + sxv.size());
  return factors;
}

}  // namespace

Status decode(const SparseBtf& sparse, const TexelRect& part, Btf& out, Progress* progress) {
  CHECK(part.inside(sparse.info));
  const SparseChannel& shape = any_channel(sparse);
  std::vector<float> values(out.values_per_texel());
  const size_t directions = sparse.mean.size();
  Status status;
  if (progress != nullptr) progress->stage("Multiplying out the atoms");
  for_patches(shape, sparse.info, part, [&](size_t patch, uint32_t x0, uint32_t y0) {
    if (progress != nullptr && progress->cancelled()) status = JobQueue::cancelled_error();
    if (!status) return;
    std::array<Matrix, 3> channels;
    for (size_t c = 0; c < 3; ++c)
      if (sparse.channels[c]) channels[c] = patch_values(*sparse.channels[c], patch);
    for (uint32_t y = std::max(y0, part.y); y < std::min(y0 + shape.size[1], part.y + part.height); ++y)
      for (uint32_t x = std::max(x0, part.x); x < std::min(x0 + shape.size[0], part.x + part.width); ++x) {
        const auto row = index(size_t{y - y0} * shape.size[0] + (x - x0));
        for (size_t c = 0; c < 3; ++c)
          for (size_t d = 0; d < directions; ++d)
            values[3 * d + c] =
                sparse.channels[c] ? channels[c](row, index(d)) * sparse.deviation[d] + sparse.mean[d] : 0;
        out.write_texel(size_t{y - part.y} * part.width + (x - part.x), values);
      }
    // Behind each row of patches.
    if (x0 + shape.size[0] < part.x + part.width) return;
    const uint32_t rows = std::min(y0 + shape.size[1] - part.y, part.height);
    if (progress != nullptr) progress->fraction(static_cast<float>(rows) / static_cast<float>(part.height));
    out.forget(0, out.texel_count());
  });
  return status;
}

FactoredBtf factored(const SparseBtf& sparse, const TexelRect& part) {
  CHECK(part.inside(sparse.info));
  FactoredBtf btf;
  btf.info = info_of(sparse, part);
  btf.channels = {"log Y", "log U", "log V"};
  for (const auto& channel : sparse.channels)
    btf.factors.push_back(channel ? channel_factors(sparse, *channel, part)
                                  : zeros(sparse.mean.size(), btf.info.texel_count()));
  return btf;
}

}  // namespace vamp
