#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/gltf_document.h"
#include "scene/texture_from_image.h"

namespace vernier {

/// What has been decoded so far: an image used as colour and as data is decoded twice, a texture used twice once.
struct GltfTextures {
  std::map<std::pair<int, TexelEncoding>, std::shared_ptr<const Texels>> texels;  ///< by image; null: cannot be decoded
  std::map<std::pair<int, TexelEncoding>, int> numbers;                           ///< by texture, in Scene::textures
};

/// Number in scene.textures of texture `index` of the file read as `encoding`, added on first use. EXT_texture_webp is
/// preferred to the plain source. -1, as if there were no texture, with an unsupported_gltf that names it, where the
/// image cannot be found or decoded or is KHR_texture_basisu without fallback. Throws Error(refused) for a number that
/// is out of range; `place` names who asks.
int gltf_scene_texture(GltfDocument& document, int index, TexelEncoding encoding, const std::string& place,
                       GltfTextures& textures, Scene& scene);

}  // namespace vernier
