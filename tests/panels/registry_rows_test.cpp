// Each parameter of the registry is a row with all that a designer needs.
#include "editor/panels/registry_rows.h"

#include <imgui_internal.h>

#include <cmath>

#include "editor/model/edits_material.h"
#include "tests/panels/panel_test.h"

namespace vamp::ui {
namespace {

template <class Visit>
void for_each_row(Visit visit) {
  for (const ModelRow& model : models()) {
    for (size_t v = 0; v < model.variants.size(); ++v) {
      for (const ParameterRow& row : model.parameters) {
        if (row.belongs_to(static_cast<uint8_t>(v)) && !row.hidden) visit(model, static_cast<uint8_t>(v), row);
      }
    }
  }
}

TEST(RegistryRow, EveryParameterHasLabelUnitRangeDefaultAndTooltip) {
  int count = 0;
  for_each_row([&](const ModelRow& model, uint8_t, const ParameterRow& row) {
    ++count;
    const RegistryRow words(row);
    const Parameter parameter = words.parameter(row.fallback);
    SCOPED_TRACE(std::string(model.name) + "." + std::string(row.name));
    EXPECT_STRNE(parameter.label, "");
    EXPECT_STRNE(parameter.description, "");
    // "1" is the unit of a plain number; all others are said.
    EXPECT_FALSE(row.unit.empty());
    EXPECT_EQ(row.unit == "1", *parameter.unit == 0);
    EXPECT_LT(parameter.low, parameter.high);
    EXPECT_GE(parameter.initial, parameter.low);
    EXPECT_LE(parameter.initial, parameter.high);
    if (row.unit == "deg") {
      EXPECT_THAT(parameter.format, testing::HasSubstr("°"));
      EXPECT_NEAR(parameter.initial, row.fallback * 57.29578f, 1e-3f);
    }
  });
  EXPECT_GT(count, 25);
}

TEST(RegistryRow, TheSliderMovesAsTheRegistrySays) {
  for_each_row([&](const ModelRow& model, uint8_t, const ParameterRow& row) {
    const RegistryRow words(row);
    const Parameter p = words.parameter(row.fallback);
    SCOPED_TRACE(std::string(model.name) + "." + std::string(row.name));
    EXPECT_EQ(p.mapping->from_slider(0, p.low, p.high), p.low);
    EXPECT_EQ(p.mapping->from_slider(1, p.low, p.high), p.high);
    for (const float t : {0.1f, 0.25f, 0.5f, 0.9f}) {
      const float value = p.mapping->from_slider(t, p.low, p.high);
      EXPECT_NEAR(value, from_slider(row, t) * words.factor, 2e-5f * std::max(std::abs(p.high), std::abs(value)));
      EXPECT_NEAR(p.mapping->to_slider(value, p.low, p.high), t, 1e-4f);
    }
  });
}

class MaterialRows : public PanelTest {};

// ImGui's log says which texts a frame shows.
TEST_F(MaterialRows, EveryVisibleParameterOfAModelIsShownAndNoOther) {
  for (const ModelRow& model : models()) {
    for (size_t v = 0; v < model.variants.size(); ++v) {
      const auto variant = static_cast<uint8_t>(v);
      select("Vamp", 0, 3);
      document_.edit(set_model(*document_.project(), one_row(selection_.material, {0, 3}), model.model, variant));
      BasisSection section;
      std::string shown;
      frame([&] {
        ImGui::LogToBuffer();
        section.draw(context_, EditScope::this_cluster);
        shown = ImGui::GetCurrentContext()->LogBuffer.c_str();
        ImGui::LogFinish();
      });
      for (const ParameterRow& row : model.parameters) {
        const ParameterRow* now = find_parameter(model.model, variant, row.name);
        const bool expected = now != nullptr && !now->hidden && now->label == row.label;
        const bool found = shown.find("\n" + std::string(row.label)) != std::string::npos ||
                           shown.find(" " + std::string(row.label)) != std::string::npos;
        EXPECT_EQ(found, expected) << model.name << " " << model.variants[v].name << " " << row.label << "\n" << shown;
      }
    }
  }
}

}  // namespace
}  // namespace vamp::ui
