#pragma once
// The Vulkan instance and its validation messages; shared by the devices made from it.
#include <vulkan/vulkan.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/gpu/device_info.h"

namespace vamp::gpu {

class Instance {
 public:
  static Result<std::shared_ptr<Instance>> create(const Options& options);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance handle() const { return instance_; }
  bool validating() const { return messenger_ != VK_NULL_HANDLE; }
  std::vector<std::string> messages() const;
  uint64_t message_count() const;
  void name_object(VkDevice device, VkObjectType type, uint64_t handle, const std::string& name) const;

  struct Candidate {
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    DeviceInfo info;
  };
  // The best first, those that cannot serve last.
  Result<std::vector<Candidate>> candidates() const;

 private:
  Instance() = default;
  static VkBool32 VKAPI_PTR on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT*, void*);
  static VkDebugUtilsMessengerCreateInfoEXT messenger_info(Instance* self);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
  uint64_t message_count_ = 0;
};

// The queue family that computes and, where there is one, draws as well; UINT32_MAX: none.
uint32_t compute_family(VkPhysicalDevice physical);

// Reads what a device is and can do (device_info.cpp).
DeviceInfo describe(VkPhysicalDevice physical);

}  // namespace vamp::gpu
