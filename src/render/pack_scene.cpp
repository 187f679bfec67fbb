#include "render/pack_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "error.h"
#include "math/elapsed.h"
#include "render/append_words.h"
#include "render/bake_instances.h"
#include "render/build_trees.h"
#include "render/lay_out_vertices.h"
#include "render/pack_materials.h"
#include "scene/environment_harmonics.h"
#include "scene/frame_scene.h"

namespace vernier {
namespace {

void set_environment(PackedScene& packed, const Scene& scene) {
  RenderConstants& constants = packed.constants;
  const Environment& environment = scene.environment;
  constants.sky = environment.sky;
  constants.ground = environment.ground;
  packed.steering.environment_texture =
      environment.texture < 0 ? NONE : static_cast<std::uint32_t>(environment.texture);
  constants.environment_scale = environment.texture_scale;
  const std::array<glm::vec3, 9> harmonics = ambient_harmonics(scene);
  for (std::size_t i = 0; i < harmonics.size(); ++i) constants.ambient_harmonics[i] = harmonics[i];
}

/// Sets the filter of all textures but the environment's, which is always linear.
void set_texture_filter(PackedScene& packed, TextureFilter filter) {
  for (std::size_t texture = 0; 4 * texture < packed.textures.size(); ++texture) {
    if (texture == packed.steering.environment_texture) continue;
    std::uint32_t& word = packed.textures[4 * texture + 3];
    const std::uint32_t of_file = (word >> TEXTURE_FILE_FILTER_SHIFT) & 1u;
    const std::uint32_t chosen = filter == TextureFilter::nearest  ? TEXTURE_FILTER_NEAREST
                                 : filter == TextureFilter::linear ? TEXTURE_FILTER_LINEAR
                                                                   : of_file;
    word = (word & ~(1u << TEXTURE_FILTER_SHIFT)) | chosen << TEXTURE_FILTER_SHIFT;
  }
}

void set_space(RenderConstants& constants, const TracedSpace& space) {
  constants.world_center = glm::vec3(space.center);
  constants.metres_per_unit = static_cast<float>(space.metres_per_unit);
}

void set_layout(SteeringConstants& steering, const VertexLayout& layout) {
  steering.vertex_texels = layout.texels;
  steering.normal_texel = layout.normal;
  steering.uv01_texel = layout.uv01;
  steering.uv23_texel = layout.uv23;
  steering.color_texel = layout.color;
  steering.tangent_texel = layout.tangent;
}

}  // namespace

DeviceLight device_light(const Light& light, const TracedSpace& space) {
  DeviceLight device{};
  device.kind = static_cast<std::uint32_t>(light.kind);
  device.position = glm::vec3(traced_from_world(space, light.position));
  device.direction = glm::vec3(light.direction);
  // Compilers of shaders may take it that nothing is infinite.
  device.range = std::min(static_cast<float>(light.range / space.metres_per_unit), std::numeric_limits<float>::max());
  const bool directional = light.kind == LightKind::directional;
  const double scale = directional ? 1.0 : 1.0 / (space.metres_per_unit * space.metres_per_unit);
  device.intensity = glm::vec3(glm::dvec3(light.intensity) * scale);
  const double cos_outer = std::cos(light.outer_cone_angle);
  device.cos_outer = static_cast<float>(cos_outer);
  // 1/1024: shaders/README.md 5.4; a cone edge narrower than that counts as that wide.
  device.cone_scale = static_cast<float>(1.0 / std::max(std::cos(light.inner_cone_angle) - cos_outer, 1.0 / 1024.0));
  return device;
}

std::vector<std::uint32_t> pack_lights(const std::vector<Light>& lights, const TracedSpace& space) {
  std::vector<std::uint32_t> words;
  for (const Light& light : lights) append_words(words, device_light(light, space));
  return words;
}

PackedScene pack_shape(const Scene& scene, unsigned thread_count, std::optional<BuildMethod> method,
                       const std::function<void(double)>& progress, Sharing sharing, UvSets uvs) {
  PackedScene packed;
  const auto bake_start = std::chrono::steady_clock::now();
  packed.space = choose_traced_space(world_bounds(scene));
  const InstancePlan plan = plan_instances(scene, method ? sharing : Sharing::never);
  BakedScene baked = bake_instances(scene, packed.space, plan, uvs);
  packed.bake_ms = ms_since(bake_start);
  const auto build_start = std::chrono::steady_clock::now();
  SceneTrees trees = build_trees(scene, plan, packed.space, baked, thread_count, method, progress);
  packed.bvh_build_ms = ms_since(build_start);
  const auto layout_start = std::chrono::steady_clock::now();
  const VertexLayout layout = baked.layout;
  packed.first_triangles = std::move(baked.first_triangles);
  packed.vertices = lay_out_vertices(std::move(baked), trees, thread_count);
  packed.bake_ms += ms_since(layout_start);
  packed.bvh = std::move(trees.bvh);
  packed.instances = std::move(trees.instances);
  packed.triangle_count = plan.triangles;
  packed.traced_triangles = trees.traced_triangles;
  packed.hidden_triangles = trees.hidden_triangles;
  set_space(packed.constants, packed.space);
  packed.steering.triangle_count = packed.bvh.triangle_count;
  packed.steering.object_count = static_cast<std::uint32_t>(packed.first_triangles.size());
  packed.steering.one = 1;
  set_layout(packed.steering, layout);
  return packed;
}

PackedScene pack_shape(const Scene& scene, const RenderSettings& settings,
                       const std::function<void(double)>& progress) {
  const bool driver_builds = settings.traversal == TraversalForm::ray_query;
  const bool shows_uv = wants_aov(settings, "uv");
  return pack_shape(scene, 0, driver_builds ? std::nullopt : std::optional(settings.bvh), progress, settings.sharing,
                    shows_uv ? UvSets::all : UvSets::of_textures);
}

void pack_look(const Scene& scene, PackedScene& packed) {
  packed.materials = pack_materials(scene, packed.space.metres_per_unit);
  for (const Material& material : scene.materials)
    packed.workflows |= 1u << static_cast<std::uint32_t>(material.workflow);
  packed.lights = pack_lights(scene.lights, packed.space);
  packed.steering.light_count = static_cast<std::uint32_t>(scene.lights.size());
  PackedTextures textures = pack_textures(scene);
  packed.textures = std::move(textures.textures);
  packed.texels = std::move(textures.texels);
  set_environment(packed, scene);
}

PackedScene pack_scene(const Scene& scene, unsigned thread_count, std::optional<BuildMethod> method, Sharing sharing) {
  PackedScene packed = pack_shape(scene, thread_count, method, {}, sharing);
  pack_look(scene, packed);
  return packed;
}

PackedScene pack_scene(const Scene& scene, const RenderSettings& settings) {
  PackedScene packed = pack_shape(scene, settings);
  pack_look(scene, packed);
  return packed;
}

void set_camera(PackedScene& packed, const Camera& camera, const RenderSettings& settings) {
  RenderConstants& constants = packed.constants;
  const TracedSpace& space = packed.space;
  const glm::dmat4& frame = camera.world_from_camera;
  const glm::dvec3 origin = traced_from_world(space, glm::dvec3(frame[3]));
  const double farthest = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
  if (!(farthest <= std::exp2(40))) {
    throw Error(ErrorKind::refused, "the camera is more than 2^40 scene extents away from the scene");
  }
  const double aspect = aspect_of(settings);
  const double half_height =
      camera.orthographic ? camera.half_height / space.metres_per_unit : std::tan(camera.vertical_fov / 2.0);
  constants.camera_origin = glm::vec3(origin);
  constants.camera_right = glm::vec3(glm::dvec3(frame[0]) * (half_height * aspect));
  constants.camera_up = glm::vec3(glm::dvec3(frame[1]) * half_height);
  constants.camera_forward = glm::vec3(-glm::dvec3(frame[2]));
  packed.steering.orthographic = camera.orthographic ? 1 : 0;
}

void set_settings(PackedScene& packed, const RenderSettings& settings) {
  set_texture_filter(packed, settings.texture_filter);
  RenderConstants& constants = packed.constants;
  constants.image_width = static_cast<std::uint32_t>(settings.width);
  constants.image_height = static_cast<std::uint32_t>(settings.height);
  constants.seed = settings.seed;
  packed.steering.spp = settings.spp;
  packed.steering.pixel_filter = settings.pixel_filter == PixelFilter::tent ? PIXEL_FILTER_TENT : PIXEL_FILTER_BOX;
  constants.max_bounces = settings.max_bounces;
  constants.cutoff = settings.cutoff;
}

}  // namespace vernier
