#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <memory>
#include <vector>

#include "scene/scene.h"

namespace vernier::test {

/// Adds a material that reflects, transmits and emits nothing (blinn, black) and returns it for the test to fill.
inline Material& add_black(Scene& scene) {
  Material material;
  material.workflow = Workflow::blinn;
  material.base_color = glm::vec4(0, 0, 0, 1);
  material.specular = glm::vec3(0);
  scene.materials.push_back(material);
  return scene.materials.back();
}

/// Adds an instance of a mesh of one triangle or, with four corners, of the two triangles 012 and 023, in the material
/// added last.
inline Mesh& add_polygon(Scene& scene, std::initializer_list<glm::vec3> corners) {
  Mesh mesh;
  mesh.positions = corners;
  for (std::uint32_t corner = 2; corner < corners.size(); ++corner) mesh.triangles.push_back({0u, corner - 1, corner});
  mesh.triangle_materials.assign(mesh.triangles.size(), static_cast<std::uint32_t>(scene.materials.size() - 1));
  scene.instances.push_back({"", static_cast<std::uint32_t>(scene.meshes.size()), glm::dmat4(1.0)});
  scene.meshes.push_back(mesh);
  return scene.meshes.back();
}

/// Adds the square |x|, |y| <= half at height z whose front looks along +Z. Its uvs run from (0, 0) at the lower left.
inline Mesh& add_square(Scene& scene, float z, float half = 1.0f) {
  Mesh& mesh = add_polygon(scene, {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
  mesh.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return mesh;
}

/// Adds the axis-aligned box from lo to hi, its fronts outside.
inline Mesh& add_box(Scene& scene, glm::vec3 lo, glm::vec3 hi) {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.push_back({corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  mesh.triangle_materials.assign(12, static_cast<std::uint32_t>(scene.materials.size() - 1));
  scene.instances.push_back({"", static_cast<std::uint32_t>(scene.meshes.size()), glm::dmat4(1.0)});
  scene.meshes.push_back(mesh);
  return scene.meshes.back();
}

/// Texels of linear bytes, each 0xAABBGGRR.
inline std::shared_ptr<const Texels> linear_texels(std::uint32_t width, std::uint32_t height,
                                                   std::vector<std::uint32_t> words) {
  return std::make_shared<Texels>(Texels{TEXTURE_FORMAT_LINEAR8, width, height, std::move(words)});
}

/// Adds a texture to `scene` and returns its index.
inline int add_texture(Scene& scene, std::shared_ptr<const Texels> texels, Sampler sampler = {}) {
  scene.textures.push_back({"", sampler, std::move(texels)});
  return static_cast<int>(scene.textures.size()) - 1;
}

}  // namespace vernier::test
