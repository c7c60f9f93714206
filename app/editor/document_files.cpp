#include "app/editor/document_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/files.h"
#include "engine/core/log.h"
#include "engine/project/default_project.h"
#include "engine/project/project_file.h"

namespace vamp {
namespace {

const std::vector<std::string> kDocuments{".vampproj", ".glb", ".gltf"};

std::string ago(std::chrono::steady_clock::duration past) {
  const auto s = std::chrono::duration_cast<std::chrono::seconds>(past).count();
  if (s < 60) return fmt::format("{} s ago", s);
  if (s < 3600) return fmt::format("{} min ago", s / 60);
  return fmt::format("{} h ago", s / 3600);
}

// Where the current folder is gone, a relative path has to do.
fs::path absolute_or_same(const fs::path& path) {
  std::error_code code;
  fs::path full = fs::absolute(path, code);
  return code ? path : full;
}

std::string names_of(const std::vector<fs::path>& files) {
  std::string names;
  for (size_t i = 0; i < files.size() && i < 4; ++i) names += "\n  " + files[i].filename().string();
  if (files.size() > 4) names += fmt::format("\n  and {} more", files.size() - 4);
  return names;
}

}  // namespace

bool is_model(const fs::path& path) {
  return std::find(kDocuments.begin(), kDocuments.end(), lower_extension(path)) != kDocuments.end();
}

DocumentFiles::DocumentFiles(Document& document, ui::FileDialog& dialog, ui::Question& question, JobQueue& jobs)
    : document_(document), dialog_(dialog), question_(question), jobs_(jobs) {
  document_.listen([this](const ProjectPtr&, const std::string&) {
    if (!ready_) return;
    if (document_.dirty() && !edited_at_) edited_at_ = Clock::now();
    autosave_.update(document_);
  });
}

void DocumentFiles::start(const fs::path& file, bool reopen) {
  fs::path path = file;
  if (path.empty() && reopen)
    for (const fs::path& last : recent_.list())
      if (RecentFiles::exists(last)) {
        path = last;
        break;
      }
  load(path);
}

void DocumentFiles::new_document() {
  when_settled([this] { load({}); });
}

void DocumentFiles::open() {
  ui::FileRequest request;
  request.title = "Open a model or project";
  request.extensions = kDocuments;
  const fs::path& here = document_.path().empty() ? document_.project()->model : document_.path();
  request.folder = here.parent_path();
  request.places = {shipped_dir("scenes")};
  request.done = [this](const fs::path& path) { open(path); };
  dialog_.open(std::move(request));
}

void DocumentFiles::open(const fs::path& path) {
  when_settled([this, path] { load(path); });
}

void DocumentFiles::when_settled(std::function<void()> go_on) {
  if (!ready_ || !document_.dirty()) return go_on();
  if (question_.open()) return;
  const std::string name = document_.path().empty() ? "The new project" : document_.path().filename().string();
  question_.ask("Unsaved changes", name + " has changes that are not saved.", {"Save", "Discard", "Cancel"},
                [this, go_on](size_t answer) {
                  if (answer == 0) save(go_on);
                  if (answer == 1) go_on();
                });
}

// What was asked before a document was loaded does not cover edits made while it was.
void DocumentFiles::when_settled_since(const ProjectPtr& before, const std::string& name, std::function<void()> go_on) {
  if (document_.project() == before) return go_on();
  if (ready_ && document_.dirty() && question_.open())
    return ui::notify(ui::Notice::warning, name + " was not opened: the document has changes that are not saved");
  when_settled(std::move(go_on));
}

// Loads on a worker. The document that is open stays until the other one is there and sound.
void DocumentFiles::load(const fs::path& path) {
  if (loading_) loading_->cancel();
  problem_.clear();
  load_began_ = std::chrono::system_clock::now();
  const std::string name = path.empty() ? "the default shoe" : path.filename().string();
  loading_ = jobs_.start(
      "Loading " + name,
      [path](Progress& progress) -> Result<Project> {
        progress.stage("reading");
        return path.empty() ? default_project() : open_scene(path);
      },
      [this, path, name, before = document_.project()](Result<Project> project) {
        if (project) {
          loading_ = nullptr;
          const auto loaded = std::make_shared<Project>(std::move(*project));
          return when_settled_since(before, name, [this, path, loaded] {
            const bool is_project = lower_extension(path) == ".vampproj";
            const fs::path full = path.empty() ? path : absolute_or_same(path);
            take(std::move(*loaded), is_project ? full : fs::path(), !is_project);
            if (path.empty()) return;
            if (const Status status = recent_.add(full); !status) spdlog::warn("{}", status.error().message());
          });
        }
        if (project.error().kind == ErrorKind::interrupted) return;
        loading_ = nullptr;
        problem_ = project.error().message();
        spdlog::error("{}", problem_);
        // Where nothing is open the window says so in the picture's place.
        if (ready_) ui::notify(ui::Notice::error, problem_);
      });
}

void DocumentFiles::take(Project project, const fs::path& document, bool fresh) {
  // Nothing is autosaved of the document that goes: it was saved or given up.
  ready_ = false;
  document_.reset(std::move(project), document);
  ready_ = true;
  problem_.clear();
  edited_at_ = saved_at_ = std::nullopt;
  autosave_.update(document_);
  if (replaced) replaced(fresh);
  // What is not quite as it was saved: the log alone is read by few.
  const std::vector<std::string> warnings = warnings_since(load_began_);
  if (warnings.empty()) return;
  const std::string others = warnings.size() == 1 ? "" : fmt::format("\n{} more in the Log panel", warnings.size() - 1);
  ui::notify(ui::Notice::warning, warnings.front() + others);
}

void DocumentFiles::save(std::function<void()> then) {
  if (!ready_) return;
  document_.commit_gesture();
  if (document_.path().empty()) return save_as(std::move(then));
  collect_then_write(document_.path(), std::move(then));
}

void DocumentFiles::save_as(std::function<void()> then) {
  if (!ready_) return;
  document_.commit_gesture();
  ui::FileRequest request;
  request.mode = ui::FileRequest::Mode::save;
  request.title = "Save the project";
  request.extensions = {".vampproj"};
  const fs::path& path = document_.path();
  if (!path.empty()) request.folder = path.parent_path();
  const fs::path stem = path.empty() ? document_.project()->model.stem() : path.stem();
  request.name = (stem.empty() ? "shoe" : stem.string()) + ".vampproj";
  request.done = [this, then](const fs::path& chosen) { collect_then_write(chosen, then); };
  dialog_.open(std::move(request));
}

// A project file names what it needs by relative paths, so what lies elsewhere is copied beside it, on request.
void DocumentFiles::collect_then_write(const fs::path& path, std::function<void()> then) {
  const std::vector<fs::path> outside = outside_files(*document_.project(), path);
  if (outside.empty()) return write(path, std::move(then));
  question_.ask(
      "Files outside of the project's folder",
      fmt::format("{} needs {} that {} elsewhere:{}\n\nA project can be moved and passed on only with its files "
                  "beside it.",
                  path.filename().string(), outside.size() == 1 ? "a file" : "files",
                  outside.size() == 1 ? "lies" : "lie", names_of(outside)),
      {"Copy them beside it", "Cancel"}, [this, path, then](size_t answer) {
        if (answer != 0) return;
        jobs_.start(
            "Copying files", [project = document_.project(), path](Progress&) { return collect_files(*project, path); },
            [this, path, then](Result<Project> collected) {
              if (!collected) return ui::notify(ui::Notice::error, collected.error().message());
              // The paths alone are taken: the designer may have gone on meanwhile.
              document_.edit("Copy files beside the project", "", [&](Project& now) {
                now.model = collected->model;
                now.environment.path = collected->environment.path;
                for (MaterialInstance& material : now.materials)
                  for (const MaterialInstance& copied : collected->materials)
                    if (material.fit == copied.fit) material.preset = copied.preset;
              });
              write(path, then);
            });
      });
}

void DocumentFiles::write(const fs::path& path, std::function<void()> then) {
  const Status saved = save_project(*document_.project(), path);
  if (!saved) return ui::notify(ui::Notice::error, saved.error().message());
  document_.mark_saved(absolute_or_same(path));
  saved_at_ = Clock::now();
  edited_at_ = std::nullopt;
  autosave_.update(document_);
  if (const Status status = recent_.add(document_.path()); !status) spdlog::warn("{}", status.error().message());
  ui::notify(ui::Notice::done, "Saved " + path.filename().string());
  if (then) then();
}

void DocumentFiles::offer_recovery() {
  if (leftovers_.empty()) leftovers_ = find_leftovers();
  if (leftovers_.empty() || question_.open()) return;
  const Leftover leftover = leftovers_.front();
  leftovers_.erase(leftovers_.begin());
  const auto next = [this] {
    if (!leftovers_.empty()) offer_recovery();
  };
  const std::string name = !leftover.document.empty() ? leftover.document.filename().string() : leftover.model;
  if (!leftover.problem.empty()) {
    spdlog::warn("{}", leftover.problem);
    // It may be of a newer version, or readable again tomorrow: it is the user's to throw away.
    ui::notify(ui::Notice::warning,
               "Unsaved work of an earlier session cannot be read and is left where it is: " + leftover.problem);
    return next();
  }
  const int64_t now =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
  question_.ask(
      "Recover unsaved work",
      fmt::format("Vamp did not end properly. Unsaved changes of {} were kept {}.", name.empty() ? "a project" : name,
                  ago(std::chrono::seconds(std::max<int64_t>(now - leftover.saved_at, 0)))),
      {"Recover", "Discard", "Ask again next time"}, [this, leftover, next](size_t answer) {
        if (answer == 0) return recover_leftover(leftover);
        if (answer == 1) discard(leftover);
        next();
      });
}

void DocumentFiles::recover_leftover(const Leftover& leftover) {
  if (loading_) loading_->cancel();
  problem_.clear();
  load_began_ = std::chrono::system_clock::now();
  loading_ = jobs_.start(
      "Recovering", [leftover](Progress&) { return recover(leftover); },
      [this, leftover, before = document_.project()](Result<Project> project) {
        loading_ = nullptr;
        if (!project) {
          problem_ = project.error().message();
          return ui::notify(ui::Notice::error, problem_);
        }
        const auto recovered = std::make_shared<Project>(std::move(*project));
        when_settled_since(before, "What was recovered",
                           [this, leftover, recovered] { take_recovered(leftover, std::move(*recovered)); });
      });
}

void DocumentFiles::take_recovered(const Leftover& leftover, Project project) {
  take(std::move(project), leftover.document, false);
  document_.mark_unsaved();
  edited_at_ = Clock::now();
  autosave_.update(document_);
  // The old autosave may only go when there is a new one.
  const Status kept = autosave_.flush();
  if (kept) {
    discard(leftover);
  } else {
    ui::notify(ui::Notice::warning, kept.error().message());
  }
  spdlog::info("recovered {}", leftover.file.string());
  ui::notify(ui::Notice::done, "Recovered; save it to keep it");
}

std::string DocumentFiles::title() const {
  if (!ready_) return loading_ ? "Loading…" : "Vamp";
  const Project& project = *document_.project();
  std::string name =
      !document_.path().empty() ? document_.path().filename().string() : project.model.filename().string();
  if (name.empty()) name = "untitled";
  return document_.dirty() ? name + "*" : name;
}

std::string DocumentFiles::saved_text() const {
  if (!ready_) return "";
  if (document_.dirty()) {
    // The autosave begins 2 s after the first unsaved edit, and may fail.
    if (autosave_.written() && edited_at_ && Clock::now() - *edited_at_ > std::chrono::seconds(4))
      return "Not saved · autosaved";
    return "Not saved";
  }
  if (saved_at_) return "Saved " + ago(Clock::now() - *saved_at_);
  return document_.path().empty() ? "New" : "Saved";
}

void DocumentFiles::tell_problems() {
  if (std::string problem = autosave_.take_problem(); !problem.empty())
    ui::notify(ui::Notice::warning, "Autosave failed: " + problem);
}

}  // namespace vamp
