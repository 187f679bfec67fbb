#include "scene/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace vernier {
namespace {

constexpr std::array<std::string_view, 18> kSupported = {"KHR_lights_punctual",
                                                         "KHR_materials_ior",
                                                         "KHR_materials_transmission",
                                                         "KHR_materials_volume",
                                                         "KHR_materials_specular",
                                                         "KHR_materials_emissive_strength",
                                                         "KHR_materials_unlit",
                                                         "KHR_materials_pbrSpecularGlossiness",
                                                         "KHR_texture_transform",
                                                         "KHR_mesh_quantization",
                                                         "KHR_node_visibility",
                                                         "EXT_mesh_gpu_instancing",
                                                         "EXT_texture_webp",
                                                         "KHR_draco_mesh_compression",
                                                         "EXT_meshopt_compression",
                                                         "KHR_meshopt_compression",
                                                         "KHR_xmp",
                                                         "KHR_xmp_json_ld"};  // the last two: metadata, nothing to see

template <typename Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void check_gltf_extensions(GltfDocument& document, const std::map<std::string, std::string>& places) {
  for (const std::string& name : document.model.extensionsRequired) {
    if (!contains(kSupported, name)) refuse_gltf(document, "extensionsRequired", name + " is not supported");
  }
  for (const auto& [name, place] : places) {
    // gltf_textures reports it per texture, and says whether a fallback was found.
    if (contains(kSupported, name) || name == "KHR_texture_basisu") continue;
    unsupported_gltf(document, place.empty() ? "extensions" : place, "extension " + name + " is ignored");
  }
  for (const std::string& name : document.model.extensionsUsed) {
    if (contains(kSupported, name) || places.contains(name)) continue;
    unsupported_gltf(document, "extensionsUsed", "extension " + name + " is ignored");
  }
}

}  // namespace vernier
