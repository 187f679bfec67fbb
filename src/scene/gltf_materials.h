#pragma once

#include "scene/gltf_document.h"
#include "scene/gltf_textures.h"

namespace vernier {

/// glTF 2.0, section 3.9.6: what a primitive without material looks like: white, metallic 1, roughness 1.
Material gltf_default_material();

/// Material `index` of the file with its extensions (KHR_materials_ior, _transmission, _volume, _specular,
/// _emissive_strength, _unlit, _pbrSpecularGlossiness, KHR_texture_transform); its textures are added to `scene`.
/// Factors outside their range are clamped. Throws Error(refused) for an unknown alpha mode or a texture number out of
/// range.
Material gltf_material(GltfDocument& document, int index, GltfTextures& textures, Scene& scene);

}  // namespace vernier
