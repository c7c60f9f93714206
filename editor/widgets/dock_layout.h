#pragma once
// Where the panels are: a tree of splits whose leaves hold tabs. Plain data, no drawing.
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace vamp::ui {

enum class DockSide { middle, left, right, top, bottom };

struct DockNode {
  enum class Kind { leaf, row, column } kind = Kind::leaf;  // row: side by side; column: one above the other

  // Splits. Where one child holds the central panel, the other keeps `pixels` (at 96 dpi) when the window is resized;
  // otherwise the first takes `fraction` of the room.
  float pixels = 260;
  float fraction = 0.5f;
  int collapsed = 0;  // 0: none, 1: the first child, 2: the second
  std::unique_ptr<DockNode> first;
  std::unique_ptr<DockNode> second;

  // Leaves.
  std::vector<std::string> tabs;  // panel identifiers
  size_t active = 0;

  bool is_leaf() const { return kind == Kind::leaf; }
  bool holds(std::string_view panel) const;
};

struct DockPlace {
  std::string panel;
  std::string beside;   // joins the tabs of this panel when a stored layout does not know it
  bool hidden = false;  // only on request
};

class DockLayout {
 public:
  DockLayout() : root_(std::make_unique<DockNode>()) {}
  explicit DockLayout(std::unique_ptr<DockNode> root) : root_(std::move(root)) {}

  static std::unique_ptr<DockNode> leaf(std::vector<std::string> tabs);
  static std::unique_ptr<DockNode> row(std::unique_ptr<DockNode> first, std::unique_ptr<DockNode> second, float pixels,
                                       float fraction = 0.5f);
  static std::unique_ptr<DockNode> column(std::unique_ptr<DockNode> first, std::unique_ptr<DockNode> second,
                                          float pixels, float fraction = 0.5f);

  // Text with a version; bad_input when it is damaged or from a later program. `file` is for the message.
  static Result<DockLayout> parse(std::string_view text, std::string_view file);
  std::string print() const;

  // Removes panels that the program no longer has and adds those that the layout has never seen, beside the named one.
  // Panels that the user closed stay closed.
  void reconcile(std::span<const DockPlace> places);

  DockNode& root() { return *root_; }
  const DockNode& root() const { return *root_; }
  DockNode* leaf_of(std::string_view panel);
  bool visible(std::string_view panel) const { return root_->holds(panel); }

  // Brings a panel's tab to the front, opening it where it was last or beside `beside`.
  void show(const std::string& panel, std::string_view beside);
  void close(std::string_view panel);

  // Moves a panel to the tabs of `target` at `index` (middle), or splits `target` and takes that side of it.
  void move(const std::string& panel, DockNode& target, DockSide side, size_t index);

 private:
  void remove(std::string_view panel);
  std::unique_ptr<DockNode> root_;
  std::vector<std::string> closed_;
};

}  // namespace vamp::ui
