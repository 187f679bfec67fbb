#pragma once

#include <bit>

#include "shader/tiny_scene.h"

namespace vernier::test {

/// A 1x1 texture of floats.
inline std::shared_ptr<Texels> float_texel(float r, float g, float b) {
  const auto word = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  return std::make_shared<Texels>(Texels{TEXTURE_FORMAT_FLOAT, 1, 1, {word(r), word(g), word(b), word(1.0f)}});
}

/// tiny_scene with all slots of the wall textured, an unlit square and an image around it: every effect that is not the
/// camera's.
inline Scene every_effect_scene() {
  Scene scene = tiny_scene();
  const int spots = scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR].texture;
  for (const int slot : {TEXTURE_SLOT_SURFACE, TEXTURE_SLOT_OCCLUSION, TEXTURE_SLOT_EMISSION, TEXTURE_SLOT_SPECULAR}) {
    scene.materials[0].textures[slot].texture = spots;
  }
  Material& sign = add_black(scene);
  sign.workflow = Workflow::metallic_roughness;
  sign.unlit = true;
  sign.base_color = glm::vec4(0.2f, 0.9f, 0.4f, 1);
  add_polygon(scene, {{-0.9f, 0.4f, 0.1f}, {-0.4f, 0.4f, 0.1f}, {-0.4f, 0.9f, 0.1f}});
  scene.environment.texture = add_texture(scene, float_texel(0.9f, 1.5f, 0.4f));
  return scene;
}

/// camera_at(3.5) with parallel rays.
inline Camera orthographic_camera() {
  Camera camera = camera_at(3.5);
  camera.orthographic = true;
  return camera;
}

}  // namespace vernier::test
