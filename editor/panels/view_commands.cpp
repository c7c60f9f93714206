#include "editor/panels/view_commands.h"

#include "editor/panels/subject.h"

namespace vamp::ui {

const std::array<StandardViewRow, 6> kStandardViews{{
    {StandardView::three_quarter, "Three-quarter", "From the front, the right and above"},
    {StandardView::left, "Left", "From -X"},
    {StandardView::right, "Right", "From +X"},
    {StandardView::front, "Front", "From +Z"},
    {StandardView::back, "Back", "From -Z"},
    {StandardView::top, "Top", "From above"},
}};

namespace {

constexpr float kLandscape = 4.0f / 3;
constexpr float kMargin = 0.05f;  // of the picture, on each side

// Where the camera stands, seen from the model.
vec3 side_of(StandardView view) {
  switch (view) {
    case StandardView::three_quarter:
      return vec3(1.0f, 0.6f, 1.2f);  // as default_camera() has it
    case StandardView::left:
      return vec3(-1, 0, 0);
    case StandardView::right:
      return vec3(1, 0, 0);
    case StandardView::front:
      return vec3(0, 0, 1);
    case StandardView::back:
      return vec3(0, 0, -1);
    case StandardView::top:
      return vec3(0, 1, 0.0175f);  // a degree off the pole, where orbiting stops too
  }
  return vec3(0, 0, 1);
}

}  // namespace

float view_aspect(const PanelContext& context) {
  const ImVec2 size = context.viewport_size;
  return size.x >= 1 && size.y >= 1 ? size.x / size.y : kLandscape;
}

void fit_view(PanelContext& context) {
  const Project& project = *context.document.project();
  context.document.set_camera(fit(project.camera, subject_points(project), view_aspect(context), kMargin));
}

void fit_part(PanelContext& context, int part) {
  const Project& project = *context.document.project();
  context.document.set_camera(fit(project.camera, part_points(project, part), view_aspect(context), kMargin));
}

void fit_selection(PanelContext& context) {
  context.selection.part >= 0 ? fit_part(context, context.selection.part) : fit_view(context);
}

void fit_opened(PanelContext& context) {
  const Project& project = *context.document.project();
  const std::vector<vec3> points = subject_points(project);
  const float aspect = view_aspect(context);
  const bool own = !project.scene->cameras.empty();
  if (own && (in_view(project.camera, points, aspect, kMargin) || !in_view(project.camera, points, kLandscape, 0)))
    return;
  context.document.set_camera(fit(project.camera, points, aspect, kMargin));
}

void standard_view(PanelContext& context, StandardView view) {
  const Project& project = *context.document.project();
  Camera camera = project.camera;
  camera.target = subject_bounds(project).center();
  camera.eye = camera.target + side_of(view);
  camera.up = vec3(0, 1, 0);
  context.document.set_camera(fit(camera, subject_points(project), view_aspect(context), kMargin));
}

}  // namespace vamp::ui
