#include "engine/gpu/acceleration_structure.h"

#include <algorithm>
#include <cstring>

#include "engine/core/check.h"
#include "engine/gpu/acceleration_state.h"
#include "engine/gpu/command_list.h"
#include "engine/gpu/device.h"
#include "engine/gpu/machine.h"

namespace vamp::gpu {
namespace {

constexpr const char* kExtensions[] = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_RAY_QUERY_EXTENSION_NAME,
                                       VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
constexpr VkDeviceSize kCornerBytes = 16;

VkDeviceAddress address_of(const Device& device, VkBuffer buffer) {
  const VkBufferDeviceAddressInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO, .buffer = buffer};
  return vkGetBufferDeviceAddress(device.handle(), &info);
}

uint64_t scratch_alignment(const Device& device) {
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &structures};
  vkGetPhysicalDeviceProperties2(device.physical(), &properties);
  return structures.minAccelerationStructureScratchOffsetAlignment;
}

// What one level is built of.
struct Recipe {
  VkAccelerationStructureGeometryKHR geometry{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
  VkAccelerationStructureBuildGeometryInfoKHR info{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
  uint32_t primitives;

  Recipe(VkAccelerationStructureTypeKHR type, uint32_t count) : primitives(count) {
    info.type = type;
    info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
    info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
    info.geometryCount = 1;
    info.pGeometries = &geometry;
  }
  Recipe(const Recipe&) = delete;
  Recipe& operator=(const Recipe&) = delete;
};

struct BottomRecipe : Recipe {
  explicit BottomRecipe(const AccelerationState& state)
      : Recipe(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, state.triangles) {
    geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
    geometry.geometry.triangles = {.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR,
                                   .vertexFormat = VK_FORMAT_R32G32B32_SFLOAT,
                                   .vertexData = {.deviceAddress = address_of(state.device, state.corners->buffer)},
                                   .vertexStride = kCornerBytes,
                                   .maxVertex = std::max(3 * state.triangles, 1u) - 1,
                                   .indexType = VK_INDEX_TYPE_NONE_KHR};
  }
};

struct TopRecipe : Recipe {
  explicit TopRecipe(const AccelerationState& state) : Recipe(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, 1) {
    geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
    geometry.geometry.instances = {.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR,
                                   .data = {.deviceAddress = address_of(state.device, state.instance.handle())}};
  }
};

void make_level(AccelerationState& state, AccelerationState::Level& level, const Recipe& recipe,
                const std::string& name) {
  VkAccelerationStructureBuildSizesInfoKHR sizes{VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
  state.calls.sizes(state.device.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &recipe.info,
                    &recipe.primitives, &sizes);
  level.scratch_bytes = sizes.buildScratchSize;
  level.memory =
      Buffer(state.device, {.name = name, .bytes = sizes.accelerationStructureSize, .usage = Usage::ray_storage});
  const VkAccelerationStructureCreateInfoKHR info{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR,
                                                  .buffer = level.memory.handle(),
                                                  .size = sizes.accelerationStructureSize,
                                                  .type = recipe.info.type};
  require(state.calls.create(state.device.handle(), &info, nullptr, &level.handle), "GPU rays '" + name + "'");
}

// What one build wrote is seen by what follows in these stages.
void barrier_after_build(VkCommandBuffer commands, VkPipelineStageFlags to, VkAccessFlags reads) {
  const VkMemoryBarrier memory{
      .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
      .srcAccessMask = VK_ACCESS_ACCELERATION_STRUCTURE_READ_BIT_KHR | VK_ACCESS_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
      .dstAccessMask = reads};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ACCELERATION_STRUCTURE_BUILD_BIT_KHR, to, 0, 1, &memory, 0, nullptr,
                       0, nullptr);
}

}  // namespace

bool has_ray_queries(VkPhysicalDevice physical) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> present(count);
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, present.data());
  const bool extended = std::all_of(std::begin(kExtensions), std::end(kExtensions), [&](const char* wanted) {
    return std::any_of(present.begin(), present.end(),
                       [wanted](const auto& e) { return std::strcmp(e.extensionName, wanted) == 0; });
  });
  if (!extended) return false;
  RayQueryFeatures has;
  VkPhysicalDeviceVulkan12Features vulkan12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &has.structures};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &vulkan12};
  vkGetPhysicalDeviceFeatures2(physical, &features);
  return has.structures.accelerationStructure && has.queries.rayQuery && vulkan12.bufferDeviceAddress;
}

