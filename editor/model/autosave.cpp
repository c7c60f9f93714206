#include "editor/model/autosave.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <random>
#include <thread>
#include <utility>

#include "editor/model/autosave_file.h"
#include "engine/core/files.h"
#include "engine/core/log.h"

namespace vamp {
namespace {

using Clock = std::chrono::steady_clock;

// From a failed write to the next attempt: a full disk may have room again.
constexpr std::chrono::seconds kRetry{10};

// Opens and locks a file for as long as this process lives; -1 where that cannot be. Another program that looks for
// leftovers may take the file away between the two steps: then it is made again.
int hold_lock(const fs::path& path) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const int lock = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    if (lock < 0) return -1;
    struct stat held {
    }, there{};
    if (::flock(lock, LOCK_EX) == 0 && ::fstat(lock, &held) == 0 && ::stat(path.c_str(), &there) == 0 &&
        held.st_ino == there.st_ino && held.st_dev == there.st_dev)
      return lock;
    ::close(lock);
  }
  return -1;
}

std::string new_id() {
  std::random_device random;
  return fmt::format("{}-{:08x}", ::getpid(), random());
}

}  // namespace

struct Autosave::State {
  Options options;
  fs::path lock_path, document_path;
  int lock = -1;

  std::mutex mutex;
  std::condition_variable changed;
  std::optional<AutosaveContent> pending;
  Clock::time_point due;
  bool stop = false;
  bool outdated = false;     // the document was saved since: what was written is to be removed
  bool written = false;      // the last write succeeded, and the document was not saved since
  std::string problem;       // not told yet
  std::string last_problem;  // of the last write; the same one is told once, however often it is tried again

  std::mutex writing;  // held around the disk: flush() and the worker never write at once
  std::thread worker;

  // Takes what is pending and writes it. Serialising happens here, off the caller's thread.
  Status write_pending() {
    const std::lock_guard one_writer(writing);
    std::optional<AutosaveContent> content;
    {
      const std::lock_guard lock_state(mutex);
      content.swap(pending);
      // What is pending is newer than the save that outdated the file, and replaces it.
      if (content) outdated = false;
    }
    if (!content) return {};
    const Status status = write_now(*content);
    const std::lock_guard lock_state(mutex);
    written = status && !outdated;
    if (status) {
      last_problem.clear();
      return status;
    }
    if (const std::string found = status.error().message(); found != last_problem) {
      problem = last_problem = found;
      spdlog::warn("autosave: {}", problem);
    }
    // It is still not on disk: unless something newer came or it was saved meanwhile, it is tried again.
    if (!pending && !outdated) {
      pending = std::move(content);
      due = Clock::now() + std::max<Clock::duration>(options.delay, kRetry);
      changed.notify_all();
    }
    return status;
  }

  // Running out of memory here must not end the program: the document in memory is all there is.
  Status write_now(const AutosaveContent& content) const {
    try {
      return write_autosave(content, document_path);
    } catch (const std::exception& error) {
      return fail(ErrorKind::failed, document_path.string(), "", error.what());
    }
  }

  void remove_document() {
    const std::lock_guard one_writer(writing);
    std::error_code code;
    fs::remove(document_path, code);
  }

  // Not when flush() has written a newer document since the worker looked.
  void remove_outdated() {
    const std::lock_guard one_writer(writing);
    {
      const std::lock_guard lock_state(mutex);
      if (!std::exchange(outdated, false)) return;
    }
    std::error_code code;
    fs::remove(document_path, code);
  }

  void work() {
    std::unique_lock lock_state(mutex);
    while (!stop) {
      if (outdated) {
        lock_state.unlock();
        remove_outdated();
        lock_state.lock();
      } else if (!pending) {
        changed.wait(lock_state);
      } else if (Clock::now() < due) {
        changed.wait_until(lock_state, due);
      } else {
        lock_state.unlock();
        (void)write_pending();  // kept in `problem`, and tried again
        lock_state.lock();
      }
    }
  }

  void stop_worker() {
    {
      const std::lock_guard lock_state(mutex);
      stop = true;
    }
    changed.notify_all();
    if (worker.joinable()) worker.join();
  }
};

Autosave::Autosave(Options options) : state_(std::make_unique<State>()) {
  if (options.folder.empty()) options.folder = default_autosave_folder();
  state_->options = options;
  std::error_code code;
  fs::create_directories(options.folder, code);
  // Documents are nobody else's business.
  if (fs::is_directory(options.folder, code)) fs::permissions(options.folder, fs::perms::owner_all, code);
  const std::string id = new_id();
  state_->lock_path = options.folder / (id + ".lock");
  state_->document_path = options.folder / (id + ".json");
  state_->lock = hold_lock(state_->lock_path);
  if (state_->lock < 0) {
    state_->problem = options.folder.string() + ": cannot be written, so nothing is saved automatically";
    spdlog::warn("autosave: {}", state_->problem);
  }
  state_->worker = std::thread([state = state_.get()] { state->work(); });
}

Autosave::~Autosave() {
  state_->stop_worker();
  if (state_->lock < 0) return;
  if (!state_->document_path.empty()) state_->remove_document();
  std::error_code code;
  fs::remove(state_->lock_path, code);
  ::close(state_->lock);
}

void Autosave::update(const Document& document) {
  const bool dirty = document.dirty();
  {
    const std::lock_guard lock(state_->mutex);
    if (dirty) {
      // The clock runs from the first edit that is not on disk: a long drag does not put it off.
      if (!state_->pending) state_->due = Clock::now() + state_->options.delay;
      state_->pending = AutosaveContent{document.project(), document.path()};
    } else {
      state_->pending.reset();
      state_->outdated = true;
      state_->written = false;
    }
  }
  state_->changed.notify_all();
}

Status Autosave::flush() { return state_->write_pending(); }

void Autosave::abandon() {
  state_->stop_worker();
  (void)state_->write_pending();  // said in the log; there is nothing else to be done at an end like this
  state_->document_path.clear();
}

bool Autosave::written() const {
  const std::lock_guard lock(state_->mutex);
  return state_->written;
}

std::string Autosave::take_problem() {
  const std::lock_guard lock(state_->mutex);
  return std::exchange(state_->problem, {});
}

}  // namespace vamp
