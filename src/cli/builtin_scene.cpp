#include "cli/builtin_scene.h"

#include "cli/builtin_scene_bytes.h"
#include "scene/validate_scene.h"

namespace vernier {
namespace {

// A room by day around the still life, for the mirror ball and the glass: the file cannot bring one.
constexpr glm::vec3 kSky(0.32f, 0.38f, 0.48f);
constexpr glm::vec3 kGround(0.10f, 0.08f, 0.07f);

}  // namespace

LoadingScene open_builtin_scene(const LoadOptions& options) {
  LoadingScene loading = open_gltf_memory(kBuiltinSceneBytes, kBuiltinSceneName, options);
  validate_scene(loading.scene);
  loading.scene.environment.sky = kSky;
  loading.scene.environment.ground = kGround;
  return loading;
}

}  // namespace vernier
