#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/device.h"

namespace vernier {

/// Memory that the host sees, with an address for the driver's builds.
struct AddressedBuffer {
  vk::raii::DeviceMemory memory{nullptr};
  vk::raii::Buffer buffer{nullptr};
  vk::raii::BufferView view{nullptr};  ///< of storage texel buffers
  std::span<std::byte> mapped;
  vk::DeviceAddress address = 0;
};

/// A device opened with ray queries, which the renderer does without. Owns it.
class RayQueryDevice {
 public:
  /// Whether the driver of `device` has ray queries.
  static bool is_offered(const Device& device);
  /// Opens the physical device of `device`, which has them, once more.
  explicit RayQueryDevice(const Device& device);

  const vk::raii::Device& vk() const { return device_; }
  /// Memory of `bytes` for `usage`; with a view where that names storage texel buffers.
  AddressedBuffer make_buffer(std::size_t bytes, vk::BufferUsageFlags usage) const;
  /// The same, filled with `bytes`.
  AddressedBuffer make_filled(std::span<const std::byte> bytes, vk::BufferUsageFlags usage) const;
  /// Records by `record`, submits and waits; seconds between timestamps before and after, by the clock
  /// where there are none.
  double run(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;

 private:
  std::uint32_t memory_type(std::uint32_t allowed) const;

  const Device* opened_;
  vk::raii::Device device_{nullptr};
  vk::raii::Queue queue_{nullptr};
  vk::raii::CommandPool pool_{nullptr};
  vk::raii::QueryPool queries_{nullptr};
};

}  // namespace vernier
