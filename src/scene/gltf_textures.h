#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "scene/gltf_document.h"
#include "scene/pending_images.h"
#include "scene/texture_from_image.h"

namespace vernier {

/// An image of the file and what its texels are read as: an image used as colour and as data is decoded twice.
using GltfImageUse = std::pair<int, TexelEncoding>;

/// What is there so far. A texture used twice is decoded once, and so are bytes that several images name.
struct GltfTextures {
  PendingImages& images;                                         ///< decode what textures ask for
  std::map<GltfImageUse, std::shared_ptr<const Texels>> texels;  ///< by image, until they are decoded
  std::map<std::pair<int, TexelEncoding>, int> numbers;          ///< by texture, in Scene::textures
  std::map<std::string, int> image_of_bytes;                     ///< by URI or bufferView the first image of it
};

/// Number in scene.textures of texture `index` of the file read as `encoding`, added on first use. EXT_texture_webp is
/// preferred to the plain source. -1, as if there were no texture, with an unsupported_gltf that names it, where there
/// is no image or it is KHR_texture_basisu without fallback; one that is broken is told of once it is decoded, or
/// refused in a strict document. Throws Error(refused) for a number that is out of range; `place` names who asks.
int gltf_scene_texture(GltfDocument& document, int index, TexelEncoding encoding, const std::string& place,
                       GltfTextures& textures, Scene& scene);

}  // namespace vernier
