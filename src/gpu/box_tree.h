#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/buffer.h"
#include "gpu/device.h"

namespace vernier {

/// An axis-aligned box as drivers take it.
struct DeviceBox {
  glm::vec3 lo, hi;
};

/// The driver's own tree over boxes (VK_KHR_acceleration_structure), for ray queries: box i has the primitive index i.
/// Owns its memory; movable.
class BoxTree {
 public:
  BoxTree() = default;
  /// Has the driver of `device`, whose description says ray_query, build it over `boxes`, whose coordinates are finite
  /// with lo <= hi. Throws Error(refused) where the driver or its memory takes less.
  BoxTree(const Device& device, std::span<const DeviceBox> boxes);

  /// What queries are asked of: one instance, in place, of the tree over the boxes.
  const vk::raii::AccelerationStructureKHR& vk() const { return top_.built; }
  /// Memory that stays.
  std::uint64_t size_bytes() const { return bottom_.memory.size_bytes() + top_.memory.size_bytes(); }

 private:
  struct Structure {
    Buffer memory;
    vk::raii::AccelerationStructureKHR built{nullptr};
  };
  static Structure build(const Device& device, vk::AccelerationStructureTypeKHR type,
                         const vk::AccelerationStructureGeometryKHR& geometry, std::uint32_t count);

  Structure bottom_, top_;
};

}  // namespace vernier
