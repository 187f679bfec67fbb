#include "scene/gltf_references.h"

#include <algorithm>
#include <cmath>

namespace vernier {
namespace {

std::string numbered(const char* what, std::size_t index) {
  return std::string(what) + " " + std::to_string(index);
}

void check_accessors(const GltfDocument& document) {
  const tinygltf::Model& model = document.model;
  const std::size_t view_count = model.bufferViews.size();
  for (std::size_t i = 0; i < view_count; ++i) {
    check_gltf_index(document, numbered("bufferView", i), "buffer", model.bufferViews[i].buffer,
                     document.buffers.size());
  }
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    const tinygltf::Accessor& accessor = model.accessors[i];
    const std::string place = numbered("accessor", i);
    check_gltf_optional_index(document, place, "bufferView", accessor.bufferView, view_count);
    if (!accessor.sparse.isSparse) continue;
    check_gltf_index(document, place + ", sparse indices", "bufferView", accessor.sparse.indices.bufferView,
                     view_count);
    check_gltf_index(document, place + ", sparse values", "bufferView", accessor.sparse.values.bufferView, view_count);
  }
}

void check_meshes(const GltfDocument& document) {
  const tinygltf::Model& model = document.model;
  const std::size_t accessor_count = model.accessors.size();
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    for (std::size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
      const tinygltf::Primitive& primitive = model.meshes[m].primitives[p];
      const std::string place = numbered("mesh", m) + ", primitive " + std::to_string(p);
      check_gltf_optional_index(document, place, "material", primitive.material, model.materials.size());
      check_gltf_optional_index(document, place, "accessor", primitive.indices, accessor_count);
      for (const auto& [name, index] : primitive.attributes) {
        check_gltf_index(document, place + ", " + name, "accessor", index, accessor_count);
      }
      for (const auto& target : primitive.targets) {
        for (const auto& [name, index] : target) {
          check_gltf_index(document, place + ", target " + name, "accessor", index, accessor_count);
        }
      }
    }
  }
}

void check_length(const GltfDocument& document, const std::string& place, const char* what,
                  const std::vector<double>& values, std::size_t length) {
  if (!values.empty() && values.size() != length) {
    refuse_gltf(
        document, place,
        std::string(what) + " has " + std::to_string(values.size()) + " numbers, not " + std::to_string(length));
  }
}

void check_nodes(const GltfDocument& document) {
  const tinygltf::Model& model = document.model;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const tinygltf::Node& node = model.nodes[i];
    const std::string place = numbered("node", i);
    check_gltf_optional_index(document, place, "mesh", node.mesh, model.meshes.size());
    check_gltf_optional_index(document, place, "skin", node.skin, model.skins.size());
    check_gltf_optional_index(document, place, "camera", node.camera, model.cameras.size());
    for (const int child : node.children) check_gltf_index(document, place, "node", child, model.nodes.size());
    check_length(document, place, "matrix", node.matrix, 16);
    check_length(document, place, "translation", node.translation, 3);
    check_length(document, place, "rotation", node.rotation, 4);
    check_length(document, place, "scale", node.scale, 3);
  }
  for (std::size_t i = 0; i < model.scenes.size(); ++i) {
    for (const int node : model.scenes[i].nodes) {
      check_gltf_index(document, numbered("scene", i), "node", node, model.nodes.size());
    }
  }
  check_gltf_optional_index(document, "", "scene", model.defaultScene, model.scenes.size());
  for (std::size_t i = 0; i < model.skins.size(); ++i) {
    const tinygltf::Skin& skin = model.skins[i];
    const std::string place = numbered("skin", i);
    for (const int joint : skin.joints) check_gltf_index(document, place, "node", joint, model.nodes.size());
    check_gltf_optional_index(document, place, "accessor", skin.inverseBindMatrices, model.accessors.size());
    check_gltf_optional_index(document, place, "node", skin.skeleton, model.nodes.size());
  }
}

void check_textures(const GltfDocument& document) {
  const tinygltf::Model& model = document.model;
  for (std::size_t i = 0; i < document.images.size(); ++i) {
    check_gltf_optional_index(document, numbered("image", i), "bufferView", document.images[i].buffer_view,
                              model.bufferViews.size());
  }
  for (std::size_t i = 0; i < model.textures.size(); ++i) {
    const std::string place = numbered("texture", i);
    check_gltf_optional_index(document, place, "image", model.textures[i].source, document.images.size());
    check_gltf_optional_index(document, place, "sampler", model.textures[i].sampler, model.samplers.size());
  }
}

// With one parent at most, a node that no root reaches is on a cycle or hangs from one.
void check_tree(const GltfDocument& document) {
  const std::vector<tinygltf::Node>& nodes = document.model.nodes;
  std::vector<int> parents(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        refuse_gltf(document, numbered("node", std::size_t(child)),
                    "it is a child of node " + std::to_string(parent) + " and of node " + std::to_string(i));
      }
      parent = static_cast<int>(i);
    }
  }
  std::vector<int> reached;
  std::vector<bool> is_reached(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (parents[i] < 0) reached.push_back(static_cast<int>(i));
  }
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const auto node = static_cast<std::size_t>(reached[next]);
    is_reached[node] = true;
    reached.insert(reached.end(), nodes[node].children.begin(), nodes[node].children.end());
  }
  const auto lost = std::find(is_reached.begin(), is_reached.end(), false);
  if (lost != is_reached.end()) {
    refuse_gltf(document, numbered("node", std::size_t(lost - is_reached.begin())), "it is its own ancestor (a cycle)");
  }
}

}  // namespace

void check_gltf_index(const GltfDocument& document, const std::string& place, const char* what, int index,
                      std::size_t count) {
  if (index < 0 || static_cast<std::size_t>(index) >= count) {
    refuse_gltf(
        document, place,
        std::string(what) + " " + std::to_string(index) + " does not exist, the file has " + std::to_string(count));
  }
}

void check_gltf_optional_index(const GltfDocument& document, const std::string& place, const char* what, int index,
                               std::size_t count) {
  if (index != -1) check_gltf_index(document, place, what, index, count);
}

void check_gltf_references(const GltfDocument& document) {
  check_accessors(document);
  check_meshes(document);
  check_nodes(document);
  check_textures(document);
  check_tree(document);
}

}  // namespace vernier