RayQueryFeatures::RayQueryFeatures() : extensions(std::begin(kExtensions), std::end(kExtensions)) {
  structures.accelerationStructure = VK_TRUE;
  structures.pNext = &queries;
  queries.rayQuery = VK_TRUE;
}

AccelerationState::Calls::Calls(VkDevice device) {
  const auto load = [device](auto& call, const char* name) {
    call = reinterpret_cast<std::remove_reference_t<decltype(call)>>(vkGetDeviceProcAddr(device, name));
    CHECK(call);
  };
  load(create, "vkCreateAccelerationStructureKHR");
  load(destroy, "vkDestroyAccelerationStructureKHR");
  load(sizes, "vkGetAccelerationStructureBuildSizesKHR");
  load(address, "vkGetAccelerationStructureDeviceAddressKHR");
  load(build, "vkCmdBuildAccelerationStructuresKHR");
}

AccelerationState::AccelerationState(Device& owner) : Resource(owner), calls(owner.handle()) {}

AccelerationState::~AccelerationState() {
  calls.destroy(device.handle(), top.handle, nullptr);
  calls.destroy(device.handle(), bottom.handle, nullptr);
}

void AccelerationState::mark_used(uint64_t value) {
  corners->mark_used(value);
  for (const Buffer* buffer : {&instance, &bottom.memory, &top.memory}) buffer->state()->mark_used(value);
}

AccelerationStructure::AccelerationStructure(Device& device, const std::string& name, const Buffer& corners,
                                             uint32_t triangles) {
  CHECK(device.info().ray_queries && has(corners.usage(), Usage::ray_input));
  CHECK(uint64_t{triangles} * 3 * kCornerBytes <= corners.bytes());
  auto state = std::make_shared<AccelerationState>(device);
  state->triangles = triangles;
  state->corners = corners.state();
  make_level(*state, state->bottom, BottomRecipe(*state), name);

  const VkAccelerationStructureDeviceAddressInfoKHR bottom{
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR,
      .accelerationStructure = state->bottom.handle};
  const VkAccelerationStructureInstanceKHR instance{
      .transform = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
      .mask = 0xff,
      .flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR,
      .accelerationStructureReference = state->calls.address(device.handle(), &bottom)};
  state->instance = Buffer(device, {.name = name + ", instance", .bytes = sizeof(instance), .usage = Usage::ray_input});
  device.upload(state->instance, 0, std::as_bytes(std::span(&instance, 1)));
  make_level(*state, state->top, TopRecipe(*state), name + ", top level");
  state_ = std::move(state);
}

void CommandList::build(const AccelerationStructure& structure) {
  CHECK(device_ && structure);
  const AccelerationState& state = *structure.state();
  keep(structure.state());
  const uint64_t alignment = scratch_alignment(*device_);
  const Buffer scratch(*device_, {.name = "scratch of rays",
                                  .bytes = std::max(state.bottom.scratch_bytes, state.top.scratch_bytes) + alignment,
                                  .usage = Usage::storage | Usage::ray_storage});
  use(scratch);
  const VkDeviceAddress start = (address_of(*device_, scratch.handle()) + alignment - 1) / alignment * alignment;
  const auto build_level = [&](const AccelerationState::Level& level, Recipe&& recipe) {
    recipe.info.dstAccelerationStructure = level.handle;
    recipe.info.scratchData.deviceAddress = start;
    const VkAccelerationStructureBuildRangeInfoKHR range{.primitiveCount = recipe.primitives};
    const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range;
    state.calls.build(handle(), 1, &recipe.info, &ranges);
  };
  build_level(state.bottom, BottomRecipe(state));
  barrier_after_build(handle(), VK_PIPELINE_STAGE_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                      VK_ACCESS_ACCELERATION_STRUCTURE_READ_BIT_KHR | VK_ACCESS_ACCELERATION_STRUCTURE_WRITE_BIT_KHR);
  build_level(state.top, TopRecipe(state));
  barrier_after_build(handle(), VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_ACCELERATION_STRUCTURE_READ_BIT_KHR);
}

}  // namespace vamp::gpu
