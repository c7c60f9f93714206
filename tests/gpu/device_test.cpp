// Which device is taken, what it refuses, and whether validation listens.
#include "engine/gpu/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "shaders/spirv.h"
#include "tests/gpu/gpu_test.h"

namespace vamp::gpu {
namespace {

using testing::HasSubstr;

// Sets an environment variable for the length of a test.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    setenv(name, value, 1);
  }
  ~Environment() { old_.empty() ? unsetenv(name_) : setenv(name_, old_.c_str(), 1); }

 private:
  const char* name_;
  std::string old_;
};

TEST(DeviceChoice, ListsTheBestDeviceFirst) {
  const auto devices = list_devices();
  ASSERT_TRUE(devices) << devices.error().message();
  ASSERT_FALSE(devices->empty());
  for (uint32_t i = 0; i < devices->size(); ++i) {
    const DeviceInfo& info = (*devices)[i];
    EXPECT_EQ(info.index, i);
    EXPECT_FALSE(info.name.empty());
    EXPECT_FALSE(info.driver.empty());
    if (i > 0 && (*devices)[i - 1].unsuitable.empty() == info.unsuitable.empty()) {
      EXPECT_LE((*devices)[i - 1].type, info.type);
    }
    if (info.is_lavapipe) {
      EXPECT_TRUE(info.is_cpu);
      EXPECT_GE(info.driver_major, 22u) << info.driver;
      EXPECT_THAT(info.driver, HasSubstr("Mesa " + std::to_string(info.driver_major)));
    }
    EXPECT_GE(info.max_storage_range, 128u << 20);
    EXPECT_GT(info.max_texel_elements, 0u);
    EXPECT_GT(info.subgroup_size, 0u);
  }
}

TEST(DeviceChoice, TakesAnIndexOrAPartOfAName) {
  const auto devices = list_devices();
  ASSERT_TRUE(devices);
  std::string part = devices->front().name.substr(1, 4);
  for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& wanted : {std::string(), std::string("0"), part}) {
    const auto device = Device::create({.device = wanted, .validate = false});
    ASSERT_TRUE(device) << device.error().message();
    EXPECT_EQ((*device)->info().name, devices->front().name);
    EXPECT_FALSE((*device)->validating());
  }
}

TEST(DeviceChoice, NamesTheDevicesWhenNoneIsMeant) {
  const auto devices = list_devices();
  ASSERT_TRUE(devices);
  for (const char* wanted : {"99", "no such gpu", "-1"}) {
    const auto device = Device::create({.device = wanted, .validate = false});
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().kind, ErrorKind::no_device);
    EXPECT_THAT(device.error().message(), HasSubstr(devices->front().name));
    EXPECT_THAT(device.error().message(), HasSubstr(wanted));
  }
}

TEST(DeviceChoice, SaysThatThereIsNoDriver) {
  const Environment old_name("VK_ICD_FILENAMES", "/nonexistent/driver.json");
  const Environment new_name("VK_DRIVER_FILES", "/nonexistent/driver.json");
  const auto devices = list_devices();
  const auto device = Device::create();
  ASSERT_FALSE(devices);
  ASSERT_FALSE(device);
  for (const Error& error : {devices.error(), device.error()}) {
    EXPECT_EQ(error.kind, ErrorKind::no_device);
    EXPECT_THAT(error.message(), HasSubstr("Vulkan"));
    EXPECT_EQ(error.message().find('\n'), std::string::npos);
  }
}

TEST(DeviceChoice, NamesTheMissingExtension) {
  const auto instance = Device::create({.device = {}, .instance_extensions = {"VK_NONE_instance"}});
  ASSERT_FALSE(instance);
  EXPECT_THAT(instance.error().message(), HasSubstr("VK_NONE_instance"));
  const auto device = Device::create({.device = {}, .device_extensions = {"VK_NONE_device"}});
  ASSERT_FALSE(device);
  EXPECT_THAT(device.error().message(), HasSubstr("VK_NONE_device"));
}

TEST(DeviceChoice, OpensWithWhatAWindowNeeds) {
  const auto device = Device::create({.device = {},
                                      .validate = true,
                                      .instance_extensions = {"VK_KHR_surface"},
                                      .device_extensions = {"VK_KHR_swapchain"}});
  ASSERT_TRUE(device) << device.error().message();
  EXPECT_NE((*device)->instance(), nullptr);
  EXPECT_NE((*device)->queue(), nullptr);
  EXPECT_EQ((*device)->validation_count(), 0u);
}

