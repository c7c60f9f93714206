// The registry of actions: shortcuts and the search of the palette.
#include "editor/widgets/actions.h"

#include "tests/widgets/ui_test.h"

namespace vamp::ui {
namespace {

TEST(Shortcut, NamesBecomeKeys) {
  EXPECT_EQ(parse_shortcut("Ctrl+Shift+P"), (Shortcut{'P', true, true, false}));
  EXPECT_EQ(parse_shortcut("F11"), (Shortcut{300, false, false, false}));
  EXPECT_EQ(parse_shortcut("Alt+Left"), (Shortcut{263, false, false, true}));
  EXPECT_EQ(parse_shortcut(""), Shortcut{});
  EXPECT_DEATH(parse_shortcut("Ctrl+Nonsense"), "");
}

class ActionsTest : public UiTest {
 protected:
  void SetUp() override {
    actions_.add({.id = "undo", .label = "Undo", .menu = "Edit", .shortcut = "Ctrl+Z", .run = [this] { ++undone_; }});
    actions_.add({.id = "fit", .label = "Fit view", .menu = "View", .shortcut = "F", .run = [this] { ++fitted_; }});
    actions_.add({.id = "never",
                  .label = "Never",
                  .menu = "View",
                  .shortcut = "N",
                  .run = [this] { ++never_; },
                  .enabled = [] { return false; }});
    actions_.add({.id = "leave", .label = "Nothing", .menu = "Select", .shortcut = "Esc", .run = [this] { ++left_; }});
  }
  void tap(int code, bool ctrl) {
    ImGui::GetIO().KeyCtrl = ctrl;
    key(code, true);
    step();
    key(code, false);
    ImGui::GetIO().KeyCtrl = false;
    step();
  }
  void step() {
    frame([&] {
      actions_.handle_shortcuts();
      if (field_) {
        ImGui::SetKeyboardFocusHere();
        ImGui::InputText("field", text_, sizeof text_);
      }
      actions_.draw_popups();
    });
  }
  Actions actions_;
  int undone_ = 0, fitted_ = 0, never_ = 0, left_ = 0;
  bool field_ = false;
  char text_[32] = {};
};

TEST_F(ActionsTest, AShortcutRunsItsActionOncePerPress) {
  step();
  tap('Z', true);
  EXPECT_EQ(undone_, 1);
  tap('Z', false);
  EXPECT_EQ(undone_, 1);
  tap('F', false);
  EXPECT_EQ(fitted_, 1);
}

TEST_F(ActionsTest, DisabledActionsDoNotRun) {
  step();
  tap('N', false);
  EXPECT_EQ(never_, 0);
  EXPECT_FALSE(actions_.run("never"));
  EXPECT_FALSE(actions_.run("unknown"));
}

TEST_F(ActionsTest, EscThatClosesAPopupDoesNothingElse) {
  step();
  actions_.open_sheet();
  step();
  step();
  tap(kEscape, false);
  EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
  EXPECT_EQ(left_, 0);
  tap(kEscape, false);
  EXPECT_EQ(left_, 1);
}

TEST_F(ActionsTest, ATextFieldKeepsItsKeys) {
  field_ = true;
  for (int i = 0; i < 3; ++i) step();
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  tap('F', false);
  tap('Z', true);
  EXPECT_EQ(fitted_ + undone_, 0);
}

TEST_F(ActionsTest, AnIdentifierOrShortcutTwiceIsAMistake) {
  EXPECT_DEATH(actions_.add({.id = "undo", .label = "x"}), "");
  EXPECT_DEATH(actions_.add({.id = "other", .label = "x", .shortcut = "Ctrl+Z"}), "");
}

TEST_F(ActionsTest, ThePaletteRunsTheBestHit) {
  step();
  actions_.open_palette();
  for (int i = 0; i < 3; ++i) step();
  type("fit");
  step();
  step();
  tap(kEnter, false);
  EXPECT_EQ(fitted_, 1);
  EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup));
}

TEST(Palette, LettersInOrderMatchAndStartsOfWordsWin) {
  EXPECT_EQ(Actions::match("xyz", "Reset layout"), 0);
  EXPECT_GT(Actions::match("", "Anything"), 0);
  EXPECT_GT(Actions::match("rl", "Reset layout"), Actions::match("rl", "Orbit light"));
  EXPECT_GT(Actions::match("RESET", "reset layout"), 0);
}

}  // namespace
}  // namespace vamp::ui
