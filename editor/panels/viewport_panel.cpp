#include "editor/panels/viewport_panel.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "editor/model/edits_scene.h"
#include "editor/panels/material_drop.h"
#include "editor/panels/no_document.h"
#include "editor/panels/part_menu.h"
#include "editor/panels/subject.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/edit.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/places.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr float kClickTravel = 4;         // at 96 dpi: a drag that stays within is a click
constexpr float kDegreesPerPixel = 0.4f;  // at 96 dpi
constexpr float kZoomStep = 0.88f;        // of the distance, a notch of the wheel
constexpr float kKeyDegrees = 5;

// Key numbers are GLFW's.
enum : int { kKeyEscape = 256, kKeyRight = 262, kKeyLeft = 263, kKeyDown = 264, kKeyUp = 265 };

Pick pick_at(const PanelContext& context, float x, float y) {
  if (context.pick) return context.pick(x, y);
  return context.session != nullptr ? context.session->pick(x, y) : Pick{};
}

}  // namespace

void ViewportPanel::draw(PanelContext& context) {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (size.x < 1 || size.y < 1) return;
  ask_for_size(context, size);
  note_place("Viewport", low, ImVec2(low.x + size.x, low.y + size.y));
  if (!context.problem.empty()) return draw_no_document(context);
  draw_picture(context, low);

  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton(
      "##picture", size,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  // Also while something else is dragged over it.
  const bool over = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  update_hover(context, low, over && drag_ != Drag::orbit && drag_ != Drag::pan);
  accept_material(context, context.hover.part);
  handle_mouse(context, low, size, hovered);
  handle_keys(context, hovered);
  draw_chips(context, low, size, over);
  draw_menu(context);
  popup_was_open_ = popup_is_open();
}

void ViewportPanel::draw_menu(PanelContext& context) {
  if (!ImGui::BeginPopup("##part")) return;
  const ProjectPtr project = context.document.project();
  if (pressed_part_ >= 0 && static_cast<size_t>(pressed_part_) < project->parts.size()) {
    part_menu(context, pressed_part_);
  } else {
    if (ImGui::MenuItem("Frame the model")) fit_view(context);
    if (ImGui::MenuItem("Show all parts", "Alt+H")) context.document.edit(show_only(*project, -1));
    if (ImGui::MenuItem("Outlines", "Ctrl+H", context.show_outlines)) context.show_outlines = !context.show_outlines;
  }
  ImGui::EndPopup();
}

void ViewportPanel::ask_for_size(PanelContext& context, ImVec2 size) {
  context.viewport_size = size;
  const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
  if (width == asked_width_ && height == asked_height_) return;
  asked_width_ = width;
  asked_height_ = height;
  if (context.resize_viewport) context.resize_viewport(width, height);
}

void ViewportPanel::draw_picture(const PanelContext& context, ImVec2 low) const {
  const ViewportTextures& view = context.viewport;
  if (view.picture == nullptr || view.width <= 0 || view.height <= 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high(low.x + static_cast<float>(view.width), low.y + static_cast<float>(view.height));
  list.AddImage(view.picture, low, high);
  if (view.restarted != nullptr) list.AddImage(view.restarted, low, high);
  if (context.show_outlines && view.outline != nullptr) list.AddImage(view.outline, low, high);
}

void ViewportPanel::update_hover(PanelContext& context, ImVec2 low, bool over) {
  if (!over) {
    context.hover = Pick{};
    hover_at_ = ImVec2(-1, -1);
    return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const ImVec2 at(mouse.x - low.x, mouse.y - low.y);
  // The renderer answers for the picture it shows, which follows the document a moment later.
  const uint64_t picture = context.session != nullptr ? context.session->picture_version() : 0;
  const bool same = at.x == hover_at_.x && at.y == hover_at_.y && hover_picture_ == picture;
  if (same && hover_revision_ == context.document.revision()) return;
  hover_picture_ = picture;
  hover_at_ = at;
  hover_revision_ = context.document.revision();
  context.hover = pick_at(context, at.x, at.y);
}

void ViewportPanel::handle_mouse(PanelContext& context, ImVec2 low, ImVec2 size, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  if (drag_ == Drag::none && ImGui::IsItemActivated()) {
    button_ = ImGui::IsMouseClicked(1) ? 1 : ImGui::IsMouseClicked(2) ? 2 : 0;
    const bool pan = (button_ == 2 && io.KeyShift) || (button_ == 0 && io.KeyCtrl && io.KeyAlt);
    const bool orbit = button_ != 0 || io.KeyAlt || context.tool == Tool::orbit;
    drag_ = pan ? Drag::pan : orbit ? Drag::orbit : Drag::other;
    travelled_ = false;
    pressed_part_ = context.hover.part;  // while it is held nothing is hovered
  }
  if (drag_ != Drag::none) {
    const bool started = !travelled_;
    if (ImGui::IsMouseDragging(button_, px(kClickTravel))) travelled_ = true;
    const bool down = ImGui::IsMouseDown(button_);
    if (down && travelled_) {
      // The way to the threshold counts, so that the picture stays under the mouse.
      const ImVec2 way = started ? ImGui::GetMouseDragDelta(button_, 0) : io.MouseDelta;
      const Camera& camera = context.document.project()->camera;
      if (drag_ == Drag::orbit) {
        const float step = kDegreesPerPixel / theme().scale;
        context.document.set_camera(orbit(camera, -way.x * step, way.y * step));
      } else if (drag_ == Drag::pan) {
        context.document.set_camera(pan(camera, -way.x / size.y, way.y / size.y));
      }
    }
    if (!down) {
      if (!travelled_ && button_ == 0 && hovered && !io.KeyAlt) click(context);
      if (!travelled_ && button_ == 1 && hovered) {
        if (pressed_part_ >= 0 && pressed_part_ != context.selection.part)
          context.selection = select_part(*context.document.project(), pressed_part_);
        ImGui::OpenPopup("##part");
      }
      drag_ = Drag::none;
    }
  }
  if (hovered && io.MouseWheel != 0) zoom(context, low, size);
  if (hovered && ImGui::IsMouseDoubleClicked(0) && context.hover.part < 0) fit_view(context);
}

void ViewportPanel::zoom(PanelContext& context, ImVec2 low, ImVec2 size) const {
  const ImGuiIO& io = ImGui::GetIO();
  const Project& project = *context.document.project();
  const Camera before = project.camera;
  const float radius = std::max(subject_bounds(project).radius(), 1e-6f);
  const float notches = std::clamp(io.MouseWheel, -8.0f, 8.0f);
  Camera camera = dolly(before, std::pow(kZoomStep, notches), radius);
  const float old_distance = glm::length(before.target - before.eye);
  const float distance = glm::length(camera.target - camera.eye);
  if (!(old_distance > 0) || !(distance > 0)) return;
  // What lies under the mouse at the target's distance stays there.
  const float away = old_distance / distance - 1;
  const float x = (io.MousePos.x - low.x - size.x / 2) / size.y, y = (low.y + size.y / 2 - io.MousePos.y) / size.y;
  context.document.set_camera(pan(camera, x * away, y * away));
}

void ViewportPanel::click(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  Selection next;
  if (context.hover.part >= 0) {
    next = select_part(*project, context.hover.part);
    next.cluster = context.hover.cluster;
    // The same function in another cluster, where there is one: to compare them.
    if (next.material == context.selection.material) next.basis = context.selection.basis;
  }
  context.selection = valid_selection(*project, next);
}

void ViewportPanel::handle_keys(PanelContext& context, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool here = hovered || ImGui::IsWindowFocused();
  if (!here || io.WantTextInput || edit_is_open() || drag_ != Drag::none || io.KeyCtrl || io.KeyAlt) return;
  if (popup_was_open_ || popup_is_open()) return;
  if (ImGui::IsKeyPressed(kKeyEscape, false)) context.selection = Selection{};
  if (!ImGui::IsWindowFocused()) return;
  const float step = io.KeyShift ? 1 : kKeyDegrees;
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key) ? 1.0f : 0.0f; };
  const float yaw = (pressed(kKeyRight) - pressed(kKeyLeft)) * step;
  const float pitch = (pressed(kKeyUp) - pressed(kKeyDown)) * step;
  if (yaw != 0 || pitch != 0) context.document.set_camera(orbit(context.document.project()->camera, yaw, pitch));
}

}  // namespace vamp::ui
