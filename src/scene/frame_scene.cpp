#include "scene/frame_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/view_side.h"

namespace vernier {
namespace {

// Share of the half-angle's tangent that stays free around the box.
constexpr double kMargin = 1.05;
// Thinner than this part of the largest extent a box counts as flat.
constexpr double kFlat = 1e-3;
// Three quarters view, from the right, above and in front.
constexpr glm::dvec3 kThreeQuarters(0.9, 0.6, 1.0);
// Share of the other axes in the view of a flat box, and more for the one that makes it look lit from the front.
constexpr double kOblique = 0.35;

// A box without extent is given a metre, one without any is at the origin.
WorldBounds with_extent(const WorldBounds& bounds) {
  const bool empty = !(glm::all(glm::lessThanEqual(bounds.lo, bounds.hi)));
  const WorldBounds box = empty ? WorldBounds{glm::dvec3(0.0), glm::dvec3(0.0)} : bounds;
  if (box.lo != box.hi) return box;
  return {box.lo - glm::dvec3(0.5), box.hi + glm::dvec3(0.5)};
}

// Direction from the box towards the camera. A flat box is seen from nearer its thin axis, from the positive side.
glm::dvec3 view_side(const WorldBounds& box) {
  const glm::dvec3 size = box.hi - box.lo;
  const double largest = std::max({size.x, size.y, size.z});
  int flat_axis = -1;
  int flat_count = 0;
  for (const int axis : {0, 1, 2}) {
    if (size[axis] >= kFlat * largest) continue;
    flat_axis = axis;
    ++flat_count;
  }
  // A line has no side to prefer.
  if (flat_count != 1) return glm::normalize(kThreeQuarters);
  glm::dvec3 side = kOblique * kThreeQuarters;
  side[flat_axis] = 1.0;
  return glm::normalize(side);
}

std::array<glm::dvec3, 8> corners_of(const WorldBounds& box) {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z};
  }
  return corners;
}

// Where the eye is along one image axis, and how far back it must be at least: for all corners
// |x - eye| <= slope (back - z), tight on both sides.
struct Fit {
  double eye;
  double back;
};

Fit fit_axis(const std::array<glm::dvec3, 8>& corners, const glm::dvec3& axis, const glm::dvec3& backward,
             double slope) {
  double right = -std::numeric_limits<double>::infinity();
  double left = right;
  for (const glm::dvec3& corner : corners) {
    const double x = glm::dot(corner, axis);
    const double z = glm::dot(corner, backward);
    right = std::max(right, slope * z + x);
    left = std::max(left, slope * z - x);
  }
  return {0.5 * (right - left), 0.5 * (right + left) / slope};
}

// From the side `z`, which is not vertical.
Camera fitted_camera(const WorldBounds& box, const glm::dvec3& z, double vertical_fov, double aspect) {
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), z));
  const glm::dvec3 y = glm::cross(z, x);
  // About the middle, so that far boxes lose no digits.
  const glm::dvec3 middle = 0.5 * box.lo + 0.5 * box.hi;
  const std::array<glm::dvec3, 8> corners = corners_of({box.lo - middle, box.hi - middle});
  const double slope = std::tan(0.5 * vertical_fov) / kMargin;
  const Fit horizontal = fit_axis(corners, x, z, aspect * slope);
  const Fit vertical = fit_axis(corners, y, z, slope);
  const double back = std::max(horizontal.back, vertical.back);
  const glm::dvec3 eye = middle + horizontal.eye * x + vertical.eye * y + back * z;
  Camera camera;
  camera.name = "framed";
  camera.vertical_fov = vertical_fov;
  camera.world_from_camera = glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(eye, 1));
  return camera;
}

}  // namespace

WorldBounds world_bounds(const Scene& scene) {
  WorldBounds bounds{glm::dvec3(std::numeric_limits<double>::infinity()),
                     glm::dvec3(-std::numeric_limits<double>::infinity())};
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const glm::uvec3& triangle : mesh.triangles) {
      // Dropped ones have no place.
      if (triangle == glm::uvec3(0)) continue;
      for (int c = 0; c < 3; ++c) {
        const glm::dvec3 corner(instance.world_from_object * glm::dvec4(mesh.positions[triangle[c]], 1.0));
        bounds.lo = glm::min(bounds.lo, corner);
        bounds.hi = glm::max(bounds.hi, corner);
      }
    }
  }
  return bounds;
}

Camera frame_camera(const WorldBounds& bounds, double vertical_fov, double aspect) {
  const WorldBounds box = with_extent(bounds);
  return fitted_camera(box, view_side(box), vertical_fov, aspect);
}

Camera frame_scene(const Scene& scene, double vertical_fov, double aspect) {
  const WorldBounds box = with_extent(world_bounds(scene));
  return fitted_camera(box, choose_view_side(scene, box, view_side(box)), vertical_fov, aspect);
}

}  // namespace vernier
