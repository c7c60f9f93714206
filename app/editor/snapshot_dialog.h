#pragma once
// Exporting the picture at any size: what is asked for, and the job that does it.
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "editor/widgets/file_dialog.h"
#include "engine/core/jobs.h"
#include "engine/render/snapshot.h"

namespace vamp {

namespace gpu {
class Device;
}

class SnapshotDialog {
 public:
  // `device`: the snapshot is rendered on a queue of its own of the same device, so that the window stays fluent.
  SnapshotDialog(gpu::Device& device, ui::FileDialog& files, JobQueue& jobs);

  // `project` as it is now is what is rendered; the viewport's size is the first offer, with no fewer samples than it
  // has.
  void open(std::shared_ptr<const Project> project, int viewport_width, int viewport_height, uint32_t viewport_samples);
  // The last choices again, without asking.
  void repeat(std::shared_ptr<const Project> project);
  bool can_repeat() const { return !path_.empty() && !running(); }
  void draw();

  bool running() const { return job_ != nullptr; }
  // Told when a job begins and ends: the viewport's renderer rests meanwhile.
  std::function<void(bool running)> busy;

 private:
  enum class Format { png8, png16, exr_float, exr_half };
  void start();
  void draw_size();
  void draw_quality();
  void draw_file();
  bool may_write();
  std::filesystem::path path_with_extension(std::filesystem::path path) const;

  gpu::Device& device_;
  ui::FileDialog& files_;
  JobQueue& jobs_;
  std::shared_ptr<const Project> project_;
  std::shared_ptr<Progress> job_;
  bool open_ = false;

  int preset_ = 0;  // of the sizes; the last is one's own
  int viewport_width_ = 1280, viewport_height_ = 960;
  float width_ = 1280, height_ = 960;
  enum class Stop { samples, time, noise };
  Stop stop_ = Stop::samples;
  float samples_ = 64, seconds_ = 30, noise_ = 2;  // noise in percent
  bool transparent_ = false;
  Format format_ = Format::png8;
  std::filesystem::path path_;
  std::filesystem::path replaces_;  // the user agreed to write over this file
  std::string problem_;
};

}  // namespace vamp
