#include "engine/fit/joint_weights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

constexpr size_t kFunctions = 6;

// Texels that are sums of six functions, the same amount of a seventh everywhere, and more or less of an eighth, which
// stand for the mean and the only term of a residual.
class JointWeightsTest : public ::testing::Test {
 protected:
  JointWeightsTest() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> amount(0.2f, 1);
    truth_.dictionary = test::random_dictionary(random, kFunctions + 2, 0.9);
    for (int t = 0; t < 16; ++t) {
      test::SyntheticTexel texel;
      for (int j = 0; j < static_cast<int>(kFunctions) + 2; ++j) {
        texel.support.push_back(j);
        const float grey = j == kFunctions ? 0.3f : amount(random);
        texel.weights.push_back(j < static_cast<int>(kFunctions) ? vec3(grey, amount(random), amount(random))
                                                                 : vec3(grey));
      }
      truth_.texels.push_back(texel);
    }
    btf_ = test::measure(truth_, 4, 4);
    const Measurement measurement(btf_);
    design_ = make_design({truth_.dictionary.begin(), truth_.dictionary.begin() + kFunctions}, measurement);
    const Design rest = make_design({truth_.dictionary.begin() + kFunctions, truth_.dictionary.end()}, measurement);
    residual_.means = Rows(1, measurement.values());
    residual_.terms = Rows(kMaxTerms, measurement.values());
    const auto length = static_cast<float>(std::sqrt(3 * rest.gram[3]));
    for (size_t i = 0; i < measurement.values(); ++i) {
      const size_t pair = i % measurement.pair_count();
      residual_.means.row(0)[i] = 0.3f * rest.columns.row(0)[pair];
      residual_.terms.row(0)[i] = rest.columns.row(1)[pair] / length;
    }
    codes_ = code_texels(measurement, design_, {}, Coder::elimination, kFunctions, worker_);
    for (const TexelCode& code : codes_)
      weights_.push_back({{code.path.order.begin(), code.path.order.end()},
                          weights_of(code, code.path.order.size(), design_.gram, kFunctions)});
    clustering_ = {1, std::vector<uint16_t>(codes_.size())};
  }

  void refit(double pull) {
    refit_weights(Measurement(btf_), design_, codes_, clustering_, residual_, pull, worker_, weights_);
  }

  // The largest difference to the truth, over the texels that use all functions.
  float farthest() const {
    float most = 0;
    for (size_t t = 0; t < weights_.size(); ++t)
      for (size_t i = 0; i < weights_[t].bases.size(); ++i)
        for (size_t c = 0; c < kChannels; ++c)
          most = std::max(most, std::abs(weights_[t].weights[i * kChannels + c] -
                                         truth_.texels[t].weights[weights_[t].bases[i]][static_cast<int>(c)]));
    return most;
  }

  test::Synthetic truth_;
  Btf btf_ = test::measure(test::random_synthetic(1, 1, 1, 1), 1, 1);
  Design design_;
  ResidualFit residual_;
  std::vector<TexelCode> codes_;
  std::vector<TexelWeights> weights_;
  Clustering clustering_;
  Worker worker_;
};

TEST_F(JointWeightsTest, FindTheFunctionsBehindAResidual) {
  for (const TexelWeights& texel : weights_) ASSERT_EQ(texel.bases.size(), kFunctions);
  EXPECT_GT(farthest(), 0.05f);
  refit(0);
  EXPECT_LT(farthest(), 5e-3f);
}

TEST_F(JointWeightsTest, APullKeepsThemNearWhatTheyWere) {
  const float alone = farthest();
  const std::vector<TexelWeights> before = weights_;
  refit(1e6);
  for (size_t t = 0; t < weights_.size(); ++t)
    for (size_t i = 0; i < weights_[t].weights.size(); ++i)
      EXPECT_NEAR(weights_[t].weights[i], before[t].weights[i], 1e-3f);
  refit(0.05);
  EXPECT_LT(farthest(), alone);
}

}  // namespace
}  // namespace vamp::fit
