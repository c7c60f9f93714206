#pragma once
// A grid of pictures with names, such as the presets.
#include <imgui.h>

#include <string>

namespace vamp::ui {

// Lays items out in as many columns as fit; use one for each grid and frame.
class ThumbnailGrid {
 public:
  // `size` of a picture at 96 dpi; the columns share the width that is left.
  explicit ThumbnailGrid(float size);

  struct Result {
    bool clicked = false;
    bool activated = false;  // double-click or Enter
    bool menu = false;       // right click
  };

  // One item. `picture` 0 shows a grey field. While it is dragged ImGui carries `payload` under `payload_type` (at most
  // 32 characters; null: it cannot be dragged). `note` is for the tooltip.
  Result item(const char* id, ImTextureID picture, const char* name, bool selected, const char* payload_type,
              const std::string& payload, const char* note);

  void end();

 private:
  float cell_ = 0;
  float spacing_ = 0;
  int columns_ = 1;
  int index_ = 0;
  ImVec2 origin_;
};

}  // namespace vamp::ui
