// The parameter row under scripted input: what it reports is one gesture, one undo step.
#include <cmath>

#include "editor/widgets/colour.h"
#include "editor/widgets/hemisphere.h"
#include "editor/widgets/row.h"
#include "tests/widgets/ui_test.h"

namespace vamp::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ParameterRowTest : public UiTest {
 protected:
  // Frames with one row at the top of the window; remembers what it reported.
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      frame([&] {
        columns_ = next_row();
        if (shown_) {
          const EditOf<float> edit = parameter_row(parameter_, value_, state_);
          if (edit) {
            events_.push_back(edit.event);
            before_ = edit.before;
          }
        }
        abandoned_ = take_abandoned_edit() || abandoned_;
      });
    }
  }
  float middle() const { return columns_.top + columns_.height / 2; }
  float bar(float t) const { return columns_.control + t * (columns_.control_end - columns_.control); }
  void drag_to(float t) {
    move(bar(t), middle());
    step();
  }
  void grab(float t) {
    step(2);
    drag_to(t);
    press(true);
    step();
  }
  void let_go() {
    press(false);
    step(2);
  }
  void click(float x) {
    move(x, middle());
    step();
    press(true);
    step();
    press(false);
    step();
  }
  void start_typing() {
    step(2);
    const float x = (columns_.number + columns_.number_end) / 2;
    click(x);
    click(x);
    step();
  }
  void tap(int code) {
    key(code, true);
    step();
    key(code, false);
    step(2);
  }

  Parameter parameter_{"Gloss", 0, 1, 0.42f};
  float value_ = 0.5f;
  RowState state_;
  RowColumns columns_{};
  std::vector<Edit> events_;
  float before_ = -1;
  bool shown_ = true;
  bool abandoned_ = false;
};

TEST_F(ParameterRowTest, ADragIsOneGesture) {
  grab(0.5f);
  EXPECT_THAT(events_, IsEmpty());
  drag_to(0.6f);
  drag_to(0.8f);
  EXPECT_TRUE(edit_is_open());
  let_go();
  EXPECT_FALSE(edit_is_open());
  EXPECT_THAT(events_, ElementsAre(Edit::began, Edit::changing, Edit::committed));
  EXPECT_FLOAT_EQ(before_, 0.5f);
  EXPECT_NEAR(value_, 0.8f, 0.02f);
  EXPECT_FALSE(abandoned_);
}

TEST_F(ParameterRowTest, AClickAloneChangesNothing) {
  grab(0.9f);
  let_go();
  EXPECT_THAT(events_, IsEmpty());
  EXPECT_EQ(value_, 0.5f);
}

TEST_F(ParameterRowTest, ShiftMakesADragTenTimesFiner) {
  grab(0.5f);
  ImGui::GetIO().KeyShift = true;
  drag_to(0.9f);
  let_go();
  EXPECT_NEAR(value_, 0.54f, 0.005f);
}

TEST_F(ParameterRowTest, EscRestoresTheValueAndLeavesNoStep) {
  grab(0.5f);
  drag_to(0.9f);
  ASSERT_NE(value_, 0.5f);
  tap(kEscape);
  EXPECT_EQ(value_, 0.5f);
  drag_to(0.2f);  // the button is still down: the gesture is over all the same
  let_go();
  EXPECT_EQ(value_, 0.5f);
  EXPECT_THAT(events_, ElementsAre(Edit::began, Edit::cancelled));
  EXPECT_FLOAT_EQ(before_, 0.5f);
}

TEST_F(ParameterRowTest, DraggedBackToTheStartIsNoStep) {
  value_ = 0;
  grab(0.5f);
  drag_to(0.7f);
  drag_to(0.1f);  // below the range: clamped to where it began
  let_go();
  EXPECT_EQ(value_, 0);
  EXPECT_EQ(events_.back(), Edit::cancelled);
}

TEST_F(ParameterRowTest, TheValueStaysInItsRange) {
  grab(0.5f);
  drag_to(3.0f);
  EXPECT_EQ(value_, 1);
  drag_to(-5.0f);
  EXPECT_EQ(value_, 0);
  let_go();
}

TEST_F(ParameterRowTest, ATypedNumberIsOneStep) {
  start_typing();
  type("0.77");
  step(2);
  EXPECT_THAT(events_, IsEmpty());
  tap(kEnter);
  EXPECT_FLOAT_EQ(value_, 0.77f);
  EXPECT_THAT(events_, ElementsAre(Edit::committed));
  EXPECT_FLOAT_EQ(before_, 0.5f);
  EXPECT_FALSE(edit_is_open());
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
}

TEST_F(ParameterRowTest, TypingIsClampedAndNonsenseIsRefused) {
  for (const char* text : {"1e30", "7"}) {
    value_ = 0.5f;
    start_typing();
    type(text);
    step();
    tap(kEnter);
    EXPECT_EQ(value_, 1) << text;
  }
  for (const char* text : {"nan", "inf", "abc", "-", ""}) {
    value_ = 0.5f;
    start_typing();
    if (*text == 0) tap(kBackspace);
    type(text);
    step();
    tap(kEnter);
    EXPECT_EQ(value_, 0.5f) << text;
  }
}

TEST_F(ParameterRowTest, EscWhileTypingKeepsTheOldNumber) {
  start_typing();
  type("0.9");
  step();
  tap(kEscape);
  EXPECT_EQ(value_, 0.5f);
  EXPECT_THAT(events_, IsEmpty());
}

