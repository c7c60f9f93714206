#pragma once
// The presets as pictures: double-click one or drag it onto a part, which shows it as it was saved. Materials that were
// edited in the document stand above them, to be put on further parts with their edits.
#include <string>
#include <vector>

#include "editor/panels/context.h"

namespace vamp::ui {

class PresetsPanel {
 public:
  void draw(PanelContext& context);

 private:
  bool draw_edited(PanelContext& context);  // whether there are any
  void draw_edited_menu(PanelContext& context);
  void draw_presets(PanelContext& context, const std::vector<const LibraryEntry*>& presets);
  void draw_menu(PanelContext& context, const LibraryEntry& entry);
  void draw_rename(PanelContext& context);
  void report(const PanelContext& context, const Status& status) const;

  std::string search_, tag_;
  bool edited_open_ = true, own_open_ = true, shipped_open_ = true;
  std::string edited_;                  // the material whose menu is open, by name
  const LibraryEntry* menu_ = nullptr;  // asked for in this frame
  std::filesystem::path renamed_;       // the preset whose name is being typed; empty: none
  std::string name_;
  bool rename_wanted_ = false;
};

}  // namespace vamp::ui
