#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "bvh/bvh.h"
#include "render/bake_instances.h"
#include "render/plan_instances.h"
#include "render/render_settings.h"
#include "render/traced_space.h"
#include "scene/scene.h"
#include "shared/material_layout.h"
#include "shared/render_constants.h"

namespace vernier {

/// The scene's arrays as the device reads them (shared/bindings.h), and the BVH over them. No Vulkan here.
struct PackedScene {
  TracedSpace space;
  Bvh bvh;
  std::vector<std::uint32_t> first_triangles;
  std::vector<std::uint32_t> instances;
  LargeArray<std::uint32_t> vertices;
  std::vector<std::uint32_t> materials;
  std::vector<std::uint32_t> lights;
  std::vector<std::uint32_t> textures;
  std::vector<std::uint32_t> texels;
  RenderConstants constants{};         ///< all that the scene decides; set_camera and set_settings add the rest
  SteeringConstants steering{};        ///< likewise
  std::uint64_t triangle_count = 0;    ///< of all instances, as are the next two
  std::uint64_t traced_triangles = 0;  ///< in the BVH
  std::uint64_t hidden_triangles = 0;  ///< left out of it: they lie exactly on opaque ones before them
  std::uint32_t workflows = 0;         ///< OR of 1 << WORKFLOW_* of the materials
  double bake_ms = 0.0;
  double bvh_build_ms = 0.0;
};

/// Packs what hangs on the triangles of `scene`, which has passed validate_scene, but on no texel: the traced space,
/// the BVH, vertices, instances. Builds by `method` on `thread_count` threads (0: all cores); without a method
/// triangles are listed for the driver's tree (list_triangles). `sharing` decides which meshes are traced in a space of
/// their own: none without a method. Without UvSets::all the AOV `uv` is 0 where no texture asks for it.
PackedScene pack_shape(const Scene& scene, unsigned thread_count,
                       std::optional<BuildMethod> method = BuildMethod::standard,
                       const std::function<void(double share)>& progress = {}, Sharing sharing = Sharing::automatic,
                       UvSets uvs = UvSets::all);

/// The same on all cores as `settings` have it: with TraversalForm::ray_query triangles alone, every instance's.
PackedScene pack_shape(const Scene& scene, const RenderSettings& settings,
                       const std::function<void(double share)>& progress = {});

/// Packs the rest of `scene` into `packed`, which has its shape: materials, textures, lights, environment.
void pack_look(const Scene& scene, PackedScene& packed);

/// Both in one, the first with the arguments given.
PackedScene pack_scene(const Scene& scene, unsigned thread_count,
                       std::optional<BuildMethod> method = BuildMethod::standard, Sharing sharing = Sharing::automatic);
PackedScene pack_scene(const Scene& scene, const RenderSettings& settings);

/// `light` in device layout.
DeviceLight device_light(const Light& light, const TracedSpace& space);

/// `lights` in device layout, one after the other.
std::vector<std::uint32_t> pack_lights(const std::vector<Light>& lights, const TracedSpace& space);

/// Sets the camera of `packed` for an image of settings.width x settings.height.
/// Throws Error(refused) when the camera stands more than 2^40 scene extents away: there a pixel is wider than the
/// scene.
void set_camera(PackedScene& packed, const Camera& camera, const RenderSettings& settings);

/// Sets what the settings decide: size, seed, samples, bounces, cutoff, filters.
void set_settings(PackedScene& packed, const RenderSettings& settings);

}  // namespace vernier
