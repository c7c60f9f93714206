#include "editor/widgets/file_dialog.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "editor/widgets/controls.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/notify.h"
#include "editor/widgets/theme.h"
#include "engine/core/text.h"

namespace vamp::ui {

namespace fs = std::filesystem;

namespace {

constexpr size_t kMostEntries = 20000;  // of a folder; more are not listed

fs::path home() {
  const char* folder = std::getenv("HOME");
  return folder != nullptr && *folder != 0 ? fs::path(folder) : fs::path("/");
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool fits(const std::string& name, const std::vector<std::string>& extensions) {
  const std::string low = lower(name);
  return extensions.empty() ||
         std::any_of(extensions.begin(), extensions.end(), [&](const std::string& e) { return low.ends_with(e); });
}

std::string size_text(uint64_t bytes) {
  char text[32];
  const double value = static_cast<double>(bytes);
  if (bytes < 1024) {
    ImFormatString(text, sizeof text, "%.0f B", value);
  } else if (bytes < 1024 * 1024) {
    ImFormatString(text, sizeof text, "%.0f KiB", value / 1024);
  } else {
    ImFormatString(text, sizeof text, "%.1f MiB", value / 1024 / 1024);
  }
  return text;
}

}  // namespace

std::string with_extension(const std::string& name, const std::vector<std::string>& extensions) {
  return name.empty() || fits(name, extensions) ? name : name + extensions.front();
}

void FileDialog::open(FileRequest request) {
  request_ = std::move(request);
  name_ = request_.name;
  open_ = true;
  focus_name_ = true;
  fs::path start = request_.folder;
  if (!is_folder(start)) start = recent_.empty() ? fs::path() : recent_.front();
  go(is_folder(start) ? start : home());
}

void FileDialog::go(const fs::path& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (error || !is_folder(real)) {
    problem_ = folder.string() + ": cannot be opened";
    return;
  }
  folder_ = real;
  list();
}

void FileDialog::list() {
  entries_.clear();
  problem_.clear();
  chosen_ = -1;
  confirm_ = false;
  std::error_code error;
  fs::directory_iterator at(folder_, fs::directory_options::skip_permission_denied, error);
  if (error) problem_ = folder_.string() + ": " + error.message();
  for (; !error && at != fs::directory_iterator() && entries_.size() < kMostEntries; at.increment(error)) {
    std::error_code ignored;
    Entry entry;
    entry.name = at->path().filename().string();
    entry.folder = at->is_directory(ignored);
    if (!hidden_ && entry.name.starts_with('.')) continue;
    if (!entry.folder && (request_.mode == FileRequest::Mode::folder || !fits(entry.name, request_.extensions))) {
      continue;
    }
    if (!entry.folder) entry.bytes = at->file_size(ignored);
    if (ignored) entry.bytes = 0;
    entries_.push_back(std::move(entry));
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
}

// The name as it stands: a folder is entered, a file is taken.
void FileDialog::accept() {
  if (name_.empty()) {
    if (request_.mode == FileRequest::Mode::folder) finish(folder_);
    return;
  }
  fs::path path = name_.starts_with("~/") ? home() / name_.substr(2) : fs::path(name_);
  path = folder_ / path;
  if (is_folder(path)) {
    name_.clear();
    go(path);
    return;
  }
  if (request_.mode == FileRequest::Mode::save) path = with_extension(path.string(), request_.extensions);
  std::error_code ignored;
  const bool exists = fs::exists(path, ignored);
  if (request_.mode == FileRequest::Mode::save) {
    if (!is_folder(path.parent_path())) {
      problem_ = path.parent_path().string() + ": no such folder";
    } else if (exists && !confirm_) {
      confirm_ = true;
    } else {
      finish(path);
    }
  } else if (request_.mode == FileRequest::Mode::open && exists) {
    finish(path);
  } else {
    problem_ = path.filename().string() + ": no such file here";
  }
}

void FileDialog::finish(const fs::path& path) {
  const fs::path folder = is_folder(path) ? path : path.parent_path();
  std::erase(recent_, folder);
  recent_.insert(recent_.begin(), folder);
  if (recent_.size() > 8) recent_.resize(8);
  open_ = false;
  const auto done = std::exchange(request_.done, nullptr);
  if (done) done(path);
}

void FileDialog::draw() {
  if (!open_) return;
  bool open = true;
  const std::string title = request_.title + "###file dialog";
  if (!begin_dialog(title.c_str(), open, 760)) {
    if (!open) open_ = false;
    return;
  }
  // Where we are, as buttons.
  fs::path target;
  if (ImGui::Button("Up")) target = folder_.parent_path();
  ImGui::SameLine();
  fs::path part;
  int index = 0;
  for (const fs::path& step : folder_) {
    part /= step;
    ImGui::PushID(index++);
    if (ImGui::GetContentRegionAvail().x > px(120) && ImGui::SmallButton(step.string().c_str())) target = part;
    ImGui::SameLine(0, px(2));
    ImGui::PopID();
  }
  ImGui::NewLine();
  if (!target.empty()) go(target);
  draw_places();
  ImGui::SameLine();
  draw_entries();
  draw_footer();
  handle_keys();
  if (!open) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  end_dialog();
}

void FileDialog::draw_places() {
  ImGui::BeginChild("places", ImVec2(px(150), px(330)), true);
  fs::path target;
  const auto place = [&](const char* label, const fs::path& path) {
    if (path.empty()) return;
    // The root and "folder/" have no file name.
    const std::string name = *label != 0 ? label : path.filename().empty() ? path.string() : path.filename().string();
    ImGui::PushID(path.c_str());
    if (ImGui::Selectable(name.c_str(), path == folder_)) target = path;
    ImGui::PopID();
  };
  place("Home", home());
  for (const fs::path& path : request_.places) place("", path);
  if (!recent_.empty()) {
    ImGui::TextDisabled("Recent");
    for (const fs::path& path : recent_) place("", path);
  }
  ImGui::EndChild();
  if (!target.empty()) go(target);
}

void FileDialog::draw_entries() {
  ImGui::BeginChild("entries", ImVec2(0, px(330)), true);
  fs::path target;
  bool take = false;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()), px(22));
  const bool scroll = std::exchange(scroll_, false) && chosen_ >= 0;
  if (scroll) ImGui::SetScrollY(px(22) * static_cast<float>(chosen_) - ImGui::GetWindowHeight() / 2);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Entry& entry = entries_[static_cast<size_t>(i)];
      ImGui::PushID(i);
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float width = ImGui::GetContentRegionAvail().x;
      if (ImGui::Selectable("##entry", i == chosen_, ImGuiSelectableFlags_AllowDoubleClick,
                            ImVec2(0, px(22) - ImGui::GetStyle().ItemSpacing.y))) {
        chosen_ = i;
        confirm_ = false;
        problem_.clear();
        if (!entry.folder || request_.mode == FileRequest::Mode::folder) name_ = entry.name;
        if (ImGui::IsMouseDoubleClicked(0)) {
          take = !entry.folder;
          if (entry.folder) target = folder_ / entry.name;
        }
      }
      ImDrawList& list = *ImGui::GetWindowDrawList();
      draw_icon(list, entry.folder ? Icon::folder : Icon::file, ImVec2(at.x + px(10), at.y + px(9)), px(12),
                entry.folder ? theme().accent_line : theme().dim);
      list.AddText(ImVec2(at.x + px(24), at.y + px(1)), theme().text, entry.name.c_str());
      if (!entry.folder) {
        const std::string size = size_text(entry.bytes);
        list.AddText(ImVec2(at.x + width - ImGui::CalcTextSize(size.c_str()).x - px(4), at.y + px(1)), theme().dim,
                     size.c_str());
      }
      ImGui::PopID();
    }
  }
  if (entries_.empty()) ImGui::TextDisabled("Nothing here that fits");
  ImGui::EndChild();
  if (!target.empty()) go(target);
  if (take) accept();
}

