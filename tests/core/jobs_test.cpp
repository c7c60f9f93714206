#include "engine/core/jobs.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace vamp {
namespace {

// Work waits at a gate until the test opens it.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
};

TEST(JobQueue, DeliversInTheOrderOfRequestOnTheAskingThread) {
  JobQueue queue(3);
  Gate first;
  Gate others_done;
  std::atomic<int> others{0};
  std::vector<int> order;
  const auto asking = std::this_thread::get_id();
  for (int i = 0; i < 6; ++i)
    queue.start(
        "job",
        [&, i](Progress&) -> Result<int> {
          EXPECT_NE(std::this_thread::get_id(), asking);
          if (i == 0)
            first.wait();
          else if (++others == 5)
            others_done.open();
          return i;
        },
        [&](Result<int> result) {
          EXPECT_EQ(std::this_thread::get_id(), asking);
          order.push_back(*result);
        });
  others_done.wait();
  EXPECT_EQ(queue.deliver(), 0u);  // the first is not ready
  first.open();
  queue.finish();
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(queue.empty());
}

TEST(JobQueue, ErrorsAreDelivered) {
  JobQueue queue;
  std::string message;
  queue.start(
      "load", [](Progress&) -> Status { return fail(ErrorKind::bad_input, "a.png", "", "a file", "nothing"); },
      [&](Status status) { message = status.error().message(); });
  queue.finish();
  EXPECT_EQ(message, "a.png: expected a file, found nothing");
}

TEST(JobQueue, RunningWorkIsCancelledAndWaitingWorkNeverRuns) {
  JobQueue queue;
  Gate started;
  bool ran = false;
  std::vector<ErrorKind> kinds;
  const auto keep_kind = [&](Status status) { kinds.push_back(status ? ErrorKind::failed : status.error().kind); };
  const auto running = queue.start(
      "long",
      [&](Progress& progress) -> Status {
        progress.stage("turning");
        progress.fraction(0.5f);
        started.open();
        while (!progress.cancelled()) std::this_thread::yield();
        return JobQueue::cancelled_error();
      },
      keep_kind);
  const auto waiting = queue.start(
      "never",
      [&](Progress&) -> Status {
        ran = true;
        return {};
      },
      keep_kind);
  started.wait();
  EXPECT_EQ(running->stage(), "turning");
  EXPECT_EQ(running->fraction(), 0.5f);
  const auto jobs = queue.jobs();
  ASSERT_EQ(jobs.size(), 2u);
  EXPECT_EQ(jobs[0].name, "long");
  EXPECT_TRUE(jobs[0].started);
  EXPECT_FALSE(jobs[1].started);
  waiting->cancel();
  running->cancel();
  queue.finish();
  EXPECT_FALSE(ran);
  EXPECT_EQ(kinds, (std::vector<ErrorKind>{ErrorKind::interrupted, ErrorKind::interrupted}));
}

TEST(JobQueue, LeavingCancelsAndDeliversNothing) {
  bool delivered = false;
  Gate started;
  {
    JobQueue queue;
    queue.start(
        "long",
        [&](Progress& progress) -> Status {
          started.open();
          while (!progress.cancelled()) std::this_thread::yield();
          return {};
        },
        [&](Status) { delivered = true; });
    started.wait();
  }
  EXPECT_FALSE(delivered);
}

TEST(JobQueue, DeliveriesMayStartTheNextJob) {
  JobQueue queue;
  int last = 0;
  std::function<void(int)> next = [&](int value) {
    queue.start(
        "step", [value](Progress&) -> Result<int> { return value; },
        [&](Result<int> result) {
          last = *result;
          if (last < 5) next(last + 1);
        });
  };
  next(1);
  queue.finish();
  EXPECT_EQ(last, 5);
}

TEST(JobQueue, WhatWorkThrowsIsThrownOnDelivery) {
  JobQueue queue;
  int delivered = 0;
  queue.start(
      "gpu", [](Progress&) -> Status { throw MachineError(ErrorKind::device_lost, "device lost"); },
      [&](Status) { ++delivered; });
  queue.start(
      "after", [](Progress&) -> Status { return {}; }, [&](Status) { ++delivered; });
  EXPECT_THROW(queue.finish(), MachineError);
  queue.finish();
  EXPECT_EQ(delivered, 1);
}

TEST(JobQueue, WakesTheOwnerWhenSomethingIsReady) {
  Gate awake;
  JobQueue queue(1, [&] { awake.open(); });
  int result = 0;
  queue.start(
      "job", [](Progress&) -> Result<int> { return 7; }, [&](Result<int> r) { result = *r; });
  awake.wait();
  EXPECT_EQ(queue.deliver(), 1u);
  EXPECT_EQ(result, 7);
}

}  // namespace
}  // namespace vamp
