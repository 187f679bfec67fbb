#include "ray_query_device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace vernier {
namespace {

constexpr std::array kExtensions = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_RAY_QUERY_EXTENSION_NAME,
                                    VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
constexpr std::uint32_t kTimestamps = 2;

vk::raii::Device open(const Device& device) {
  const float priority = 1.0f;
  const vk::DeviceQueueCreateInfo queue({}, device.queue_family(), 1, &priority);
  vk::StructureChain<vk::DeviceCreateInfo, vk::PhysicalDeviceVulkan12Features,
                     vk::PhysicalDeviceAccelerationStructureFeaturesKHR, vk::PhysicalDeviceRayQueryFeaturesKHR>
      chain;
  chain.get<vk::DeviceCreateInfo>().setQueueCreateInfos(queue).setPEnabledExtensionNames(kExtensions);
  chain.get<vk::PhysicalDeviceVulkan12Features>().bufferDeviceAddress = VK_TRUE;
  chain.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().accelerationStructure = VK_TRUE;
  chain.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().rayQuery = VK_TRUE;
  return {device.physical(), chain.get<vk::DeviceCreateInfo>()};
}

}  // namespace

bool RayQueryDevice::is_offered(const Device& device) {
  const std::vector<vk::ExtensionProperties> offered = device.physical().enumerateDeviceExtensionProperties();
  return std::all_of(kExtensions.begin(), kExtensions.end(), [&](std::string_view wanted) {
    return std::any_of(offered.begin(), offered.end(),
                       [&](const vk::ExtensionProperties& one) { return wanted == one.extensionName.data(); });
  });
}

RayQueryDevice::RayQueryDevice(const Device& device)
    : opened_(&device),
      device_(open(device)),
      queue_(device_, device.queue_family(), 0),
      pool_(device_, vk::CommandPoolCreateInfo({}, device.queue_family())),
      queries_(device_, vk::QueryPoolCreateInfo({}, vk::QueryType::eTimestamp, kTimestamps)) {}

std::uint32_t RayQueryDevice::memory_type(std::uint32_t allowed) const {
  using Property = vk::MemoryPropertyFlagBits;
  const vk::PhysicalDeviceMemoryProperties memory = opened_->physical().getMemoryProperties();
  const vk::MemoryPropertyFlags needed = Property::eHostVisible | Property::eHostCoherent;
  for (const vk::MemoryPropertyFlags wanted : {needed | Property::eDeviceLocal, needed}) {
    for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
      if ((allowed >> type & 1u) != 0 && (memory.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
    }
  }
  throw std::runtime_error("the device has no memory that the host sees");
}

AddressedBuffer RayQueryDevice::make_buffer(std::size_t bytes, vk::BufferUsageFlags usage) const {
  AddressedBuffer made;
  usage |= vk::BufferUsageFlagBits::eShaderDeviceAddress;
  made.buffer = device_.createBuffer(vk::BufferCreateInfo({}, bytes, usage));
  const vk::MemoryRequirements needs = made.buffer.getMemoryRequirements();
  vk::StructureChain<vk::MemoryAllocateInfo, vk::MemoryAllocateFlagsInfo> chain;
  chain.get<vk::MemoryAllocateInfo>()
      .setAllocationSize(needs.size)
      .setMemoryTypeIndex(memory_type(needs.memoryTypeBits));
  chain.get<vk::MemoryAllocateFlagsInfo>().setFlags(vk::MemoryAllocateFlagBits::eDeviceAddress);
  made.memory = device_.allocateMemory(chain.get<vk::MemoryAllocateInfo>());
  made.buffer.bindMemory(*made.memory, 0);
  made.mapped = {static_cast<std::byte*>(made.memory.mapMemory(0, VK_WHOLE_SIZE)), bytes};
  made.address = device_.getBufferAddress(vk::BufferDeviceAddressInfo(*made.buffer));
  if (usage & vk::BufferUsageFlagBits::eStorageTexelBuffer) {
    made.view = device_.createBufferView(
        vk::BufferViewCreateInfo({}, *made.buffer, vk::Format::eR32G32B32A32Uint, 0, VK_WHOLE_SIZE));
  }
  return made;
}

AddressedBuffer RayQueryDevice::make_filled(std::span<const std::byte> bytes, vk::BufferUsageFlags usage) const {
  AddressedBuffer made = make_buffer(bytes.size(), usage);
  std::memcpy(made.mapped.data(), bytes.data(), bytes.size());
  return made;
}

double RayQueryDevice::run(const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
  using Stage = vk::PipelineStageFlagBits;
  const vk::raii::CommandBuffers all(device_,
                                     vk::CommandBufferAllocateInfo(*pool_, vk::CommandBufferLevel::ePrimary, 1));
  const vk::raii::CommandBuffer& commands = all.front();
  const bool timed = opened_->description().timestamps;
  const auto start = std::chrono::steady_clock::now();
  commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  if (timed) {
    commands.resetQueryPool(*queries_, 0, kTimestamps);
    commands.writeTimestamp(Stage::eTopOfPipe, *queries_, 0);
  }
  record(commands);
  if (timed) commands.writeTimestamp(Stage::eBottomOfPipe, *queries_, 1);
  const vk::MemoryBarrier to_all(vk::AccessFlagBits::eMemoryWrite,
                                 vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eHostRead);
  commands.pipelineBarrier(Stage::eAllCommands, Stage::eAllCommands | Stage::eHost, {}, to_all, nullptr, nullptr);
  commands.end();
  const vk::raii::Fence fence = device_.createFence({});
  const vk::CommandBuffer submitted = *commands;
  queue_.submit(vk::SubmitInfo(nullptr, nullptr, submitted), *fence);
  if (device_.waitForFences(*fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()) != vk::Result::eSuccess) {
    throw std::runtime_error("ray queries: the device does not answer");
  }
  if (!timed) return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto [result, ticks] =
      queries_.getResults<std::uint64_t>(0, kTimestamps, kTimestamps * sizeof(std::uint64_t), sizeof(std::uint64_t),
                                         vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
  constexpr double kSecondsPerNs = 1e-9;
  return static_cast<double>(ticks[1] - ticks[0]) * opened_->description().timestamp_period_ns * kSecondsPerNs;
}

}  // namespace vernier
