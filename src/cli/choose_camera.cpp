#include "cli/choose_camera.h"

#include <charconv>
#include <cmath>

#include "error.h"
#include "scene/frame_scene.h"

namespace vernier {
namespace {

glm::dvec3 axis(const Camera& camera, int column) {
  return glm::dvec3(camera.world_from_camera[column]);
}

[[noreturn]] void refuse_camera(const Scene& scene, const std::string& wanted) {
  std::string known;
  for (std::size_t index = 0; index < scene.cameras.size(); ++index) {
    const std::string& name = scene.cameras[index].name;
    known += (index == 0 ? "" : ", ") + std::to_string(index) + (name.empty() ? "" : " (" + name + ")");
  }
  throw Error(ErrorKind::usage, "--camera: there is no camera `" + wanted + "` in " + scene.source +
                                    "; there are: " + (known.empty() ? "none" : known));
}

const Camera& named_camera(const Scene& scene, const std::string& wanted) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == wanted) {
      return camera;
    }
  }
  std::size_t index = 0;
  const char* end = wanted.data() + wanted.size();
  const auto [rest, failure] = std::from_chars(wanted.data(), end, index);
  if (failure != std::errc() || rest != end || index >= scene.cameras.size()) {
    refuse_camera(scene, wanted);
  }
  return scene.cameras[index];
}

// A unit vector without overflow: view distances may be as large as double allows.
glm::dvec3 unit(const glm::dvec3& vector) {
  const double largest = std::fmax(std::fabs(vector.x), std::fmax(std::fabs(vector.y), std::fabs(vector.z)));
  return largest > 0.0 ? glm::normalize(vector / largest) : glm::dvec3(0.0);
}

Camera starting_camera(const Scene& scene, const SceneSettings& settings, double aspect) {
  if (!settings.camera.empty()) {
    return named_camera(scene, settings.camera);
  }
  if (!scene.cameras.empty()) {
    return scene.cameras.front();
  }
  const glm::dvec3 up = settings.up ? unit(*settings.up) : glm::dvec3(0.0, 1.0, 0.0);
  return frame_scene(scene, settings.vertical_fov.value_or(Camera{}.vertical_fov), aspect, up);
}

glm::dvec3 up_of(const SceneSettings& settings, const glm::dvec3& forward) {
  if (settings.up) {
    return *settings.up;
  }
  const glm::dvec3 y(0.0, 1.0, 0.0);
  return glm::cross(forward, y) == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, -1.0) : y;
}

void look(Camera& camera, const glm::dvec3& eye, const glm::dvec3& forward, const glm::dvec3& up) {
  const glm::dvec3 right = unit(glm::cross(forward, unit(up)));
  if (right == glm::dvec3(0.0)) {
    throw Error(ErrorKind::usage, "--up: it has no length or lies along the line of sight");
  }
  camera.world_from_camera = glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(right, forward), 0.0),
                                        glm::dvec4(-forward, 0.0), glm::dvec4(eye, 1.0));
}

glm::dvec3 middle_of(const Scene& scene) {
  const WorldBounds bounds = seen_bounds(scene);
  return bounds.lo * 0.5 + bounds.hi * 0.5;
}

void move_camera(Camera& camera, const Scene& scene, const SceneSettings& settings) {
  const glm::dvec3 eye = settings.eye.value_or(axis(camera, 3));
  glm::dvec3 forward = -axis(camera, 2);
  if (settings.eye || settings.target) {
    const glm::dvec3 target = settings.target ? *settings.target : middle_of(scene);
    forward = unit(target - eye);
    if (forward == glm::dvec3(0.0)) {
      throw Error(ErrorKind::usage,
                  std::string(settings.eye ? "--eye" : "--target") + ": eye and target are the same point");
    }
  }
  look(camera, eye, forward, up_of(settings, forward));
}

}  // namespace

Camera choose_camera(const Scene& scene, const SceneSettings& settings, double aspect) {
  Camera camera = starting_camera(scene, settings, aspect);
  if (settings.vertical_fov && camera.orthographic) {
    throw Error(ErrorKind::usage, "--fov: the camera is orthographic and has no field of view");
  }
  if (settings.view_height && !camera.orthographic) {
    throw Error(ErrorKind::usage, "--view-height: the camera is not orthographic; it has a field of view, --fov");
  }
  camera.vertical_fov = settings.vertical_fov.value_or(camera.vertical_fov);
  if (settings.view_height) {
    camera.half_height = *settings.view_height / 2.0;
  }
  if (settings.eye || settings.target || settings.up) {
    move_camera(camera, scene, settings);
  }
  return camera;
}

}  // namespace vernier
