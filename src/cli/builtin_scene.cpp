#include "cli/builtin_scene.h"

#include "cli/builtin_scene_bytes.h"

namespace vernier {

Scene load_builtin_scene(const LoadOptions& options) {
  return load_gltf_memory(kBuiltinSceneBytes, kBuiltinSceneName, options);
}

}  // namespace vernier
