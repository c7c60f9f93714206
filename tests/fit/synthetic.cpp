#include "tests/fit/synthetic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/brdf/registry.h"
#include "engine/core/check.h"
#include "engine/fit/rows.h"
#include "engine/material/directions.h"

namespace vamp::test {
namespace {

const fit::Pairs& ubo_pairs() {
  static const fit::Pairs pairs = {ubo2003_directions(), ubo2003_directions()};
  return pairs;
}

Basis random_basis(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  const auto between = [&](float low, float high) { return low * std::pow(high / low, uniform(random)); };
  Basis basis;
  basis.lobe = default_lobe(static_cast<Model>(random() % kModelCount));
  auto& p = basis.lobe.params;
  switch (basis.lobe.model) {
    case Model::lambert:
      break;
    case Model::oren_nayar:
      p[1] = between(0.3f, 1.f);
      break;
    case Model::blinn_phong:
      p[1] = between(4, 80);
      break;
    case Model::ward:
      p[1] = between(0.15f, 0.3f), p[2] = between(0.3f, 0.7f);
      break;
    case Model::cook_torrance:
      p[1] = between(0.15f, 0.6f), p[2] = between(0.04f, 0.5f);
      break;
    case Model::lafortune:
      p[1] = -1 + 0.3f * uniform(random), p[2] = -1 + 0.3f * uniform(random), p[4] = between(4, 60);
      break;
    case Model::ashikhmin_shirley:
      p[0] = between(0.04f, 0.5f), p[2] = between(5, 80), p[3] = between(5, 80);
      break;
  }
  const float tilt = 0.7f * std::sqrt(uniform(random)), phi = 6.2831853f * uniform(random);
  basis.normal = vec3(std::sin(tilt) * std::cos(phi), std::sin(tilt) * std::sin(phi), std::cos(tilt));
  basis.psi = 3.1415927f * uniform(random);
  return basis;
}

}  // namespace

std::vector<Basis> random_dictionary(std::mt19937& random, size_t count, double closest) {
  const fit::Pairs& pairs = ubo_pairs();
  std::vector<Basis> dictionary;
  fit::Rows columns(count, pairs.count());
  while (dictionary.size() < count) {
    const size_t n = dictionary.size();
    const Basis basis = random_basis(random);
    float* row = columns.row(n);
    fit::evaluate_column(basis, pairs, nullptr, row);
    std::vector<double> products(n + 1);
    fit::dot_rows(row, 1, columns.row(0), n + 1, pairs.count(), products.data());
    const double length = std::sqrt(products[n]);
    for (size_t i = 0; i < pairs.count(); ++i) row[i] = static_cast<float>(row[i] / length);
    if (std::all_of(products.begin(), products.end() - 1, [&](double c) { return c < closest * length; }))
      dictionary.push_back(basis);
  }
  return dictionary;
}

Synthetic random_synthetic(uint32_t seed, int texels, size_t dictionary, size_t functions) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  Synthetic synthetic;
  synthetic.dictionary = random_dictionary(random, dictionary);
  std::vector<int> all(dictionary);
  std::iota(all.begin(), all.end(), 0);
  for (int t = 0; t < texels; ++t) {
    SyntheticTexel texel;
    std::shuffle(all.begin(), all.end(), random);
    texel.support.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(functions));
    std::sort(texel.support.begin(), texel.support.end());
    for (size_t i = 0; i < functions; ++i) {
      const float weight = 0.1f + 0.9f * uniform(random);
      texel.weights.emplace_back(weight * (0.3f + 0.7f * uniform(random)), weight * (0.3f + 0.7f * uniform(random)),
                                 weight * (0.3f + 0.7f * uniform(random)));
    }
    synthetic.texels.push_back(texel);
  }
  return synthetic;
}

Btf measure(const Synthetic& synthetic, int width, int height) {
  CHECK(static_cast<size_t>(width) * static_cast<size_t>(height) == synthetic.texels.size());
  const fit::Pairs& pairs = ubo_pairs();
  fit::Rows columns(synthetic.dictionary.size(), pairs.count());
  for (size_t j = 0; j < columns.count; ++j)
    fit::evaluate_column(synthetic.dictionary[j], pairs, nullptr, columns.row(j));
  BtfInfo info;
  info.width = static_cast<uint32_t>(width), info.height = static_cast<uint32_t>(height);
  info.views = info.lights = ubo81();
  info.mm_per_texel = 0.1f;
  info.synthetic = true;
  info.name = "sum of known functions";
  auto btf = Btf::in_memory(info);
  CHECK(btf.has_value());
  std::vector<float> values(btf->values_per_texel());
  for (size_t t = 0; t < synthetic.texels.size(); ++t) {
    const SyntheticTexel& texel = synthetic.texels[t];
    std::fill(values.begin(), values.end(), 0.f);
    for (size_t i = 0; i < texel.support.size(); ++i) {
      const float* column = columns.row(static_cast<size_t>(texel.support[i]));
      for (size_t p = 0; p < pairs.count(); ++p)
        for (size_t c = 0; c < 3; ++c) values[p * 3 + c] += texel.weights[i][static_cast<int>(c)] * column[p];
    }
    btf->write_texel(t, values);
  }
  return std::move(*btf);
}

}  // namespace vamp::test
