// The tree of panels: moves, closing, storing, and layouts from elsewhere.
#include "editor/widgets/dock_layout.h"

#include <random>

#include "editor/widgets/dock.h"
#include "tests/widgets/ui_test.h"

namespace vamp::ui {
namespace {

using testing::ElementsAre;

DockLayout three() {
  return DockLayout(DockLayout::row(
      DockLayout::leaf({"presets", "parts"}),
      DockLayout::row(DockLayout::leaf({"viewport"}), DockLayout::leaf({"material", "plots"}), 400), 250));
}

size_t count_panels(const DockNode& node) {
  return node.is_leaf() ? node.tabs.size() : count_panels(*node.first) + count_panels(*node.second);
}

TEST(DockLayout, StoresAndRestoresItself) {
  DockLayout layout = three();
  layout.close("plots");
  layout.move("parts", *layout.leaf_of("material"), DockSide::bottom, 0);
  const std::string text = layout.print();
  const Result<DockLayout> back = DockLayout::parse(text, "layout.json");
  ASSERT_TRUE(back.has_value()) << back.error().message();
  EXPECT_EQ(back->print(), text);
}

TEST(DockLayout, DamagedOrLaterTextIsRefused) {
  const std::string good = three().print();
  std::string later = good;
  later.replace(later.find("\"version\": 1"), 12, "\"version\": 9");
  std::string other = good;
  other.replace(other.find("vamp-layout"), 11, "some-layout");
  std::string deep = R"({"tabs":[],"active":0})";
  for (int i = 0; i < 20; ++i) {
    deep = R"({"split":"row","pixels":1,"fraction":0.5,"collapsed":0,"first":)" + deep +
           R"(,"second":{"tabs":["a"],"active":0}})";
  }
  deep = R"({"format":"vamp-layout","version":1,"root":)" + deep + R"(,"closed":[]})";
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("{}"), good.substr(0, good.size() / 2), later, other, deep}) {
    const Result<DockLayout> layout = DockLayout::parse(text, "layout.json");
    ASSERT_FALSE(layout.has_value()) << text;
    EXPECT_THAT(layout.error().message(), testing::HasSubstr("layout.json"));
  }
}

TEST(DockLayout, APanelNamedTwiceAppearsOnce) {
  const Result<DockLayout> layout = DockLayout::parse(
      R"({"format":"vamp-layout","version":1,"root":{"tabs":["a","b","a"],"active":7},"closed":[]})", "layout.json");
  ASSERT_TRUE(layout.has_value());
  EXPECT_THAT(layout->root().tabs, ElementsAre("a", "b"));
}

TEST(DockLayout, NewPanelsJoinTheirNeighbourAndUnknownOnesGo) {
  DockLayout layout = three();
  layout.close("plots");
  const std::vector<DockPlace> places{{"presets", ""},           {"viewport", ""},       {"material", ""},
                                      {"plots", "material"},     {"lights", "material"}, {"log", "nowhere"},
                                      {"debug", "presets", true}};
  layout.reconcile(places);
  EXPECT_FALSE(layout.visible("parts"));  // no such panel any more
  EXPECT_FALSE(layout.visible("plots"));  // closed by the user
  EXPECT_FALSE(layout.visible("debug"));  // on request only
  EXPECT_TRUE(layout.visible("log"));
  EXPECT_EQ(layout.leaf_of("lights"), layout.leaf_of("material"));
  EXPECT_EQ(layout.leaf_of("material")->active, 0u);  // what was in front stays in front
  layout.show("plots", "material");
  EXPECT_EQ(layout.leaf_of("plots"), layout.leaf_of("material"));
  EXPECT_EQ(layout.leaf_of("plots")->tabs[layout.leaf_of("plots")->active], "plots");
}

TEST(DockLayout, EmptyLeavesDisappear) {
  DockLayout layout = three();
  layout.close("presets");
  layout.close("parts");
  EXPECT_EQ(layout.root().kind, DockNode::Kind::row);
  EXPECT_EQ(layout.root().first->tabs.front(), "viewport");
}

