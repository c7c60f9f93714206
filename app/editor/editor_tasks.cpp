// What actions and panels ask for.
#include <algorithm>
#include <thread>

#include "app/editor/editor.h"
#include "editor/model/edits_material.h"
#include "editor/model/edits_scene.h"
#include "editor/widgets/notify.h"
#include "engine/core/files.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/project/project_file.h"
#include "engine/render/snapshot.h"

namespace vamp {

void Editor::assign_preset_file(const fs::path& path, int part) {
  const size_t index = static_cast<size_t>(part);
  if (part < 0 || index >= project().parts.size()) return;
  documents_.start(
      "Loading " + path.filename().string(), [path](Progress&) { return load_preset(path); },
      [this, path, name = project().parts[index].name](Result<Preset> preset) {
        if (!preset) return ui::notify(ui::Notice::error, preset.error().message());
        // By its name: another document may be open by now.
        const int still = find_part(project(), name);
        if (still >= 0) put_on_part(*preset, path, still);
      });
}

// As it was saved. Who meant what was made of it in this document takes that with one more click.
void Editor::put_on_part(const Preset& preset, const fs::path& path, int part) {
  const ProjectPtr before = document_.project();
  document_.edit(put_preset(*before, part, std::make_shared<const Preset>(preset), path.string()));
  selection_ = select_part(project(), part);
  const MaterialInstance& now = project().materials[static_cast<size_t>(selection_.material)];
  // The part's own if it was one, else the first.
  const MaterialInstance* edited = nullptr;
  for (size_t i = 0; i < before->materials.size(); ++i) {
    const MaterialInstance& other = before->materials[i];
    if (other.preset != now.preset || other.checksum != now.checksum || other.edits == now.edits) continue;
    const bool own = before->parts[static_cast<size_t>(part)].material == static_cast<int>(i);
    if (edited == nullptr || own) edited = &other;
  }
  if (edited == nullptr) return;
  const std::string& name = before->parts[static_cast<size_t>(part)].name;
  ui::notify(ui::Notice::info,
             preset.name + " is on " + name + " as it was saved. There is an edited one in this project.",
             "Use the edited one", [this, name, edited = *edited] {
               const int still = find_part(project(), name);
               if (still < 0) return;
               Edit again = paste_material(project(), still, edited);
               again.name = edited.name + " (edited) on " + name;
               document_.edit(again);
               selection_ = select_part(project(), still);
             });
}

// The material that was saved, if it is still there: from now on it goes by its new name.
void Editor::become_preset(const SavedPreset& saved) {
  const std::vector<MaterialInstance>& materials = project().materials;
  for (size_t i = 0; i < materials.size(); ++i)
    if (materials[i].name == saved.material && materials[i].fit == saved.fit) {
      document_.edit(vamp::become_preset(project(), static_cast<int>(i), saved.preset, saved.path.string()));
      return;
    }
}

void Editor::choose_preset_file() {
  ui::FileRequest request;
  request.title = "Put a preset on the part";
  request.extensions = {".vamp"};
  request.places = {presets_.own_folder(), shipped_dir("presets")};
  request.done = [this](const fs::path& path) { assign_preset_file(path, selection_.part); };
  dialog_.open(std::move(request));
}

void Editor::choose_environment() {
  ui::FileRequest request;
  request.title = "Import environment";
  request.extensions = {".hdr", ".exr"};
  request.done = [this](const fs::path& path) { load_environment(path); };
  dialog_.open(std::move(request));
}

void Editor::load_environment(const fs::path& path) {
  if (!files_.ready()) return;
  documents_.start(
      "Loading " + path.filename().string(),
      [path, before = document_.project()](Progress&) -> Result<EnvironmentState> {
        Project copy = *before;
        VAMP_CHECK_STATUS(assign_environment(copy, path.string()));
        return copy.environment;
      },
      [this](Result<EnvironmentState> environment) {
        if (!environment) return ui::notify(ui::Notice::error, environment.error().message());
        document_.edit(set_environment(project(), std::move(*environment)));
      });
}

void Editor::step_part(int by) {
  const int count = static_cast<int>(project().parts.size());
  if (count == 0) return;
  const int from = selection_.part < 0 ? (by > 0 ? -1 : count) : selection_.part;
  selection_ = select_part(project(), (from + by + count) % count);
}

void Editor::step_cluster(int by) {
  if (selection_.material < 0) return;
  const Spmm& fit = *project().materials[static_cast<size_t>(selection_.material)].fit;
  const int count = static_cast<int>(fit.clusters.size());
  if (count == 0) return;
  const int from = selection_.cluster < 0 ? (by > 0 ? -1 : count) : selection_.cluster;
  selection_.cluster = (from + by + count) % count;
  selection_.basis = -1;
}

void Editor::set_ui_scale(float scale) {
  settings_.ui_scale = scale;
  window_.set_scale(scale);
  save_settings_now();
}

void Editor::save_settings_now() {
  if (options_.safe_mode) return;
  const window::Place place = window_.place();
  settings_.window = {place.x, place.y, place.width, place.height, place.maximised, place.placed};
  if (!dialog_.recent().empty()) settings_.last_folder = dialog_.recent().front().string();
  if (const Status status = save_settings(settings_); !status) spdlog::warn("{}", status.error().message());
}

// The linear picture with its job, once every pixel has the samples at which the project stops refining: what a fresh
// `vamp render --from` of it must give to the byte.
Status Editor::record_exit() {
  if (options_.record_exit.empty()) return {};
  const std::string file = options_.record_exit.string();
  if (!session_) return fail(ErrorKind::failed, file, "", "a picture to record", "none was rendered");
  session_->pause(false);
  const auto until = Clock::now() + std::chrono::minutes(5);
  const auto done = [this](const RenderStatus& status) {
    return status.finished && status.project == document_.project() && status.width == viewport_width_ &&
           status.height == viewport_height_;
  };
  for (RenderStatus status = session_->status(); !done(status); status = session_->status()) {
    if (!status.error.empty()) return fail(ErrorKind::failed, file, "", "a picture", status.error);
    if (Clock::now() > until)
      return fail(ErrorKind::failed, file, "", "a picture that is refined to its last sample within 5 minutes");
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  int width = 0, height = 0;
  Still still;
  std::vector<float> pixels = session_->linear_picture(width, height, still.samples);
  still.image = Image(width, height, {"R", "G", "B", "A"});
  still.image.pixels = std::move(pixels);
  const Job job{.project = project(),
                .width = static_cast<uint32_t>(width),
                .height = static_cast<uint32_t>(height),
                .samples = still.samples,
                .device = device_.info().name,
                .driver = device_.info().driver};
  return save_snapshot(still, job, options_.record_exit, {});
}

}  // namespace vamp
