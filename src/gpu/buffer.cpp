#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

#include "error.h"
#include "gpu/submission.h"
#include "gpu/vk_check.h"
#include "math/large_pages.h"

namespace vernier {
namespace {

// Large enough that the copies, not the submissions, take the time; small beside any scene that needs several.
constexpr std::uint64_t kStagingBytes = std::uint64_t{16} << 20;

using Memory = vk::MemoryPropertyFlagBits;

struct UseTraits {
  const char* name;
  vk::BufferUsageFlags usage;
  vk::Format texel_format;    ///< undefined unless read as texels
  std::uint64_t texel_bytes;  ///< 0 unless read as texels
};

UseTraits traits_of(BufferUse use) {
  using Usage = vk::BufferUsageFlagBits;
  switch (use) {
    case BufferUse::uniform:
      return {"uniform buffer", Usage::eUniformBuffer, vk::Format::eUndefined, 0};
    case BufferUse::texels_rgba32ui:
      return {"texel buffer", Usage::eStorageTexelBuffer, vk::Format::eR32G32B32A32Uint, 16};
    case BufferUse::texels_r32ui:
      return {"texel buffer", Usage::eStorageTexelBuffer, vk::Format::eR32Uint, 4};
    case BufferUse::storage_and_texels:
      return {"storage buffer", Usage::eStorageBuffer | Usage::eStorageTexelBuffer, vk::Format::eR32G32B32A32Uint, 16};
    case BufferUse::tree_input:
      return {"buffer of boxes", Usage::eAccelerationStructureBuildInputReadOnlyKHR | Usage::eShaderDeviceAddress,
              vk::Format::eUndefined, 0};
    case BufferUse::tree_storage:
      return {"tree of boxes", Usage::eAccelerationStructureStorageKHR | Usage::eShaderDeviceAddress,
              vk::Format::eUndefined, 0};
    case BufferUse::tree_scratch:
      return {"scratch buffer", Usage::eStorageBuffer | Usage::eShaderDeviceAddress, vk::Format::eUndefined, 0};
    case BufferUse::storage:
    case BufferUse::storage_host_visible:
      break;
  }
  return {"storage buffer", Usage::eStorageBuffer, vk::Format::eUndefined, 0};
}

[[noreturn]] void refuse(const Device& device, const UseTraits& traits, std::uint64_t bytes, const std::string& limit) {
  throw Error(ErrorKind::refused, "device " + device.description().name + ": a " + traits.name + " of " +
                                      std::to_string(bytes) + " bytes is needed, and " + limit);
}

void check_limits(const Device& device, const UseTraits& traits, BufferUse use, std::uint64_t bytes) {
  const DeviceDescription& limits = device.description();
  const auto bound = [&](std::uint64_t most, const std::string& what) {
    if (bytes > most) refuse(device, traits, bytes, what + " " + std::to_string(most) + " bytes");
  };
  if (use == BufferUse::uniform) {
    bound(device.physical().getProperties().limits.maxUniformBufferRange, "the device allows");
  }
  if (traits.texel_bytes != 0) {
    const std::uint64_t texels = bytes / traits.texel_bytes;
    if (texels > limits.max_texel_buffer_elements) {
      refuse(device, traits, bytes,
             "its " + std::to_string(texels) + " texels are more than the " +
                 std::to_string(limits.max_texel_buffer_elements) + " the device allows");
    }
  }
  // Scratch memory is a storage buffer that is never bound.
  if (traits.usage & vk::BufferUsageFlagBits::eStorageBuffer && use != BufferUse::tree_scratch) {
    bound(limits.max_storage_buffer_range_bytes, "the device allows");
  }
  bound(limits.max_allocation_bytes, "the device allocates at most");
}

/// The first memory type allowed by `type_bits` with all of `wanted`: drivers list the plainest, fastest first.
std::optional<std::uint32_t> memory_type(const vk::PhysicalDeviceMemoryProperties& memory, std::uint32_t type_bits,
                                         vk::MemoryPropertyFlags wanted) {
  for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
    const bool allowed = (type_bits >> type & 1U) != 0;
    if (allowed && (memory.memoryTypes[type].propertyFlags & wanted) == wanted) return type;
  }
  return std::nullopt;
}

vk::raii::DeviceMemory allocate(const Device& device, const UseTraits& traits, const vk::MemoryRequirements& needs,
                                std::uint32_t type) {
  const vk::PhysicalDeviceMemoryProperties& memory = device.memory();
  const std::uint64_t heap_bytes = memory.memoryHeaps[memory.memoryTypes[type].heapIndex].size;
  const std::string has = "the device's memory has " + std::to_string(heap_bytes) + " bytes";
  if (needs.size > heap_bytes) refuse(device, traits, needs.size, has);
  vk::MemoryAllocateInfo allocation(needs.size, type);
  const vk::MemoryAllocateFlagsInfo has_address(vk::MemoryAllocateFlagBits::eDeviceAddress);
  if (traits.usage & vk::BufferUsageFlagBits::eShaderDeviceAddress) allocation.pNext = &has_address;
  try {
    return device.vk().allocateMemory(allocation);
  } catch (const vk::OutOfDeviceMemoryError&) {
    refuse(device, traits, needs.size, has + " in all, not enough of them free");
  } catch (const vk::OutOfHostMemoryError&) {
    refuse(device, traits, needs.size, has + " in all, and the host's are used up");
  }
}

void check_range(const Buffer& buffer, std::uint64_t offset, std::uint64_t bytes) {
  if (offset % 4 != 0 || bytes % 4 != 0 || offset > buffer.size_bytes() || bytes > buffer.size_bytes() - offset) {
    throw std::logic_error("buffer of " + std::to_string(buffer.size_bytes()) + " bytes: a copy of " +
                           std::to_string(bytes) + " bytes at " + std::to_string(offset) + " does not fit");
  }
}

}  // namespace

