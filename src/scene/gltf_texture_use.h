#pragma once

#include <string>

#include "scene/gltf_document.h"
#include "scene/gltf_textures.h"

namespace vernier {

/// A textureInfo object of the file: `index` -1 for none; `transform` is its KHR_texture_transform or nullptr.
struct GltfTextureReference {
  int index = -1;
  int uv_set = 0;
  const tinygltf::Value* transform = nullptr;
};

/// Base colour, metallic-roughness or emission.
GltfTextureReference texture_reference(const tinygltf::TextureInfo& texture);
/// Normal texture; its scale is the material's.
GltfTextureReference texture_reference(const tinygltf::NormalTextureInfo& texture);
/// Occlusion texture; its strength is the material's.
GltfTextureReference texture_reference(const tinygltf::OcclusionTextureInfo& texture);
/// The member `name` of an extension's object; none where it is missing. One without a valid index has -2, which is
/// refused later.
GltfTextureReference texture_reference(const tinygltf::Value& extension, const char* name);

/// uv_from_vertex_uv of a KHR_texture_transform: offset after rotation after scale. The rotation is counter-clockwise
/// for the image as seen, v pointing down: (u, v) -> (u cos + v sin, v cos - u sin), as TextureTransformTest of the
/// glTF sample models expects.
glm::mat3x2 gltf_uv_transform(const tinygltf::Value& transform);

/// The texture as a material uses it; its texCoord gives way to the one of the transform. A UV set from kUvSetCount on
/// is unsupported: no texture.
TextureUse gltf_texture_use(GltfDocument& document, const GltfTextureReference& reference, TexelEncoding encoding,
                            const std::string& place, GltfTextures& textures, Scene& scene);

}  // namespace vernier
