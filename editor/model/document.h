#pragma once
// The open document: the current project, how it came to be (undo, redo), and whether it is saved. Projects are
// immutable values; every change makes a new one, so that the renderer, the autosave and the history hold theirs
// without locks. To be used from one thread.
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/project/project.h"

namespace vamp {

using ProjectPtr = std::shared_ptr<const Project>;

// A change with the name that the history and the renderer's "why it restarted" show.
struct Edit {
  std::string name;       // "Roughness of grain"
  std::string merge_key;  // equal for edits that may become one step; empty: never merged
  std::function<void(Project&)> change;
};

enum class Merge {
  never,      // a step of its own
  with_last,  // joins the last step if that has the same merge key: key presses, the mouse wheel
};

class Document {
 public:
  static constexpr size_t kMaxSteps = 500;
  // What the history's projects may take beside the tables that they share; older steps go first.
  static constexpr size_t kMaxHistoryBytes = size_t{256} << 20;

  explicit Document(Project project, std::filesystem::path path = {});

  const ProjectPtr& project() const { return current_; }
  uint64_t revision() const { return revision_; }  // grows with every change of project()

  // One step; or, while a gesture is open, a part of it. Returns whether anything changed: an edit that leaves the
  // project as it was makes no step and tells nobody.
  bool edit(const Edit& edit, Merge merge = Merge::never);
  bool edit(std::string name, std::string merge_key, std::function<void(Project&)> change, Merge merge = Merge::never);

  // A drag is one step, however many edits it takes: begin when the widget activates, edit() on every move, commit when
  // it is let go; cancel (Esc) puts back what was there. The step bears the name of the gesture's last edit. begin
  // commits a gesture that is still open; undo, redo and saving do so too.
  void begin_gesture();
  bool commit_gesture();  // whether there is a new step
  void cancel_gesture();
  bool in_gesture() const { return gesture_open_; }
  // The project as the gesture found it, for edits relative to it; project() when none is open.
  const ProjectPtr& gesture_start() const { return gesture_open_ ? states_[at_].project : current_; }

  // Where the camera stands is saved but is no step: one looks around between any two edits, and an undo that moved the
  // view would hide what it undid. Nor does it make the document unsaved. Kept views (Project::cameras) are steps.
  void set_camera(const Camera& camera);

  bool can_undo() const { return at_ > 0 || gesture_changed(); }
  bool can_redo() const { return !gesture_changed() && at_ + 1 < states_.size(); }
  std::string undo_name() const;  // of the step that undo would take back; empty when there is none
  std::string redo_name() const;
  bool undo();
  bool redo();

  // The history panel: names of the steps, oldest first; the first `steps_done()` of them are in force.
  std::vector<std::string> step_names() const;
  size_t steps_done() const { return at_; }
  void go_to_step(size_t steps_done);

  // A new document in place of the old one: no history, saved.
  void reset(Project project, std::filesystem::path path);

  // The file it was loaded from or last saved to; empty: none yet.
  const std::filesystem::path& path() const { return path_; }
  void set_path(std::filesystem::path path) { path_ = std::move(path); }
  // Whether it differs from what was last saved; undoing back to that makes it saved again.
  bool dirty() const;
  void mark_saved(std::filesystem::path path);
  // After a recovery: differs from any file, whatever is undone.
  void mark_unsaved() { saved_ = nullptr; }

  // Told after every change, with the name of the edit: "Undo roughness of grain".
  using Listener = std::function<void(const ProjectPtr&, const std::string& reason)>;
  void listen(Listener listener) { listeners_.push_back(std::move(listener)); }

 private:
  struct State {
    std::string name, merge_key;  // of the step that led here
    ProjectPtr project;
    size_t bytes = 0;
  };
  bool gesture_changed() const { return gesture_open_ && gesture_edited_; }
  void push(std::string name, std::string merge_key);
  void trim();
  void set_current(ProjectPtr project, const std::string& reason);
  void move_to(size_t index, const std::string& reason);

  // states_[at_] is the current state; while a gesture is open, what it started from. Their cameras are not read.
  std::deque<State> states_;
  size_t at_ = 0;
  size_t history_bytes_ = 0;
  ProjectPtr current_;
  ProjectPtr saved_;
  std::filesystem::path path_;
  uint64_t revision_ = 0;
  bool gesture_open_ = false, gesture_edited_ = false, mergeable_ = false;
  std::string gesture_name_;
  std::vector<Listener> listeners_;
};

}  // namespace vamp