std::uint32_t memory_type_for(const Device& device, std::uint32_t type_bits, bool host_visible) {
  const vk::PhysicalDeviceMemoryProperties& memory = device.memory();
  const vk::MemoryPropertyFlags host = Memory::eHostVisible | Memory::eHostCoherent;
  const std::vector<vk::MemoryPropertyFlags> wishes =
      host_visible ? std::vector<vk::MemoryPropertyFlags>{host | Memory::eHostCached, host}
                   : std::vector<vk::MemoryPropertyFlags>{Memory::eDeviceLocal, {}};
  for (const vk::MemoryPropertyFlags& wish : wishes) {
    if (const auto type = memory_type(memory, type_bits, wish)) return *type;
  }
  throw Error(ErrorKind::failed, "device " + device.description().name + ": no type of memory fits");
}

Buffer::Buffer(const Device& device, std::uint64_t size_bytes, BufferUse use) : use_(use) {
  const UseTraits traits = traits_of(use);
  check_limits(device, traits, use, size_bytes);
  size_bytes_ = size_bytes == 0 ? 16 : (size_bytes + 3) / 4 * 4;
  vk_check("creating a buffer", [&] {
    const vk::BufferUsageFlags copies = vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    buffer_ = device.vk().createBuffer(vk::BufferCreateInfo({}, size_bytes_, traits.usage | copies));
    const vk::MemoryRequirements needs = buffer_.getMemoryRequirements();
    const std::uint32_t type = memory_type_for(device, needs.memoryTypeBits, use == BufferUse::storage_host_visible);
    memory_ = allocate(device, traits, needs, type);
    buffer_.bindMemory(*memory_, 0);
    const vk::MemoryPropertyFlags flags = device.memory().memoryTypes[type].propertyFlags;
    // Uncached memory is left to staging: the host reads it a hundred times slower.
    const vk::MemoryPropertyFlags direct = Memory::eHostVisible | Memory::eHostCoherent | Memory::eHostCached;
    if (use == BufferUse::storage_host_visible || (flags & direct) == direct) {
      mapped_ = {static_cast<std::byte*>(memory_.mapMemory(0, VK_WHOLE_SIZE)), size_bytes_};
    }
    if (traits.texel_bytes != 0) {
      view_ =
          device.vk().createBufferView(vk::BufferViewCreateInfo({}, *buffer_, traits.texel_format, 0, VK_WHOLE_SIZE));
    }
  });
  // llvmpipe's memory is the host's: rays that jump about in it wait for the tables of small pages.
  if (device.description().is_llvmpipe) wish_for_large_pages(mapped_);
  clear(device);
}

vk::DeviceAddress Buffer::address(const Device& device) const {
  return device.vk().getBufferAddress(vk::BufferDeviceAddressInfo(*buffer_));
}

void Buffer::upload(const Device& device, std::span<const std::byte> bytes, std::uint64_t offset_bytes) {
  check_range(*this, offset_bytes, bytes.size());
  if (bytes.empty()) return;
  if (!mapped_.empty()) {
    std::memcpy(mapped_.data() + offset_bytes, bytes.data(), bytes.size());
    return;
  }
  Buffer staging(device, std::min<std::uint64_t>(bytes.size(), kStagingBytes), BufferUse::storage_host_visible);
  for (std::uint64_t done = 0; done < bytes.size(); done += kStagingBytes) {
    const std::span<const std::byte> part =
        bytes.subspan(done, std::min<std::uint64_t>(bytes.size() - done, kStagingBytes));
    std::memcpy(staging.mapped_.data(), part.data(), part.size());
    run_transfer(device, [&](const vk::raii::CommandBuffer& commands) {
      commands.copyBuffer(*staging.buffer_, *buffer_, vk::BufferCopy(0, offset_bytes + done, part.size()));
    });
  }
}

void Buffer::download(const Device& device, std::span<std::byte> bytes, std::uint64_t offset_bytes) const {
  check_range(*this, offset_bytes, bytes.size());
  if (bytes.empty()) return;
  if (!mapped_.empty()) {
    std::memcpy(bytes.data(), mapped_.data() + offset_bytes, bytes.size());
    return;
  }
  Buffer staging(device, std::min<std::uint64_t>(bytes.size(), kStagingBytes), BufferUse::storage_host_visible);
  for (std::uint64_t done = 0; done < bytes.size(); done += kStagingBytes) {
    const std::span<std::byte> part = bytes.subspan(done, std::min<std::uint64_t>(bytes.size() - done, kStagingBytes));
    run_transfer(device, [&](const vk::raii::CommandBuffer& commands) {
      commands.copyBuffer(*buffer_, *staging.buffer_, vk::BufferCopy(offset_bytes + done, 0, part.size()));
    });
    std::memcpy(part.data(), staging.mapped_.data(), part.size());
  }
}

void Buffer::clear(const Device& device) {
  clear_front(device, size_bytes_);
}

void Buffer::clear_front(const Device& device, std::uint64_t bytes) {
  const std::uint64_t count = std::min(bytes, size_bytes_);
  if (!mapped_.empty()) {
    std::memset(mapped_.data(), 0, count);
    return;
  }
  run_transfer(device, [&](const vk::raii::CommandBuffer& commands) { commands.fillBuffer(*buffer_, 0, count, 0); });
}

}  // namespace vernier
