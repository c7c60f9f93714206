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

  struct Item {
    const char* id;
    ImTextureID picture = nullptr;  // null shows the ground alone
    const char* name;               // over up to three lines
    const char* note = "";          // for the tooltip, below the whole name
    bool selected = false;
    bool changed = false;  // an amber dot: it is not what it was saved as
    // While it is dragged ImGui carries `payload` under this type (at most 32 characters); null: it cannot be dragged.
    const char* payload_type = nullptr;
    std::string payload;
  };
  Result item(const Item& item);

  void end();

 private:
  float caption(const char* name, ImVec2 low, bool selected) const;

  float cell_ = 0;
  float spacing_ = 0;
  int columns_ = 1;
  int column_ = 0;
  ImVec2 origin_;
  float top_ = 0, bottom_ = 0;  // of the line of items that is being drawn
};

}  // namespace vamp::ui
