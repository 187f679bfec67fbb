#include "scene/gltf_texture_use.h"

#include <cmath>

#include "scene/gltf_values.h"

namespace vernier {
namespace {

constexpr const char* kTransform = "KHR_texture_transform";

}  // namespace

GltfTextureReference texture_reference(const tinygltf::TextureInfo& texture) {
  return {texture.index, texture.texCoord, find_gltf_extension(texture.extensions, kTransform)};
}

GltfTextureReference texture_reference(const tinygltf::NormalTextureInfo& texture) {
  return {texture.index, texture.texCoord, find_gltf_extension(texture.extensions, kTransform)};
}

GltfTextureReference texture_reference(const tinygltf::OcclusionTextureInfo& texture) {
  return {texture.index, texture.texCoord, find_gltf_extension(texture.extensions, kTransform)};
}

GltfTextureReference texture_reference(const tinygltf::Value& extension, const char* name) {
  if (!extension.Has(name)) return {};
  const tinygltf::Value& texture = extension.Get(name);
  GltfTextureReference reference{gltf_index(texture, "index", -2), gltf_index(texture, "texCoord", 0), nullptr};
  if (texture.Has("extensions") && texture.Get("extensions").Has(kTransform)) {
    reference.transform = &texture.Get("extensions").Get(kTransform);
  }
  return reference;
}

glm::mat3x2 gltf_uv_transform(const tinygltf::Value& transform) {
  const glm::dvec2 offset = gltf_vector2(transform, "offset", glm::dvec2(0.0));
  const glm::dvec2 scale = gltf_vector2(transform, "scale", glm::dvec2(1.0));
  const double angle = gltf_number(transform, "rotation", 0.0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {gltf_float(c * scale.x), gltf_float(-s * scale.x), gltf_float(s * scale.y),
          gltf_float(c * scale.y), gltf_float(offset.x),     gltf_float(offset.y)};
}

TextureUse gltf_texture_use(GltfDocument& document, const GltfTextureReference& reference, TexelEncoding encoding,
                            const std::string& place, GltfTextures& textures, Scene& scene) {
  TextureUse use;
  if (reference.index == -1) return use;
  int uv_set = reference.uv_set;
  if (reference.transform != nullptr) {
    uv_set = gltf_index(*reference.transform, "texCoord", uv_set);
    use.uv_from_vertex_uv = gltf_uv_transform(*reference.transform);
  }
  use.texture = gltf_scene_texture(document, reference.index, encoding, place, textures, scene);
  if (uv_set < 0 || static_cast<std::size_t>(uv_set) >= kUvSetCount) {
    unsupported_gltf(document, place,
                     "texture " + std::to_string(reference.index) + " uses TEXCOORD_" + std::to_string(uv_set) +
                         ", which is not read: white");
    use.texture = -1;
    return use;
  }
  use.uv_set = static_cast<std::uint32_t>(uv_set);
  return use;
}

}  // namespace vernier
