#include "render/bake_instances.h"

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "bvh/corner_order.h"
#include "error.h"
#include "shared/render_constants.h"

namespace vernier {
namespace {

void put(std::uint32_t* vertex, std::uint32_t texel, const glm::vec4& value) {
  if (texel == NONE) return;
  for (int i = 0; i < 4; ++i)
    vertex[4 * texel + static_cast<std::uint32_t>(i)] = std::bit_cast<std::uint32_t>(value[i]);
}

/// v / |v| in double, rounded; zero stays zero.
glm::vec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0.0f);
}

glm::vec2 uv_at(const Mesh& mesh, std::size_t set, std::size_t i) {
  return mesh.uvs[set].empty() ? glm::vec2(0.0f) : mesh.uvs[set][i];
}

/// How directions of an instance become the world's.
struct DirectionTransform {
  glm::dmat3 tangent;
  glm::dmat3 normal;
  float handedness;  ///< -1 where the transform mirrors
};

void bake_vertex(const Mesh& mesh, std::size_t i, const DirectionTransform& transform, const VertexLayout& layout,
                 std::uint32_t* out) {
  const glm::vec3 n = mesh.normals.empty() ? glm::vec3(0.0f) : unit(transform.normal * glm::dvec3(mesh.normals[i]));
  put(out, layout.normal, glm::vec4(n, 0.0f));
  put(out, layout.uv01, glm::vec4(uv_at(mesh, 0, i), uv_at(mesh, 1, i)));
  put(out, layout.uv23, glm::vec4(uv_at(mesh, 2, i), uv_at(mesh, 3, i)));
  put(out, layout.color, mesh.colors.empty() ? glm::vec4(1.0f) : mesh.colors[i]);
  if (mesh.tangents.empty()) {
    put(out, layout.tangent, glm::vec4(0.0f));
  } else {
    const glm::vec4& tangent = mesh.tangents[i];
    put(out, layout.tangent,
        glm::vec4(unit(transform.tangent * glm::dvec3(tangent)), tangent.w * transform.handedness));
  }
}

/// The corners in the order that they are traced in, the winding kept.
glm::uvec3 traced_order(const glm::uvec3& corner, const std::vector<glm::vec3>& positions) {
  const int first = corner_opposite_longest_edge(positions[corner.x], positions[corner.y], positions[corner.z]);
  return {corner[first], corner[(first + 1) % 3], corner[(first + 2) % 3]};
}

/// Appends one placed mesh, its corners to `corners` with ids that are their place there. `positions` is scratch space.
void bake_placed(const Mesh& mesh, const glm::dmat4& world_from_object, const TracedSpace& space,
                 std::vector<glm::vec3>& positions, std::vector<BvhTriangle>& corners, BakedScene& baked) {
  const glm::dmat3 direction(world_from_object);
  const bool mirrored = glm::determinant(direction) < 0.0;
  const DirectionTransform transform{direction, glm::transpose(glm::inverse(direction)), mirrored ? -1.0f : 1.0f};
  const std::size_t vertex_words = 4 * static_cast<std::size_t>(baked.layout.texels);
  const std::size_t first = baked.layout.texels == 0 ? 0 : baked.vertices.size() / vertex_words;
  baked.vertices.resize(baked.vertices.size() + vertex_words * mesh.positions.size());
  positions.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec4 world = world_from_object * glm::dvec4(mesh.positions[i], 1.0);
    positions[i] = glm::vec3(traced_from_world(space, glm::dvec3(world))) + 0.0f;  // -0 becomes +0
    bake_vertex(mesh, i, transform, baked.layout, baked.vertices.data() + vertex_words * (first + i));
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    glm::uvec3 corner = mesh.triangles[i];
    if (mirrored) std::swap(corner.y, corner.z);
    corner = traced_order(corner, positions);
    const auto id = static_cast<std::uint32_t>(corners.size());
    corners.push_back({positions[corner.x], positions[corner.y], positions[corner.z], id});
    const auto base = static_cast<std::uint32_t>(first);
    baked.triangles.insert(baked.triangles.end(),
                           {base + corner.x, base + corner.y, base + corner.z, mesh.triangle_materials[i]});
  }
}

