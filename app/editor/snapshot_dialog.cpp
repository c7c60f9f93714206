#include "app/editor/snapshot_dialog.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/editor/background_device.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/notify.h"
#include "editor/widgets/row.h"
#include "editor/widgets/theme.h"
#include "engine/core/files.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Size {
  const char* name;
  int width, height;
};
constexpr int kMaxSide = 8192;
constexpr std::array kSizes{Size{"Viewport", 0, 0},
                            Size{"Full HD, 1920 × 1080", 1920, 1080},
                            Size{"4K, 3840 × 2160", 3840, 2160},
                            Size{"Square, 2048 × 2048", 2048, 2048},
                            Size{"Print A4 at 300 dpi, 3508 × 2480", 3508, 2480},
                            Size{"8K, 7680 × 4320", 7680, 4320},
                            Size{"Custom", 0, 0}};
constexpr int kCustom = static_cast<int>(kSizes.size()) - 1;
constexpr std::array<const char*, 4> kFormats{"PNG, 8 bit", "PNG, 16 bit", "OpenEXR, float", "OpenEXR, half"};

struct Order {
  std::shared_ptr<const Project> project;
  StillOptions still;
  SnapshotFormat format;
  fs::path path;
};

// Renders and writes. A cancelled picture is not written.
Status make_snapshot(gpu::Device& window_device, const Order& order, Progress& progress) {
  progress.stage("preparing");
  VAMP_TRY(const std::unique_ptr<gpu::Device> device, background_device(window_device));
  progress.stage("rendering");
  VAMP_TRY(const Still still, render_still(*device, order.project, order.still, &progress));
  if (progress.cancelled()) return JobQueue::cancelled_error();
  progress.stage("writing");
  const Job job{.project = *order.project,
                .width = static_cast<uint32_t>(order.still.width),
                .height = static_cast<uint32_t>(order.still.height),
                .samples = order.still.noise_goal > 0 ? order.still.samples : still.samples,
                .noise_goal = order.still.noise_goal,
                .complete = still.complete || order.still.seconds > 0,
                .device = device->info().name,
                .driver = device->info().driver};
  return save_snapshot(still, job, order.path, order.format);
}

}  // namespace

SnapshotDialog::SnapshotDialog(gpu::Device& device, ui::FileDialog& files, JobQueue& jobs)
    : device_(device), files_(files), jobs_(jobs) {}

void SnapshotDialog::open(std::shared_ptr<const Project> project, int viewport_width, int viewport_height,
                          uint32_t viewport_samples) {
  if (running()) return;
  samples_ = std::max(samples_, static_cast<float>(viewport_samples));
  project_ = std::move(project);
  viewport_width_ = std::max(viewport_width, 1);
  viewport_height_ = std::max(viewport_height, 1);
  if (path_.empty()) {
    const fs::path stem = project_->model.stem();
    std::error_code code;  // the current folder may be gone: a relative path has to do then
    const fs::path folder = fs::current_path(code);
    const std::string name = stem.empty() ? "picture" : stem.string();
    path_ = folder / (name + ".png");
    for (int i = 2; fs::exists(path_, code); ++i) path_ = folder / fmt::format("{} {}.png", name, i);
  }
  problem_.clear();
  replaces_.clear();
  open_ = true;
}

void SnapshotDialog::repeat(std::shared_ptr<const Project> project) {
  if (!can_repeat()) return;
  project_ = std::move(project);
  start();
}

fs::path SnapshotDialog::path_with_extension(fs::path path) const {
  path.replace_extension(format_ == Format::png8 || format_ == Format::png16 ? ".png" : ".exr");
  return path;
}

void SnapshotDialog::draw_size() {
  std::array<const char*, kSizes.size()> names{};
  for (size_t i = 0; i < kSizes.size(); ++i) names[i] = kSizes[i].name;
  ui::combo_row("Size", preset_, names, 0, "Width and height in pixels.");
  if (preset_ == 0) {
    width_ = static_cast<float>(viewport_width_);
    height_ = static_cast<float>(viewport_height_);
  } else if (preset_ != kCustom) {
    width_ = static_cast<float>(kSizes[static_cast<size_t>(preset_)].width);
    height_ = static_cast<float>(kSizes[static_cast<size_t>(preset_)].height);
  }
  const ui::Parameter side{.label = "Width",
                           .low = 16,
                           .high = kMaxSide,
                           .initial = static_cast<float>(viewport_width_),
                           .format = "%.0f px",
                           .description = "Pixels. Typing a size makes it a custom one.",
                           .mapping = &ui::kLog,
                           .whole = true};
  ui::Parameter height = side;
  height.label = "Height";
  height.initial = static_cast<float>(viewport_height_);
  if (ui::parameter_row(side, width_)) preset_ = kCustom;
  if (ui::parameter_row(height, height_)) preset_ = kCustom;
}

