#include "app/editor/background_device.h"

#include <sys/resource.h>

#include <future>

#include "engine/gpu/device.h"

namespace vamp {

Result<std::unique_ptr<gpu::Device>> background_device(const gpu::Device& window_device) {
  constexpr int kNice = 5;
  // The driver's threads start with the device and inherit the priority of the thread that makes it.
  const auto make = [&window_device] {
    setpriority(PRIO_PROCESS, 0, kNice);  // of this thread alone: Linux counts threads as processes here
    return window_device.sibling();
  };
  return std::async(std::launch::async, make).get();
}

}  // namespace vamp
