// Factorised files: the same bits after a round trip, and products that say what was put in, in every colour model.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <random>

#include "engine/btf/factored_btf.h"
#include "tests/btf/small_btf.h"
#include "tests/material/temporary_folder.h"

namespace vamp {
namespace {

using ::testing::HasSubstr;

// Values of a texel and direction by channel.
using Values = std::function<std::vector<double>(size_t texel, size_t direction)>;

BtfInfo tiny_info() {
  BtfInfo info = test::small_info();
  info.views = named_direction_set({direction_of({0, 0}), direction_of({0.9, 2})});
  return info;
}

// Factors of full rank that hold `values` without error: one component a texel.
FactoredBtf exact(const Values& values, bool decorrelated, bool transposed, std::vector<std::string> channels,
                  int scalar_bytes = 4) {
  FactoredBtf btf;
  btf.info = tiny_info();
  btf.decorrelated = decorrelated;
  btf.channels = std::move(channels);
  const size_t n = btf.channels.size(), shared = decorrelated ? 1 : n;
  const size_t texels = btf.info.texel_count(), directions = btf.direction_count();
  for (size_t set = 0; set < n / shared; ++set) {
    Factors f;
    f.scalar_bytes = scalar_bytes;
    f.components = static_cast<uint32_t>(transposed ? directions : texels);
    f.s.assign(f.components, 1);
    // One side holds the values, the other picks a column of them.
    std::vector<float> picks(size_t{f.components} * f.components);
    for (size_t i = 0; i < f.components; ++i) picks[i * f.components + i] = 1;
    for (size_t row = 0; row < shared * (transposed ? texels : directions); ++row)
      for (size_t k = 0; k < f.components; ++k) {
        const size_t texel = transposed ? row / shared : k, direction = transposed ? k : row / shared;
        f.u.push_back(static_cast<float>(values(texel, direction)[decorrelated ? set : row % shared]));
      }
    f.sxv = picks;
    f.rows = static_cast<uint32_t>(f.u.size() / f.components);
    f.columns = f.components;
    btf.factors.push_back(std::move(f));
  }
  return btf;
}

std::vector<double> colours(size_t texel, size_t direction) {
  const double t = static_cast<double>(texel), d = static_cast<double>(direction);
  return {0.02 + 0.1 * t + 0.01 * d, 0.5 + 0.03 * d, 2.5 - 0.15 * t};
}

class Factored : public ::testing::Test {
 protected:
  FactoredBtf written_and_read(const FactoredBtf& btf) {
    EXPECT_TRUE(write_factored_btf(folder_ / "a.btf", btf));
    auto read = read_factored_btf(folder_ / "a.btf");
    EXPECT_TRUE(read) << read.error().message();
    return read ? *read : FactoredBtf{};
  }
  static Btf decoded(const FactoredBtf& factored) {
    Btf btf = Btf::in_memory(factored.info).value();
    const Status status = decode(factored, btf, "test");
    EXPECT_TRUE(status) << status.error().message();
    return btf;
  }
  static void expect_colours(const Btf& btf, const Values& values) {
    const size_t lights = btf.light_count();
    for (size_t t = 0; t < btf.texel_count(); ++t)
      for (size_t d = 0; d < btf.view_count() * lights; ++d)
        for (size_t c = 0; c < 3; ++c) {
          const double expected = values(t, d)[c];
          // Half a unit in the last place of a half, and float factors.
          ASSERT_NEAR(double{btf.at(t, d / lights, d % lights, c)}, expected, std::abs(expected) * 5.5e-4 + 1e-6)
              << "texel " << t << " direction " << d << " channel " << c;
        }
  }
  test::TemporaryFolder folder_;
};

TEST_F(Factored, FloatFactorsKeepTheirBits) {
  std::mt19937 random(3);
  for (const bool decorrelated : {false, true})
    for (const int scalar_bytes : {2, 4}) {
      FactoredBtf btf = exact(colours, decorrelated, false, {"R", "G", "B"}, scalar_bytes);
      for (Factors& factors : btf.factors)
        for (auto* values : {&factors.s, &factors.u, &factors.sxv})
          for (float& value : *values) {
            // Any finite bits, down to denormals.
            const auto bits = static_cast<uint32_t>(random());
            value = scalar_bytes == 4 ? std::bit_cast<float>(bits & 0xbfffffffu)
                                      : float_from_half(static_cast<Half>(bits & 0xbfffu));
          }
      const FactoredBtf read = written_and_read(btf);
      ASSERT_EQ(read.factors.size(), btf.factors.size());
      for (size_t i = 0; i < btf.factors.size(); ++i) {
        EXPECT_EQ(read.factors[i].scalar_bytes, scalar_bytes);
        EXPECT_EQ(read.factors[i].s, btf.factors[i].s);
        EXPECT_EQ(read.factors[i].u, btf.factors[i].u);
        EXPECT_EQ(read.factors[i].sxv, btf.factors[i].sxv);
      }
    }
}

TEST_F(Factored, EveryArrangementDecodesToTheSameValues) {
  for (const bool decorrelated : {false, true})
    for (const bool transposed : {false, true})
      expect_colours(decoded(written_and_read(exact(colours, decorrelated, transposed, {"R", "G", "B"}))), colours);
}

TEST_F(Factored, WithoutTheCosineItIsMultipliedIn) {
  FactoredBtf btf = exact(colours, true, false, {"R", "G", "B"});
  btf.has_cosine = false;
  const BtfInfo info = btf.info;
  expect_colours(decoded(written_and_read(btf)), [&info](size_t t, size_t d) {
    std::vector<double> values = colours(t, d);
    for (double& value : values) value *= info.lights[d % info.lights.size()].z;
    return values;
  });
}

// From RGB to the model, as the format defines it.
std::vector<double> encoded(ColourModel model, const std::vector<double>& rgb) {
  const double e = 1e-5;
  const double y = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
  const double u = (rgb[2] - y) / 2.03211, v = (rgb[0] - y) / 1.13983;
  const double co = (rgb[0] - rgb[2]) / 2, cg = rgb[1] / 2 - (rgb[0] + rgb[2]) / 4;
  const auto signed_log = [e](double x) { return std::copysign(std::log(std::abs(x) / e), x); };
  switch (model) {
    case ColourModel::rgb:
      return rgb;
    case ColourModel::yuv:
      return {y, u, v};
    case ColourModel::pca:
      return {rgb[2] - 0.25, (rgb[0] - 0.5) / 2, rgb[1] - 1};
    case ColourModel::ycocg:
      return {rgb[0] / 4 + rgb[1] / 2 + rgb[2] / 4, co, cg};
    case ColourModel::spectral: {
      const double sum = rgb[0] + rgb[1] + rgb[2];
      return {sum, rgb[1] / sum, rgb[2] / sum};
    }
    case ColourModel::log_y_uv:
      return {std::log(y + e), u, v};
    case ColourModel::log_y_log_uv:
      return {std::log(y + e), signed_log(u), signed_log(v)};
    case ColourModel::log_y_uv_by_y:
      return {std::log(y + e), u / (y + e), v / (y + e)};
    case ColourModel::log_rgb:
      return {std::log(rgb[0] + e), std::log(rgb[1] + e), std::log(rgb[2] + e)};
  }
  return {};
}

TEST_F(Factored, EveryColourModelGivesItsColoursBack) {
  for (const int number : {0, 1, 3, 4, 5, 9, 10, 11, 12}) {
    const ColourModel model = *colour_model(number);
    SCOPED_TRACE(name_of(model));
    FactoredBtf btf =
        exact([model](size_t t, size_t d) { return encoded(model, colours(t, d)); }, true, false, {"R", "G", "B"});
    btf.colour.model = model;
    if (model == ColourModel::pca) {
      btf.colour.mean = {0.5f, 1, 0.25f};
      btf.colour.matrix = {0, 0, 1, 2, 0, 0, 0, 1, 0};
    }
    const FactoredBtf read = written_and_read(btf);
    EXPECT_EQ(read.colour.model, model);
    // The green of YUV follows from its rounded coefficients: within 1e-4 of the exact inverse.
    Btf out = decoded(read);
    for (size_t t = 0; t < out.texel_count(); ++t)
      for (size_t d = 0; d < 8; ++d)
        for (size_t c = 0; c < 3; ++c) {
          const double expected = colours(t, d)[c];
          ASSERT_NEAR(double{out.at(t, d / 4, d % 4, c)}, expected, 1e-3 * expected + 4e-4);
        }
  }
}

TEST_F(Factored, AReducedDynamicRangeOfFmfIsRestored) {
  FactoredBtf btf = exact([](size_t t, size_t d) { return encoded(ColourModel::log_rgb, colours(t, d)); }, false, false,
                          {"R", "G", "B"});
  btf.colour.model = ColourModel::log_rgb;
  const FactoredBtf read = written_and_read(btf);
  EXPECT_EQ(read.colour.model, ColourModel::log_rgb);
  expect_colours(decoded(read), colours);
}

TEST_F(Factored, SpectraComeOutAsTheirColour) {
  // Flat spectra are grey; a band around 620 nm is red.
  std::vector<std::string> names;
  for (int nm = 400; nm <= 720; nm += 10) names.push_back(std::to_string(nm));
  const FactoredBtf flat =
      exact([&](size_t, size_t) { return std::vector<double>(names.size(), 0.5); }, false, false, names);
  expect_colours(decoded(written_and_read(flat)), [](size_t, size_t) { return std::vector<double>{0.5, 0.5, 0.5}; });
  const FactoredBtf red = exact(
      [&](size_t, size_t) {
        std::vector<double> values(names.size(), 0.05);
        for (size_t i = 21; i < values.size(); ++i) values[i] = 0.8;
        return values;
      },
      true, false, names);
  const Btf btf = decoded(written_and_read(red));
  EXPECT_GT(btf.at(0, 0, 0, 0), 3 * btf.at(0, 0, 0, 1));
  EXPECT_GT(btf.at(0, 0, 0, 0), 3 * btf.at(0, 0, 0, 2));
}

TEST_F(Factored, ValuesThatOverflowAreRefusedWithTheirPlace) {
  FactoredBtf btf = exact([](size_t t, size_t d) { return std::vector<double>(3, t == 7 && d == 5 ? 1e4 : 0.0); }, true,
                          false, {"R", "G", "B"});
  btf.colour.model = ColourModel::log_rgb;
  Btf out = Btf::in_memory(btf.info).value();
  const Status status = decode(btf, out, "loud.btf");
  ASSERT_FALSE(status);
  EXPECT_THAT(status.error().message(), HasSubstr("loud.btf: texel (2, 1), view 1, light 1"));
}

TEST_F(Factored, ChannelsMayBeStoredEitherWayRoundEach) {
  FactoredBtf btf = exact(colours, true, false, {"R", "G", "B"});
  btf.factors[1] = exact(colours, true, true, {"R", "G", "B"}).factors[1];
  expect_colours(decoded(written_and_read(btf)), colours);
}

}  // namespace
}  // namespace vamp
