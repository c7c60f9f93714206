#include "engine/brdf/registry.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/brdf/lobes.h"

namespace vamp {
namespace {

TEST(Registry, EveryRowIsComplete) {
  ASSERT_EQ(models().size(), static_cast<size_t>(kModelCount));
  for (size_t m = 0; m < models().size(); ++m) {
    const ModelRow& model = models()[m];
    EXPECT_EQ(static_cast<size_t>(model.model), m);
    EXPECT_FALSE(model.label.empty() || model.tooltip.empty()) << model.name;
    EXPECT_LT(model.default_variant, model.variants.size());
    for (const VariantRow& variant : model.variants) {
      EXPECT_FALSE(variant.name.empty() || variant.label.empty() || variant.tooltip.empty() || variant.citation.empty())
          << model.name;
    }
    for (const ParameterRow& row : model.parameters) {
      EXPECT_FALSE(row.name.empty() || row.label.empty() || row.unit.empty() || row.tooltip.empty() ||
                   row.citation.empty())
          << model.name;
      EXPECT_LT(row.min, row.max) << model.name << "." << row.name;
      EXPECT_TRUE(row.fallback >= row.min && row.fallback <= row.max) << model.name << "." << row.name;
      EXPECT_LT(row.slot, 6);
      EXPECT_FALSE(row.mapping == Mapping::logarithmic && row.min < 0) << row.name;
    }
  }
}

TEST(Registry, EachVariantHasOneRowPerSlotAndName) {
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      std::set<int> slots;
      std::set<std::string_view> names;
      for (const ParameterRow& row : model.parameters) {
        if (!row.belongs_to(v)) continue;
        EXPECT_TRUE(slots.insert(row.slot).second) << model.name << "." << row.name;
        EXPECT_TRUE(names.insert(row.name).second) << model.name << "." << row.name;
        EXPECT_EQ(find_parameter(model.model, v, row.name), &row);
        EXPECT_EQ(find_parameter(model.model, v, static_cast<int>(row.slot)), &row);
      }
    }
  }
}

TEST(Registry, NamesAreFoundAndUnknownOnesAreNot) {
  for (const ModelRow& model : models()) {
    EXPECT_EQ(find_model(model.name), model.model);
    for (uint8_t v = 0; v < model.variants.size(); ++v) EXPECT_EQ(find_variant(model.model, model.variants[v].name), v);
  }
  EXPECT_FALSE(find_model("phong"));
  EXPECT_FALSE(find_variant(Model::ward, "raw"));
  EXPECT_EQ(find_parameter(Model::cook_torrance, kCookTorranceModernExact, "f0"), nullptr);
  EXPECT_NE(find_parameter(Model::cook_torrance, kCookTorranceModernExact, "ior"), nullptr);
}

TEST(Registry, ScaleIsHiddenAndOneWhereWeightsCarryIt) {
  for (const ModelRow& model : models()) {
    for (const ParameterRow& row : model.parameters) {
      if (row.name == "ks" || (row.hidden && row.name != "rs")) {
        EXPECT_TRUE(row.hidden) << model.name;
        EXPECT_EQ(row.fallback, 1.0f) << model.name << "." << row.name;
      }
    }
  }
  EXPECT_FALSE(find_parameter(Model::oren_nayar, kOrenNayarFull, "rho")->hidden);
  EXPECT_TRUE(find_parameter(Model::oren_nayar, kOrenNayarQualitative, "rho")->hidden);
  EXPECT_FALSE(find_parameter(Model::ashikhmin_shirley, kAshikhminShirleySpecular, "rs")->hidden);
}

TEST(Registry, SliderAndValueGoBackAndForth) {
  for (const ModelRow& model : models()) {
    for (const ParameterRow& row : model.parameters) {
      EXPECT_EQ(from_slider(row, 0), row.min) << row.name;
      EXPECT_EQ(from_slider(row, 1), row.max) << row.name;
      EXPECT_EQ(from_slider(row, -3), row.min);
      EXPECT_EQ(to_slider(row, row.max * 2 + 1), 1.0f);
      float before = row.min;
      for (int i = 1; i <= 20; ++i) {
        const float position = static_cast<float>(i) / 20;
        const float value = from_slider(row, position);
        EXPECT_GT(value, before) << row.name;
        EXPECT_NEAR(to_slider(row, value), position, 1e-4) << row.name;
        before = value;
      }
    }
  }
}

TEST(Registry, AnglesAreShownInDegrees) {
  const ParameterRow* sigma = find_parameter(Model::oren_nayar, kOrenNayarQualitative, "sigma");
  ASSERT_NE(sigma, nullptr);
  EXPECT_NEAR(sigma->max * sigma->display_factor(), 90, 1e-4);
  EXPECT_NEAR(sigma->fallback * sigma->display_factor(), 20, 1e-4);
}

TEST(Registry, DefaultsAreValidAndDamageIsNamed) {
  for (const ModelRow& model : models()) {
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      EXPECT_TRUE(validate(default_lobe(model.model, v), "a.json", "bases[0]"));
    }
  }
  Lobe lobe = default_lobe(Model::oren_nayar);
  lobe.params[1] = 30;  // degrees where radians are due
  auto status = validate(lobe, "a.json", "bases[3]");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().place, "bases[3].sigma");
  EXPECT_EQ(status.error().expected, "0 to 90 deg");
  lobe.params[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(validate(lobe, "a.json", "bases[3]"));
  lobe = default_lobe(Model::lambert);
  lobe.params[4] = 1;
  EXPECT_FALSE(validate(lobe, "a.json", "bases[3]"));
  lobe = default_lobe(Model::ward);
  lobe.variant = 3;
  EXPECT_FALSE(validate(lobe, "a.json", "bases[3]"));
  lobe.model = static_cast<Model>(200);
  EXPECT_FALSE(validate(lobe, "a.json", "bases[3]"));
}

TEST(Registry, ChangingTheVariantKeepsWhatBothHave) {
  Lobe lobe = default_lobe(Model::cook_torrance);
  lobe.params[1] = 0.4f;
  const Lobe exact = with_variant(lobe, kCookTorranceModernExact);
  EXPECT_EQ(exact.params[1], 0.4f);
  EXPECT_EQ(exact.params[2], 1.5f);
  EXPECT_TRUE(validate(exact, "", ""));
}

TEST(Packing, EveryVariantSaysWhichCodeItNeeds) {
  for (const Lobe& lobe : test::lobes_of_width(0.5)) EXPECT_NE(lobe_models_bit(lobe), 0u) << words_of(lobe);
  EXPECT_EQ(lobe_models_bit(default_lobe(Model::ward)), 8u);
}

}  // namespace
}  // namespace vamp
