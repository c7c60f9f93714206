#include "engine/gpu/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/gpu/device.h"
#include "engine/gpu/machine.h"
#include "engine/gpu/resource.h"

namespace vamp::gpu {
namespace {

// Builds of acceleration structures find their buffers by address.
bool has_address(Usage usage) { return has(usage, Usage::ray_input) || has(usage, Usage::ray_storage); }

VkBufferUsageFlags flags_of(Usage usage) {
  VkBufferUsageFlags flags = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (has(usage, Usage::storage)) flags |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  if (has(usage, Usage::uniform_texel)) flags |= VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
  if (has(usage, Usage::storage_texel)) flags |= VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT;
  if (has(usage, Usage::uniform)) flags |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
  if (has(usage, Usage::indirect)) flags |= VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  if (has(usage, Usage::ray_input)) flags |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
  if (has(usage, Usage::ray_storage)) flags |= VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR;
  if (has_address(usage)) flags |= VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
  return flags;
}

// lavapipe compiles a kernel anew for texel buffers that differ in whether their size is a power of two, and for texel
// views that differ in whether bits 8 to 15 of their size are all 0 (it takes those for a number of mip levels): an
// edit that makes a table grow, or a window of another size, would stop the picture for a second. So none has either:
// some unused bytes at the end see to it.
uint64_t texel_buffer_bytes(uint64_t bytes) {
  bytes = std::max<uint64_t>(bytes, 272);
  if ((bytes >> 8 & 255) == 0) bytes += 256;
  return std::has_single_bit(bytes) ? bytes + 256 : bytes;
}

}  // namespace

Resource::Resource(Device& owner) : device(owner) { device.resources_.fetch_add(1, std::memory_order_relaxed); }
Resource::~Resource() { device.resources_.fetch_sub(1, std::memory_order_relaxed); }

BufferState::~BufferState() {
  vkDestroyBuffer(device.handle(), buffer, nullptr);
  vkFreeMemory(device.handle(), memory, nullptr);  // unmaps
  device.allocated_.fetch_sub(allocated, std::memory_order_relaxed);
}

ViewState::~ViewState() { vkDestroyBufferView(device.handle(), view, nullptr); }

Buffer::Buffer(Device& device, const BufferDesc& desc) {
  auto state = std::make_shared<BufferState>(device);
  state->desc = desc;
  const std::string what = fmt::format("GPU buffer '{}' of {}", desc.name, mebibytes(desc.bytes));
  // A whole number of 16-byte rows, so that fills and views of any format cover the end; never nothing.
  uint64_t bytes = std::max<uint64_t>(16, (desc.bytes + 15) / 16 * 16);
  if (has(desc.usage, Usage::uniform_texel | Usage::storage_texel)) bytes = texel_buffer_bytes(bytes);
  if (bytes < desc.bytes || bytes > device.info().max_allocation_bytes)
    throw MachineError(ErrorKind::device_lost, fmt::format("{}: this device allows at most {}", what,
                                                           mebibytes(device.info().max_allocation_bytes)));
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                .size = bytes,
                                .usage = flags_of(desc.usage),
                                .sharingMode = VK_SHARING_MODE_EXCLUSIVE};
  require(vkCreateBuffer(device.handle(), &info, nullptr, &state->buffer), what);
  device.name_object(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(state->buffer), desc.name);

  // One allocation a buffer; the kind's memory type unless this buffer may not live there.
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device.handle(), state->buffer, &needs);
  const auto kind = static_cast<size_t>(desc.memory);
  CHECK(needs.memoryTypeBits & (1u << device.memory_type_[kind]));
  const VkMemoryAllocateFlagsInfo flags{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO,
                                        .flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT};
  const VkMemoryAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                      .pNext = has_address(desc.usage) ? &flags : nullptr,
                                      .allocationSize = needs.size,
                                      .memoryTypeIndex = device.memory_type_[kind]};
  require(vkAllocateMemory(device.handle(), &allocate, nullptr, &state->memory),
          fmt::format("{} ({} allocated so far)", what, mebibytes(device.allocated_)));
  state->bytes = bytes;
  state->allocated = needs.size;
  device.allocated_.fetch_add(needs.size, std::memory_order_relaxed);
  require(vkBindBufferMemory(device.handle(), state->buffer, state->memory, 0), what);
  if (device.memory_flags_[kind] & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) {
    void* mapped = nullptr;
    require(vkMapMemory(device.handle(), state->memory, 0, VK_WHOLE_SIZE, 0, &mapped), what);
    state->mapped = static_cast<std::byte*>(mapped);
    state->host_cached = device.memory_flags_[kind] & VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  }
  state_ = std::move(state);
}

