#pragma once

#include <array>
#include <map>
#include <string>

#include "scene/gltf_document.h"

namespace vernier {

/// Two names of one way to compress bufferViews; what the later one added cannot be decoded here.
inline constexpr std::array kMeshoptExtensions{"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// Compares the extensions a file names with those that are read. `places` has the extensions found in the file and the
/// first object that carries each (empty: the top level). Throws Error(refused) for one in `extensionsRequired` that is
/// not supported; any other such one is reported once by unsupported_gltf with its place. Extensions that change no
/// picture are passed over.
void check_gltf_extensions(GltfDocument& document, const std::map<std::string, std::string>& places);

}  // namespace vernier
