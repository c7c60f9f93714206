#include "engine/render/session.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/core/clock.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/render/noise.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

// What edits may be answered from; at 640 x 480 some 270 samples (see Renderer::set_history).
constexpr uint64_t kHistoryBytes = 160u << 20;

// So many pixels are shaded again before a newer edit is looked for: some 10 ms on two cores of lavapipe.
constexpr uint32_t kReplayPixels = 1u << 16;

}  // namespace

class RenderSession::Impl {
 public:
  Impl(gpu::Device& device, std::shared_ptr<const Project> project, int width, int height)
      : device_(device), renderer_(device), next_project_(std::move(project)), next_size_(ivec2(width, height)) {
    status_.device = device.info().name;
    renderer_.set_history(kHistoryBytes);
    thread_ = std::thread([this] { run(); });
  }

  ~Impl() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }

  void set_project(std::shared_ptr<const Project> project, std::string reason) {
    {
      const std::lock_guard lock(mutex_);
      next_project_ = std::move(project);
      // Several edits may arrive between two tiles: the last one's reason stands for them.
      if (!reason.empty()) next_reason_ = std::move(reason);
    }
    wake_.notify_all();
  }

  void resize(int width, int height) {
    {
      const std::lock_guard lock(mutex_);
      next_size_ = ivec2(std::max(width, 1), std::max(height, 1));
    }
    wake_.notify_all();
  }

  void pause(bool paused) {
    {
      const std::lock_guard lock(mutex_);
      paused_ = paused;
    }
    wake_.notify_all();
  }

  void lose_device() {
    {
      const std::lock_guard lock(mutex_);
      lose_device_ = true;
    }
    wake_.notify_all();
  }

  RenderStatus status() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }

  uint64_t picture_version() const { return picture_version_.load(std::memory_order_acquire); }

  bool copy_picture(std::vector<uint32_t>& rgba, int& width, int& height, uint64_t& version) const {
    const std::lock_guard lock(picture_mutex_);
    if (version == picture_version_ || picture_.empty()) return false;
    rgba = picture_;
    width = picture_size_.x;
    height = picture_size_.y;
    version = picture_version_;
    return true;
  }

  bool copy_ids(std::vector<uint32_t>& ids, int& width, int& height, uint64_t& version) const {
    const std::lock_guard lock(picture_mutex_);
    if (version == ids_version_) return false;
    ids = ids_;
    width = ids_size_.x;
    height = ids_size_.y;
    version = ids_version_;
    return true;
  }

  Pick pick(float x, float y) const {
    std::shared_ptr<const Project> project;
    std::shared_ptr<const SceneTables> tables;
    std::vector<frame::PartRow> rows;
    ivec2 size;
    {
      const std::lock_guard lock(picture_mutex_);
      project = drawn_.project;
      tables = drawn_.tables;
      rows = drawn_.rows;
      size = picture_size_;
    }
    Pick found;
    if (!project || size.x == 0) return found;
    const float w = static_cast<float>(size.x), h = static_cast<float>(size.y);
    const CameraFrame camera = camera_frame(project->camera, w / h);
    const vec3 direction = camera_ray(camera, 2 * x / w - 1, 1 - 2 * y / h);
    const std::optional<Hit> hit = vamp::pick(tables->bvh, camera.origin, direction);
    if (!hit) return found;
    const Scene& scene = *project->scene;
    const uvec3 corners = scene.triangles[hit->triangle];
    found.part = static_cast<int>(scene.triangle_part[hit->triangle]);
    found.material = project->parts[static_cast<size_t>(found.part)].material;
    found.uv =
        (1 - hit->u - hit->v) * scene.uvs[corners.x] + hit->u * scene.uvs[corners.y] + hit->v * scene.uvs[corners.z];
    found.position = camera.origin + hit->t * direction;
    found.distance = hit->t;
    const Spmm& fit = *project->materials[static_cast<size_t>(found.material)].fit;
    const size_t texel = texel_at(rows[static_cast<size_t>(found.part)], found.uv);
    found.cluster = static_cast<int>(fit.texels[texel].cluster_count & 255u);
    return found;
  }

  std::vector<float> linear_picture(int& width, int& height, uint32_t& samples) const {
    // The render thread lets waiting readers in between two tiles.
    readers_.fetch_add(1);
    const std::lock_guard lock(renderer_mutex_);
    readers_.fetch_sub(1);
    width = renderer_.region().width;
    height = renderer_.region().height;
    samples = renderer_.replayed_samples();
    if (width == 0) return {};
    return renderer_.linear_picture(device_.last_submitted());
  }

 private:
  struct Drawn {
    std::shared_ptr<const Project> project;
    std::shared_ptr<const SceneTables> tables;
    std::vector<frame::PartRow> rows;
  };

  void run() {
    try {
      while (step()) {
      }
    } catch (const MachineError& error) {
      spdlog::error("{}", error.what());
      const std::lock_guard lock(mutex_);
      status_.error = error.what();
      status_.lost = true;
    } catch (const std::exception& error) {
      // Above all the computer's memory: the picture stops, the document stays.
      spdlog::error("the renderer stopped: {}", error.what());
      const std::lock_guard lock(mutex_);
      status_.error = std::string("the renderer stopped: ") + error.what();
      status_.lost = true;
    }
  }

  // One round: take over what was asked for, refine one tile, show it. False: stop.
  bool step() {
    std::shared_ptr<const Project> project;
    std::optional<ivec2> size;
    std::string reason;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] {
        return stop_ || lose_device_ || next_project_ || next_size_ ||
               (!refused_ && (paused_ ? busy_.load() : !finished_.load()));
      });
      if (stop_) return false;
      if (lose_device_) throw MachineError(ErrorKind::device_lost, "the device was lost on request");
      // A drag sends edits faster than a large material is shaded: each of them gets its first whole picture.
      const bool hold = owes_picture_ && renderer_.replaying() && !next_size_;
      if (!hold) project = std::exchange(next_project_, nullptr);
      size = std::exchange(next_size_, std::nullopt);
      if (!hold) reason = std::exchange(next_reason_, "");
    }
    while (readers_.load() > 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const std::lock_guard lock(renderer_mutex_);
    if (project) take_project(std::move(project), reason);
    if (size) take_size(*size);
    busy_ = wants_preview_ || renderer_.replaying();
    if (refused_ || renderer_.region().width == 0) return true;
    {
      // What is paused is refinement; an edit is shown.
      const std::lock_guard state(mutex_);
      if (paused_ && !renderer_.replaying() && !wants_preview_) return true;
    }
    if (std::exchange(wants_preview_, false))
      show_all(renderer_.preview(preview_stride()));
    else if (renderer_.replaying())
      shade_again();
    else
      refine_tile();
    busy_ = renderer_.replaying();
    return true;
  }

  void take_project(std::shared_ptr<const Project> project, const std::string& reason) {
    const Result<Change> change = renderer_.set_project(project);
    if (!change) {
      spdlog::error("{}", change.error().message());
      refused_ = true;
      const std::lock_guard lock(mutex_);
      status_.error = change.error().message();
      return;
    }
    refused_ = false;
    {
      const std::lock_guard lock(picture_mutex_);
      drawn_ = {project, renderer_.scene_tables(), renderer_.part_rows()};
    }
    if (change->restarted && change->places_moved) forget_ids();
    if (change->restarted) restart(reason.empty() ? change->what : reason);
    if (change->reshaded > 0) begin_shading_again(reason.empty() ? change->what : reason, *change);
    if (change->recomposed && renderer_.region().width > 0) {
      noise_.restart();
      show_all(renderer_.recompose());
    }
    finished_ =
        renderer_.region().width > 0 && !renderer_.replaying() && renderer_.samples() >= project->settings.max_samples;
    const std::lock_guard lock(mutex_);
    // Light and exposure are a matter of sums that are there: no pixel lost its samples.
    if (change->recomposed && !change->restarted && change->reshaded == 0 && !reason.empty()) {
      status_.restart_reason = reason;
      status_.restarted_pixels = 0;
    }
    status_.project = std::move(project);
    status_.error.clear();
    status_.finished = finished_;
    if (change->bytes > 0) status_.bytes_uploaded = change->bytes;
  }

  void take_size(ivec2 size) {
    if (size == ivec2(renderer_.region().width, renderer_.region().height)) return;
    const bool first = renderer_.region().width == 0;
    renderer_.set_region(size.x, size.y, {0, 0, size.x, size.y});
    {
      const std::lock_guard lock(picture_mutex_);
      picture_.assign(static_cast<size_t>(size.x) * static_cast<size_t>(size.y), 0xff202020u);
      picture_size_ = size;
    }
    forget_ids();
    restart(first ? "opened" : "window resized");
  }

  void restart(const std::string& reason) {
    cursor_ = 0;
    pass_whole_ = true;
    wants_preview_ = true;
    owes_picture_ = false;
    finished_ = false;
    start_ = Clock::now();
    pass_start_ = start_;
    noise_.restart();
    ids_stale_ = true;
    const std::lock_guard lock(mutex_);
    status_.restart_reason = reason;
    status_.samples = 0;
    status_.finished = false;
    status_.restarted_pixels =
        static_cast<uint64_t>(renderer_.region().width) * static_cast<uint64_t>(renderer_.region().height);
  }

  // A look that is due within a frame: the whole picture follows a moving camera, and tiles take its place when it
  // rests.
  uint32_t preview_stride() const {
    constexpr double kFrame = 20;  // ms
    const double sample = pass_ms_.empty() ? 16 * kFrame : pass_ms_.back();
    return static_cast<uint32_t>(std::clamp(std::ceil(std::sqrt(sample / kFrame)), 1.0, 8.0));
  }

  void begin_shading_again(const std::string& reason, const Change& change) {
    start_ = Clock::now();
    owes_picture_ = true;
    noise_.forget_picture();
    ids_stale_ = ids_stale_ || change.places_moved;
    const std::lock_guard lock(mutex_);
    status_.restart_reason = reason;
    status_.restarted_pixels = change.reshaded;
    status_.samples = 0;
    status_.finished = false;
  }

  void shade_again() {
    const uint64_t value = renderer_.replay(kReplayPixels);
    device_.wait(value);
    if (!renderer_.replay_pass_complete()) return;
    show_all(value);
    owes_picture_ = false;
    const uint32_t samples = renderer_.replayed_samples();
    const bool over = !renderer_.replaying();
    if (over && ids_stale_) update_ids();
    finished_ = over && samples >= renderer_.project().settings.max_samples;
    pass_start_ = Clock::now();
    pass_whole_ = cursor_ == 0;
    const std::lock_guard lock(mutex_);
    status_.samples = samples;
    status_.seconds = seconds_since(start_);
    status_.noise = over ? noise_.at(samples) : -1;
    status_.finished = finished_;
  }

  void refine_tile() {
    const uint32_t limit = renderer_.project().settings.max_samples;
    const uint32_t before = renderer_.samples_of(cursor_);
    const uint64_t value = renderer_.refine(cursor_, limit);
    device_.wait(value);
    show_tile(cursor_, value);
    const uint32_t batch = renderer_.samples_of(cursor_) - before;
    if (++cursor_ < renderer_.tile_count()) return;
    cursor_ = 0;
    end_pass(batch, value);
  }

  void end_pass(uint32_t batch, uint64_t value) {
    const uint32_t samples = renderer_.samples();
    if (batch > 0 && pass_whole_) {
      pass_ms_.push_back(1e3 * seconds_since(pass_start_) / batch);
      if (pass_ms_.size() > 9) pass_ms_.pop_front();
    }
    if (ids_stale_) update_ids();
    if (samples >= SAMPLES_PER_HIT && prepared_ != renderer_.key()) {
      prepared_ = renderer_.key();
      device_.wait(renderer_.prepare_replay());
    }
    if (noise_.wants(samples)) noise_.add(samples, renderer_.linear_picture(value));
    finished_ = samples >= renderer_.project().settings.max_samples;
    std::vector<double> sorted(pass_ms_.begin(), pass_ms_.end());
    std::sort(sorted.begin(), sorted.end());
    {
      const std::lock_guard lock(mutex_);
      status_.width = renderer_.region().width;
      status_.height = renderer_.region().height;
      status_.samples = samples;
      status_.seconds = seconds_since(start_);
      status_.ms_per_sample = sorted.empty() ? 0 : sorted[sorted.size() / 2];
      status_.noise = noise_.at(samples);
      status_.gpu_bytes = device_.bytes_allocated();
      status_.finished = finished_;
      if (status_.ms_per_sample > 0)
        status_.mrays_per_second = renderer_.rays_per_sample(coverage_) / status_.ms_per_sample * 1e-3;
    }
    pass_start_ = Clock::now();
    pass_whole_ = true;
  }

  // What was drawn from them would stand where things were.
  void forget_ids() {
    const std::lock_guard lock(picture_mutex_);
    if (ids_.empty()) return;
    ids_.clear();
    ids_size_ = ivec2(0);
    ++ids_version_;
  }

  void update_ids() {
    const std::vector<float> layers = renderer_.aov_layers(renderer_.render_aov());
    const ivec2 size(renderer_.region().width, renderer_.region().height);
    const size_t pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    std::vector<uint32_t> ids(pixels);
    size_t covered = 0;
    for (size_t i = 0; i < pixels; ++i) {
      const float part = layers[4 * (pixels + i) + 2], cluster = layers[4 * (pixels + i) + 3];
      if (part < 0) continue;
      ++covered;
      ids[i] = (static_cast<uint32_t>(part) + 1) | static_cast<uint32_t>(cluster + 1) << 16;
    }
    coverage_ = static_cast<double>(covered) / static_cast<double>(pixels);
    ids_stale_ = false;
    const std::lock_guard lock(picture_mutex_);
    ids_ = std::move(ids);
    ids_size_ = size;
    ++ids_version_;
  }

  // Copies a tile of the display into the picture that readers get.
  void show_tile(int tile, uint64_t value) {
    const uint32_t* display = renderer_.mapped_display();
    if (display == nullptr) {
      // Without mapped memory a copy is only worth while for a whole pass.
      if (tile + 1 == renderer_.tile_count()) show_all(value);
      return;
    }
    const Region area = renderer_.tile(tile);
    const std::lock_guard lock(picture_mutex_);
    for (int y = area.y; y < area.y + area.height; ++y) {
      const size_t at = static_cast<size_t>(y) * static_cast<size_t>(picture_size_.x) + static_cast<size_t>(area.x);
      std::memcpy(&picture_[at], &display[at], static_cast<size_t>(area.width) * sizeof(uint32_t));
    }
    picture_version_.fetch_add(1, std::memory_order_release);
  }

  void show_all(uint64_t value) {
    std::vector<uint32_t> display = renderer_.display_picture(value);
    const std::lock_guard lock(picture_mutex_);
    picture_ = std::move(display);
    picture_version_.fetch_add(1, std::memory_order_release);
  }

  gpu::Device& device_;

  // The renderer: used by the render thread, and by readers between two tiles.
  mutable std::mutex renderer_mutex_;
  mutable std::atomic<int> readers_{0};
  mutable Renderer renderer_;
  int cursor_ = 0;
  bool wants_preview_ = false;
  bool owes_picture_ = false;  // of the last edit, all of it
  bool pass_whole_ = true;     // pass_start_ was at its first tile
  bool ids_stale_ = true;
  KernelKey prepared_;  // for which replay's kernels are compiled
  double coverage_ = 1;
  NoiseEstimate noise_;
  std::deque<double> pass_ms_;
  Clock::time_point start_ = Clock::now(), pass_start_ = start_;

  // What was asked for, and what is told.
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::shared_ptr<const Project> next_project_;
  std::optional<ivec2> next_size_;
  std::string next_reason_;
  bool paused_ = false, stop_ = false, lose_device_ = false;
  std::atomic<bool> finished_{false}, refused_{false};
  std::atomic<bool> busy_{false};  // something is to be shown even while refinement is paused
  RenderStatus status_;

  // What is shown.
  mutable std::mutex picture_mutex_;
  std::vector<uint32_t> picture_, ids_;
  ivec2 picture_size_{0, 0}, ids_size_{0, 0};
  std::atomic<uint64_t> picture_version_{0};
  uint64_t ids_version_ = 0;
  Drawn drawn_;

  std::thread thread_;
};

