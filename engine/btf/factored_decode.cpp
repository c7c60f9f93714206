// The product of the factors, block by block of texels.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>

#include "engine/btf/factored_btf.h"
#include "engine/btf/sample_colour.h"
#include "engine/core/jobs.h"

namespace vamp {
namespace {

using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstMap = Eigen::Map<const Matrix>;

// So many values at once: 32 MiB of floats.
constexpr size_t kBlockValues = size_t{8} << 20;

// The product of one set of factors for a block of texels, whichever way round it is stored.
class Product {
 public:
  // channels: those that share the set, 1 or all.
  Product(const Factors& factors, size_t channels, size_t directions)
      : factors_(factors), channels_(channels), transposed_(factors.rows != channels * directions) {}

  void multiply(size_t first_texel, size_t count) {
    const auto k = static_cast<Eigen::Index>(factors_.components);
    const ConstMap u(factors_.u.data(), static_cast<Eigen::Index>(factors_.rows), k);
    const ConstMap sxv(factors_.sxv.data(), static_cast<Eigen::Index>(factors_.columns), k);
    // Transposed, the channels lie beside the texels.
    const size_t rows = transposed_ ? channels_ : 1;
    const auto of_block = [&](const ConstMap& by_texel) {
      return by_texel.middleRows(static_cast<Eigen::Index>(first_texel * rows),
                                 static_cast<Eigen::Index>(count * rows));
    };
    if (transposed_) {
      product_.noalias() = of_block(u) * sxv.transpose();
    } else {
      product_.noalias() = of_block(sxv) * u.transpose();
    }
  }

  // texel: in the block.
  double at(size_t texel, size_t direction, size_t channel) const {
    const size_t row = transposed_ ? texel * channels_ + channel : texel;
    const size_t column = transposed_ ? direction : direction * channels_ + channel;
    return double{product_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column))};
  }

 private:
  const Factors& factors_;
  size_t channels_;
  bool transposed_;
  Matrix product_;
};

}  // namespace

Status decode(const FactoredBtf& factored, Btf& out, std::string_view file, Progress* progress) {
  const size_t lights = factored.info.lights.size();
  const size_t directions = factored.direction_count();
  const size_t texels = out.texel_count();
  const size_t channels = factored.channels.size();
  const size_t shared = channels / factored.factors.size();
  std::vector<Product> products;
  for (const Factors& factors : factored.factors) products.emplace_back(factors, shared, directions);

  VAMP_TRY(const SampleColour colour, SampleColour::of(factored, file));
  const size_t block = std::clamp<size_t>(kBlockValues / (directions * channels), 1, texels);
  std::vector<float> values(out.values_per_texel());
  std::vector<double> sample(channels);
  if (progress != nullptr) progress->stage("Multiplying out the factors");

  for (size_t first = 0; first < texels; first += block) {
    if (progress != nullptr) progress->fraction(static_cast<float>(first) / static_cast<float>(texels));
    if (progress != nullptr && progress->cancelled()) return JobQueue::cancelled_error();
    const size_t count = std::min(block, texels - first);
    for (Product& product : products) product.multiply(first, count);
    for (size_t t = 0; t < count; ++t) {
      for (size_t d = 0; d < directions; ++d) {
        for (size_t c = 0; c < channels; ++c) sample[c] = products[c / shared].at(t, d, c % shared);
        if (!colour.convert(sample, d % lights, std::span(values).subspan(3 * d).first<3>()))
          return fail(ErrorKind::bad_input, file, place_of(factored.info, first + t, d), "a finite value", "none");
      }
      out.write_texel(first + t, values);
    }
    out.forget(first, count);
  }
  return {};
}

}  // namespace vamp
