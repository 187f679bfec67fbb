#include "render/memory_need.h"

#include <algorithm>

#include "bvh/bvh.h"
#include "error.h"
#include "math/host_memory.h"
#include "render/bake_instances.h"
#include "render/film.h"
#include "render/pack_materials.h"
#include "render/plan_instances.h"
#include "render/read_film.h"
#include "render/tile_tracer.h"
#include "shared/film_layout.h"
#include "shared/instance_layout.h"

namespace vernier {
namespace {

/// Per triangle, all that lives at once when the BVH is written: box references 32, binary nodes 32, plans of the
/// collapse 24.
constexpr std::uint64_t kBuildBytes = 88;
/// Vertices and material, until the vertices are laid out (lay_out_vertices.h).
constexpr std::uint64_t kTriangleBytes = 16;
/// A vertex in the list of those that are laid out.
constexpr std::uint64_t kListedBytes = 8;
/// Number of the first triangle of an object.
constexpr std::uint64_t kObjectBytes = 4;
/// Of an attribute of a vertex.
constexpr std::uint64_t kTexelBytes = 16;

/// Of a pixel that is developed: colour 16, samples 4, and as much for what the film tells besides.
constexpr std::uint64_t kDevelopedBytes = 40;

/// Most nodes have four children, so that there are four for ten triangles: half as many are not met.
std::uint64_t most_record_bytes(std::uint64_t triangles) {
  return (triangles + triangles / 2 + 1) * sizeof(BvhRecord);
}

/// Vertices on the borders of chunks are laid out more than once: up to an eighth of all were met, twice as many are
/// not.
std::uint64_t most_vertices(const InstancePlan& plan) {
  return std::min(3 * plan.stored_triangles, plan.stored_vertices + plan.stored_vertices / 4);
}

/// What the host needs at the most.
std::uint64_t of_host(const MemoryNeed& need, const MemoryThere& there) {
  return need.host_bytes + (there.shared ? need.device_bytes : 0);
}

void check(const std::string& source, const MemoryNeed& need, std::uint64_t needed, std::optional<std::uint64_t> there,
           const char* whose) {
  if (!there || needed <= *there) return;
  const bool shares = need.stored_triangles < need.triangles;
  const bool by_textures = need.texture_bytes > needed / 4;  // they may count twice
  const std::string stored = shares ? " (" + std::to_string(need.stored_triangles) + " in memory)" : "";
  const std::string textures = by_textures ? " and " + needed_memory_text(need.texture_bytes) + " of textures" : "";
  throw Error(ErrorKind::refused, source + ": " + std::to_string(need.triangles) + " triangles" + stored + textures +
                                      " need " + needed_memory_text(needed) + " of the " + whose + "'s memory, " +
                                      memory_there_text(*there) + " are there; " +
                                      (by_textures ? "make the textures smaller" : "simplify or split the model"));
}

void check_image(std::uint64_t scene, std::uint64_t image, std::optional<std::uint64_t> there, const char* whose) {
  if (!there || scene + image <= *there) return;
  throw Error(ErrorKind::usage, "--size: so many pixels need " + needed_memory_text(image) + " of the " + whose +
                                    "'s memory beside the scene's " + needed_memory_text(scene) + ", " +
                                    memory_there_text(*there) + " are there; render it in parts with --crop");
}

}  // namespace

MemoryNeed memory_need(const Scene& scene, Sharing sharing) {
  const InstancePlan plan = plan_instances(scene, sharing);
  MemoryNeed need;
  need.triangles = plan.triangles;
  need.stored_triangles = plan.stored_triangles;
  std::uint64_t shared_triangles = 0;
  for (const std::uint32_t mesh : plan.meshes) shared_triangles += scene.meshes[mesh].triangles.size();
  const std::uint64_t vertex_bytes = choose_vertex_layout(scene, UvSets::all).texels * kTexelBytes;
  const std::uint64_t laid_out = most_vertices(plan);
  need.texture_bytes = texel_words(scene) * sizeof(std::uint32_t);
  const std::uint64_t but_vertices = most_record_bytes(plan.stored_triangles + plan.shared_instances) +
                                     plan.shared_instances * sizeof(DeviceInstance) +
                                     scene.instances.size() * kObjectBytes + need.texture_bytes;
  need.device_bytes = but_vertices + laid_out * vertex_bytes;
  const std::uint64_t baked = plan.stored_triangles * kTriangleBytes + plan.stored_vertices * vertex_bytes;
  const std::uint64_t building = (plan.stored_triangles + plan.shared_instances) * (sizeof(BvhTriangle) + kBuildBytes);
  const std::uint64_t laying_out = laid_out * (vertex_bytes + kListedBytes);
  // The records of shared meshes are there twice when they are put behind those of the scene.
  need.host_bytes = but_vertices + baked + std::max(building, laying_out) + most_record_bytes(shared_triangles);
  return need;
}

MemoryNeed need_of_copies(const Scene& scene, std::uint64_t bytes_per_triangle) {
  MemoryNeed need;
  for (const Instance& instance : scene.instances) need.triangles += scene.meshes[instance.mesh].triangles.size();
  need.stored_triangles = need.triangles;
  need.host_bytes = need.triangles * bytes_per_triangle;
  return need;
}

MemoryNeed image_need(const RenderSettings& settings, const DeviceDescription& device) {
  const PixelRect area = image_area(settings);
  const std::uint64_t pixels = static_cast<std::uint64_t>(area.width) * static_cast<std::uint64_t>(area.height);
  const std::uint64_t sums = pixels * FILM_WORDS * sizeof(std::uint32_t);
  const std::uint64_t geometry = wants_geometry(settings) ? Film::aov_bytes(area) : 0;
  MemoryNeed need;
  need.device_bytes = sums + geometry + tracing_bytes(settings, device);
  // Sums and layers as they are read, twice where they become layers of the image.
  need.host_bytes = (settings.film_layer ? 2 : 1) * sums + 2 * geometry + pixels * kDevelopedBytes;
  return need;
}

MemoryThere memory_there() {
  MemoryThere there;
  there.host_bytes = host_memory_there();
  return there;
}

MemoryThere memory_there(const DeviceDescription& device) {
  MemoryThere there = memory_there();
  there.shared = device.is_cpu;
  // lavapipe says 2 GiB, whatever the host has.
  if (!there.shared) there.device_bytes = device.device_memory_bytes;
  return there;
}

MemoryNeed after_shape(MemoryNeed need) {
  need.host_bytes = need.texture_bytes;
  return need;
}

MemoryThere claim_memory(MemoryClaim& claim, const MemoryNeed& need, MemoryThere there) {
  const std::uint64_t bytes = claim.take(of_host(need, there));
  if (there.host_bytes) there.host_bytes = bytes;
  return there;
}

void check_memory(const std::string& source, const MemoryNeed& need, const MemoryThere& there) {
  check(source, need, need.device_bytes, there.device_bytes, "device");
  check(source, need, of_host(need, there), there.host_bytes, "host");
}

void check_image_memory(const MemoryNeed& scene, const MemoryNeed& image, const MemoryThere& there) {
  check_image(scene.device_bytes, image.device_bytes, there.device_bytes, "device");
  // What the host needed to build the tree is free again by then.
  check_image(there.shared ? scene.device_bytes : 0, of_host(image, there), there.host_bytes, "host");
}

std::string memory_text(const MemoryNeed& need, const MemoryThere& there) {
  const auto of = [](std::optional<std::uint64_t> bytes, const char* whose) {
    return std::string(" of the ") + whose + "'s" + (bytes ? " " + memory_there_text(*bytes) : "");
  };
  const std::string device = needed_memory_text(need.device_bytes);
  const bool shares = need.stored_triangles < need.triangles;
  const std::string stored = shares ? std::to_string(need.triangles) + " triangles, " +
                                          std::to_string(need.stored_triangles) + " of them in memory; at most "
                                    : "at most ";
  return "memory: " + stored + needed_memory_text(of_host(need, there)) + of(there.host_bytes, "host") +
         (there.shared ? ", " + device + " of them for the device" : ", " + device + of(there.device_bytes, "device"));
}

}  // namespace vernier
