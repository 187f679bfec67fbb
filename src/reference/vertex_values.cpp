#include "reference/vertex_values.h"

#include <algorithm>

#include "reference/textures.h"

namespace vernier::reference {

namespace {

const Mesh& mesh_of(const Scene& scene, const Triangle& triangle) {
  return scene.meshes[scene.instances[triangle.instance].mesh];
}

}  // namespace

std::array<glm::dvec2, 3> corner_uvs(const Scene& scene, const Triangle& triangle, std::size_t set) {
  const std::vector<glm::vec2>& uvs = mesh_of(scene, triangle).uvs[set];
  std::array<glm::dvec2, 3> corners{};
  if (uvs.empty()) return corners;
  for (int corner = 0; corner < 3; ++corner) corners[corner] = uvs[triangle.vertices[corner]];
  return corners;
}

glm::dvec2 uv_at(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights, std::size_t set) {
  const std::array<glm::dvec2, 3> corners = corner_uvs(scene, triangle, set);
  return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

glm::dvec4 color_at(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights) {
  const std::vector<glm::vec4>& colors = mesh_of(scene, triangle).colors;
  if (colors.empty()) return glm::dvec4(1.0);
  // From corner 0: three equal ones give what they are.
  const glm::dvec4 first(colors[triangle.vertices[0]]);
  return first + weights.y * (glm::dvec4(colors[triangle.vertices[1]]) - first) +
         weights.z * (glm::dvec4(colors[triangle.vertices[2]]) - first);
}

glm::dvec4 texture_at(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights, std::size_t slot) {
  const TextureUse& use = scene.materials[triangle.material].textures[slot];
  if (use.texture < 0) return glm::dvec4(1.0);
  const Texture& texture = scene.textures[use.texture];
  const glm::dvec3 vertex_uv(uv_at(scene, triangle, weights, use.uv_set), 1.0);
  return sample_texels(*texture.texels, texture.sampler, glm::dmat3x2(use.uv_from_vertex_uv) * vertex_uv);
}

double coverage(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights) {
  const Material& material = scene.materials[triangle.material];
  if (material.alpha_mode == AlphaMode::opaque) return 1.0;
  const bool blinn = material.workflow == Workflow::blinn;
  const double texture = blinn ? texture_at(scene, triangle, weights, TEXTURE_SLOT_ALPHA).x
                               : texture_at(scene, triangle, weights, TEXTURE_SLOT_BASE_COLOR).w;
  const double alpha = material.base_color.w * color_at(scene, triangle, weights).w * texture;
  if (material.alpha_mode == AlphaMode::mask) return alpha < material.alpha_cutoff ? 0.0 : 1.0;
  return std::clamp(alpha, 0.0, 1.0);
}

}  // namespace vernier::reference
