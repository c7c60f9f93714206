// Every panel under every selection, and under a hand that does anything at all.
#include <algorithm>
#include <random>

#include "editor/model/edits_scene.h"
#include "tests/panels/panel_test.h"

namespace vamp::ui {
namespace {

class EveryPanel : public PanelTest {
 protected:
  template <class Visit>
  void for_each(Visit visit) {
    visit(panels_.viewport);
    visit(panels_.presets);
    visit(panels_.parts);
    visit(panels_.lights);
    visit(panels_.camera);
    visit(panels_.history);
    visit(panels_.log);
    visit(panels_.material);
    visit(panels_.render);
  }
  void draw_all() {
    for_each([&](auto& panel) { draw(panel, 3); });
  }
  void add_lights() {
    for (int i = 0; i < kLightTypeCount; ++i) {
      document_.edit(add_light(*document_.project(), new_light(*document_.project(), static_cast<LightType>(i))));
    }
  }
  Panels panels_;
};

TEST_F(EveryPanel, DrawsWithNothingSelectedAndChangesNothing) {
  const ProjectPtr before = document_.project();
  draw_all();
  EXPECT_EQ(document_.project(), before);
  EXPECT_EQ(selection_, Selection{});
}

TEST_F(EveryPanel, DrawsEverySelection) {
  add_lights();
  const ProjectPtr before = document_.project();
  for (const char* part : {"Vamp", "Sole"}) {
    for (const int cluster : {-1, 0, 1}) {
      for (const int basis : {-1, 0, 6}) {
        select(part, cluster, basis);
        draw_all();
      }
    }
  }
  EXPECT_EQ(document_.project(), before);
}

TEST_F(EveryPanel, ASelectionThatIsGoneDoesNoHarm) {
  selection_ = {99, 99, 99, 99};
  draw_all();
  EXPECT_EQ(selection_.part, -1);
  selection_ = {0, 77, 500, 70000};
  draw_all();
  EXPECT_EQ(selection_.material, document_.project()->parts[0].material);
}

TEST_F(EveryPanel, DrawsALostDevice) {
  context_.status.error = "the device was lost";
  draw_all();
}

TEST_F(EveryPanel, SaysInThePicturesPlaceWhyNothingIsOpen) {
  context_.problem = "shoe.glb: expected a glTF file, found nothing";
  std::string opened;
  context_.recent_files = [] { return std::vector<std::filesystem::path>{"/shoes/derby.vampproj"}; };
  context_.open_file = [&](const std::filesystem::path& path) { opened = path.string(); };
  draw_all();
  for (float y = 120; y < 400 && opened.empty(); y += 6) {
    move(60, y);
    draw(panels_.viewport, 2);
    press(true);
    draw(panels_.viewport);
    press(false);
    draw(panels_.viewport);
  }
  EXPECT_EQ(opened, "/shoes/derby.vampproj");
}

TEST_F(EveryPanel, TheWaysOnAreThereForTheKeyboardToo) {
  context_.problem = "shoe.glb: expected a glTF file, found nothing";
  std::string asked;
  context_.run = [&](const std::string& action) { asked = action; };
  draw(panels_.viewport, 5);
  EXPECT_EQ(asked, "");
  key(' ', true);
  draw(panels_.viewport, 2);
  key(' ', false);
  draw(panels_.viewport, 2);
  EXPECT_EQ(asked, "file.open");
}

TEST_F(EveryPanel, DrawsInTheDockAsItIsShipped) {
  Dock dock(default_layout);
  add_panels(dock, panels_, context_);
  select("Vamp");
  ImGui::GetIO().DisplaySize = ImVec2(1600, 1000);
  for (int i = 0; i < 3; ++i) {
    ImGui::NewFrame();
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(1600, 1000));
    ImGui::Begin("all", nullptr, ImGuiWindowFlags_NoDecoration);
    dock.draw(ImVec2(0, 0), ImVec2(1600, 1000));
    ImGui::End();
    ImGui::Render();
  }
  for (const char* id : {"viewport", "presets", "parts", "lights", "camera", "history", "log", "material", "render"}) {
    EXPECT_TRUE(dock.visible(id)) << id;
  }
}

// Presses, drags, types and turns the wheel at random. The project must stay valid, and undo and redo exact.
TEST_F(EveryPanel, AnythingAHandCanDoKeepsTheProjectValid) {
  const auto same = [](Project a, Project b) {
    a.camera = b.camera = Camera{};  // no part of the history
    return a == b;
  };
  std::mt19937 random(17);
  const auto upto = [&](uint32_t n) { return static_cast<int>(random() % n); };
  context_.pick = [&](float x, float) {
    Pick pick;
    pick.part = x < 200 ? 0 : x < 300 ? 1 : -1;
    pick.cluster = 0;
    return pick;
  };
  const Project start = *document_.project();
  add_lights();
  int changes = 0;
  document_.listen([&](const ProjectPtr&, const std::string&) { ++changes; });
  for_each([&](auto& panel) {
    for (int i = 0; i < 700; ++i) {
      const int what = upto(10);
      if (what < 4) move(static_cast<float>(upto(400)), static_cast<float>(upto(500)));
      if (what == 4) ImGui::GetIO().MousePos.x += static_cast<float>(upto(60) - 30);
      if (what == 5 || what == 6) press(upto(5) < 3, upto(8) == 0 ? 1 : 0);
      if (what == 7) ImGui::GetIO().MouseWheel = static_cast<float>(upto(5) - 2);
      if (what == 8 && upto(4) == 0) type(upto(2) == 0 ? "7" : "-1e9");
      const int code = std::array{kEscape, kEnter, kTab, kDown, kBackspace}[static_cast<size_t>(upto(5))];
      if (what == 9) key(code, true);
      draw(panel);
      key(code, false);
      if (i % 100 == 0) {
        const Status status = validate(*document_.project(), "");
        ASSERT_TRUE(status) << status.error().message();
      }
    }
    for (int button = 0; button < 2; ++button) press(false, button);
    move(-100, -100);
    draw(panel, 3);
    document_.commit_gesture();
  });
  const Status status = validate(*document_.project(), "");
  ASSERT_TRUE(status) << status.error().message();
  EXPECT_GT(changes, 100);  // the hand met something
  document_.go_to_step(document_.step_names().size());
  const Project end = *document_.project();
  document_.go_to_step(0);
  EXPECT_TRUE(same(*document_.project(), start));
  document_.go_to_step(document_.step_names().size());
  EXPECT_TRUE(same(*document_.project(), end));
}

TEST(Texts, NumbersReadWell) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(1940), "1,940");
  EXPECT_EQ(count_text(705600), "705,600");
  EXPECT_EQ(count_text(1048576), "1,048,576");
  EXPECT_EQ(bytes_text(48), "48 bytes");
  EXPECT_EQ(bytes_text(1u << 20), "1 MiB");
}

}  // namespace
}  // namespace vamp::ui
