#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "scene/pending_images.h"
#include "scene/scene.h"

namespace vernier {

/// Limits and habits of loading.
struct LoadOptions {
  bool strict = false;  ///< what would be a warning about an unsupported feature is an Error (refused)
};

/// A scene as read from its files, whose images are still being decoded.
struct LoadingScene {
  Scene scene;           ///< all but the texels of its textures, of which some may still turn out to be broken
  PendingImages images;  ///< give it those
};

/// Whether `path` ends in what open_scene takes: .gltf, .glb or .obj, in any case of letters.
bool has_scene_extension(const std::string& path);

/// Reads a scene file and begins to decode its images; the extension (.gltf, .glb, .obj, any case) picks the loader.
/// The scene has passed validate_scene. Throws Error(refused) with file and place for anything broken, missing or too
/// large.
LoadingScene open_scene(const std::string& path, const LoadOptions& options);

/// Waits for the images of `loading`. Throws as PendingImages::finish.
Scene finish(LoadingScene loading);

/// Both in one.
Scene load_scene(const std::string& path, const LoadOptions& options);

/// Reads glTF 2.0, text or binary; not yet validated.
LoadingScene open_gltf(const std::string& path, const LoadOptions& options);

/// The same from the bytes `file` of a file called `name` (for messages and relative URIs).
LoadingScene open_gltf_memory(std::span<const std::byte> file, const std::string& name, const LoadOptions& options);

/// Reads Wavefront OBJ with its MTL files; not yet validated.
LoadingScene open_obj(const std::string& path, const LoadOptions& options);

}  // namespace vernier
