#pragma once

#include <map>
#include <string>

#include "scene/gltf_document.h"

namespace vernier {

/// Compares the extensions a file names with those that are read. `places` has the extensions found in the file and the
/// first object that carries each (empty: the top level). Throws Error(refused) for one in `extensionsRequired` that is
/// not supported; any other such one is reported once by unsupported_gltf with its place. Extensions that change no
/// picture are passed over.
void check_gltf_extensions(GltfDocument& document, const std::map<std::string, std::string>& places);

}  // namespace vernier
