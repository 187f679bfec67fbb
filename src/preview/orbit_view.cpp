#include "preview/orbit_view.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace vernier {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNearestPole = kPi / 180.0;

glm::dvec3 axis(const OrbitView& view, int column) {
  return glm::dvec3(view.camera.world_from_camera[column]);
}

glm::dvec3 eye(const OrbitView& view) {
  return axis(view, 3);
}

double distance(const OrbitView& view) {
  return glm::length(view.target - eye(view));
}

OrbitView shifted(OrbitView view, const glm::dvec3& by) {
  view.camera.world_from_camera[3] += glm::dvec4(by, 0.0);
  view.target += by;
  return view;
}

/// `view` turned as a whole by `turn` around its target.
OrbitView turned(OrbitView view, const glm::dmat4& turn) {
  const glm::dmat4 there = glm::translate(glm::dmat4(1.0), view.target);
  const glm::dmat4 back = glm::translate(glm::dmat4(1.0), -view.target);
  view.camera.world_from_camera = there * turn * back * view.camera.world_from_camera;
  return view;
}

}  // namespace

OrbitView orbit_view(const Camera& camera, const WorldBounds& bounds) {
  OrbitView view{camera, glm::dvec3(0.0)};
  const bool empty = bounds.lo.x > bounds.hi.x;
  const glm::dvec3 middle = empty ? glm::dvec3(0.0) : (bounds.lo + bounds.hi) * 0.5;
  const double extent = empty ? 1.0 : std::max(glm::length(bounds.hi - bounds.lo), 1e-6);
  const double along = glm::dot(middle - eye(view), -axis(view, 2));
  view.target = eye(view) - axis(view, 2) * std::max(along, extent * 1e-3);
  return view;
}

OrbitView framed(const OrbitView& view, const WorldBounds& bounds, double aspect) {
  const Camera all =
      frame_camera(bounds, view.camera.orthographic ? Camera{}.vertical_fov : view.camera.vertical_fov, aspect);
  Camera camera = view.camera;
  camera.world_from_camera = all.world_from_camera;
  OrbitView out = orbit_view(camera, bounds);
  // What the perspective camera sees of the target's plane.
  if (camera.orthographic) out.camera.half_height = distance(out) * std::tan(all.vertical_fov * 0.5);
  return out;
}

OrbitView orbited(const OrbitView& view, double yaw, double pitch) {
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const OrbitView yawed = turned(view, glm::rotate(glm::dmat4(1.0), -yaw, up));
  const double from_pole = std::acos(std::clamp(glm::dot(axis(yawed, 2), up), -1.0, 1.0));
  // A camera that looks along Y already may leave the pole, but nothing goes nearer.
  const double lowest = std::min(kNearestPole, from_pole);
  const double highest = std::max(kPi - kNearestPole, from_pole);
  const double wanted = std::clamp(from_pole - pitch, lowest, highest);
  return turned(yawed, glm::rotate(glm::dmat4(1.0), wanted - from_pole, axis(yawed, 0)));
}

OrbitView panned(const OrbitView& view, double right, double up) {
  const Camera& camera = view.camera;
  const double height =
      camera.orthographic ? 2.0 * camera.half_height : 2.0 * std::tan(camera.vertical_fov * 0.5) * distance(view);
  return shifted(view, (axis(view, 0) * right + axis(view, 1) * up) * height);
}

OrbitView zoomed(const OrbitView& view, double factor) {
  OrbitView out = view;
  if (view.camera.orthographic) {
    out.camera.half_height *= factor;
  } else {
    out.camera.world_from_camera[3] = glm::dvec4(view.target + (eye(view) - view.target) * factor, 1.0);
  }
  return out;
}

OrbitView moved(const OrbitView& view, const glm::dvec3& steps) {
  return shifted(view, (axis(view, 0) * steps.x + axis(view, 1) * steps.y - axis(view, 2) * steps.z) * distance(view));
}

}  // namespace vernier
