#include "gpu/device.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string_view>

#include "error.h"
#include "gpu/vector_width.h"
#include "gpu/vk_check.h"

namespace vernier {
namespace {

// Ray queries, and what they ask for.
constexpr std::array kRayQueryExtensions = {VK_KHR_RAY_QUERY_EXTENSION_NAME,
                                            VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                            VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};

std::optional<std::uint32_t> compute_queue_family(const vk::raii::PhysicalDevice& physical) {
  const std::vector<vk::QueueFamilyProperties> families = physical.getQueueFamilyProperties();
  for (std::uint32_t index = 0; index < families.size(); ++index) {
    if (families[index].queueFlags & vk::QueueFlagBits::eCompute) return index;
  }
  return std::nullopt;
}

const char* kind_name(vk::PhysicalDeviceType type) {
  switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
      return "discrete GPU";
    case vk::PhysicalDeviceType::eIntegratedGpu:
      return "integrated GPU";
    case vk::PhysicalDeviceType::eVirtualGpu:
      return "virtual GPU";
    case vk::PhysicalDeviceType::eCpu:
      return "CPU";
    default:
      return "other";
  }
}

std::string version_text(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

std::string hexadecimal(std::uint64_t number, int digits) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%0*llx", digits, static_cast<unsigned long long>(number));
  return text.data();
}

std::string pipeline_key(const vk::PhysicalDeviceProperties& properties) {
  std::string key = hexadecimal(properties.vendorID, 8) + "-" + hexadecimal(properties.deviceID, 8) + "-" +
                    hexadecimal(properties.driverVersion, 8) + "-";
  for (const std::uint8_t byte : properties.pipelineCacheUUID) key += hexadecimal(byte, 2);
  return key;
}

void describe_limits(const vk::PhysicalDeviceLimits& limits, DeviceDescription& out) {
  out.max_storage_buffer_range_bytes = limits.maxStorageBufferRange;
  out.max_texel_buffer_elements = limits.maxTexelBufferElements;
  out.max_workgroup_invocations = limits.maxComputeWorkGroupInvocations;
  out.max_storage_buffers = limits.maxPerStageDescriptorStorageBuffers;
  out.max_storage_texel_buffers = limits.maxPerStageDescriptorStorageImages;
  out.timestamp_period_ns = limits.timestampPeriod;
}

void describe_memory(const vk::PhysicalDeviceMemoryProperties& memory, DeviceDescription& out) {
  for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap) {
    if (memory.memoryHeaps[heap].flags & vk::MemoryHeapFlagBits::eDeviceLocal) {
      out.device_memory_bytes = std::max<std::uint64_t>(out.device_memory_bytes, memory.memoryHeaps[heap].size);
    }
  }
}

/// What only devices of version 1.2 can be asked for.
void describe_vulkan_12(const vk::raii::PhysicalDevice& physical, DeviceDescription& out) {
  const auto properties = physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceVulkan11Properties,
                                                  vk::PhysicalDeviceVulkan12Properties>();
  const auto& vulkan_11 = properties.get<vk::PhysicalDeviceVulkan11Properties>();
  const auto& vulkan_12 = properties.get<vk::PhysicalDeviceVulkan12Properties>();
  out.driver = std::string(vulkan_12.driverName.data());
  if (vulkan_12.driverInfo[0] != '\0') out.driver += " " + std::string(vulkan_12.driverInfo.data());
  out.is_llvmpipe = vulkan_12.driverID == vk::DriverId::eMesaLlvmpipe;
  out.max_allocation_bytes = vulkan_11.maxMemoryAllocationSize;
  out.subgroup_size = vulkan_11.subgroupSize;
  out.subgroup_ballot = (vulkan_11.subgroupSupportedStages & vk::ShaderStageFlagBits::eCompute) &&
                        (vulkan_11.subgroupSupportedOperations & vk::SubgroupFeatureFlagBits::eBallot);
  const auto features = physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>();
  out.float64 = features.get<vk::PhysicalDeviceFeatures2>().features.shaderFloat64 == VK_TRUE;
  if (features.get<vk::PhysicalDeviceVulkan12Features>().scalarBlockLayout != VK_TRUE) {
    out.unusable_reason = "no scalar block layout";
  }
}

/// Whether a device of version 1.2 has ray queries.
bool has_ray_query(const vk::raii::PhysicalDevice& physical) {
  const std::vector<vk::ExtensionProperties> offered = physical.enumerateDeviceExtensionProperties();
  for (const std::string_view wanted : kRayQueryExtensions) {
    const auto is_wanted = [&](const vk::ExtensionProperties& one) { return wanted == one.extensionName.data(); };
    if (std::ranges::none_of(offered, is_wanted)) return false;
  }
  const auto features =
      physical
          .getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                        vk::PhysicalDeviceAccelerationStructureFeaturesKHR, vk::PhysicalDeviceRayQueryFeaturesKHR>();
  return features.get<vk::PhysicalDeviceVulkan12Features>().bufferDeviceAddress == VK_TRUE &&
         features.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().accelerationStructure == VK_TRUE &&
         features.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().rayQuery == VK_TRUE;
}

/// Why ray queries, where the driver of Vulkan 1.2 has them, are of no use; empty where they are.
std::string describe_ray_queries(const vk::raii::PhysicalDevice& physical, const DeviceDescription& device) {
  if (!has_ray_query(physical)) return "its driver has no ray queries (VK_KHR_ray_query)";
  // With 16 lanes Mesa 26.1.6 smashes its stack while it builds a tree, with 4 it does not end. 25.0.7 builds with 16;
  // what came between has not been tried.
  constexpr std::uint32_t kFirstUntried = VK_MAKE_API_VERSION(0, 25, 1, 0);
  if (device.is_llvmpipe && device.subgroup_size != 8 && physical.getProperties().driverVersion >= kFirstUntried) {
    return "its driver has ray queries with vectors of 256 bits alone (LP_NATIVE_VECTOR_WIDTH=256)";
  }
  return "";
}

