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

/// The driver's own tree (VK_KHR_acceleration_structure), for ray queries: box or triangle i has the primitive index i.
/// Owns its memory; movable.
class DriverTree {
 public:
  DriverTree() = default;
  /// Has the driver of `device`, whose description says ray_query, build it over `boxes`, whose coordinates are finite
  /// with lo <= hi. Throws Error(refused) where the driver or its memory takes less.
  DriverTree(const Device& device, std::span<const DeviceBox> boxes);
  /// The same over opaque triangles, whose corners are numbers of positions, to be met by the driver's own test.
  DriverTree(const Device& device, std::span<const glm::vec3> positions, std::span<const glm::uvec3> corners);

  /// What queries are asked of: one instance, in place, of the tree over all.
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
  void build_both(const Device& device, const vk::AccelerationStructureGeometryKHR& geometry, std::size_t count);

  Structure bottom_, top_;
};

}  // namespace vernier