RenderSession::RenderSession(gpu::Device& device, std::shared_ptr<const Project> project, int width, int height)
    : impl_(std::make_unique<Impl>(device, std::move(project), width, height)) {}
RenderSession::~RenderSession() = default;

void RenderSession::set_project(std::shared_ptr<const Project> project, std::string reason) {
  impl_->set_project(std::move(project), std::move(reason));
}
void RenderSession::resize(int width, int height) { impl_->resize(width, height); }
void RenderSession::pause(bool paused) { impl_->pause(paused); }
void RenderSession::lose_device() { impl_->lose_device(); }
RenderStatus RenderSession::status() const { return impl_->status(); }
uint64_t RenderSession::picture_version() const { return impl_->picture_version(); }
bool RenderSession::copy_picture(std::vector<uint32_t>& rgba, int& width, int& height, uint64_t& version) const {
  return impl_->copy_picture(rgba, width, height, version);
}
Pick RenderSession::pick(float x, float y) const { return impl_->pick(x, y); }
bool RenderSession::copy_ids(std::vector<uint32_t>& ids, int& width, int& height, uint64_t& version) const {
  return impl_->copy_ids(ids, width, height, version);
}
std::vector<float> RenderSession::linear_picture(int& width, int& height, uint32_t& samples) const {
  return impl_->linear_picture(width, height, samples);
}

}  // namespace vamp