void SnapshotDialog::draw_quality() {
  int way = static_cast<int>(stop_);
  constexpr std::array<const char*, 3> kWays{"Samples", "Time", "Noise"};
  ui::combo_row("Stop after", way, kWays, 0,
                "When the picture is good enough: a number of samples, a time, or a noise that is reached everywhere.");
  stop_ = static_cast<Stop>(way);
  if (stop_ == Stop::noise) {
    ui::parameter_row(
        {.label = "Noise",
         .low = 0.1f,
         .high = 20,
         .initial = 2,
         .format = "%.2f %%",
         .description = "Relative noise. Each part of the picture stops where it has less; half the noise "
                        "takes up to four times as long.",
         .mapping = &ui::kLog},
        noise_);
  } else if (stop_ == Stop::time) {
    ui::parameter_row({.label = "Time",
                       .low = 1,
                       .high = 3600,
                       .initial = 30,
                       .format = "%.0f s",
                       .description = "Rendering stops after the sample that is under way then.",
                       .mapping = &ui::kLog,
                       .whole = true},
                      seconds_);
  } else {
    ui::parameter_row({.label = "Samples",
                       .low = 1,
                       .high = 65536,
                       .initial = 64,
                       .format = "%.0f",
                       .description = "Of every pixel. Four times as many halve the noise.",
                       .mapping = &ui::kLog,
                       .whole = true},
                      samples_);
  }
}

void SnapshotDialog::draw_file() {
  int format = static_cast<int>(format_);
  ui::combo_row("Format", format, kFormats, 0,
                "PNG holds what the window shows; OpenEXR holds the linear light, before exposure and tone curve.");
  format_ = static_cast<Format>(format);
  const bool png = format_ == Format::png8 || format_ == Format::png16;
  ui::toggle_row("Transparent", transparent_, false, "PNG: the model without its background. OpenEXR always has alpha.",
                 {.locked = !png});
  path_ = path_with_extension(path_);
  std::string text = path_.string();
  if (ui::text_row("File", text, "Where the picture goes.") && !text.empty()) {
    std::error_code code;
    const fs::path full = fs::absolute(text, code);
    path_ = code ? fs::path(text) : full;
    const std::string extension = path_.extension().string();
    if (extension == ".exr" && png) format_ = Format::exr_float;
    if (extension == ".png" && !png) format_ = Format::png8;
  }
}

// Whether the picture can go where it is meant to go; a file that is there already is asked about once.
bool SnapshotDialog::may_write() {
  const Status sound = check_snapshot(path_, {});
  std::error_code code;
  const bool asks = sound && replaces_ != path_ && fs::exists(path_, code);
  if (asks) replaces_ = path_;
  problem_ = !sound ? sound.error().message() : asks ? path_.filename().string() + " is there already." : "";
  return problem_.empty();
}

void SnapshotDialog::draw() {
  if (!ui::begin_dialog("Export snapshot", open_, 520)) return;
  // Before the rows are drawn: Enter in a field ends the typing, and the field is active no more when that is done.
  const bool typing = ImGui::IsAnyItemActive();
  draw_size();
  draw_quality();
  draw_file();
  ui::gap(6);
  if (!problem_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui::theme().error);
    ImGui::TextWrapped("%s", problem_.c_str());
    ImGui::PopStyleColor();
  }
  ui::gap(4);
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
  const bool enter = (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) && !typing && !ImGui::IsAnyItemActive();
  const bool go = ui::primary_button(replaces_ == path_ ? "Replace it" : "Export", ui::px(96)) || enter;
  ImGui::SameLine();
  if (ImGui::Button("Choose file…", ImVec2(0, ui::px(28)))) {
    ImGui::CloseCurrentPopup();
    open_ = false;
    ui::FileRequest request;
    request.mode = ui::FileRequest::Mode::save;
    request.title = "Export snapshot";
    request.folder = path_.parent_path();
    request.name = path_.filename().string();
    request.extensions = {path_.extension().string()};
    request.done = [this](const fs::path& path) {
      path_ = replaces_ = path;  // the file dialog has asked
      problem_.clear();
      open_ = true;
    };
    files_.open(std::move(request));
  }
  ImGui::SameLine();
  if (ImGui::Button("Cancel", ImVec2(ui::px(84), ui::px(28)))) open_ = false;
  if (go && may_write()) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  ui::end_dialog();
  if (go && !open_) start();
}

void SnapshotDialog::start() {
  Order order;
  order.project = project_;
  order.path = path_;
  order.still.width = static_cast<int>(std::lround(width_));
  order.still.height = static_cast<int>(std::lround(height_));
  order.still.samples = static_cast<uint32_t>(std::lround(samples_));
  if (stop_ != Stop::samples) order.still.samples = project_->settings.max_samples;
  if (stop_ == Stop::time) order.still.seconds = static_cast<double>(seconds_);
  if (stop_ == Stop::noise) order.still.noise_goal = noise_ / 100;
  order.format.png_bits = format_ == Format::png16 ? 16 : 8;
  order.format.exr_half = format_ == Format::exr_half;
  order.format.transparent = transparent_;
  if (busy) busy(true);
  job_ = jobs_.start(
      "Snapshot " + path_.filename().string(),
      [&device = device_, order](Progress& progress) { return make_snapshot(device, order, progress); },
      [this, order](const Status& status) {
        job_ = nullptr;
        if (busy) busy(false);
        if (status) return ui::notify(ui::Notice::done, "Snapshot saved: " + order.path.string());
        if (status.error().kind == ErrorKind::interrupted) return ui::notify(ui::Notice::info, "Snapshot cancelled");
        ui::notify(ui::Notice::error, status.error().message());
      });
}

}  // namespace vamp
