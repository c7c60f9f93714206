// The library in its panel, and what was made of presets in the document.
#include <algorithm>

#include "editor/model/edits_material.h"
#include "editor/panels/material_drop.h"
#include "editor/panels/preset_tags.h"
#include "tests/panels/panel_test.h"

namespace vamp::ui {
namespace {

LibraryEntry entry(const char* name, std::vector<std::string> tags) {
  LibraryEntry made;
  made.info.name = name;
  made.info.tags = std::move(tags);
  return made;
}

TEST(CommonTags, AreTheFrequentOnesThatTellPresetsApart) {
  std::vector<LibraryEntry> entries{
      entry("calf", {"material", "leather", "brown"}),   entry("patent", {"material", "leather"}),
      entry("nubuck", {"material", "leather", "brown"}), entry("twill", {"material", "textile"}),
      entry("denim", {"material", "textile"}),           entry("felt", {"material", "wool"})};
  EXPECT_EQ(common_tags(entries), (std::vector<std::string>{"leather", "brown", "textile"}));
  entries.resize(5);
  EXPECT_TRUE(common_tags(entries).empty());  // a handful is seen at a glance
}

class Presets : public PanelTest {
 protected:
  const MaterialInstance& shown() const {
    return document_.project()->materials[static_cast<size_t>(selection_.material)];
  }
  void edit_it() { document_.edit(set_gain(*document_.project(), one_row(selection_.material, {0, 0}), vec3(2))); }
  PresetsPanel panel_;
};

TEST_F(Presets, AMaterialIsEditedWhenItIsNotWhatItsPresetWasSavedAs) {
  select("Vamp");
  EXPECT_FALSE(is_edited(context_, shown()));
  edit_it();
  EXPECT_TRUE(is_edited(context_, shown()));
  // Kept as a preset of its own it is just that.
  Preset preset;
  preset.name = "Bright";
  preset.fit = shown().fit;
  preset.edits = shown().edits;
  std::filesystem::remove_all(folder_);
  const auto path = library_.save_new(preset);
  ASSERT_TRUE(path) << path.error().message();
  document_.edit(become_preset(*document_.project(), selection_.material, *load_preset(*path), path->string()));
  EXPECT_EQ(shown().name, "Bright");
  EXPECT_FALSE(is_edited(context_, shown()));
  document_.edit(reset_material(*document_.project(), selection_.material));
  EXPECT_TRUE(is_edited(context_, shown()));
  std::filesystem::remove_all(folder_);
}

TEST_F(Presets, AnEditedMaterialIsSharedByADoubleClick) {
  select("Vamp");
  edit_it();
  const std::string edited = shown().name;
  select("Sole");
  // Below the search field and the title, whatever their heights are.
  for (float y = 60; y < 140 && shown().name != edited; y += 16) {
    move(40, y);
    draw(panel_, 12);
    for (const bool down : {true, false, true, false}) {
      press(down);
      draw(panel_);
    }
  }
  EXPECT_EQ(shown().name, edited);
  EXPECT_EQ(selection_.part, find_part(*document_.project(), "Sole"));
}

}  // namespace
}  // namespace vamp::ui
