#include "app/editor/editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "app/editor/background_device.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/edit.h"
#include "editor/widgets/notify.h"
#include "editor/widgets/theme.h"
#include "engine/core/clock.h"
#include "engine/core/files.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/render/trace_path.h"

namespace vamp {
namespace {

// What stands in the document before the first model is there.
Project empty_project() {
  Project project;
  project.scene = std::make_shared<const Scene>();
  return project;
}

}  // namespace

Editor::Editor(gpu::Device& device, window::Window& window, window::Textures& textures, Settings settings,
               const EditorOptions& options)
    : device_(device),
      window_(window),
      textures_(textures),
      options_(options),
      settings_(std::move(settings)),
      documents_(1, [&window] { window.wake(); }),
      exports_(1, [&window] { window.wake(); }),
      document_(empty_project()),
      dock_(ui::default_layout),
      files_(document_, dialog_, question_, documents_),
      thumbnails_(textures, [&window] { window.wake(); }),
      snapshot_(device, dialog_, exports_),
      preset_dialog_(device, presets_, documents_),
      picture_(textures),
      context_{document_, selection_, presets_} {
  document_.listen([this](const ProjectPtr& now, const std::string& reason) {
    selection_ = valid_selection(*now, selection_);
    if (session_) session_->set_project(now, reason);
  });
  files_.replaced = [this](bool fresh) { take_document(fresh); };
  preset_dialog_.saved = [this](const SavedPreset& saved) { become_preset(saved); };
  snapshot_.busy = [this](bool running) {
    if (session_) session_->pause(running || context_.paused);
  };
  if (options_.tell) teller_.emplace();
  prepare_device();
  connect_context();
  ui::add_panels(dock_, panels_, context_);
  add_actions();
  if (!settings_.layout.empty())
    if (const Status status = dock_.restore(settings_.layout, "settings"); !status)
      spdlog::warn("{}", status.error().message());
  if (!settings_.last_folder.empty()) dialog_.set_recent({settings_.last_folder});
  presets_.rescan();
  files_.start(options_.file, settings_.reopen_last && !options_.safe_mode);
  files_.offer_recovery();
}

Editor::~Editor() {
  documents_.cancel_all();
  exports_.cancel_all();
}

void Editor::connect_context() {
  context_.pick = [this](float x, float y) { return session_ ? session_->pick(x, y) : Pick{}; };
  context_.resize_viewport = [this](int width, int height) {
    viewport_width_ = std::max(width, 1);
    viewport_height_ = std::max(height, 1);
    if (session_) session_->resize(viewport_width_, viewport_height_);
  };
  context_.thumbnail = [this](const PresetInfo& preset) { return thumbnails_.find(preset); };
  context_.assign_preset = [this](const fs::path& path, int part) { assign_preset_file(path, part); };
  context_.save_preset_as = [this](int material) { preset_dialog_.open(project(), material); };
  context_.choose_environment = [this] { choose_environment(); };
  context_.recent_files = [this] {
    std::vector<fs::path> there;
    for (const fs::path& path : files_.recent().list())
      if (RecentFiles::exists(path)) there.push_back(path);
    return there;
  };
  context_.open_file = [this](const fs::path& path) { files_.open(path); };
  context_.run = [this](const std::string& action) { actions_.run(action); };
  context_.report = [](const std::string& line) { ui::notify(ui::Notice::error, line); };
}

// Another document is open: nothing of the old one is selected, its picture goes.
void Editor::take_document(bool fresh) {
  tell_time("document loaded");
  if (fresh && viewport_width_ > 0) ui::fit_opened(context_);
  context_.opened_camera = project().camera;
  selection_ = {};
  context_.hover = {};
  picture_.clear();
  if (session_) session_->set_project(document_.project(), "Opened " + files_.title());
}

// What is measured at the first start takes longer than a frame.
void Editor::prepare_device() {
  coming_device_ = std::async(std::launch::async, [this] {
    auto device = background_device(device_);
    if (device) tune_trace_paths(**device);
    return device;
  });
}

void Editor::start_renderer() {
  if (session_ || !files_.ready() || viewport_width_ == 0) return;
  if (!render_device_) {
    if (coming_device_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    auto device = coming_device_.get();
    if (!device) throw MachineError(device.error().kind, device.error().message());
    render_device_ = std::move(*device);
  }
  const uint64_t memory =
      options_.edit_memory < 0 ? RenderSession::kAutomaticMemory : static_cast<uint64_t>(options_.edit_memory) << 20;
  session_ =
      std::make_unique<RenderSession>(*render_device_, document_.project(), viewport_width_, viewport_height_, memory);
  session_->when_answered([this] { window_.show_soon(); });
  session_->pause(context_.paused || snapshot_.running());
  context_.session = session_.get();
}

void Editor::tell_time(const char* what) const {
  spdlog::debug("{} after {:.2f} s", what, seconds_since(options_.started));
}

void Editor::update_renderer() {
  start_renderer();
  if (!session_) return;
  context_.status = session_->status();
  session_->set_weights_at_hand(std::exchange(context_.weights_at_hand, {}));
  // A cluster is tinted for those who look for it; while a value is dragged nothing lies over the colour that changes.
  const bool tint = context_.show_cluster && !ui::edit_is_open();
  const Outlined selected{selection_.part, tint ? selection_.cluster : -1};
  if (picture_.version() == 0 && session_->picture_version() > 0) tell_time("first tile");
  picture_.update(*session_, context_.show_outlines ? selected : Outlined{},
                  context_.show_outlines ? Outlined{context_.hover.part, -1} : Outlined{}, context_.show_restarted);
  context_.viewport = picture_.textures();
  if (!told_first_picture_ && context_.status.samples > 0) {
    told_first_picture_ = true;
    tell_time("first whole sample");
  }
  if (told_first_picture_ && document_.can_undo()) lose_device_for_test();
  if (context_.status.error == told_error_) return;
  told_error_ = context_.status.error;
  if (context_.status.lost) {
    lost_ = fail(ErrorKind::device_lost, "", "", told_error_ + "; unsaved changes are offered at the next start");
    // Whatever becomes of the machine now.
    if (const Status kept = files_.autosave().flush(); !kept) ui::notify(ui::Notice::warning, kept.error().message());
  } else if (!told_error_.empty()) {
    ui::notify(ui::Notice::error, "The renderer stopped: " + told_error_);
  }
}

// Asked until there is an answer: another question may be open when the device goes.
void Editor::ask_about_lost_device() {
  if (lost_ || question_.open() || !session_) return;
  question_.ask("The renderer lost its device",
                told_error_ + ".\n\nThe document is whole, and what is not saved is kept for the next start.",
                {"Start the renderer anew", "Quit", "Go on without a picture"}, [this](size_t answer) {
                  if (answer == 0) restart_renderer();
                  if (answer == 1) {
                    // As after a crash: the program ends with an error, and the next start offers the document.
                    files_.autosave().abandon();
                    window_.quit();
                  } else {
                    lost_ = {};
                  }
                });
}

void Editor::restart_renderer() {
  context_.session = nullptr;
  session_ = nullptr;
  render_device_ = nullptr;  // perhaps it was lost
  prepare_device();
  picture_.clear();
  told_error_.clear();
  lost_ = {};
}

void Editor::lose_device_for_test() {
  const std::string what = std::exchange(options_.lose_device, "");
  if (what == "renderer") session_->lose_device();
  if (what == "window") throw MachineError(ErrorKind::device_lost, "the device was lost on request");
}

void Editor::frame() {
  if (options_.interrupted && options_.interrupted()) {
    files_.autosave().abandon();
    window_.quit();
  }
  documents_.deliver();
  exports_.deliver();
  thumbnails_.deliver();
  files_.tell_problems();
  update_renderer();
  context_.problem = files_.ready() || files_.loading() ? "" : files_.problem();

  ui::ShellContent content;
  content.title = files_.title();
  content.tools = [this] { draw_tools(); };
  content.tools_right = [this] { draw_tools_right(); };
  content.status_left = status_left();
  content.status_right = status_right();
  ui::draw_shell(actions_, dock_, content);
  draw_job_cards();
  draw_about();
  snapshot_.draw();
  preset_dialog_.draw();
  dialog_.draw();
  ask_about_lost_device();
  question_.draw();
  if (ui::take_abandoned_edit()) document_.commit_gesture();

  if (content.title != title_) {
    title_ = content.title;
    window_.set_title(title_ == "Vamp" ? title_ : title_ + " — Vamp");
  }
  if (dock_.take_changed()) {
    settings_.layout = dock_.store();
    save_settings_now();
  }
  measure_frames();
  if (teller_) teller_->tell(context_);
  if (ImGui::GetFrameCount() <= 2) tell_time("frame of the window");
}

void Editor::shown() {
  if (session_) session_->picture_shown(picture_.version());
}

double Editor::wake_after() const {
  if (options_.frames > 0 && told_first_picture_) return 0;
  double wait = ui::take_frame_request();
  // Something refines: often while it visibly changes, less often later, so that the machine renders instead.
  const bool refining = session_ && !context_.paused && !context_.status.finished && context_.status.error.empty();
  if (refining) wait = std::min(wait, context_.status.samples < 16 ? 0.033 : 0.1);
  if (coming_device_.valid()) wait = std::min(wait, 0.02);
  if (!documents_.empty() || !exports_.empty()) wait = std::min(wait, 0.1);
  // "Saved 12 s ago" goes on, signals are noticed.
  return std::min(wait, 0.5);
}

void Editor::close_wanted() {
  const bool snapshot = snapshot_.running();
  if (!snapshot && preset_dialog_.saving() == 0) return files_.when_settled([this] { window_.quit(); });
  if (question_.open()) return;
  question_.ask(
      "Still being written",
      std::string(snapshot ? "A snapshot" : "A preset") + " is still being made; it is lost if Vamp ends now.",
      {"Wait", "Quit anyway", "Cancel"}, [this](size_t answer) {
        if (answer == 1) files_.when_settled([this] { window_.quit(); });
      });
}

void Editor::dropped(const std::vector<std::string>& paths) {
  for (const std::string& text : paths) {
    const fs::path path(text);
    const std::string extension = lower_extension(path);
    std::error_code code;
    if (is_model(path)) {
      files_.open(path);
    } else if (extension == ".hdr" || extension == ".exr") {
      load_environment(path);
    } else if (extension == ".vamp" || fs::exists(path / "material.json", code)) {
      // Onto what the mouse is over, else onto what is selected.
      const int part = context_.hover.part >= 0 ? context_.hover.part : selection_.part;
      if (part < 0) {
        ui::notify(ui::Notice::warning, "Drop a preset onto a part, or select the part first");
      } else {
        assign_preset_file(path, part);
      }
    } else {
      ui::notify(ui::Notice::warning, path.filename().string() +
                                          ": expected a model (.glb, .gltf), a project (.vampproj), a preset (.vamp) "
                                          "or an environment (.hdr, .exr)");
    }
  }
}

void Editor::abandon() { files_.autosave().abandon(); }

Status Editor::finish() {
  VAMP_CHECK_STATUS(lost_);
  const Status recorded = record_exit();
  if (!options_.safe_mode) {
    settings_.layout = dock_.store();
    save_settings_now();
  }
  return recorded;
}

// Prints what a number of frames took, as one line of JSON, and ends: how fluent the window is while the renderer
// works.
void Editor::measure_frames() {
  if (options_.frames <= 0 || !told_first_picture_) return;
  const auto now = Clock::now();
  const window::FrameTimes& times = window_.times();
  if (last_frame_ != Clock::time_point{}) {
    frame_ms_.push_back(1e3 * std::chrono::duration<double>(now - last_frame_).count());
    build_ms_.push_back(times.build_ms);
    draw_ms_.push_back(times.draw_ms);
    present_ms_.push_back(times.present_ms);
  }
  last_frame_ = now;
  if (frame_ms_.size() < static_cast<size_t>(options_.frames)) return;
  const auto at = [](std::vector<double>& values, double fraction) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(fraction * static_cast<double>(values.size() - 1))];
  };
  double total = 0;
  for (const double ms : frame_ms_) total += ms;
  fmt::print(
      "{{\"frames\": {}, \"frames_per_s\": {:.1f}, \"frame_ms\": {:.2f}, \"frame_ms_95\": {:.2f}, \"frame_ms_max\": "
      "{:.2f}, \"build_ms\": {:.2f}, \"draw_ms\": {:.2f}, \"present_ms\": {:.2f}, \"samples\": {}, \"ms_per_sample\": "
      "{:.1f}, \"device\": \"{}\"}}\n",
      frame_ms_.size(), 1e3 * static_cast<double>(frame_ms_.size()) / total, at(frame_ms_, 0.5), at(frame_ms_, 0.95),
      at(frame_ms_, 1), at(build_ms_, 0.5), at(draw_ms_, 0.5), at(present_ms_, 0.5), context_.status.samples,
      context_.status.ms_per_sample, context_.status.device);
  std::fflush(stdout);
  window_.quit();
}

}  // namespace vamp
