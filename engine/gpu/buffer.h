#pragma once
// Memory on the device: buffers, what is inside them, and texel views of them.
#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

namespace vamp::gpu {

class Device;
struct BufferState;
struct ViewState;

// What a buffer is for; combine with |. Copies from and to a buffer are always allowed.
enum class Usage : uint32_t {
  none = 0,
  storage = 1,        // buffer { ... } in GLSL
  uniform_texel = 2,  // samplerBuffer, usamplerBuffer: read only, twice as fast as storage on lavapipe 22
  storage_texel = 4,  // imageBuffer, uimageBuffer
  uniform = 8,        // uniform { ... }
  indirect = 16,      // arguments of dispatch_indirect
  // Where the device has ray queries:
  ray_input = 32,    // what an AccelerationStructure is built of
  ray_storage = 64,  // what it lies in
};
constexpr Usage operator|(Usage a, Usage b) {
  return static_cast<Usage>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
constexpr bool has(Usage set, Usage flag) { return (static_cast<uint32_t>(set) & static_cast<uint32_t>(flag)) != 0; }

enum class Memory {
  device,    // fastest for kernels; mapped as well where the device shares the host's memory (lavapipe)
  upload,    // written by the host, mapped
  readback,  // read by the host, mapped and cached
};

struct BufferDesc {
  std::string name;  // for messages and the validation layer
  uint64_t bytes = 0;
  Usage usage = Usage::storage;
  Memory memory = Memory::device;
};

// One buffer with memory of its own. Contents are undefined until written. Descriptor sets and command lists that use
// a buffer keep its memory alive, so a handle may go at any time; the memory is freed once the device is done with it.
class Buffer {
 public:
  Buffer() = default;
  // Throws MachineError when memory runs out. 0 bytes are allowed (and take 16).
  Buffer(Device& device, const BufferDesc& desc);

  explicit operator bool() const { return state_ != nullptr; }
  VkBuffer handle() const;
  uint64_t bytes() const;  // as asked for
  Usage usage() const;
  const std::string& name() const;
  // The host's view of the memory, coherent; nullptr where the host cannot see it. Whoever writes through it must know
  // that the device is not reading; Device::upload knows by itself.
  std::byte* mapped() const;
  const std::shared_ptr<BufferState>& state() const { return state_; }

  Buffer(Buffer&&) noexcept = default;
  Buffer& operator=(Buffer&&) noexcept = default;

 private:
  std::shared_ptr<BufferState> state_;
};

// A buffer of `count` rows of T.
template <class T>
class TypedBuffer : public Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  TypedBuffer() = default;
  TypedBuffer(Device& device, const std::string& name, uint64_t count, Usage usage = Usage::storage,
              Memory memory = Memory::device)
      : Buffer(device, BufferDesc{name, count * sizeof(T), usage, memory}) {}
  uint64_t count() const { return *this ? bytes() / sizeof(T) : 0; }
  // Empty where the host cannot see the memory.
  std::span<T> mapped_rows() const {
    if (!mapped()) return {};
    return {reinterpret_cast<T*>(mapped()), static_cast<size_t>(count())};
  }
};

// A buffer seen as texels of one format, for samplerBuffer and imageBuffer (after the buffer's usage).
class TexelView {
 public:
  TexelView() = default;
  // The bytes [offset, offset + bytes) of the buffer, the whole rest by default. Throws MachineError when the view has
  // more texels than the device allows or the device cannot view the format so; Device::fits_texel_view asks first.
  TexelView(Device& device, const Buffer& buffer, VkFormat format, uint64_t offset = 0, uint64_t bytes = VK_WHOLE_SIZE);

  explicit operator bool() const { return state_ != nullptr; }
  VkBufferView handle() const;
  uint64_t texels() const;
  const std::shared_ptr<ViewState>& state() const { return state_; }

  TexelView(TexelView&&) noexcept = default;
  TexelView& operator=(TexelView&&) noexcept = default;

 private:
  std::shared_ptr<ViewState> state_;
};

// Bytes of one texel of the formats that texel views take: 1, 2 and 4 channels of 8, 16 and 32 bits.
uint64_t texel_bytes(VkFormat format);

}  // namespace vamp::gpu
