#pragma once

#include <map>
#include <string>

#include "scene/parse_mtl.h"
#include "scene/pending_images.h"
#include "scene/scene.h"

namespace vernier {

/// What the texels of an MTL map are turned into.
enum class MtlMapUse {
  color,   ///< sRGB colours as they are
  scalar,  ///< one channel, linear
  height,  ///< heights to a normal map
  normal   ///< a normal map as it is
};

/// When an image is decoded: with the others, by `ObjTextures::images`, or at once where it has to be known whether it
/// is sound.
enum class Decoding { later, at_once };

/// Textures of one OBJ file, each decoded once. Key: file, use, sampler and the options that change texels.
struct ObjTextures {
  PendingImages& images;   ///< decode them
  std::string obj_folder;  ///< folder of the OBJ file, empty or with a slash at its end
  bool strict = false;     ///< an image that is missing or broken is an Error(refused)
  std::map<std::string, int> texture_by_key = {};
};

/// Adds the texture of `map` to `scene`, or finds it again, and says how it is looked up: uv' = uv scale + offset in
/// MTL's upward v, converted to downward v. Clamping with -clamp on.
/// The file is sought in `mtl_folder`, then in the folder of the OBJ, then by its bare name in both: models travel with
/// paths of the machine they were made on. Backslashes are slashes.
/// A missing image is a warning of `scene` and no texture (-1), told once, and so is a broken one that is decoded at
/// once; of others `images` tells. Where `textures` are strict both throw Error(refused). No map: no texture.
TextureUse use_obj_texture(Scene& scene, ObjTextures& textures, const MtlTexture& map, MtlMapUse use,
                           const std::string& mtl_folder, Decoding decoding = Decoding::later);

}  // namespace vernier
