#pragma once
// The editor while its window is open: the document with everything that follows it, what the menus do, what is drawn.
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/document_files.h"
#include "app/editor/options.h"
#include "app/editor/preset_dialog.h"
#include "app/editor/snapshot_dialog.h"
#include "app/editor/teller.h"
#include "app/editor/thumbnails.h"
#include "app/editor/viewport_picture.h"
#include "app/window/window.h"
#include "editor/model/settings.h"
#include "editor/panels/panels.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/dock.h"
#include "editor/widgets/shell.h"
#include "engine/core/clock.h"
#include "engine/core/error.h"

namespace vamp {

class Editor {
 public:
  Editor(gpu::Device& device, window::Window& window, window::Textures& textures, Settings settings,
         const EditorOptions& options);
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  // The window's hooks.
  void frame();
  void shown();
  double wake_after() const;
  void close_wanted();
  void dropped(const std::vector<std::string>& paths);

  // After the window's loop, at a clean end: what --record-exit asked for; settings.
  Status finish();
  // The machine failed: the document is put aside for the next start.
  void abandon();

 private:
  // editor_actions.cpp, editor_view_actions.cpp: the registry.
  void add_actions();
  void add_file_actions();
  void add_edit_actions();
  void add_selection_actions();
  void add_material_actions();
  void add_light_actions();
  void add_view_actions();
  void add_render_actions();
  void explain_the_mouse();
  void draw_recent_files();

  // editor_tasks.cpp: what actions and panels ask for.
  void assign_preset_file(const std::filesystem::path& path, int part);
  void put_on_part(const Preset& preset, const std::filesystem::path& path, int part);
  void become_preset(const SavedPreset& saved);
  void load_environment(const std::filesystem::path& path);
  void choose_preset_file();
  void choose_environment();
  void step_part(int by);
  void step_cluster(int by);
  void set_ui_scale(float scale);
  void save_settings_now();
  Status record_exit();

  // editor_bars.cpp: what stands around the panels.
  void draw_tools();
  void draw_tools_right();
  std::vector<ui::StatusItem> status_left() const;
  std::vector<ui::StatusItem> status_right() const;
  void draw_job_cards();
  void draw_about();

  void connect_context();
  void take_document(bool fresh);
  void prepare_device();
  void start_renderer();
  void update_renderer();
  void measure_frames();
  void lose_device_for_test();
  void restart_renderer();
  void ask_about_lost_device();
  void tell_time(const char* what) const;  // since the start, in the log
  const Project& project() const { return *document_.project(); }

  gpu::Device& device_;
  window::Window& window_;
  window::Textures& textures_;
  EditorOptions options_;
  Settings settings_;

  // The queues stand before what their results reach; ~Editor ends them first of all.
  JobQueue documents_, exports_;
  Document document_;
  Selection selection_;
  PresetLibrary presets_;
  ui::Actions actions_;
  ui::Dock dock_;
  ui::Question question_;
  ui::FileDialog dialog_;
  DocumentFiles files_;
  Thumbnails thumbnails_;
  SnapshotDialog snapshot_;
  PresetDialog preset_dialog_;
  ViewportPicture picture_;
  ui::PanelContext context_;
  ui::Panels panels_;
  std::future<Result<std::unique_ptr<gpu::Device>>> coming_device_;  // until it is here
  std::unique_ptr<gpu::Device> render_device_;
  std::unique_ptr<RenderSession> session_;

  std::optional<Teller> teller_;  // --tell

  int viewport_width_ = 0, viewport_height_ = 0;
  bool about_ = false;
  std::string title_, told_error_;
  bool told_first_picture_ = false;
  Status lost_;  // what the renderer lost its device by; fine as long as it has one

  // --frames
  std::vector<double> frame_ms_, build_ms_, draw_ms_, present_ms_;
  Clock::time_point last_frame_{};
};

}  // namespace vamp
