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

/// An image of the file and what its texels are read as: an image used as colour and as data is decoded twice.
using GltfImageUse = std::pair<int, TexelEncoding>;

/// What became of an image.
struct DecodedImage {
  std::shared_ptr<const Texels> texels;  ///< null: `fault` says why
  std::string fault;
  std::string path;  ///< of the file of its own that it was read from; empty where there is none
};

/// What has been decoded so far. A texture used twice is decoded once, and so is a file that several images name.
struct GltfTextures {
  std::map<GltfImageUse, DecodedImage> decoded;  ///< beforehand (decode_gltf_images); others when they are asked for
  std::vector<GltfImageUse>* wanted = nullptr;   ///< only notes what is asked for here and hands out one white texel
  std::map<GltfImageUse, std::shared_ptr<const Texels>> texels;  ///< by image; null: cannot be decoded
  std::map<std::pair<int, TexelEncoding>, int> numbers;          ///< by texture, in Scene::textures
  std::map<std::string, int> image_of_file;                      ///< by URI the first image that names it
};

/// Decodes `uses`, each there once, on all cores. Changes and tells nothing: gltf_scene_texture does when they are
/// used.
std::map<GltfImageUse, DecodedImage> decode_gltf_images(const GltfDocument& document,
                                                        const std::vector<GltfImageUse>& uses);

/// Number in scene.textures of texture `index` of the file read as `encoding`, added on first use. EXT_texture_webp is
/// preferred to the plain source. -1, as if there were no texture, with an unsupported_gltf that names it, where the
/// image cannot be found or decoded or is KHR_texture_basisu without fallback. Throws Error(refused) for a number that
/// is out of range; `place` names who asks.
int gltf_scene_texture(GltfDocument& document, int index, TexelEncoding encoding, const std::string& place,
                       GltfTextures& textures, Scene& scene);

}  // namespace vernier
