#pragma once
// The presets as pictures: double-click one or drag it onto a part.
#include <string>

#include "editor/panels/context.h"

namespace vamp::ui {

// What a preset that is being dragged carries: its path, as text with a zero at the end.
inline constexpr const char* kPresetPayload = "vamp.preset";
std::filesystem::path preset_of_payload(const ImGuiPayload& payload);

class PresetsPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_menu(PanelContext& context, const LibraryEntry& entry);
  void draw_rename(PanelContext& context);
  void report(const PanelContext& context, const Status& status) const;

  std::string search_;
  std::filesystem::path renamed_;  // the preset whose name is being typed; empty: none
  std::string name_;
  bool rename_wanted_ = false;
};

}  // namespace vamp::ui
