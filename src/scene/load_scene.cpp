#include "scene/load_scene.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "error.h"
#include "scene/flat_normals.h"
#include "scene/validate_scene.h"

namespace vernier {
namespace {

std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Scene load_by_extension(const std::string& path, const LoadOptions& options) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".gltf" || extension == ".glb") return load_gltf(path, options);
  if (extension == ".obj") return load_obj(path, options);
  throw Error(ErrorKind::refused, path + ": not a scene file by its name, which must end in .gltf, .glb or .obj");
}

}  // namespace

Scene load_scene(const std::string& path, const LoadOptions& options) {
  Scene scene = load_by_extension(path, options);
  validate_scene(scene);
  drop_flat_normals(scene);
  return scene;
}

}  // namespace vernier
