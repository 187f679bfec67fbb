#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/instance.h"
#include "gpu/pipeline_store.h"

namespace vernier {

/// What there is to know of a device before it is opened.
struct DeviceDescription {
  int index = 0;  ///< position in the loader's order; what `--device` takes
  std::string name;
  std::string kind;         ///< discrete GPU, integrated GPU, virtual GPU, CPU, other
  std::string driver;       ///< driver name and its own version text
  std::string api_version;  ///< 1.3.230
  std::string
      pipeline_key;     ///< hexadecimal: what compiled pipelines are bound to: vendor, device, driver version, UUID
  bool usable = false;  ///< Vulkan 1.2, scalar block layout, a compute queue
  std::string unusable_reason;
  bool is_cpu = false;
  bool float64 = false;  ///< shaders may use it; ours do not
  bool is_llvmpipe = false;
  std::uint64_t max_storage_buffer_range_bytes = 0;
  std::uint32_t max_texel_buffer_elements = 0;
  std::uint64_t max_allocation_bytes = 0;
  std::uint64_t device_memory_bytes = 0;  ///< largest device-local heap
  std::uint32_t max_workgroup_invocations = 0;
  std::uint32_t subgroup_size = 0;
  bool subgroup_ballot = false;      ///< invocations of a compute subgroup can vote
  bool ray_query = false;            ///< the driver builds trees of boxes and finds those that a ray meets
  std::string no_ray_query_reason;   ///< empty where ray_query
  std::uint32_t timestamp_bits = 0;  ///< of a timestamp that count; 0: the device has none
  double timestamp_period_ns = 0.0;
  /// Storage buffers a shader stage may bind.
  std::uint32_t max_storage_buffers = 0;
  /// The same of storage texel buffers, which count as storage images.
  std::uint32_t max_storage_texel_buffers = 0;
};

/// All devices of `instance` in the loader's order.
std::vector<DeviceDescription> list_devices(const VulkanInstance& instance);

/// The device that `selector` means: empty: the best usable one (discrete GPU, integrated, virtual, CPU; the lower
/// index among equals; llvmpipe before other CPU devices); a number: that index; otherwise the name or a part of
/// it, any case; a whole name comes before a part of another. Throws Error(no_device) that lists what there is.
DeviceDescription choose_device(const std::vector<DeviceDescription>& devices, const std::string& selector);

/// An opened device with one compute queue. Features asked for: scalar block layout only (and ray
/// queries, with what they need, where `ray_query`).
class Device {
 public:
  /// Opens `description`, which list_devices(instance) gave. `instance` outlives the device. `compiled_pipelines`: what
  /// a device of the same pipeline_key gave before; a driver that does not want it compiles anew. `extensions`: names
  /// of device extensions that a window asks for. Throws Error(no_device) where the device is not usable.
  Device(const VulkanInstance& instance, const DeviceDescription& description,
         std::span<const std::byte> compiled_pipelines = {}, const std::vector<const char*>& extensions = {});

  const DeviceDescription& description() const { return description_; }
  const vk::raii::PhysicalDevice& physical() const { return physical_; }
  const vk::raii::Device& vk() const { return device_; }
  const vk::raii::Queue& queue() const { return queue_; }
  std::uint32_t queue_family() const { return queue_family_; }
  const vk::PhysicalDeviceMemoryProperties& memory() const { return memory_; }
  /// Where pipelines are looked up before they are compiled, and put.
  const vk::raii::PipelineCache& pipeline_cache() const { return pipeline_cache_; }
  /// Those that this device compiled.
  PipelineStore& pipelines() const { return *pipelines_; }
  /// All pipelines compiled so far, those the device was opened with among them, as the driver writes them.
  std::vector<std::byte> compiled_pipelines() const;

 private:
  DeviceDescription description_;
  vk::raii::PhysicalDevice physical_{nullptr};
  vk::PhysicalDeviceMemoryProperties memory_;
  vk::raii::Device device_{nullptr};
  std::uint32_t queue_family_ = 0;
  vk::raii::Queue queue_{nullptr};
  vk::raii::PipelineCache pipeline_cache_{nullptr};
  std::unique_ptr<PipelineStore> pipelines_ = std::make_unique<PipelineStore>();  // gone before the device is
};

}  // namespace vernier
