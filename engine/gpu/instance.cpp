#include "engine/gpu/instance.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "engine/core/log.h"
#include "engine/gpu/machine.h"

namespace vamp::gpu {
namespace {

constexpr char kValidationLayer[] = "VK_LAYER_KHRONOS_validation";
constexpr size_t kKeptMessages = 1000;

// With one thread a core, lavapipe's few workers can end up sharing a core while the other idles; a few more threads
// than cores cost nothing and shorten small jobs on a busy machine. Read by the driver when devices are listed. What
// the user has set stands.
void give_lavapipe_threads() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (std::thread::hardware_concurrency() < 4) setenv("LP_NUM_THREADS", "4", /*overwrite=*/0);
  });
}

bool has_layer(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(),
                     [name](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool has_extension(const std::string& name) {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(),
                     [&name](const auto& extension) { return name == extension.extensionName; });
}

tl::unexpected<Error> no_driver(const std::string& found) {
  return fail(ErrorKind::no_device, "", "Vulkan", "a driver (on Debian: apt install mesa-vulkan-drivers)", found);
}

template <class Function>
Function load(VkInstance instance, const char* name) {
  return reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, name));
}

}  // namespace

VkDebugUtilsMessengerCreateInfoEXT Instance::messenger_info(Instance* self) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  info.pfnUserCallback = &Instance::on_message;
  info.pUserData = self;
  return info;
}

Result<std::shared_ptr<Instance>> Instance::create(const Options& options) {
  give_lavapipe_threads();
  uint32_t version = VK_API_VERSION_1_0;
  vkEnumerateInstanceVersion(&version);
  if (version < VK_API_VERSION_1_2)
    return fail(ErrorKind::no_device, "", "Vulkan loader", "version 1.2 or later",
                std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)));

  // Gather layers and extensions, and say which one is missing rather than leaving it to a number.
  std::vector<const char*> layers, extensions;
  for (const auto& name : options.instance_extensions) {
    if (!has_extension(name))
      return fail(ErrorKind::failed, "", "Vulkan", "the instance extension " + name, "a driver without it");
    extensions.push_back(name.c_str());
  }
  if (options.validate) {
    if (!has_layer(kValidationLayer))
      return fail(ErrorKind::failed, "", "Vulkan validation",
                  std::string(kValidationLayer) + " (on Debian: apt install vulkan-validationlayers)",
                  "it is not installed");
    layers.push_back(kValidationLayer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  }

  auto self = std::shared_ptr<Instance>(new Instance);
  const VkApplicationInfo application{
      .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .pApplicationName = "vamp", .apiVersion = VK_API_VERSION_1_2};
  auto messenger = messenger_info(self.get());
  const VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                         .pNext = &messenger,
                                         .enabledValidationFeatureCount = 1,
                                         .pEnabledValidationFeatures = &synchronization};
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  if (options.validate)
    info.pNext = options.validate_synchronization ? static_cast<const void*>(&features) : &messenger;
  info.enabledLayerCount = static_cast<uint32_t>(layers.size());
  info.ppEnabledLayerNames = layers.data();
  info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  if (const VkResult result = vkCreateInstance(&info, nullptr, &self->instance_); result != VK_SUCCESS) {
    self->instance_ = VK_NULL_HANDLE;
    return no_driver(text_of(result));
  }
  if (options.validate) {
    const auto create = load<PFN_vkCreateDebugUtilsMessengerEXT>(self->instance_, "vkCreateDebugUtilsMessengerEXT");
    self->set_name_ = load<PFN_vkSetDebugUtilsObjectNameEXT>(self->instance_, "vkSetDebugUtilsObjectNameEXT");
    messenger = messenger_info(self.get());
    if (create) create(self->instance_, &messenger, nullptr, &self->messenger_);
  }
  return self;
}

Instance::~Instance() {
  if (!instance_) return;
  if (messenger_)
    load<PFN_vkDestroyDebugUtilsMessengerEXT>(instance_, "vkDestroyDebugUtilsMessengerEXT")(instance_, messenger_,
                                                                                            nullptr);
  vkDestroyInstance(instance_, nullptr);
}

VkBool32 VKAPI_PTR Instance::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                        VkDebugUtilsMessageTypeFlagsEXT,
                                        const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  auto* self = static_cast<Instance*>(user);
  const std::string text = data->pMessage ? data->pMessage : "";
  spdlog::log(severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT ? spdlog::level::err : spdlog::level::warn,
              "Vulkan validation: {}", text);
  const std::scoped_lock lock(self->mutex_);
  ++self->message_count_;
  if (self->messages_.size() < kKeptMessages) self->messages_.push_back(text);
  return VK_FALSE;
}

std::vector<std::string> Instance::messages() const {
  const std::scoped_lock lock(mutex_);
  return messages_;
}

uint64_t Instance::message_count() const {
  const std::scoped_lock lock(mutex_);
  return message_count_;
}

void Instance::name_object(VkDevice device, VkObjectType type, uint64_t handle, const std::string& name) const {
  if (!set_name_ || name.empty()) return;
  const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                           .objectType = type,
                                           .objectHandle = handle,
                                           .pObjectName = name.c_str()};
  set_name_(device, &info);
}

Result<std::vector<Instance::Candidate>> Instance::candidates() const {
  uint32_t count = 0;
  VkResult result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  std::vector<VkPhysicalDevice> physical(count);
  if (result == VK_SUCCESS) result = vkEnumeratePhysicalDevices(instance_, &count, physical.data());
  if (result < 0) return no_driver(text_of(result));
  if (count == 0) return no_driver("no device");
  std::vector<Candidate> all;
  for (uint32_t i = 0; i < count; ++i) all.push_back({physical[i], describe(physical[i])});
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    const auto rank = [](const DeviceInfo& info) {
      return std::pair(!info.unsuitable.empty(), static_cast<int>(info.type));
    };
    return rank(a.info) < rank(b.info);
  });
  for (uint32_t i = 0; i < count; ++i) all[i].info.index = i;
  return all;
}

}  // namespace vamp::gpu
