#include "gpu/box_tree.h"

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

void check_count(const Device& device, std::size_t boxes) {
  const std::uint64_t most = limits_of(device).maxPrimitiveCount;
  if (boxes <= most) return;
  throw Error(ErrorKind::refused, "device " + device.description().name + ": a tree of " + std::to_string(boxes) +
                                      " boxes is needed, and the device allows " + std::to_string(most));
}

vk::DeviceAddress aligned(vk::DeviceAddress address, std::uint32_t alignment) {
  return (address + alignment - 1) / alignment * alignment;
}

}  // namespace

BoxTree::Structure BoxTree::build(const Device& device, vk::AccelerationStructureTypeKHR type,
                                  const vk::AccelerationStructureGeometryKHR& geometry, std::uint32_t count) {
  vk::AccelerationStructureBuildGeometryInfoKHR work(type, vk::BuildAccelerationStructureFlagBitsKHR::ePreferFastTrace);
  work.setGeometries(geometry);
  const vk::AccelerationStructureBuildSizesInfoKHR sizes =
      device.vk().getAccelerationStructureBuildSizesKHR(vk::AccelerationStructureBuildTypeKHR::eDevice, work, count);
  Structure made;
  made.memory = Buffer(device, sizes.accelerationStructureSize, BufferUse::tree_storage);
  made.built = vk_check("making a tree of boxes", [&] {
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

BoxTree::BoxTree(const Device& device, std::span<const DeviceBox> boxes) {
  check_count(device, boxes.size());
  Buffer input(device, boxes.size_bytes(), BufferUse::tree_input);
  input.upload(device, std::as_bytes(boxes));
  const vk::AccelerationStructureGeometryAabbsDataKHR all(input.address(device), sizeof(DeviceBox));
  bottom_ = build(device, vk::AccelerationStructureTypeKHR::eBottomLevel,
                  vk::AccelerationStructureGeometryKHR(vk::GeometryTypeKHR::eAabbs, all),
                  static_cast<std::uint32_t>(boxes.size()));

  constexpr std::uint32_t kAllRays = 0xff;
  vk::AccelerationStructureInstanceKHR instance;
  for (std::size_t axis = 0; axis < 3; ++axis) instance.transform.matrix[axis][axis] = 1.0f;
  instance.mask = kAllRays;
  instance.accelerationStructureReference = device.vk().getAccelerationStructureAddressKHR(*bottom_.built);
  Buffer instances(device, sizeof(instance), BufferUse::tree_input);
  instances.upload(device, std::as_bytes(std::span(&instance, 1)));
  const vk::AccelerationStructureGeometryInstancesDataKHR placed(VK_FALSE, instances.address(device));
  top_ = build(device, vk::AccelerationStructureTypeKHR::eTopLevel,
               vk::AccelerationStructureGeometryKHR(vk::GeometryTypeKHR::eInstances, placed), 1);
}

}  // namespace vernier
