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
  const ViewportTextures& view = context.viewport;
  return view.width > 0 && view.height > 0 ? static_cast<float>(view.width) / static_cast<float>(view.height)
                                           : 4.0f / 3;
}

void fit_view(PanelContext& context) {
  const Project& project = *context.document.project();
  context.document.set_camera(fit(project.camera, subject_bounds(project), view_aspect(context)));
}

void fit_part(PanelContext& context, int part) {
  const Project& project = *context.document.project();
  if (part < 0 || static_cast<size_t>(part) >= project.scene->parts.size()) return;
  const Bounds& bounds = project.scene->parts[static_cast<size_t>(part)].bounds;
  context.document.set_camera(fit(project.camera, bounds, view_aspect(context)));
}

void standard_view(PanelContext& context, StandardView view) {
  const Project& project = *context.document.project();
  Camera camera = project.camera;
  camera.target = subject_bounds(project).center();
  camera.eye = camera.target + side_of(view);
  camera.up = vec3(0, 1, 0);
  context.document.set_camera(fit(camera, subject_bounds(project), view_aspect(context)));
}

}  // namespace vamp::ui
