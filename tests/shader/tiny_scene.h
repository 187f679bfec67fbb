#pragma once

#include "render/pack_scene.h"
#include "unit/reference/test_scenes.h"

namespace vernier::test {

inline Light lamp(LightKind kind, const glm::dvec3& position, const glm::dvec3& direction, float intensity) {
  Light light;
  light.kind = kind;
  light.position = position;
  light.direction = direction;
  light.intensity = glm::vec3(intensity);
  return light;
}

/// A camera at (0, 0, z) that looks along -Z and sees `degrees` from bottom to top.
inline Camera camera_at(double z, double degrees = 40.0) {
  Camera camera;
  camera.world_from_camera[3] = glm::dvec4(0, 0, z, 1);
  camera.vertical_fov = degrees / 57.29577951308232;
  return camera;
}

/// A tinted glass box with absorption, a mirror, a textured wall, a cut-out, a clear pane and three lights: every
/// effect but the environment image and the orthographic camera.
inline Scene tiny_scene() {
  Scene scene;
  Material& wall = add_black(scene);
  wall.workflow = Workflow::metallic_roughness;
  wall.base_color = glm::vec4(0.9f, 0.8f, 0.7f, 1);
  wall.specular = glm::vec3(1);
  wall.roughness = 0.6f;
  wall.emission = glm::vec3(0.05f);
  Sampler nearest;
  nearest.filter = TEXTURE_FILTER_NEAREST;
  const int checker =
      add_texture(scene, linear_texels(2, 2, {0xffffffff, 0x40404040, 0x30303030, 0xffc0e0ff}), nearest);
  const int smooth = add_texture(scene, linear_texels(2, 2, {0xffff8080, 0xffe0a070, 0xffe07090, 0xffff8080}));
  wall.textures[TEXTURE_SLOT_BASE_COLOR].texture = checker;
  wall.textures[TEXTURE_SLOT_NORMAL].texture = smooth;
  add_square(scene, -1.0f, 1.5f);
  Material& mirror = add_black(scene);
  mirror.workflow = Workflow::metallic_roughness;
  mirror.base_color = glm::vec4(0.9f, 0.9f, 1.0f, 1);
  mirror.specular = glm::vec3(1);
  mirror.metallic = 1.0f;
  mirror.roughness = 0.1f;
  Mesh& tilted = add_polygon(scene, {{-1.5f, -1, -1}, {1.5f, -1, -1}, {1.5f, -0.8f, 1}, {-1.5f, -0.8f, 1}});
  tilted.normals.assign(4, glm::normalize(glm::vec3(0.1f, 1, -0.1f)));
  Material& glass = add_black(scene);
  glass.workflow = Workflow::metallic_roughness;
  glass.base_color = glm::vec4(0.9f, 1.0f, 0.9f, 1);
  glass.specular = glm::vec3(1);
  glass.roughness = 0.0f;
  glass.transmission = glm::vec3(1);
  glass.thin_walled = false;
  glass.absorption = glm::vec3(0.5f, 0.1f, 0.3f);
  add_box(scene, {-0.7f, -0.6f, -0.3f}, {-0.1f, 0.1f, 0.3f});
  Material& cut_out = add_black(scene);
  cut_out.base_color = glm::vec4(0.2f, 0.7f, 0.3f, 0.9f);
  cut_out.workflow = Workflow::metallic_roughness;
  cut_out.alpha_mode = AlphaMode::mask;
  cut_out.textures[TEXTURE_SLOT_BASE_COLOR].texture = checker;
  add_square(scene, 0.4f, 0.35f);
  Material& pane = add_black(scene);
  pane.base_color = glm::vec4(0.8f, 0.2f, 0.2f, 0.5f);
  pane.alpha_mode = AlphaMode::blend;
  pane.specular = glm::vec3(0.5f);
  pane.exponent = 50.0f;
  Mesh& leaning = add_polygon(scene, {{0.3f, -0.5f, 0.2f}, {0.9f, -0.5f, 0.0f}, {0.9f, 0.5f, 0.1f}});
  leaning.colors = {{1, 1, 1, 1}, {1, 0.5f, 1, 1}, {0.5f, 1, 1, 0.5f}};
  scene.lights = {lamp(LightKind::point, {0.5, 0.8, 1}, {0, 0, -1}, 4.0f),
                  lamp(LightKind::spot, {-1, 1, 1.5}, glm::normalize(glm::dvec3(0.6, -0.7, -1)), 6.0f),
                  lamp(LightKind::directional, {}, glm::normalize(glm::dvec3(-0.3, -0.5, -1)), 0.7f)};
  scene.environment.sky = glm::vec3(0.3f, 0.4f, 0.6f);
  scene.environment.ground = glm::vec3(0.2f, 0.15f, 0.1f);
  return scene;
}

/// Packed for the camera and settings.
inline PackedScene packed_for(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  PackedScene packed = pack_scene(scene, 1);
  set_camera(packed, camera, settings);
  set_settings(packed, settings);
  return packed;
}

inline RenderSettings small_image(int width, int height, std::uint32_t spp) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.spp = settings.sample_end = spp;
  return settings;
}

}  // namespace vernier::test