/// Opens `physical` with one queue of `family` and the features that `description` tells of.
vk::raii::Device open(const vk::raii::PhysicalDevice& physical, const DeviceDescription& description,
                      std::uint32_t family, std::vector<const char*> extensions) {
  const float priority = 1.0F;
  const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
  vk::StructureChain<vk::DeviceCreateInfo, vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features,
                     vk::PhysicalDeviceAccelerationStructureFeaturesKHR, vk::PhysicalDeviceRayQueryFeaturesKHR>
      chain;
  auto& vulkan_12 = chain.get<vk::PhysicalDeviceVulkan12Features>();
  vulkan_12.scalarBlockLayout = VK_TRUE;
  if (description.ray_query) {
    extensions.insert(extensions.end(), kRayQueryExtensions.begin(), kRayQueryExtensions.end());
    vulkan_12.bufferDeviceAddress = VK_TRUE;
    chain.get<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>().accelerationStructure = VK_TRUE;
    chain.get<vk::PhysicalDeviceRayQueryFeaturesKHR>().rayQuery = VK_TRUE;
  } else {
    chain.unlink<vk::PhysicalDeviceAccelerationStructureFeaturesKHR>();
    chain.unlink<vk::PhysicalDeviceRayQueryFeaturesKHR>();
  }
  chain.get<vk::DeviceCreateInfo>().setQueueCreateInfos(queue).setPEnabledExtensionNames(extensions);
  return {physical, chain.get<vk::DeviceCreateInfo>()};
}

DeviceDescription describe(const vk::raii::PhysicalDevice& physical, int index) {
  const vk::PhysicalDeviceProperties properties = physical.getProperties();
  DeviceDescription out;
  out.index = index;
  out.name = without_vector_width(properties.deviceName.data());
  out.kind = kind_name(properties.deviceType);
  out.is_cpu = properties.deviceType == vk::PhysicalDeviceType::eCpu;
  out.api_version = version_text(properties.apiVersion);
  out.pipeline_key = pipeline_key(properties);
  describe_limits(properties.limits, out);
  describe_memory(physical.getMemoryProperties(), out);
  if (properties.apiVersion < VK_API_VERSION_1_2) {
    out.driver = "version " + std::to_string(properties.driverVersion);
    out.unusable_reason = "Vulkan " + out.api_version + ", 1.2 is needed";
  } else {
    describe_vulkan_12(physical, out);
    out.no_ray_query_reason = describe_ray_queries(physical, out);
    out.ray_query = out.no_ray_query_reason.empty();
  }
  constexpr std::uint32_t kStorageBuffers = 13;  // those of the trace kernel
  if (out.unusable_reason.empty() && out.max_storage_buffers < kStorageBuffers) {
    out.unusable_reason = std::to_string(out.max_storage_buffers) + " storage buffers for a shader, " +
                          std::to_string(kStorageBuffers) + " are needed";
  }
  const std::optional<std::uint32_t> family = compute_queue_family(physical);
  if (family) {
    out.timestamp_bits = physical.getQueueFamilyProperties()[*family].timestampValidBits;
  } else if (out.unusable_reason.empty()) {
    out.unusable_reason = "no compute queue";
  }
  out.usable = out.unusable_reason.empty();
  return out;
}

}  // namespace

std::vector<DeviceDescription> list_devices(const VulkanInstance& instance) {
  std::vector<DeviceDescription> out;
  try {
    for (const vk::raii::PhysicalDevice& physical : vk::raii::PhysicalDevices(instance.vk())) {
      out.push_back(describe(physical, static_cast<int>(out.size())));
    }
  } catch (const vk::SystemError& error) {
    throw Error(ErrorKind::no_device, std::string("Vulkan: the devices cannot be listed: ") + error.what());
  }
  return out;
}

Device::Device(const VulkanInstance& instance, const DeviceDescription& description,
               std::span<const std::byte> compiled_pipelines, const std::vector<const char*>& extensions)
    : description_(description) {
  if (!description.usable) {
    throw Error(ErrorKind::no_device, "device " + std::to_string(description.index) + " (" + description.name +
                                          ") is not usable: " + description.unusable_reason);
  }
  const std::string what = "opening device " + std::to_string(description.index) + " (" + description.name + ")";
  vk_check(what.c_str(), [&] {
    vk::raii::PhysicalDevices all(instance.vk());
    physical_ = std::move(all.at(static_cast<std::size_t>(description.index)));
    memory_ = physical_.getMemoryProperties();
    queue_family_ = compute_queue_family(physical_).value();
    device_ = open(physical_, description, queue_family_, extensions);
    queue_ = vk::raii::Queue(device_, queue_family_, 0);
    const vk::PipelineCacheCreateInfo cache({}, compiled_pipelines.size(), compiled_pipelines.data());
    pipeline_cache_ = vk::raii::PipelineCache(device_, cache);
  });
}

std::vector<std::byte> Device::compiled_pipelines() const {
  return vk_check("reading compiled pipelines", [&] {
    const std::vector<std::uint8_t> bytes = pipeline_cache_.getData();
    const std::span<const std::byte> view = std::as_bytes(std::span(bytes));
    return std::vector<std::byte>(view.begin(), view.end());
  });
}

}  // namespace vernier