TEST(DockLayout, AnyMovesLoseNoPanel) {
  std::mt19937 random(11);
  const std::vector<std::string> all{"presets", "parts", "viewport", "material", "plots"};
  DockLayout layout = three();
  for (int i = 0; i < 3000; ++i) {
    const std::string& panel = all[random() % all.size()];
    DockNode* target = layout.leaf_of(all[random() % all.size()]);
    layout.move(panel, *target, static_cast<DockSide>(random() % 5), random() % 4);
    ASSERT_EQ(count_panels(layout.root()), all.size());
    for (const std::string& name : all) ASSERT_TRUE(layout.visible(name)) << i;
    ASSERT_LT(layout.leaf_of(panel)->active, layout.leaf_of(panel)->tabs.size());
  }
  EXPECT_TRUE(DockLayout::parse(layout.print(), "layout.json").has_value());
}

class DockTest : public UiTest {
 protected:
  DockTest() : dock_(three) {
    size_ = ImVec2(1400, 600);
    dock_.add({"viewport", "Viewport", [this] { viewport_ = ImGui::GetWindowSize(); }, "", true});
    for (const char* id : {"presets", "parts", "material", "plots"}) dock_.add({id, id, [] { ImGui::Text("hello"); }});
  }
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      frame([&] { dock_.draw(ImVec2(0, 0), ImVec2(width_, 500)); });
    }
  }
  Dock dock_;
  ImVec2 viewport_;
  float width_ = 1000;
};

TEST_F(DockTest, SidePanelsKeepTheirWidthWhenTheWindowGrows) {
  step(2);
  EXPECT_EQ(viewport_.x, 1000 - 250 - 400 - 2 * 4);
  width_ = 1300;
  step(2);
  EXPECT_EQ(viewport_.x, 1300 - 250 - 400 - 2 * 4);
}

TEST_F(DockTest, ASplitterDragsAndADoubleClickCollapses) {
  step(2);
  dock_.take_changed();
  move(252, 250);
  step();
  press(true);
  step();
  move(302, 250);
  step();
  press(false);
  step();
  EXPECT_EQ(viewport_.x, 1000 - 300 - 400 - 2 * 4);
  EXPECT_TRUE(dock_.take_changed());
  for (int i = 0; i < 12; ++i) step();  // apart from the next click
  for (const bool down : {true, false, true, false}) {
    press(down);
    step();
  }
  EXPECT_EQ(viewport_.x, 1000 - 400 - 2 * 4);
  EXPECT_TRUE(dock_.visible("presets"));
}

TEST_F(DockTest, ATinyWindowDoesNotBreakTheLayout) {
  for (const float width : {1.0f, 50.0f, 300.0f, 1000.0f}) {
    width_ = width;
    step(2);
  }
  EXPECT_EQ(viewport_.x, 1000 - 250 - 400 - 2 * 4);
}

TEST_F(DockTest, ATabDraggedToAnEdgeSplitsTheLeaf) {
  step(2);
  const float x = 660 + 20;
  move(x, 15);
  step();
  press(true);
  step();
  move(x + 30, 40);
  step();
  move(450, 480);  // the lower edge of the viewport
  step();
  press(false);
  step(2);
  EXPECT_TRUE(dock_.visible("material"));
  EXPECT_LT(viewport_.y, 400);
  dock_.reset();
  step(2);
  EXPECT_EQ(viewport_.y, 500);
}

TEST_F(DockTest, ADamagedLayoutFallsBackToTheDefault) {
  EXPECT_FALSE(dock_.restore("{broken", "layout.json").has_value());
  step(2);
  EXPECT_EQ(viewport_.x, 1000 - 250 - 400 - 2 * 4);
  const std::string stored = dock_.store();
  EXPECT_TRUE(dock_.restore(stored, "layout.json").has_value());
}

}  // namespace
}  // namespace vamp::ui
