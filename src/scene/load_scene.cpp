#include "scene/load_scene.h"

#include <utility>

#include "error.h"
#include "image/file_format.h"
#include "scene/flat_normals.h"
#include "scene/validate_scene.h"

namespace vernier {
namespace {

bool is_gltf(const std::string& extension) {
  return extension == ".gltf" || extension == ".glb";
}

LoadingScene open_by_extension(const std::string& path, const LoadOptions& options) {
  const std::string extension = lower_case_extension(path);
  if (is_gltf(extension)) return open_gltf(path, options);
  if (extension == ".obj") return open_obj(path, options);
  throw Error(ErrorKind::refused, path + ": not a scene file by its name, which must end in .gltf, .glb or .obj");
}

}  // namespace

bool has_scene_extension(const std::string& path) {
  const std::string extension = lower_case_extension(path);
  return is_gltf(extension) || extension == ".obj";
}

LoadingScene open_scene(const std::string& path, const LoadOptions& options) {
  LoadingScene loading = open_by_extension(path, options);
  validate_scene(loading.scene);
  drop_flat_normals(loading.scene);
  return loading;
}

Scene finish(LoadingScene loading) {
  loading.images.finish(loading.scene);
  return std::move(loading.scene);
}

Scene load_scene(const std::string& path, const LoadOptions& options) {
  return finish(open_scene(path, options));
}

}  // namespace vernier
