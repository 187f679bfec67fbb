#include "gpu/driver_tree.h"

#include <string>

#include "error.h"
#include "gpu/submission.h"
#include "gpu/vk_check.h"

namespace vernier {
namespace {

using AccelerationProperties = vk::PhysicalDeviceAccelerationStructurePropertiesKHR;

AccelerationProperties limits_of(const Device& device) {
  return device.physical()
      .getProperties2<vk::PhysicalDeviceProperties2, AccelerationProperties>()
      .get<AccelerationProperties>();
}

void check_count(const Device& device, std::size_t count) {
  const std::uint64_t most = limits_of(device).maxPrimitiveCount;
  if (count <= most) return;
  refuse("device " + device.description().name,
         "a tree of " + std::to_string(count) + " triangles is needed, and the device allows " + std::to_string(most));
}

template <typename Element>
Buffer input_of(const Device& device, std::span<const Element> elements) {
  Buffer input(device, elements.size_bytes(), BufferUse::tree_input);
  input.upload(device, std::as_bytes(elements));
  return input;
}

vk::DeviceAddress aligned(vk::DeviceAddress address, std::uint32_t alignment) {
  return (address + alignment - 1) / alignment * alignment;
}

}  // namespace

DriverTree::Structure DriverTree::build(const Device& device, vk::AccelerationStructureTypeKHR type,
                                        const vk::AccelerationStructureGeometryKHR& geometry, std::uint32_t count) {
  vk::AccelerationStructureBuildGeometryInfoKHR work(type, vk::BuildAccelerationStructureFlagBitsKHR::ePreferFastTrace);
  work.setGeometries(geometry);
  const vk::AccelerationStructureBuildSizesInfoKHR sizes =
      device.vk().getAccelerationStructureBuildSizesKHR(vk::AccelerationStructureBuildTypeKHR::eDevice, work, count);
  Structure made;
  made.memory = Buffer(device, sizes.accelerationStructureSize, BufferUse::tree_storage);
  made.built = vk_check("making a tree", [&] {
    return device.vk().createAccelerationStructureKHR(
        vk::AccelerationStructureCreateInfoKHR({}, *made.memory.vk(), 0, sizes.accelerationStructureSize, type));
  });
  const std::uint32_t alignment = limits_of(device).minAccelerationStructureScratchOffsetAlignment;
  const Buffer scratch(device, sizes.buildScratchSize + alignment, BufferUse::tree_scratch);
  work.dstAccelerationStructure = *made.built;
  work.scratchData.deviceAddress = aligned(scratch.address(device), alignment);
  const vk::AccelerationStructureBuildRangeInfoKHR range(count);
  run_transfer(device,
               [&](const vk::raii::CommandBuffer& commands) { commands.buildAccelerationStructuresKHR(work, &range); });
  return made;
}

DriverTree::DriverTree(const Device& device, std::span<const DeviceBox> boxes) {
  check_count(device, boxes.size());
  const Buffer input = input_of(device, boxes);
  const vk::AccelerationStructureGeometryAabbsDataKHR all(input.address(device), sizeof(DeviceBox));
  build_both(device, vk::AccelerationStructureGeometryKHR(vk::GeometryTypeKHR::eAabbs, all), boxes.size());
}

DriverTree::DriverTree(const Device& device, std::span<const glm::vec3> positions,
                       std::span<const glm::uvec3> corners) {
  check_count(device, corners.size());
  const Buffer vertices = input_of(device, positions);
  const Buffer indices = input_of(device, corners);
  const vk::AccelerationStructureGeometryTrianglesDataKHR all(
      vk::Format::eR32G32B32Sfloat, vertices.address(device), sizeof(glm::vec3),
      static_cast<std::uint32_t>(positions.size()) - 1, vk::IndexType::eUint32, indices.address(device));
  build_both(
      device,
      vk::AccelerationStructureGeometryKHR(vk::GeometryTypeKHR::eTriangles, all, vk::GeometryFlagBitsKHR::eOpaque),
      corners.size());
}

/// The tree over `geometry`, and the one above it that has it once.
void DriverTree::build_both(const Device& device, const vk::AccelerationStructureGeometryKHR& geometry,
                            std::size_t count) {
  bottom_ = build(device, vk::AccelerationStructureTypeKHR::eBottomLevel, geometry, static_cast<std::uint32_t>(count));
  constexpr std::uint32_t kAllRays = 0xff;
  vk::AccelerationStructureInstanceKHR instance;
  for (std::size_t axis = 0; axis < 3; ++axis) instance.transform.matrix[axis][axis] = 1.0f;
  instance.mask = kAllRays;
  instance.accelerationStructureReference = device.vk().getAccelerationStructureAddressKHR(*bottom_.built);
  const Buffer instances = input_of(device, std::span<const vk::AccelerationStructureInstanceKHR>(&instance, 1));
  const vk::AccelerationStructureGeometryInstancesDataKHR placed(VK_FALSE, instances.address(device));
  top_ = build(device, vk::AccelerationStructureTypeKHR::eTopLevel,
               vk::AccelerationStructureGeometryKHR(vk::GeometryTypeKHR::eInstances, placed), 1);
}

}  // namespace vernier