void FileDialog::draw_footer() {
  if (std::exchange(focus_name_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  const char* hint = request_.mode == FileRequest::Mode::folder ? "This folder, or a path" : "Name or path";
  if (ImGui::InputTextWithHint("##name", hint, &name_, ImGuiInputTextFlags_EnterReturnsTrue)) {
    accept();
    focus_name_ = open_;
  }
  if (ImGui::IsItemEdited()) {
    confirm_ = false;
    problem_.clear();
  }
  if (confirm_) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(theme().changed), "%s exists. Overwrite it?",
                       with_extension(fs::path(name_).filename().string(), request_.extensions).c_str());
  } else if (!problem_.empty()) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(theme().error), "%s", problem_.c_str());
  } else {
    std::string shown = request_.extensions.empty() ? "All files" : "";
    for (const std::string& e : request_.extensions) shown += (shown.empty() ? "*" : ", *") + e;
    ImGui::TextDisabled("%s", shown.c_str());
  }
  if (ImGui::Checkbox("Hidden files", &hidden_)) list();
  const char* verb = confirm_                                     ? "Overwrite"
                     : request_.mode == FileRequest::Mode::save   ? "Save"
                     : request_.mode == FileRequest::Mode::folder ? "Choose"
                                                                  : "Open";
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(186));
  if (primary_button(verb, px(90))) accept();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", ImVec2(px(90), px(28)))) open_ = false;
}

// Arrows work while the name is being typed: they choose in the list.
void FileDialog::handle_keys() {
  // Also out of the name's field, which would keep the first Esc for itself.
  if (ImGui::IsKeyPressedMap(ImGuiKey_Escape, false)) open_ = false;
  const int count = static_cast<int>(entries_.size());
  const int step = ImGui::IsKeyPressedMap(ImGuiKey_DownArrow) ? 1 : ImGui::IsKeyPressedMap(ImGuiKey_UpArrow) ? -1 : 0;
  if (step != 0 && count > 0) {
    chosen_ = std::clamp(chosen_ + step, 0, count - 1);
    name_ = entries_[static_cast<size_t>(chosen_)].name;
    confirm_ = false;
    scroll_ = true;
    // ImGui's field keeps its own copy of the text while it is being edited.
    if (ImGui::IsAnyItemActive()) ImGui::ClearActiveID();
    focus_name_ = true;
  }
  if (ImGui::IsKeyPressedMap(ImGuiKey_Backspace, false) && !ImGui::IsAnyItemActive()) go(folder_.parent_path());
}

}  // namespace vamp::ui