VkBuffer Buffer::handle() const { return state_ ? state_->buffer : VK_NULL_HANDLE; }
uint64_t Buffer::bytes() const { return state_ ? state_->desc.bytes : 0; }
Usage Buffer::usage() const { return state_ ? state_->desc.usage : Usage::none; }
std::byte* Buffer::mapped() const { return state_ ? state_->mapped : nullptr; }
const std::string& Buffer::name() const {
  CHECK(state_);
  return state_->desc.name;
}

uint64_t texel_bytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UINT:
    case VK_FORMAT_R8_UNORM:
      return 1;
    case VK_FORMAT_R16_UINT:
    case VK_FORMAT_R16_SFLOAT:
    case VK_FORMAT_R8G8_UINT:
      return 2;
    case VK_FORMAT_R8G8B8A8_UINT:
    case VK_FORMAT_R8G8B8A8_UNORM:
    case VK_FORMAT_B8G8R8A8_UNORM:
    case VK_FORMAT_R16G16_UINT:
    case VK_FORMAT_R16G16_SFLOAT:
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32_SINT:
    case VK_FORMAT_R32_SFLOAT:
      return 4;
    case VK_FORMAT_R16G16B16A16_UINT:
    case VK_FORMAT_R16G16B16A16_SFLOAT:
    case VK_FORMAT_R32G32_UINT:
    case VK_FORMAT_R32G32_SINT:
    case VK_FORMAT_R32G32_SFLOAT:
      return 8;
    case VK_FORMAT_R32G32B32A32_UINT:
    case VK_FORMAT_R32G32B32A32_SINT:
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return 16;
    default:
      return 0;
  }
}

TexelView::TexelView(Device& device, const Buffer& buffer, VkFormat format, uint64_t offset, uint64_t bytes) {
  CHECK(buffer && texel_bytes(format) > 0);
  CHECK(has(buffer.usage(), Usage::uniform_texel | Usage::storage_texel));
  CHECK(offset % device.info().texel_offset_alignment == 0 && offset <= buffer.bytes());
  if (bytes == VK_WHOLE_SIZE) bytes = buffer.bytes() - offset;
  CHECK(bytes <= buffer.bytes() - offset);
  const bool whole = offset == 0 && bytes == buffer.bytes();

  // Refuse what the device cannot view: too many texels, or this format.
  const uint64_t size = texel_bytes(format);
  const uint64_t texels = bytes / size;
  if (auto fits = device.fits_texel_view(buffer.name(), texels); !fits)
    throw MachineError(ErrorKind::device_lost, fits.error().message());
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device.physical(), format, &properties);
  VkFormatFeatureFlags wanted = 0;
  if (has(buffer.usage(), Usage::uniform_texel)) wanted |= VK_FORMAT_FEATURE_UNIFORM_TEXEL_BUFFER_BIT;
  if (has(buffer.usage(), Usage::storage_texel)) wanted |= VK_FORMAT_FEATURE_STORAGE_TEXEL_BUFFER_BIT;
  if ((properties.bufferFeatures & wanted) != wanted)
    throw MachineError(ErrorKind::device_lost,
                       fmt::format("GPU buffer '{}': {} cannot view it as texels of format {}", buffer.name(),
                                   device.info().name, static_cast<int>(format)));

  auto state = std::make_shared<ViewState>(device);
  state->buffer = buffer.state();
  state->format = format;
  state->texels = texels;
  // An empty view still needs a texel: buffers are never smaller than 16 bytes. A whole one takes the bytes at the
  // buffer's end along, for which see there.
  uint64_t range = std::max<uint64_t>(texels, 1) * size;
  if (whole && buffer.state()->bytes / size <= device.info().max_texel_elements)
    range = buffer.state()->bytes / size * size;
  const VkBufferViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO,
                                    .buffer = buffer.handle(),
                                    .format = format,
                                    .offset = texels > 0 ? offset : 0,
                                    .range = range};
  require(vkCreateBufferView(device.handle(), &info, nullptr, &state->view), "GPU view of '" + buffer.name() + "'");
  device.name_object(VK_OBJECT_TYPE_BUFFER_VIEW, reinterpret_cast<uint64_t>(state->view), buffer.name());
  state_ = std::move(state);
}

VkBufferView TexelView::handle() const { return state_ ? state_->view : VK_NULL_HANDLE; }
uint64_t TexelView::texels() const { return state_ ? state_->texels : 0; }

}  // namespace vamp::gpu
