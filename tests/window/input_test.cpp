// The input queue: what happens between two frames must not be lost or blurred.
#include "app/window/input.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace vamp::window {
namespace {

class InputTest : public testing::Test {
 protected:
  InputTest() : context_(ImGui::CreateContext()), io_(ImGui::GetIO()) {}
  ~InputTest() override { ImGui::DestroyContext(context_); }
  ImGuiContext* context_;
  ImGuiIO& io_;
  InputQueue queue_;
};

TEST_F(InputTest, AQuickTapIsSeenForOneFrame) {
  queue_.key(GLFW_KEY_F, true);
  queue_.key(GLFW_KEY_F, false);
  queue_.apply(io_);
  EXPECT_TRUE(io_.KeysDown[GLFW_KEY_F]);
  queue_.apply(io_);
  EXPECT_FALSE(io_.KeysDown[GLFW_KEY_F]);
  EXPECT_TRUE(queue_.empty());
}

TEST_F(InputTest, AModifierHoldsAsLongAsItsKey) {
  // Ctrl may be let go before the letter, all between two frames.
  queue_.key(GLFW_KEY_LEFT_CONTROL, true);
  queue_.key(GLFW_KEY_Q, true);
  queue_.key(GLFW_KEY_LEFT_CONTROL, false);
  queue_.key(GLFW_KEY_Q, false);
  queue_.apply(io_);
  EXPECT_TRUE(io_.KeysDown[GLFW_KEY_Q]);
  EXPECT_TRUE(io_.KeyCtrl);
  queue_.apply(io_);
  EXPECT_FALSE(io_.KeyCtrl);
  EXPECT_FALSE(io_.KeysDown[GLFW_KEY_Q]);
}

TEST_F(InputTest, AModifierHoldsAsLongAsItsClick) {
  queue_.key(GLFW_KEY_LEFT_CONTROL, true);
  queue_.mouse_button(0, true);
  queue_.key(GLFW_KEY_LEFT_CONTROL, false);
  queue_.apply(io_);
  EXPECT_TRUE(io_.MouseDown[0] && io_.KeyCtrl);
}

TEST_F(InputTest, ADoubleClickKeepsBothClicks) {
  for (const bool down : {true, false, true, false}) queue_.mouse_button(0, down);
  for (const bool down : {true, false, true, false}) {
    queue_.apply(io_);
    EXPECT_EQ(io_.MouseDown[0], down);
  }
}

TEST_F(InputTest, ThePointerArrivesBeforeItsClickAndStaysUntilItsRelease) {
  queue_.mouse_moved(10, 20);
  queue_.mouse_button(0, true);
  queue_.mouse_moved(30, 40);
  queue_.mouse_button(0, false);
  queue_.apply(io_);
  EXPECT_EQ(io_.MousePos.x, 10);
  EXPECT_FALSE(io_.MouseDown[0]);
  queue_.apply(io_);
  EXPECT_EQ(io_.MousePos.x, 10);
  EXPECT_TRUE(io_.MouseDown[0]);
  queue_.apply(io_);
  EXPECT_EQ(io_.MousePos.x, 30);
}

TEST_F(InputTest, MovesInARowBecomeOne) {
  for (int i = 0; i < 1000; ++i) queue_.mouse_moved(static_cast<float>(i), 0);
  queue_.apply(io_);
  EXPECT_EQ(io_.MousePos.x, 999);
  EXPECT_TRUE(queue_.empty());
}

TEST_F(InputTest, KeysOutsideOfTheTableAreIgnored) {
  queue_.key(-1, true);
  queue_.key(100000, true);
  queue_.mouse_button(17, true);
  EXPECT_TRUE(queue_.empty());
}

}  // namespace
}  // namespace vamp::window
