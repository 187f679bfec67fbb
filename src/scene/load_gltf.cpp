#include <utility>

#include "scene/gltf_cameras.h"
#include "scene/gltf_document.h"
#include "scene/gltf_draco.h"
#include "scene/gltf_lights.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_meshes.h"
#include "scene/gltf_meshopt.h"
#include "scene/gltf_nodes.h"
#include "scene/load_scene.h"

namespace vernier {
namespace {

void add_instances(GltfDocument& document, const std::vector<int>& nodes,
                   const std::vector<glm::dmat4>& world_from_node, GltfMeshes& meshes, Scene& scene) {
  for (const int index : nodes) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(index)];
    if (node.mesh < 0) continue;
    const std::uint32_t mesh = gltf_mesh_of_node(document, index, world_from_node, meshes, scene);
    const std::string& name = node.name.empty() ? scene.meshes[mesh].name : node.name;
    if (node.skin >= 0) {  // the joints have placed it; the node's own transform is ignored
      if (node.extensions.contains("EXT_mesh_gpu_instancing")) {
        unsupported_gltf(document, "node " + std::to_string(index),
                         "EXT_mesh_gpu_instancing is ignored on a mesh with a skin");
      }
      scene.instances.push_back({name, mesh, glm::dmat4(1.0)});
      continue;
    }
    for (const glm::dmat4& node_from_instance : gltf_node_instances(document, index)) {
      const glm::dmat4 world = world_from_node[static_cast<std::size_t>(index)] * node_from_instance;
      scene.instances.push_back({name, mesh, world});
    }
  }
}

void add_materials(GltfDocument& document, const GltfMeshes& meshes, LoadingScene& loading) {
  GltfTextures textures{loading.images, {}, {}, {}};
  Scene& scene = loading.scene;
  for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
    scene.materials.push_back(gltf_material(document, static_cast<int>(i), textures, scene));
  }
  if (meshes.uses_default_material) scene.materials.push_back(gltf_default_material());
}

void report_skipped(GltfDocument& document, const GltfMeshes& meshes) {
  if (meshes.skipped_primitives == 0) return;
  unsupported_gltf(document, meshes.first_skipped,
                   "points and lines are not drawn (" + std::to_string(meshes.skipped_primitives) +
                       (meshes.skipped_primitives == 1 ? " primitive)" : " primitives)"));
}

LoadingScene scene_of_document(GltfDocument document) {
  expand_gltf_meshopt(document);
  expand_gltf_draco(document);
  const std::vector<glm::dmat4> world_from_node = gltf_world_matrices(document);
  const GltfSceneNodes nodes = gltf_scene_nodes(document);

  LoadingScene loading;
  Scene& scene = loading.scene;
  scene.source = document.path;
  GltfMeshes meshes;
  add_instances(document, nodes.visible, world_from_node, meshes, scene);
  report_skipped(document, meshes);
  if (meshes.triangle_count == 0 || scene.instances.empty()) {
    refuse_gltf(document, "", "the scene has no triangles to show");
  }
  add_materials(document, meshes, loading);
  scene.cameras = gltf_cameras(document, nodes.all, world_from_node);
  scene.lights = gltf_lights(document, nodes.visible, world_from_node);
  scene.files = std::move(document.files);
  scene.warnings = std::move(document.warnings);
  return loading;
}

}  // namespace

LoadingScene open_gltf(const std::string& path, const LoadOptions& options) {
  LoadingScene loading = scene_of_document(read_gltf_document(path, options));
  std::vector<std::string>& files = loading.scene.files;
  files.insert(files.begin(), path);
  return loading;
}

LoadingScene open_gltf_memory(std::span<const std::byte> file, const std::string& name, const LoadOptions& options) {
  return scene_of_document(parse_gltf_document(file, name, options));
}

}  // namespace vernier
