#include "cli/camera_arguments.h"

namespace vernier {

SceneArguments with_camera(SceneArguments scene, const CameraWords& words) {
  scene.camera = words.camera;
  scene.eye = words.eye;
  scene.target = words.target;
  scene.up = words.up;
  scene.fov = words.fov;
  scene.view_height = words.view_height;
  return scene;
}

CameraWords words_of(const SceneArguments& scene) {
  return {scene.camera, scene.eye, scene.target, scene.up, scene.fov, scene.view_height};
}

}  // namespace vernier
