#include "engine/core/jobs.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include "engine/core/check.h"

namespace vamp {

struct JobQueue::State {
  struct Job {
    std::string name;
    std::shared_ptr<Progress> progress = std::make_shared<Progress>();
    std::function<Delivery(Progress&)> work;
    Delivery delivery;
    std::exception_ptr thrown;
    bool started = false;
    bool finished = false;
  };

  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::shared_ptr<Job>> jobs;  // not delivered yet, in the order of start()
  bool stopping = false;
  std::function<void()> wake;
  std::vector<std::thread> workers;

  std::shared_ptr<Job> next_to_run() const {
    for (const auto& job : jobs)
      if (!job->started) return job;
    return nullptr;
  }

  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      std::shared_ptr<Job> job;
      changed.wait(lock, [&] { return stopping || (job = next_to_run()) != nullptr; });
      if (stopping) return;
      job->started = true;
      lock.unlock();
      try {
        job->delivery = job->work(*job->progress);
      } catch (...) {
        job->thrown = std::current_exception();
      }
      job->work = nullptr;
      lock.lock();
      job->finished = true;
      changed.notify_all();
      lock.unlock();
      if (wake) wake();
      lock.lock();
    }
  }
};

JobQueue::JobQueue(int threads, std::function<void()> wake) : state_(std::make_shared<State>()) {
  CHECK(threads > 0);
  state_->wake = std::move(wake);
  for (int i = 0; i < threads; ++i) state_->workers.emplace_back([state = state_.get()] { state->run(); });
}

JobQueue::~JobQueue() {
  cancel_all();
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopping = true;
  }
  state_->changed.notify_all();
  for (auto& worker : state_->workers) worker.join();
}

std::shared_ptr<Progress> JobQueue::submit(std::string name, std::function<Delivery(Progress&)> work) {
  auto job = std::make_shared<State::Job>();
  job->name = std::move(name);
  job->work = std::move(work);
  {
    const std::lock_guard lock(state_->mutex);
    state_->jobs.push_back(job);
  }
  state_->changed.notify_all();
  return job->progress;
}

size_t JobQueue::deliver() {
  for (size_t count = 0;; ++count) {
    std::shared_ptr<State::Job> job;
    {
      const std::lock_guard lock(state_->mutex);
      if (state_->jobs.empty() || !state_->jobs.front()->finished) return count;
      job = std::move(state_->jobs.front());
      state_->jobs.pop_front();
    }
    // Without the lock, so that what is delivered may start the next job.
    if (job->thrown) std::rethrow_exception(job->thrown);
    job->delivery();
  }
}

void JobQueue::finish() {
  while (!empty()) {
    {
      std::unique_lock lock(state_->mutex);
      state_->changed.wait(lock, [this] { return state_->jobs.front()->finished; });
    }
    deliver();
  }
}

void JobQueue::cancel_all() {
  const std::lock_guard lock(state_->mutex);
  for (const auto& job : state_->jobs) job->progress->cancel();
}

std::vector<JobQueue::Status> JobQueue::jobs() const {
  const std::lock_guard lock(state_->mutex);
  std::vector<Status> all;
  for (const auto& job : state_->jobs) all.push_back({job->name, job->progress, job->started});
  return all;
}

bool JobQueue::empty() const {
  const std::lock_guard lock(state_->mutex);
  return state_->jobs.empty();
}

tl::unexpected<Error> JobQueue::cancelled_error() { return fail(ErrorKind::interrupted, "", "", "cancelled"); }

}  // namespace vamp