TEST_F(GpuTest, ASiblingWorksBesideItsDevice) {
  auto sibling = device->sibling();
  ASSERT_TRUE(sibling) << sibling.error().message();
  EXPECT_EQ((*sibling)->info().name, device->info().name);
  EXPECT_NE((*sibling)->handle(), device->handle());
  const TypedBuffer<uint32_t> values(**sibling, "values", 64);
  CommandList list = (*sibling)->begin();
  list.fill(values, 6);
  EXPECT_EQ((*sibling)->readback_rows(values, 0, 64, (*sibling)->submit(std::move(list))),
            std::vector<uint32_t>(64, 6));
  EXPECT_EQ(device->last_submitted(), 0u);
}

std::string refusal(const std::function<void()>& make) {
  try {
    make();
  } catch (const MachineError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::device_lost);
    return error.what();
  }
  return {};
}

TEST_F(GpuTest, RefusesWhatIsTooLarge) {
  // One texel more than a view may have, of one byte each.
  const uint64_t texels = device->info().max_texel_elements + 1;
  if (texels <= device->info().max_allocation_bytes && texels < (uint64_t{1} << 30)) {
    const Buffer buffer(*device, {"texels", texels, Usage::uniform_texel});
    EXPECT_THAT(refusal([&] { TexelView(*device, buffer, VK_FORMAT_R8_UINT); }),
                HasSubstr("texels: expected at most " + std::to_string(texels - 1)));
    EXPECT_TRUE(TexelView(*device, buffer, VK_FORMAT_R8_UINT, 0, texels - 1));
    EXPECT_FALSE(device->fits_texel_view("texels", texels));
    EXPECT_TRUE(device->fits_texel_view("texels", texels - 1));
  }
  const uint64_t range = device->info().max_storage_range;
  if (range + 4 <= device->info().max_allocation_bytes && range < (uint64_t{1} << 30)) {
    const Buffer buffer(*device, {"rows", range + 4, Usage::storage});
    const std::vector<Binding> bindings{{0, BindingType::storage_buffer}};
    EXPECT_THAT(refusal([&] { DescriptorSet(*device, "set", bindings, {{0, buffer}}); }), HasSubstr("rows"));
    EXPECT_TRUE(DescriptorSet(*device, "set", bindings, {{0, buffer, 0, range}}));
    EXPECT_FALSE(device->fits_storage_range("rows", range + 4));
    EXPECT_TRUE(device->fits_storage_range("rows", range));
  }
  const uint64_t before = device->bytes_allocated();
  EXPECT_THAT(refusal([&] { Buffer(*device, {"giant", uint64_t{1} << 62}); }), HasSubstr("giant"));
  EXPECT_THAT(refusal([&] { Buffer(*device, {"giant", UINT64_MAX}); }), HasSubstr("giant"));
  EXPECT_EQ(device->bytes_allocated(), before);
}

TEST_F(GpuTest, MemoryKindsAreMappedAsPromised) {
  const Buffer upload(*device, {"upload", 100, Usage::none, Memory::upload});
  const Buffer readback(*device, {"readback", 100, Usage::none, Memory::readback});
  const Buffer local(*device, {"local", 100});
  ASSERT_NE(upload.mapped(), nullptr);
  ASSERT_NE(readback.mapped(), nullptr);
  EXPECT_EQ(local.mapped() != nullptr, device->unified_memory());
  for (int i = 0; i < 100; ++i) upload.mapped()[i] = static_cast<std::byte>(i);
  CommandList list = device->begin();
  list.copy(upload, 0, local, 0, 100);
  list.barrier();
  list.copy(local, 0, readback, 0, 100);
  device->wait(device->submit(std::move(list)));
  for (int i = 0; i < 100; ++i) ASSERT_EQ(readback.mapped()[i], static_cast<std::byte>(i));
}

TEST(Validation, HearsMisuse) {
  auto made = Device::create({.device = {}, .validate = true, .validate_synchronization = true});
  ASSERT_TRUE(made) << made.error().message();
  Device& device = **made;
  EXPECT_TRUE(device.validating());
  const VkBufferCreateInfo empty{
      .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = 0, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
  VkBuffer buffer = VK_NULL_HANDLE;
  vkCreateBuffer(device.handle(), &empty, nullptr, &buffer);
  vkDestroyBuffer(device.handle(), buffer, nullptr);
  EXPECT_EQ(device.validation_count(), 1u);
  EXPECT_THAT(device.validation_messages(), testing::Contains(HasSubstr("size")));
}

TEST(Validation, HearsAMissingBarrierAndNamesTheBuffer) {
  auto made = Device::create({.device = {}, .validate = true, .validate_synchronization = true});
  ASSERT_TRUE(made) << made.error().message();
  Device& device = **made;
  const TypedBuffer<uint32_t> first(device, "first", 64), second(device, "second of two", 64);
  CommandList list = device.begin();
  list.fill(first, 1);
  list.copy(first, 0, second, 0, 256);
  EXPECT_GT(device.validation_count(), 0u);
  EXPECT_THAT(device.validation_messages(), testing::Contains(HasSubstr("SYNC-HAZARD")));
}

}  // namespace
}  // namespace vamp::gpu
