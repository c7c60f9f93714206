#include "editor/widgets/icons.h"

#include <imgui_internal.h>

#include <cmath>

#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr float kPi = 3.14159265f;

// Draws in units of half the icon's size around its centre, y down.
struct Pen {
  ImDrawList& list;
  ImVec2 centre;
  float unit;
  ImU32 colour;
  float width;

  ImVec2 at(float x, float y) const { return ImVec2(centre.x + x * unit, centre.y + y * unit); }
  void line(float x0, float y0, float x1, float y1) const { list.AddLine(at(x0, y0), at(x1, y1), colour, width); }
  void circle(float x, float y, float r) const { list.AddCircle(at(x, y), r * unit, colour, 0, width); }
  void disk(float x, float y, float r) const { list.AddCircleFilled(at(x, y), r * unit, colour); }
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
    list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour);
  }
  void box(float x0, float y0, float x1, float y1, float rounding) const {
    list.AddRect(at(x0, y0), at(x1, y1), colour, rounding * unit, 0, width);
  }
  void arc(float x, float y, float r, float from, float to) const {
    list.PathArcTo(at(x, y), r * unit, from, to, 18);
    list.PathStroke(colour, 0, width);
  }
};

void draw_eye(const Pen& pen, bool open) {
  pen.arc(0, 0.75f, 1.15f, kPi * 1.22f, kPi * 1.78f);
  if (open) {
    pen.arc(0, -0.75f, 1.15f, kPi * 0.22f, kPi * 0.78f);
    pen.disk(0, 0, 0.28f);
  } else {
    pen.line(-0.8f, 0.8f, 0.8f, -0.8f);
  }
}

void draw_lock(const Pen& pen, bool closed) {
  pen.list.AddRectFilled(pen.at(-0.6f, -0.05f), pen.at(0.6f, 0.85f), pen.colour, 0.15f * pen.unit);
  const float x = closed ? 0.0f : 0.45f;
  pen.arc(x, -0.15f, 0.4f, kPi, 2 * kPi);
  pen.line(x - 0.4f, -0.2f, x - 0.4f, closed ? 0.0f : -0.05f);
  if (closed) pen.line(0.4f, -0.2f, 0.4f, 0);
}

void draw_star(const Pen& pen) {
  for (int i = 0; i < 5; ++i) {
    const float a = -kPi / 2 + static_cast<float>(i) * 0.8f * kPi;
    pen.list.PathLineTo(pen.at(0.95f * std::cos(a), 0.95f * std::sin(a)));
  }
  pen.list.PathStroke(pen.colour, ImDrawFlags_Closed, pen.width);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
  const Pen pen{list, centre, size / 2, colour, std::max(1.0f, 1.2f * theme().scale)};
  switch (icon) {
    case Icon::reset:
      pen.arc(0, 0.05f, 0.68f, -kPi * 0.72f, kPi * 0.85f);
      pen.triangle(ImVec2(-0.85f, -0.95f), ImVec2(-0.85f, -0.1f), ImVec2(-0.05f, -0.42f));
      break;
    case Icon::eye:
      draw_eye(pen, true);
      break;
    case Icon::eye_closed:
      draw_eye(pen, false);
      break;
    case Icon::lock:
      draw_lock(pen, true);
      break;
    case Icon::unlocked:
      draw_lock(pen, false);
      break;
    case Icon::solo:
      pen.circle(0, 0, 0.8f);
      pen.disk(0, 0, 0.4f);
      break;
    case Icon::mute:
      pen.circle(0, 0, 0.8f);
      pen.line(-0.55f, 0.55f, 0.55f, -0.55f);
      break;
    case Icon::close:
      pen.line(-0.5f, -0.5f, 0.5f, 0.5f);
      pen.line(-0.5f, 0.5f, 0.5f, -0.5f);
      break;
    case Icon::folder:
      pen.list.AddRectFilled(pen.at(-0.85f, -0.7f), pen.at(0, 0.1f), colour, 0.15f * pen.unit);
      pen.list.AddRectFilled(pen.at(-0.85f, -0.45f), pen.at(0.85f, 0.7f), colour, 0.15f * pen.unit);
      break;
    case Icon::file:
      pen.box(-0.6f, -0.85f, 0.6f, 0.85f, 0.1f);
      break;
    case Icon::check:
      pen.line(-0.65f, 0, -0.2f, 0.5f);
      pen.line(-0.2f, 0.5f, 0.65f, -0.55f);
      break;
    case Icon::warning:
      list.AddTriangle(pen.at(0, -0.8f), pen.at(0.9f, 0.8f), pen.at(-0.9f, 0.8f), colour, pen.width);
      pen.line(0, -0.3f, 0, 0.25f);
      pen.disk(0, 0.52f, 0.1f);
      break;
    case Icon::chevron:
      pen.line(-0.45f, -0.2f, 0, 0.3f);
      pen.line(0, 0.3f, 0.45f, -0.2f);
      break;
    case Icon::star:
      draw_star(pen);
      break;
  }
}

bool icon_button(const char* id, Icon icon, const char* tooltip, bool lit, ImU32 lit_colour) {
  const float size = px(18);
  const bool pressed = ImGui::InvisibleButton(id, ImVec2(size, size));
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  ImGui::RenderNavHighlight(ImRect(low, high), ImGui::GetItemID());
  ImU32 colour = lit ? (lit_colour != 0 ? lit_colour : theme().text) : theme().dim;
  if (hovered && !lit) colour = theme().text;
  draw_icon(*ImGui::GetWindowDrawList(), icon, ImVec2((low.x + high.x) / 2, (low.y + high.y) / 2), px(12),
            ImGui::GetColorU32(colour));
  hover_text(tooltip);
  return pressed;
}

}  // namespace vamp::ui
