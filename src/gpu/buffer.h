#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/device.h"

namespace vernier {

/// How shaders see a buffer, and where it lies.
enum class BufferUse {
  storage,               ///< read and written as a storage buffer, on the device
  storage_and_texels,    ///< the same, and read as a storage texel buffer of uvec4
  uniform,               ///< a uniform buffer, on the device
  texels_rgba32ui,       ///< read as a storage texel buffer of uvec4, on the device
  texels_r32ui,          ///< read as a storage texel buffer of uint, on the device
  storage_host_visible,  ///< a storage buffer the host maps and reads and writes between submissions (counters)
  tree_input,            ///< what a driver builds a tree from, by its address (driver_tree.h)
  tree_storage,          ///< where it puts the tree
  tree_scratch           ///< where it builds
};

/// Index of the memory type, among those of `type_bits`, that suits what the host maps (`host_visible`) or what lies on
/// the device. Throws Error(failed) where none does.
std::uint32_t memory_type_for(const Device& device, std::uint32_t type_bits, bool host_visible);

/// Device memory with one use. Owns it; movable.
class Buffer {
 public:
  Buffer() = default;
  /// Allocates `size_bytes` (0 is rounded up to 16, others to a multiple of 4) zero-filled.
  /// Throws Error(refused) with both numbers when the device's limit for this use or its memory is too small.
  Buffer(const Device& device, std::uint64_t size_bytes, BufferUse use);

  std::uint64_t size_bytes() const { return size_bytes_; }
  BufferUse use() const { return use_; }
  const vk::raii::Buffer& vk() const { return buffer_; }
  /// The texel view; only of uses with texels.
  const vk::raii::BufferView& view() const { return view_; }
  /// Where it lies on the device; only of uses for trees.
  vk::DeviceAddress address(const Device& device) const;
  /// The mapped bytes; only of storage_host_visible (else empty), valid between submissions.
  std::span<std::byte> mapped() const {
    return use_ == BufferUse::storage_host_visible ? mapped_ : std::span<std::byte>();
  }

  /// Copies `bytes` to `offset_bytes` (both multiples of 4) through a staging buffer of bounded size, or directly where
  /// the memory is the host's too; waits. A copy beyond the end throws std::logic_error; an empty one does nothing.
  void upload(const Device& device, std::span<const std::byte> bytes, std::uint64_t offset_bytes = 0);
  /// Copies the buffer from `offset_bytes` on into `bytes`; waits. Ranges as in upload.
  void download(const Device& device, std::span<std::byte> bytes, std::uint64_t offset_bytes = 0) const;
  /// Fills the buffer with zeros; waits.
  void clear(const Device& device);
  /// The same for its first `bytes`, a multiple of 4 and at least 4, or all of it where it is smaller.
  void clear_front(const Device& device, std::uint64_t bytes);

 private:
  std::uint64_t size_bytes_ = 0;
  BufferUse use_ = BufferUse::storage;
  vk::raii::DeviceMemory memory_{nullptr};
  vk::raii::Buffer buffer_{nullptr};
  vk::raii::BufferView view_{nullptr};
  std::span<std::byte> mapped_;  // of any use whose memory is cached by the host
};

}  // namespace vernier
