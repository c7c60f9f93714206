#pragma once
// The document and its file: opening, saving, what becomes of unsaved changes, autosave and recovery.
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "editor/model/autosave.h"
#include "editor/model/document.h"
#include "editor/model/recent.h"
#include "editor/widgets/file_dialog.h"
#include "editor/widgets/notify.h"
#include "engine/core/clock.h"
#include "engine/core/jobs.h"
#include "engine/core/text.h"

namespace vamp {

class DocumentFiles {
 public:
  DocumentFiles(Document& document, ui::FileDialog& dialog, ui::Question& question, JobQueue& jobs);

  // Before the window is shown: nothing is open yet. `reopen`: an empty path means what was open last.
  void start(const std::filesystem::path& file, bool reopen);

  // Each asks first what to do with unsaved changes.
  void new_document();
  void open();
  void open(const std::filesystem::path& path);
  // Runs `go_on` when nothing is lost by it: saved, discarded on request, or never changed.
  void when_settled(std::function<void()> go_on);

  void save(std::function<void()> then = {});
  void save_as(std::function<void()> then = {});

  // Offers the latest document that a crash left behind, then the next.
  void offer_recovery();

  // Whether a document is there: from the first successful load on.
  bool ready() const { return ready_; }
  bool loading() const { return loading_ != nullptr; }
  // Why there is no document; empty while it is loaded or there is one.
  const std::string& problem() const { return problem_; }
  // Is called when another document took the place of the old one; `fresh`: it is a model as it is, nobody's project.
  std::function<void(bool fresh)> replaced;

  // The name for the title, with a star where it is unsaved.
  std::string title() const;
  // "Saved 12 s ago", "Not saved yet", for the status bar.
  std::string saved_text() const;
  // Tells of a full disk. Once a frame.
  void tell_problems();

  RecentFiles& recent() { return recent_; }
  Autosave& autosave() { return autosave_; }

 private:
  void load(const std::filesystem::path& path);
  void when_settled_since(const ProjectPtr& before, const std::string& name, std::function<void()> go_on);
  void take_recovered(const Leftover& leftover, Project project);
  void take(Project project, const std::filesystem::path& document, bool fresh);
  void write(const std::filesystem::path& path, std::function<void()> then);
  void collect_then_write(const std::filesystem::path& path, std::function<void()> then);
  void recover_leftover(const Leftover& leftover);

  Document& document_;
  ui::FileDialog& dialog_;
  ui::Question& question_;
  JobQueue& jobs_;
  RecentFiles recent_;
  Autosave autosave_;
  std::vector<Leftover> leftovers_;
  std::shared_ptr<Progress> loading_;
  bool ready_ = false;
  std::string problem_;
  std::chrono::system_clock::time_point load_began_;
  std::optional<Clock::time_point> saved_at_, edited_at_;
};

// What can be opened as a document.
bool is_model(const std::filesystem::path& path);

}  // namespace vamp
