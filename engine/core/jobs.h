#pragma once
// Long work on worker threads; what it comes to reaches the thread that asked, in the order in which it was asked.
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"

namespace vamp {

// One queue keeps one order: a long job holds back the results of those asked for after it. Work that should not wait
// for other work (thumbnails, a fit) has a queue of its own. All calls come from one thread, the owner's.
class JobQueue {
 public:
  // threads: from 1 up. `wake` is called by a worker whenever there may be something to deliver, so that a sleeping
  // event loop wakes; it must be safe to call from any thread.
  explicit JobQueue(int threads = 1, std::function<void()> wake = {});
  // Cancels all jobs and waits for those that run; nothing is delivered any more.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  // Runs `Result<T> work(Progress&)` on a worker, later `done(Result<T>)` inside deliver(). Work looks at
  // progress.cancelled() now and then and returns cancelled_error() when it is set; work that is cancelled before it
  // starts is not run. The progress may be kept, read and cancelled for as long as the caller likes.
  template <class Work, class Done>
  std::shared_ptr<Progress> start(std::string name, Work work, Done done) {
    using Outcome = std::invoke_result_t<Work&, Progress&>;
    return submit(std::move(name), [work = std::move(work), done = std::move(done)](Progress& progress) mutable {
      auto outcome = std::make_shared<Outcome>(progress.cancelled() ? Outcome(cancelled_error()) : work(progress));
      return Delivery([outcome, done = std::move(done)]() mutable { done(std::move(*outcome)); });
    });
  }

  // Hands over what is finished, in the order of start(); returns how many. What a job threw (MachineError, bad_alloc)
  // is thrown here.
  size_t deliver();

  // Waits for all jobs and delivers them, also those that deliveries start.
  void finish();

  void cancel_all();

  struct Status {
    std::string name;
    std::shared_ptr<Progress> progress;
    bool started = false;
  };
  // Jobs that are not delivered yet, oldest first.
  std::vector<Status> jobs() const;
  bool empty() const;

  static tl::unexpected<Error> cancelled_error();

 private:
  using Delivery = std::function<void()>;
  std::shared_ptr<Progress> submit(std::string name, std::function<Delivery(Progress&)> work);
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace vamp