/// Numbers the triangles that have none yet from `number` on.
void append_numbers(std::uint32_t number, BakedScene& baked) {
  const std::size_t first = baked.numbers.size();
  baked.numbers.resize(baked.corners.size());
  std::iota(baked.numbers.begin() + static_cast<std::ptrdiff_t>(first), baked.numbers.end(), number);
}

/// What the textures of materials are looked up by.
struct TextureReads {
  bool uv01 = false, uv23 = false, tangents = false;
};

TextureReads texture_reads(const Scene& scene) {
  TextureReads reads;
  for (const Material& material : scene.materials) {
    for (const TextureUse& use : material.textures) {
      reads.uv01 |= use.texture >= 0 && use.uv_set < 2;
      reads.uv23 |= use.texture >= 0 && use.uv_set >= 2;
    }
    reads.tangents |= material.textures[TEXTURE_SLOT_NORMAL].texture >= 0;
  }
  return reads;
}

}  // namespace

VertexLayout choose_vertex_layout(const Scene& scene, UvSets uvs) {
  const TextureReads reads = texture_reads(scene);
  const bool every_set = uvs == UvSets::all;
  bool normals = false, uv01 = false, uv23 = false, colors = false, tangents = false;
  for (const Mesh& mesh : scene.meshes) {
    normals |= !mesh.normals.empty();
    uv01 |= (every_set || reads.uv01) && (!mesh.uvs[0].empty() || !mesh.uvs[1].empty());
    uv23 |= (every_set || reads.uv23) && (!mesh.uvs[2].empty() || !mesh.uvs[3].empty());
    colors |= !mesh.colors.empty();
    tangents |= reads.tangents && !mesh.tangents.empty();
  }
  const bool any = normals || uv01 || uv23 || colors || tangents;
  VertexLayout layout{.texels = any ? 1u : 0u,
                      .normal = normals ? 0 : NONE,
                      .uv01 = NONE,
                      .uv23 = NONE,
                      .color = NONE,
                      .tangent = NONE};
  const auto place = [&](bool present, std::uint32_t& texel) {
    if (present) texel = layout.texels++;
  };
  place(uv01, layout.uv01);
  place(uv23, layout.uv23);
  place(colors, layout.color);
  place(tangents, layout.tangent);
  return layout;
}

BakedScene bake_instances(const Scene& scene, const TracedSpace& space, const InstancePlan& plan, UvSets uvs) {
  BakedScene baked;
  baked.layout = choose_vertex_layout(scene, uvs);
  if (plan.triangles >= NONE || plan.stored_vertices >= NONE) {
    throw Error(ErrorKind::refused, scene.source + ": " + std::to_string(plan.triangles) + " triangles and " +
                                        std::to_string(plan.stored_vertices) + " vertices are beyond 4294967294");
  }
  std::uint64_t copied = plan.stored_triangles;
  for (const std::uint32_t mesh : plan.meshes) copied -= scene.meshes[mesh].triangles.size();
  baked.corners.reserve(copied);
  baked.triangles.reserve(4 * plan.stored_triangles);
  baked.vertices.reserve(4 * static_cast<std::size_t>(baked.layout.texels) * plan.stored_vertices);
  baked.first_triangles.reserve(scene.instances.size());
  std::vector<glm::vec3> positions;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    baked.first_triangles.push_back(number);
    if (plan.place[i] == NONE) {
      bake_placed(mesh, instance.world_from_object, space, positions, baked.corners, baked);
      if (!plan.meshes.empty()) append_numbers(number, baked);
    }
    number += static_cast<std::uint32_t>(mesh.triangles.size());
  }
  return baked;
}

std::vector<BvhTriangle> bake_shared_mesh(const Mesh& mesh, const TracedSpace& space, BakedScene& baked) {
  std::vector<glm::vec3> positions;
  std::vector<BvhTriangle> corners;
  corners.reserve(mesh.triangles.size());
  bake_placed(mesh, glm::dmat4(1.0), space, positions, corners, baked);
  return corners;
}

}  // namespace vernier
