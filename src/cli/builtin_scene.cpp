#include "cli/builtin_scene.h"

#include "cli/builtin_scene_bytes.h"
#include "scene/validate_scene.h"

namespace vernier {

Scene load_builtin_scene(const LoadOptions& options) {
  Scene scene = load_gltf_memory(kBuiltinSceneBytes, kBuiltinSceneName, options);
  validate_scene(scene);
  return scene;
}

}  // namespace vernier
