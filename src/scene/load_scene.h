#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "scene/scene.h"

namespace vernier {

/// Limits and habits of loading.
struct LoadOptions {
  bool strict = false;  ///< what would be a warning about an unsupported feature is an Error (refused)
};

/// Reads a scene file; the extension (.gltf, .glb, .obj, any case) picks the loader. The result has passed
/// validate_scene. Throws Error(refused) with file and place for anything broken, missing or too large.
Scene load_scene(const std::string& path, const LoadOptions& options);

/// Reads glTF 2.0, text or binary.
Scene load_gltf(const std::string& path, const LoadOptions& options);

/// Reads glTF 2.0, text or binary, from the bytes `file` of a file called `name` (for messages and relative URIs).
Scene load_gltf_memory(std::span<const std::byte> file, const std::string& name, const LoadOptions& options);

/// Reads Wavefront OBJ with its MTL files.
Scene load_obj(const std::string& path, const LoadOptions& options);

}  // namespace vernier
