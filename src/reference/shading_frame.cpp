#include "reference/shading_frame.h"

#include <array>
#include <cmath>
#include <optional>

#include "reference/vertex_values.h"

namespace vernier::reference {

namespace {

std::optional<glm::dvec3> unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  if (!(length > 0.0)) return std::nullopt;
  return v / length;
}

struct Tangents {
  glm::dvec3 tangent;
  glm::dvec3 bitangent;
};

const Mesh& mesh_of(const TracedScene& scene, const Triangle& triangle) {
  return scene.scene->meshes[scene.scene->instances[triangle.instance].mesh];
}

using CornerNormals = std::array<glm::dvec3, 3>;

// In the world, unit; none where the mesh has none or a corner's is zero.
std::optional<CornerNormals> corner_normals(const TracedScene& scene, const Triangle& triangle) {
  const Mesh& mesh = mesh_of(scene, triangle);
  if (mesh.normals.empty()) return std::nullopt;
  CornerNormals normals;
  for (int corner = 0; corner < 3; ++corner) {
    const glm::dvec3 normal(mesh.normals[triangle.vertices[corner]]);
    const auto world = unit(scene.baked.frames[triangle.instance].world_from_normal * normal);
    if (!world) return std::nullopt;
    normals[corner] = *world;
  }
  return normals;
}

// The way from `position` to the tangent planes of the corners that lie above it, weighed.
glm::dvec3 rise_of(const Triangle& triangle, const CornerNormals& normals, const glm::dvec3& weights,
                   const glm::dvec3& position) {
  glm::dvec3 rise(0.0);
  for (int corner = 0; corner < 3; ++corner) {
    const double height = glm::dot(triangle.corners[corner] - position, normals[corner]);
    if (height > 0.0) rise += weights[corner] * height * normals[corner];
  }
  return rise;
}

// Sets the normal and the rise that the vertices say; `frame` has the triangle's own normal, towards the viewer.
void round_off(const TracedScene& scene, const Triangle& triangle, const glm::dvec3& weights, ShadingFrame& frame) {
  std::optional<CornerNormals> normals = corner_normals(scene, triangle);
  if (!normals) return;
  const auto smooth = unit(weights[0] * (*normals)[0] + weights[1] * (*normals)[1] + weights[2] * (*normals)[2]);
  if (!smooth) return;
  const bool along = glm::dot(*smooth, triangle.normal) >= 0.0;
  const double side = along == frame.front ? 1.0 : -1.0;
  for (glm::dvec3& normal : *normals) normal *= side;
  frame.shading_normal = side * *smooth;
  frame.rise = rise_of(triangle, *normals, weights, frame.position);
}

// The weighted tangent of the vertices; none where the mesh has none or a corner's is zero.
std::optional<glm::dvec3> vertex_tangent(const TracedScene& scene, const Triangle& triangle,
                                         const glm::dvec3& weights) {
  const Mesh& mesh = mesh_of(scene, triangle);
  if (mesh.tangents.empty()) return std::nullopt;
  glm::dvec3 sum(0.0);
  for (int corner = 0; corner < 3; ++corner) {
    const glm::dvec3 tangent(mesh.tangents[triangle.vertices[corner]]);
    const auto world = unit(scene.baked.frames[triangle.instance].world_from_tangent * tangent);
    if (!world) return std::nullopt;
    sum += weights[corner] * *world;
  }
  return sum;
}

std::optional<Tangents> tangents_from_vertices(const TracedScene& scene, const Triangle& triangle, glm::dvec3 sum,
                                               const glm::dvec3& normal) {
  const auto tangent = unit(sum - normal * glm::dot(normal, sum));
  if (!tangent) return std::nullopt;
  const double handedness = mesh_of(scene, triangle).tangents[triangle.vertices[0]].w;
  const double mirrored = scene.baked.frames[triangle.instance].handedness;
  return Tangents{*tangent, glm::cross(normal, *tangent) * handedness * mirrored};
}

std::optional<Tangents> tangents_from_uvs(const TracedScene& scene, const Triangle& triangle,
                                          const glm::dvec3& normal) {
  const TextureUse& use = scene.scene->materials[triangle.material].textures[TEXTURE_SLOT_NORMAL];
  const std::array<glm::dvec2, 3> uvs = corner_uvs(*scene.scene, triangle, use.uv_set);
  const glm::dmat2 along_image(glm::dvec2(use.uv_from_vertex_uv[0]), glm::dvec2(use.uv_from_vertex_uv[1]));
  const glm::dvec2 difference1 = uvs[1] - uvs[0];
  const glm::dvec2 difference2 = uvs[2] - uvs[0];
  const double area = difference1.x * difference2.y - difference2.x * difference1.y;
  const double turn = glm::determinant(along_image);
  if (!(std::abs(area) > 0.0 && std::abs(turn) > 0.0)) return std::nullopt;
  const double sign = (area > 0.0) == (turn > 0.0) ? 1.0 : -1.0;
  const glm::dvec2 uv1 = along_image * difference1;
  const glm::dvec2 uv2 = along_image * difference2;
  const glm::dvec3 e1 = triangle.corners[1] - triangle.corners[0];
  const glm::dvec3 e2 = triangle.corners[2] - triangle.corners[0];
  const glm::dvec3 along_u = (e1 * uv2.y - e2 * uv1.y) * sign;
  const auto tangent = unit(along_u - normal * glm::dot(normal, along_u));
  if (!tangent) return std::nullopt;
  return Tangents{*tangent, -glm::cross(normal, *tangent) * sign};
}

glm::dvec3 textured_normal(const TracedScene& scene, const Triangle& triangle, const glm::dvec3& weights,
                           const glm::dvec3& normal) {
  const Material& material = scene.scene->materials[triangle.material];
  if (material.textures[TEXTURE_SLOT_NORMAL].texture < 0) return normal;
  const auto vertex_sum = vertex_tangent(scene, triangle, weights);
  const auto tangents = vertex_sum ? tangents_from_vertices(scene, triangle, *vertex_sum, normal)
                                   : tangents_from_uvs(scene, triangle, normal);
  if (!tangents) return normal;
  const glm::dvec3 rgb(texture_at(*scene.scene, triangle, weights, TEXTURE_SLOT_NORMAL));
  const glm::dvec3 m = (2.0 * rgb - 1.0) * glm::dvec3(material.normal_scale, material.normal_scale, 1.0);
  return unit(m.x * tangents->tangent + m.y * tangents->bitangent + m.z * normal).value_or(normal);
}

}  // namespace

ShadingFrame shading_frame(const TracedScene& scene, const Hit& hit, const glm::dvec3& direction) {
  const Triangle& triangle = scene.baked.triangles[hit.triangle];
  ShadingFrame frame;
  frame.position = triangle.corners[0] + hit.weights.y * (triangle.corners[1] - triangle.corners[0]) +
                   hit.weights.z * (triangle.corners[2] - triangle.corners[0]);
  frame.front = glm::dot(triangle.normal, direction) <= 0.0;
  const double side = frame.front ? 1.0 : -1.0;
  frame.geometric_normal = side * triangle.normal;
  frame.shading_normal = frame.geometric_normal;
  round_off(scene, triangle, hit.weights, frame);
  frame.shading_normal = side * textured_normal(scene, triangle, hit.weights, side * frame.shading_normal);
  return frame;
}

}  // namespace vernier::reference
