// The picture under the mouse: what selects, what moves the camera, what does neither.
#include <cstring>
#include <glm/geometric.hpp>

#include "editor/panels/material_drop.h"
#include "editor/panels/subject.h"
#include "editor/panels/view_commands.h"
#include "tests/panels/panel_test.h"

namespace vamp::ui {
namespace {

class Viewport : public PanelTest {
 protected:
  Viewport() {
    context_.viewport.width = 400;
    context_.viewport.height = 500;
    context_.resize_viewport = [this](int width, int height) {
      ++resizes_;
      width_ = width;
      height_ = height;
    };
    context_.assign_preset = [this](const std::filesystem::path& path, int part) {
      assigned_ = path.string();
      assigned_part_ = part;
    };
    // The left half shows the vamp, the right half nothing.
    context_.pick = [this](float x, float) {
      Pick pick;
      if (x < 200) {
        pick.part = find_part(*document_.project(), "Vamp");
        pick.cluster = 1;
      }
      return pick;
    };
  }
  void step(int frames = 1) { draw(panel_, frames); }
  void hold(int button, bool down) {
    press(down, button);
    step();
  }
  void drag(int button, float x, float y, float dx, float dy) {
    move(x, y);
    step(2);
    hold(button, true);
    for (int i = 1; i <= 4; ++i) {
      move(x + dx * static_cast<float>(i) / 4, y + dy * static_cast<float>(i) / 4);
      step();
    }
    hold(button, false);
    step();
  }
  void click(float x, float y) {
    drag(0, x, y, 0, 0);
    for (int i = 0; i < 12; ++i) step();  // apart from the next click
  }
  void tap(int code) {
    key(code, true);
    step();
    key(code, false);
    step();
  }
  const Camera& camera() const { return document_.project()->camera; }

