#include "scene/gltf_meshes.h"

#include <utility>

#include "scene/gltf_primitives.h"
#include "scene/gltf_skins.h"

namespace vernier {
namespace {

constexpr std::uint64_t kMaxElements = std::uint64_t{1} << 28;

/// Primitives that name the same accessors share their vertices.
using VertexSource = std::pair<std::map<std::string, int>, std::vector<std::map<std::string, int>>>;

template <typename T>
void append_or_fill(std::vector<T>& all, const std::vector<T>& part, std::size_t before, std::size_t added,
                    const T& none) {
  if (all.empty() && part.empty()) return;
  all.resize(before, none);
  all.insert(all.end(), part.begin(), part.end());
  all.resize(before + added, none);
}

void append_vertices(Mesh& mesh, const Mesh& part) {
  const std::size_t before = mesh.positions.size();
  const std::size_t added = part.positions.size();
  append_or_fill(mesh.normals, part.normals, before, added, glm::vec3(0.0f));
  append_or_fill(mesh.tangents, part.tangents, before, added, glm::vec4(0.0f));
  append_or_fill(mesh.colors, part.colors, before, added, glm::vec4(1.0f));
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    append_or_fill(mesh.uvs[set], part.uvs[set], before, added, glm::vec2(0.0f));
  }
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
}

struct Pose {
  std::vector<double> weights;
  std::vector<glm::dmat4> joints;
  bool is_skinned = false;
};

Mesh posed_vertices(GltfDocument& document, const tinygltf::Primitive& primitive, const Pose& pose,
                    const std::string& place) {
  Mesh part = read_gltf_vertices(document, primitive, place);
  apply_gltf_morph_targets(document, primitive, pose.weights, place, part);
  if (pose.is_skinned) apply_gltf_skin(document, primitive, pose.joints, place, part);
  normalise_gltf_directions(part);
  return part;
}

/// False, with a note, for a primitive that shows nothing.
bool is_drawn(GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& place,
              GltfMeshes& meshes) {
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    refuse_gltf(document, place, "mode " + std::to_string(primitive.mode) + " does not exist");
  }
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    if (meshes.skipped_primitives++ == 0) meshes.first_skipped = place;
    return false;
  }
  if (!primitive.attributes.contains("POSITION")) {
    warn_gltf(document, place, "it has no POSITION and is not shown");
    return false;
  }
  return true;
}

void check_total(const GltfDocument& document, const std::string& place, const GltfMeshes& meshes) {
  if (meshes.vertex_count > kMaxElements || meshes.triangle_count > kMaxElements) {
    refuse_gltf(document, place, "more than " + std::to_string(kMaxElements) + " vertices or triangles in all");
  }
}

Mesh make_mesh(GltfDocument& document, int index, const Pose& pose, GltfMeshes& meshes) {
  const tinygltf::Mesh& source = document.model.meshes[static_cast<std::size_t>(index)];
  Mesh mesh;
  mesh.name = source.name;
  std::map<VertexSource, std::pair<std::size_t, std::size_t>> known;  // first vertex and count
  for (std::size_t p = 0; p < source.primitives.size(); ++p) {
    const tinygltf::Primitive& primitive = source.primitives[p];
    const std::string place = "mesh " + std::to_string(index) + ", primitive " + std::to_string(p);
    if (!is_drawn(document, primitive, place, meshes)) continue;
    const VertexSource vertices{primitive.attributes, primitive.targets};
    auto range = known.find(vertices);
    if (range == known.end()) {
      const Mesh part = posed_vertices(document, primitive, pose, place);
      range = known.emplace(vertices, std::pair(mesh.positions.size(), part.positions.size())).first;
      meshes.vertex_count += part.positions.size();
      check_total(document, place, meshes);
      append_vertices(mesh, part);
    }
    const auto [first, count] = range->second;
    const std::vector<glm::uvec3> triangles = read_gltf_triangles(document, primitive, count, place);
    meshes.triangle_count += triangles.size();
    check_total(document, place, meshes);
    for (const glm::uvec3& triangle : triangles) mesh.triangles.push_back(triangle + static_cast<std::uint32_t>(first));
    const std::size_t default_material = document.model.materials.size();
    meshes.uses_default_material |= primitive.material < 0 && !triangles.empty();
    mesh.triangle_materials.resize(
        mesh.triangles.size(),
        static_cast<std::uint32_t>(primitive.material < 0 ? default_material
                                                          : static_cast<std::size_t>(primitive.material)));
  }
  return mesh;
}

}  // namespace

std::uint32_t gltf_mesh_of_node(GltfDocument& document, int node_index, std::span<const glm::dmat4> world_from_node,
                                GltfMeshes& meshes, Scene& scene) {
  const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(node_index)];
  const tinygltf::Mesh& source = document.model.meshes[static_cast<std::size_t>(node.mesh)];
  const std::vector<double>& weights = node.weights.empty() ? source.weights : node.weights;
  const GltfPose key{node.mesh, node.skin, weights};
  if (const auto found = meshes.made.find(key); found != meshes.made.end()) return found->second;
  Pose pose{weights, {}, node.skin >= 0};
  if (pose.is_skinned) pose.joints = gltf_joint_matrices(document, node.skin, world_from_node);
  const auto number = static_cast<std::uint32_t>(scene.meshes.size());
  scene.meshes.push_back(make_mesh(document, node.mesh, pose, meshes));
  meshes.made.emplace(key, number);
  return number;
}

}  // namespace vernier
