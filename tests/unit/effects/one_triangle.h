#pragma once

#include <string>

#include "effects/detect_effects.h"

namespace vernier {

/// One triangle with material 0: black, rough, without light, so that no effect is asked for.
inline Scene one_triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_materials = {0};
  Material material;
  material.name = "paint";
  material.base_color = glm::vec4(0, 0, 0, 1);
  material.specular_strength = 0.0f;
  Scene scene;
  scene.meshes = {mesh};
  scene.instances = {Instance{}};
  scene.materials = {material};
  return scene;
}

/// one_triangle with a white diffuse material under a white environment of radiance 1.
inline Scene white_triangle() {
  Scene scene = one_triangle();
  scene.materials[0].base_color = glm::vec4(1.0f);
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  return scene;
}

inline Light light_of(LightKind kind) {
  Light light;
  light.name = "lamp";
  light.kind = kind;
  return light;
}

/// Adds a texture and puts it into `slot` of material 0.
inline void add_texture(Scene& scene, int slot) {
  scene.textures.push_back(Texture{"checker", {}, nullptr});
  scene.materials[0].textures[slot].texture = static_cast<int>(scene.textures.size()) - 1;
}

inline std::uint32_t bits_of(const Scene& scene, int max_bounces = 8) {
  return detect_effects(scene, Camera{}, max_bounces).bits;
}

inline bool is_on(const Scene& scene, std::uint32_t bit, int max_bounces = 8) {
  return (bits_of(scene, max_bounces) & bit) != 0;
}

inline std::string reason_for(const EffectSet& effects, std::uint32_t bit) {
  for (const EffectReason& verdict : effects.reasons) {
    if (verdict.bit == bit) {
      return verdict.reason;
    }
  }
  return "missing";
}

}  // namespace vernier