TEST_F(ParameterRowTest, OpeningAndLeavingTheFieldDoesNotRoundTheNumber) {
  value_ = 1.0f / 3;
  start_typing();
  tap(kEnter);
  EXPECT_EQ(value_, 1.0f / 3);
  EXPECT_THAT(events_, IsEmpty());
}

TEST_F(ParameterRowTest, AClickElsewhereCommitsWhatWasTyped) {
  start_typing();
  type("0.25");
  step();
  move(200, 300);
  step();
  press(true);
  step();
  press(false);
  step(2);
  EXPECT_FLOAT_EQ(value_, 0.25f);
  EXPECT_THAT(events_, ElementsAre(Edit::committed));
}

TEST_F(ParameterRowTest, ResetGoesToTheDefaultInOneStep) {
  step(2);
  click((columns_.reset + columns_.right) / 2);
  step(2);
  EXPECT_FLOAT_EQ(value_, 0.42f);
  EXPECT_THAT(events_, ElementsAre(Edit::committed));
  click((columns_.reset + columns_.right) / 2);
  step(2);
  EXPECT_EQ(events_.size(), 1u);  // at the default there is nothing to reset
}

TEST_F(ParameterRowTest, ARowThatVanishesInADragIsReported) {
  grab(0.5f);
  drag_to(0.8f);
  shown_ = false;
  step();
  EXPECT_TRUE(abandoned_);
  abandoned_ = false;
  let_go();
  shown_ = true;
  step(2);
  EXPECT_FALSE(abandoned_);
  EXPECT_FALSE(edit_is_open());
}

TEST_F(ParameterRowTest, ALockedRowTakesNoInput) {
  state_.locked = true;
  grab(0.5f);
  drag_to(0.9f);
  let_go();
  start_typing();
  EXPECT_FALSE(ImGui::GetIO().WantTextInput);
  EXPECT_EQ(value_, 0.5f);
  EXPECT_THAT(events_, IsEmpty());
}

TEST_F(ParameterRowTest, WholeNumbersMoveByOnesAndDoNotGetStuck) {
  parameter_ = {"Terms", 0, 4, 4};
  parameter_.whole = true;
  value_ = 0;
  grab(0.0f);
  for (int i = 1; i <= 100; ++i) drag_to(static_cast<float>(i) / 100);  // single steps below one unit
  let_go();
  EXPECT_EQ(value_, 4);
}

TEST(Number, MappingsMeetTheirEndsAndInvertEachOther) {
  for (const Mapping* mapping : {&kLinear, &kSquare, &kLog}) {
    EXPECT_EQ(mapping->from_slider(0, 0.1f, 50), 0.1f);
    EXPECT_EQ(mapping->from_slider(1, 0.1f, 50), 50);
    for (const float t : {0.1f, 0.5f, 0.9f}) {
      EXPECT_NEAR(mapping->to_slider(mapping->from_slider(t, 0.1f, 50), 0.1f, 50), t, 1e-5);
    }
  }
}

TEST(Number, AnglesWrapAndOthersClamp) {
  Parameter p{"a", 0, 360};
  EXPECT_EQ(admit(p, 370), 360);
  p.wraps = true;
  EXPECT_NEAR(admit(p, 370), 10, 1e-4);
  EXPECT_NEAR(admit(p, -30), 330, 1e-4);
  EXPECT_EQ(admit(p, NAN), p.initial);
  EXPECT_EQ(admit(p, INFINITY), p.initial);
}

TEST(Number, ParsesWhatPeopleType) {
  EXPECT_EQ(parse_number(" 12,5 mm"), 12.5f);
  EXPECT_EQ(parse_number("+3"), 3.0f);
  EXPECT_EQ(parse_number("1e3"), 1000.0f);
  EXPECT_EQ(parse_number("45°"), 45.0f);
  EXPECT_FALSE(parse_number("nan").has_value());
  EXPECT_FALSE(parse_number("inf").has_value());
  EXPECT_FALSE(parse_number("").has_value());
}

TEST(Colour, HexRoundTripsThroughLinear) {
  for (const char* hex : {"#000000", "#A8623A", "#FFFFFF", "#010203", "#7F80FE"}) {
    EXPECT_EQ(hex_from_linear(*linear_from_hex(hex)), hex);
  }
  EXPECT_EQ(hex_from_linear(*linear_from_hex(" f80 ")), "#FF8800");
  EXPECT_FALSE(linear_from_hex("#12345").has_value());
  EXPECT_FALSE(linear_from_hex("#GG0000").has_value());
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.21404114f, 1e-6);
}

TEST(Direction, TiltAndAzimuthAreTheVector) {
  const vec3 n = direction_from_tilt({30, 90});
  EXPECT_NEAR(n.x, 0, 1e-6);
  EXPECT_NEAR(n.y, 0.5, 1e-6);
  EXPECT_NEAR(n.z, std::sqrt(0.75), 1e-6);
  const Tilt back = tilt_from_direction(direction_from_tilt({18.2f, 300}));
  EXPECT_NEAR(back.tilt, 18.2, 1e-4);
  EXPECT_NEAR(back.azimuth, 300, 1e-3);
  EXPECT_EQ(tilt_from_direction(vec3(0, 0, 1)).azimuth, 0);
}

}  // namespace
}  // namespace vamp::ui
