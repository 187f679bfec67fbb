#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gpu/device.h"
#include "math/memory_claim.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace vernier {

/// Memory that a scene will take beyond what it takes as loaded, or an image.
struct MemoryNeed {
  std::uint64_t triangles = 0;         ///< of all instances
  std::uint64_t stored_triangles = 0;  ///< of meshes that instances share once (plan_instances.h)
  std::uint64_t host_bytes = 0;        ///< while its arrays and BVH are made, an upper bound
  std::uint64_t device_bytes = 0;      ///< for as long as it is rendered, an upper bound
  std::uint64_t texture_bytes = 0;     ///< of both, for textures
};

/// Memory that a scene may take; empty: not known.
struct MemoryThere {
  std::optional<std::uint64_t> host_bytes;
  std::optional<std::uint64_t> device_bytes;
  bool shared = false;  ///< the device's is the host's, as of CPU devices
};

/// Of `scene`, by its counts and by what plan_instances makes of its instances.
MemoryNeed memory_need(const Scene& scene, Sharing sharing = Sharing::automatic);

/// Of the film of an image of `settings`, of paths and samples on `device`, and on the host of the image that is made.
MemoryNeed image_need(const RenderSettings& settings, const DeviceDescription& device);

/// Of a renderer on the host that copies every instance and keeps so many bytes for each of their triangles.
MemoryNeed need_of_copies(const Scene& scene, std::uint64_t bytes_per_triangle);

/// On the host: host_memory_there.
MemoryThere memory_there();
/// The same, and on the device: its largest local heap, where its memory is its own.
MemoryThere memory_there(const DeviceDescription& device);

/// What is left of the `need` of a scene when its shape is packed (pack_shape).
MemoryNeed after_shape(MemoryNeed need);

/// Claims what `need` comes to on the host. Returns what is there, as MemoryClaim::take.
MemoryThere claim_memory(MemoryClaim& claim, const MemoryNeed& need, MemoryThere there);

/// Throws Error(refused) for the scene file `source` where `need` is more than what is `there`, with both numbers.
void check_memory(const std::string& source, const MemoryNeed& need, const MemoryThere& there);

/// Throws Error(usage) where what `image` needs beside a scene that needs `scene` is more than what is `there`.
void check_image_memory(const MemoryNeed& scene, const MemoryNeed& image, const MemoryThere& there);

/// One line: bytes needed and bytes there.
std::string memory_text(const MemoryNeed& need, const MemoryThere& there);

}  // namespace vernier
