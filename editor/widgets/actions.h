#pragma once
// One registry of everything the user can do: it feeds the menu bar, the tool bar, shortcuts, the command palette and
// the shortcut sheet.
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vamp::ui {

// Key numbers are GLFW's: letters and digits are their ASCII codes.
struct Shortcut {
  int key = 0;  // 0: none
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  friend bool operator==(const Shortcut&, const Shortcut&) = default;
};

// "Ctrl+Shift+P", "F", "Delete", "F11"; CHECKs that the text names a key. Empty gives none.
Shortcut parse_shortcut(std::string_view text);

struct Action {
  std::string id;        // "file.open"
  std::string label;     // "Open…"
  std::string menu;      // "File" or "File/Export"; empty: only in the palette
  std::string shortcut;  // "Ctrl+O" or empty
  std::function<void()> run;
  std::function<bool()> enabled;  // empty: always
  std::function<bool()> checked;  // empty: not a switch
  std::string tooltip;
  int group = 0;                      // a separator stands between neighbours of different groups
  std::function<std::string()> text;  // in place of the label in menus and tooltips where it changes: "Undo Gloss"
};

class Actions {
 public:
  // CHECKs that identifier and shortcut are new.
  void add(Action action);

  // Further entries drawn at the end of a menu, such as the recent files.
  void add_menu_part(const std::string& menu, std::function<void()> draw);

  const Action* find(std::string_view id) const;
  bool is_enabled(const Action& action) const { return !action.enabled || action.enabled(); }

  // Runs it if it is enabled; returns whether it was. Used by scripts and tests too.
  bool run(std::string_view id);

  // Runs the action whose shortcut was pressed in this frame. Text fields keep the keys that they use; nothing happens
  // while a dialog is open or a value is being dragged.
  void handle_shortcuts();

  // The menus in the order of their first action; call between BeginMenuBar and EndMenuBar.
  void draw_menus();

  // A tool bar button: `label` (the action's own when empty), lit while checked.
  void tool(std::string_view id, const char* label = "");

  void open_palette() { palette_wanted_ = true; }
  void open_sheet() { sheet_wanted_ = true; }
  void draw_popups();  // the palette and the sheet, when open; once a frame, at the root of the identifiers

  // A line of the sheet about the mouse: "Turn the view", "right drag".
  void explain(std::string what, std::string how) { gestures_.emplace_back(std::move(what), std::move(how)); }

  // How well a text fits what was typed, 0 for not at all: letters in order, better at the starts of words.
  static int match(std::string_view typed, std::string_view text);

 private:
  void draw_menu(const std::string& path);
  void draw_item(const Action& action);
  void draw_palette();
  void draw_sheet();

  std::deque<Action> actions_;  // references stay valid
  std::vector<Shortcut> shortcuts_;
  std::map<std::string, std::vector<std::function<void()>>, std::less<>> parts_;
  std::vector<std::pair<std::string, std::string>> gestures_;
  std::string typed_;
  int chosen_ = 0;
  bool palette_wanted_ = false;
  bool sheet_wanted_ = false;
  bool popup_was_open_ = false;  // in the last frame
};

}  // namespace vamp::ui