  ViewportPanel panel_;
  int resizes_ = 0, width_ = 0, height_ = 0;
  std::string assigned_;
  int assigned_part_ = -1;
};

TEST_F(Viewport, AsksForItsSizeOnce) {
  step(5);
  EXPECT_EQ(resizes_, 1);
  EXPECT_EQ(width_, 400);
  EXPECT_EQ(height_, 500);
}

TEST_F(Viewport, AClickSelectsPartAndCluster) {
  const Camera before = camera();
  click(100, 200);
  EXPECT_EQ(selection_.part, find_part(*document_.project(), "Vamp"));
  EXPECT_EQ(selection_.material, document_.project()->parts[static_cast<size_t>(selection_.part)].material);
  EXPECT_EQ(selection_.cluster, 1);
  EXPECT_EQ(camera(), before);
  click(300, 200);
  EXPECT_EQ(selection_, Selection{});
}

TEST_F(Viewport, EscSelectsNothing) {
  click(100, 200);
  ASSERT_GE(selection_.part, 0);
  tap(kEscape);
  EXPECT_EQ(selection_, Selection{});
}

TEST_F(Viewport, ADragIsNoClick) {
  drag(0, 100, 200, 30, 0);
  EXPECT_EQ(selection_, Selection{});
  drag(0, 100, 200, 3, 0);  // a hand trembles
  EXPECT_GE(selection_.part, 0);
}

TEST_F(Viewport, TheOrbitToolTurnsWithoutAStep) {
  context_.tool = Tool::orbit;
  const Camera before = camera();
  drag(0, 100, 200, 40, 20);
  EXPECT_NE(camera().eye, before.eye);
  EXPECT_EQ(camera().target, before.target);
  EXPECT_NEAR(glm::length(camera().eye - camera().target), glm::length(before.eye - before.target), 1e-4f);
  EXPECT_GT(camera().eye.y, before.eye.y);  // pulled down: seen from higher
  EXPECT_EQ(selection_, Selection{});
  EXPECT_TRUE(document_.step_names().empty());
  EXPECT_FALSE(document_.dirty());
}

TEST_F(Viewport, OtherButtonsOrbitInAnyToolAndShiftMiddlePans) {
  Camera before = camera();
  drag(1, 100, 200, 40, 0);
  EXPECT_NE(camera().eye, before.eye);
  before = camera();
  drag(2, 100, 200, 40, 0);
  EXPECT_NE(camera().eye, before.eye);
  EXPECT_EQ(camera().target, before.target);
  before = camera();
  ImGui::GetIO().KeyShift = true;
  drag(2, 100, 200, 40, 0);
  ImGui::GetIO().KeyShift = false;
  EXPECT_NE(camera().target, before.target);
  EXPECT_NEAR(glm::length((camera().eye - camera().target) - (before.eye - before.target)), 0, 1e-5f);
}

// What is under the mouse when a pan begins is under it when it ends.
TEST_F(Viewport, PanFollowsTheMouse) {
  const Camera before = camera();
  ImGui::GetIO().KeyShift = true;
  drag(2, 200, 250, 60, -40);
  ImGui::GetIO().KeyShift = false;
  const CameraFrame frame = camera_frame(camera(), 400.0f / 500);
  const vec3 way = before.target - frame.origin;
  const float depth = glm::dot(way, frame.forward);
  const float half = glm::length(frame.up);
  EXPECT_NEAR(glm::dot(way, frame.right) / glm::dot(frame.right, frame.right) / depth * 200, 60, 0.5f);
  EXPECT_NEAR(glm::dot(way, frame.up) / (half * half) / depth * 250, 40, 0.5f);
}

TEST_F(Viewport, TheWheelZoomsToTheMouse) {
  step(2);
  move(300, 150);
  step();
  const auto at_mouse = [&] {
    const CameraFrame frame = camera_frame(camera(), 400.0f / 500);
    const float depth = glm::length(camera().target - camera().eye);
    const float x = 2 * 300.0f / 400 - 1, y = 1 - 2 * 150.0f / 500;
    return frame.origin + depth * (frame.forward + x * frame.right + y * frame.up);
  };
  const vec3 before = at_mouse();
  const float distance = glm::length(camera().target - camera().eye);
  ImGui::GetIO().MouseWheel = 2;
  step();
  EXPECT_LT(glm::length(camera().target - camera().eye), distance);
  EXPECT_LT(glm::length(at_mouse() - before), 1e-4f * distance);
}

TEST_F(Viewport, ARightClickSelectsThePartAndOpensItsMenu) {
  drag(1, 100, 200, 0, 0);
  EXPECT_EQ(selection_.part, find_part(*document_.project(), "Vamp"));
  EXPECT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
  tap(256);
  // A drag with the same button turns the view and opens nothing.
  selection_ = {};
  const Camera before = camera();
  drag(1, 100, 200, 40, 0);
  EXPECT_NE(camera().eye, before.eye);
  EXPECT_EQ(selection_.part, -1);
}

TEST_F(Viewport, ArrowKeysTurn) {
  click(300, 200);
  const Camera before = camera();
  tap(263);
  EXPECT_NE(camera().eye, before.eye);
  EXPECT_EQ(camera().target, before.target);
}

TEST_F(Viewport, ShowsTheWholeModelInEveryShapeOfPicture) {
  step();
  for (const ImVec2 size : {ImVec2(400, 500), ImVec2(900, 300), ImVec2(300, 900)}) {
    context_.viewport_size = size;
    const float aspect = size.x / size.y;
    const std::vector<vec3> points = subject_points(*document_.project());
    document_.set_camera(dolly(camera(), 30, 1));
    fit_view(context_);
    EXPECT_TRUE(in_view(camera(), points, aspect, 0.049f));
    EXPECT_FALSE(in_view(camera(), points, aspect, 0.051f));
    // This model has no camera of its own, which might cut something off on purpose.
    document_.set_camera(dolly(camera(), 0.5f, 1));
    fit_opened(context_);
    EXPECT_TRUE(in_view(camera(), points, aspect, 0.049f));
    fit_part(context_, 0);
    EXPECT_TRUE(in_view(camera(), part_points(*document_.project(), 0), aspect, 0.049f));
  }
}

TEST(Subject, FloorsAndHiddenPartsAreLeftOut) {
  SceneBuilder builder;
  builder.add_box("Shoe", vec3(-0.1f, 0, -0.1f), vec3(0.1f, 0.1f, 0.1f));
  builder.add_box("Lace tip", vec3(0.1f, 0, 0.1f), vec3(0.101f, 0.001f, 0.101f));
  builder.add_quad("Floor", vec3(-4, 0, 4), vec3(8, 0, 0), vec3(0, 0, -8));
  Project project = dark_project(builder.build());
  EXPECT_LT(subject_bounds(project).radius(), 0.2f);
  EXPECT_EQ(subject_bounds(project).lo.x, -0.1f);
  project.parts[static_cast<size_t>(find_part(project, "Shoe"))].visible = false;
  project.parts[static_cast<size_t>(find_part(project, "Lace tip"))].visible = false;
  EXPECT_GT(subject_bounds(project).radius(), 4);
  for (PartState& part : project.parts) part.visible = false;
  EXPECT_EQ(subject_bounds(project), project.scene->bounds);
}

TEST(Subject, StandsWhereItsPartsWereMoved) {
  Project project = shoe_in_a_box();
  const Bounds before = subject_bounds(project);
  const auto vamp = static_cast<size_t>(find_part(project, "Vamp"));
  project.parts[vamp].place.offset = vec3(0, 2, 0);
  EXPECT_EQ(subject_bounds(project).hi.y, 2.1f);
  EXPECT_EQ(subject_bounds(project).lo, before.lo);
  Bounds points;
  for (const vec3& p : part_points(project, static_cast<int>(vamp))) points.extend(p);
  EXPECT_EQ(points.lo.y, 2);
  EXPECT_EQ(points.hi.y, 2.1f);
  // Turned by an eighth the box is wider by the root of two, about its middle.
  project.parts[vamp].place = {{}, {0, 0.785398163f, 0}};
  points = {};
  for (const vec3& p : part_points(project, static_cast<int>(vamp))) points.extend(p);
  EXPECT_NEAR(points.hi.x, 0.141421356f, 1e-6f);
  EXPECT_NEAR(points.lo.y, 0, 1e-6f);
}

TEST_F(Viewport, ADoubleClickOnNothingFits) {
  document_.set_camera(dolly(camera(), 30, 1));
  const float far = glm::length(camera().eye - camera().target);
  move(300, 200);
  step(2);
  for (const bool down : {true, false, true, false}) hold(0, down);
  EXPECT_LT(glm::length(camera().eye - camera().target), far / 2);
}

// Something above the picture that can be dragged into it.
class Dropping : public Viewport {
 protected:
  void both(const char* type, const char* payload) {
    frame([&] {
      ImGui::Button("source", ImVec2(100, 40));
      if (ImGui::BeginDragDropSource()) {
        ImGui::SetDragDropPayload(type, payload, std::strlen(payload) + 1);
        ImGui::EndDragDropSource();
      }
      ImGui::BeginChild("view", ImVec2(380, 400));
      panel_.draw(context_);
      ImGui::EndChild();
    });
  }
  void drop_at(float x, const char* type, const char* payload) {
    move(50, 30);
    both(type, payload);
    both(type, payload);
    press(true);
    both(type, payload);
    for (const float t : {0.3f, 0.6f, 1.0f, 1.0f}) {
      move(50 + (x - 50) * t, 30 + 200 * t);
      both(type, payload);
    }
    press(false);
    both(type, payload);
    both(type, payload);
  }
};

TEST_F(Dropping, APresetOnAPartIsAssignedToIt) {
  drop_at(100, kPresetPayload, "/presets/calf.vamp");
  EXPECT_EQ(assigned_, "/presets/calf.vamp");
  EXPECT_EQ(assigned_part_, find_part(*document_.project(), "Vamp"));
  assigned_.clear();
  drop_at(300, kPresetPayload, "/presets/calf.vamp");
  EXPECT_EQ(assigned_, "");
}

TEST_F(Dropping, AMaterialOfTheDocumentOnAPartIsShared) {
  const auto material_of = [&](const char* part) {
    const Project& project = *document_.project();
    return project.parts[static_cast<size_t>(find_part(project, part))].material;
  };
  ASSERT_NE(material_of("Vamp"), material_of("Sole"));
  const std::string name = document_.project()->materials[static_cast<size_t>(material_of("Sole"))].name;
  drop_at(100, kMaterialPayload, name.c_str());
  EXPECT_EQ(material_of("Vamp"), material_of("Sole"));
  EXPECT_EQ(selection_.part, find_part(*document_.project(), "Vamp"));
  EXPECT_EQ(document_.step_names().size(), 1u);
}

}  // namespace
}  // namespace vamp::ui
