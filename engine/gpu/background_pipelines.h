#pragma once
// Pipelines made on threads of their own, so that the queue which will use them need not wait.
//
// Most drivers compile while a pipeline is made. lavapipe compiles at the first dispatch, on the queue: 0.2 to 1 s in
// which nothing else runs. There each pipeline is rehearsed, made on a second device too and dispatched without work:
// the driver's disk cache then has the code, and the first dispatch on the device itself takes some milliseconds.
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/core/files.h"
#include "engine/gpu/pipeline.h"

namespace vamp::gpu {

class Device;

class BackgroundPipelines {
 public:
  enum class Urgency {
    straight,  // at once, and nothing else is on the queue: not rehearsed; wait() makes one itself
    at_once,   // somebody waits for it
    soon,
    spare,  // by a thread of low priority alone
  };
  // Under what the asker knows a pipeline by.
  using Number = uint64_t;

  // For `device`. `arrived` is called on another thread whenever there is something to take().
  BackgroundPipelines(Device& device, std::function<void()> arrived);
  // Waits for those that are being made, up to some seconds; the others are dropped.
  ~BackgroundPipelines();
  BackgroundPipelines(const BackgroundPipelines&) = delete;
  BackgroundPipelines& operator=(const BackgroundPipelines&) = delete;

  // Whether the queue gains by it: not where the driver compiles on the queue and keeps nothing on disk.
  static bool useful(const Device& device);

  // What will stand at the bindings: compiled code depends on the formats. What is not `straight` waits for it.
  void bound_as(const std::vector<Binding>& bindings, const std::vector<Bound>& bound);

  // The most urgent goes first, then who asked first.
  void want(Number number, const PipelineDesc& desc, Urgency urgency);
  // What is wanted has become more urgent; nothing if it is begun, or was as urgent before.
  void raise(Number number, Urgency urgency);
  // Drops what is not begun; returns what that was.
  std::vector<Number> drop_wanted();

  // What was made since the last time. Throws the MachineError of one that could not be made.
  std::vector<std::pair<Number, ComputePipeline>> take();
  // Waits until there is something to take; something must be wanted.
  void wait();

 private:
  struct Job {
    Number number = 0;
    PipelineDesc desc;
    Urgency urgency = Urgency::soon;
  };
  class Rehearsal;

  void work(int nice, bool spare);
  bool pick(bool spare, Job& job);
  void rehearse(std::unique_ptr<Rehearsal>& rehearsal, const PipelineDesc& desc);

  Device& device_;
  const std::function<void()> arrived_;
  const std::vector<fs::path> caches_;  // the driver's, where pipelines are rehearsed

  std::mutex mutex_;
  std::condition_variable wanted_, made_one_;
  std::vector<Job> jobs_;
  std::vector<std::pair<Binding, VkFormat>> formats_;
  std::vector<std::pair<Number, ComputePipeline>> made_;
  std::exception_ptr error_;
  int unseen_ = 0;  // rehearsals in a row of which nothing came to the cache
  bool stop_ = false;

  std::vector<std::thread> threads_;
};

}  // namespace vamp::gpu
