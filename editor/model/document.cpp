#include "editor/model/document.h"

#include <utility>

#include "engine/core/check.h"

namespace vamp {
namespace {

// Whether two projects are the same but for where the camera stands.
bool same_but_camera(const Project& a, const Project& b) {
  if (a.camera == b.camera) return a == b;
  Project moved = b;
  moved.camera = a.camera;
  return a == moved;
}

// What a project takes beside shared tables: nearly all of it is rows of edit layers.
size_t approximate_bytes(const Project& project) {
  constexpr size_t kMapNode = 48;  // a red-black tree's links and the allocator's header
  size_t bytes = sizeof(Project) + project.parts.size() * sizeof(PartState) + project.lights.size() * sizeof(Light) +
                 project.cameras.size() * sizeof(NamedCamera);
  for (const MaterialInstance& material : project.materials)
    bytes += sizeof(material) + material.edits.bases.size() * (sizeof(BasisKey) + sizeof(BasisEdit) + kMapNode) +
             material.edits.cluster_names.size() * (sizeof(std::string) + kMapNode);
  return bytes;
}

}  // namespace

Document::Document(Project project, std::filesystem::path path) { reset(std::move(project), std::move(path)); }

void Document::reset(Project project, std::filesystem::path path) {
  CHECK(project.scene != nullptr);
  gesture_open_ = gesture_edited_ = mergeable_ = false;
  states_.clear();
  at_ = 0;
  auto opened = std::make_shared<const Project>(std::move(project));
  history_bytes_ = approximate_bytes(*opened);
  states_.push_back({"Open", "", opened, history_bytes_});
  saved_ = opened;
  path_ = std::move(path);
  set_current(std::move(opened), "Open");
}

bool Document::edit(std::string name, std::string merge_key, std::function<void(Project&)> change, Merge merge) {
  return edit(Edit{std::move(name), std::move(merge_key), std::move(change)}, merge);
}

bool Document::edit(const Edit& edit, Merge merge) {
  Project next = *current_;
  edit.change(next);
  CHECK(next.scene != nullptr);
  if (next == *current_) return false;
  if (same_but_camera(*current_, next)) {
    set_camera(next.camera);
    return true;
  }
  set_current(std::make_shared<const Project>(std::move(next)), edit.name);
  if (gesture_open_) {
    gesture_edited_ = true;
    gesture_name_ = edit.name;
    return true;
  }
  const State& last = states_[at_];
  const bool joins = merge == Merge::with_last && mergeable_ && at_ + 1 == states_.size() && !edit.merge_key.empty() &&
                     last.merge_key == edit.merge_key;
  if (joins) {
    // The step now leads from where it began to here; leading nowhere, it goes.
    history_bytes_ -= last.bytes;
    states_.pop_back();
    --at_;
    if (same_but_camera(*states_[at_].project, *current_)) {
      mergeable_ = false;
      return true;
    }
  }
  push(edit.name, edit.merge_key);
  mergeable_ = true;
  return true;
}

void Document::begin_gesture() {
  commit_gesture();
  gesture_open_ = true;
  gesture_edited_ = false;
  gesture_name_.clear();
}

bool Document::commit_gesture() {
  const bool step = gesture_changed() && !same_but_camera(*current_, *states_[at_].project);
  gesture_open_ = gesture_edited_ = false;
  if (step) push(std::move(gesture_name_), "");
  return step;
}

void Document::cancel_gesture() {
  if (gesture_changed()) move_to(at_, "Cancel " + gesture_name_);
  gesture_open_ = gesture_edited_ = false;
}

void Document::set_camera(const Camera& camera) {
  if (camera == current_->camera) return;
  Project next = *current_;
  next.camera = camera;
  set_current(std::make_shared<const Project>(std::move(next)), "Camera");
}

std::string Document::undo_name() const {
  if (gesture_changed()) return gesture_name_;
  return at_ > 0 ? states_[at_].name : std::string();
}

std::string Document::redo_name() const { return can_redo() ? states_[at_ + 1].name : std::string(); }

bool Document::undo() {
  commit_gesture();
  if (at_ == 0) return false;
  const std::string reason = "Undo " + states_[at_].name;
  move_to(at_ - 1, reason);
  return true;
}

bool Document::redo() {
  commit_gesture();
  if (at_ + 1 >= states_.size()) return false;
  move_to(at_ + 1, "Redo " + states_[at_ + 1].name);
  return true;
}

std::vector<std::string> Document::step_names() const {
  std::vector<std::string> names;
  for (size_t i = 1; i < states_.size(); ++i) names.push_back(states_[i].name);
  return names;
}

void Document::go_to_step(size_t steps_done) {
  commit_gesture();
  if (steps_done >= states_.size() || steps_done == at_) return;
  move_to(steps_done, "Back to " + states_[steps_done].name);
}

bool Document::dirty() const { return saved_ == nullptr || !same_but_camera(*saved_, *current_); }

void Document::mark_saved(std::filesystem::path path) {
  commit_gesture();
  saved_ = current_;
  path_ = std::move(path);
  mergeable_ = false;
}

void Document::push(std::string name, std::string merge_key) {
  while (states_.size() > at_ + 1) {
    history_bytes_ -= states_.back().bytes;
    states_.pop_back();
  }
  const size_t bytes = approximate_bytes(*current_);
  states_.push_back({std::move(name), std::move(merge_key), current_, bytes});
  history_bytes_ += bytes;
  ++at_;
  trim();
}

void Document::trim() {
  while (states_.size() > 2 && (states_.size() > kMaxSteps + 1 || history_bytes_ > kMaxHistoryBytes)) {
    history_bytes_ -= states_.front().bytes;
    states_.pop_front();
    --at_;
  }
}

void Document::set_current(ProjectPtr project, const std::string& reason) {
  current_ = std::move(project);
  ++revision_;
  for (const Listener& listener : listeners_) listener(current_, reason);
}

void Document::move_to(size_t index, const std::string& reason) {
  at_ = index;
  mergeable_ = false;
  ProjectPtr target = states_[index].project;
  if (target->camera != current_->camera) {
    Project seen = *target;
    seen.camera = current_->camera;
    target = std::make_shared<const Project>(std::move(seen));
  }
  set_current(std::move(target), reason);
}

}  // namespace vamp
