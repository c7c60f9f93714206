#pragma once
// Draws the panels in the places of a DockLayout and lets the user drag splitters and tabs.
#include <imgui.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "editor/widgets/dock_layout.h"

namespace vamp::ui {

struct Panel {
  std::string id;     // stable, stored in layouts
  std::string title;  // on the tab
  std::function<void()> draw;
  std::string beside;    // whose tabs it joins when a stored layout does not know it
  bool central = false;  // takes the room that is left (the viewport); one panel; no tab, no padding, never closed
  bool hidden = false;   // not shown before it is asked for
};

class Dock {
 public:
  // `make_default` gives the arrangement of "Reset layout".
  explicit Dock(std::function<DockLayout()> make_default);

  void add(Panel panel);

  // Takes a stored layout; the default where the text is damaged (the error is returned so that it can be logged).
  Status restore(std::string_view text, std::string_view file);
  std::string store() const { return layout_.print(); }
  void reset();

  // Draws all panels into the rectangle, in the current window.
  void draw(ImVec2 low, ImVec2 high);

  bool visible(std::string_view panel) const { return layout_.visible(panel); }
  void show(const std::string& panel);  // opens it and brings its tab to the front
  void close(const std::string& panel);
  const std::vector<Panel>& panels() const { return panels_; }
  const std::string& focused() const { return focused_; }  // the panel with the keyboard, or empty

  // True once after the user or the program rearranged something: time to save.
  bool take_changed() { return std::exchange(changed_, false); }

 private:
  struct Drop {
    DockNode* leaf = nullptr;
    DockSide side = DockSide::middle;
    size_t index = 0;
  };
  const Panel* find(std::string_view id) const;
  const Panel* central_in(const DockNode& node) const;
  ImVec2 least(const DockNode& node) const;
  void draw_node(DockNode& node, ImVec2 low, ImVec2 high);
  void draw_split(DockNode& node, ImVec2 low, ImVec2 high);
  void draw_leaf(DockNode& leaf, ImVec2 low, ImVec2 high);
  float draw_tabs(DockNode& leaf, ImVec2 low, ImVec2 high);
  void aim(DockNode& leaf, ImVec2 low, ImVec2 high, float tabs_end);
  void finish_drag();
  void reconcile();

  std::function<DockLayout()> make_default_;
  DockLayout layout_;
  std::vector<Panel> panels_;
  std::string central_;
  std::string focused_;
  std::string dragged_;  // the panel whose tab is being dragged
  Drop drop_;
  std::vector<std::function<void()>> later_;  // what panels asked for while the tree was being drawn
  bool drawing_ = false;
  bool reconciled_ = false;
  bool changed_ = false;
};

}  // namespace vamp::ui
