#include "scene/frame_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "scene/mesh_faults.h"
#include "scene/view_side.h"

namespace vernier {
namespace {

// Share of the half-angle's tangent that stays free around the box.
constexpr double kMargin = 1.05;
// Distance of the eye from the nearest point at least, in diagonals of the box: no needle ends in the eye.
constexpr double kLeastDistance = 0.02;
// Vertices that are looked at one by one: a camera over more of them would take as long as the picture.
constexpr std::size_t kMostVisits = std::size_t{1} << 22;
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

std::vector<glm::dvec3> corners_of(const WorldBounds& box) {
  std::vector<glm::dvec3> corners(8);
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z};
  }
  return corners;
}

/// Which triangles count.
enum class Counted { traced, seen };

bool counts(const Mesh& mesh, const glm::uvec3& triangle, Counted counted) {
  if (counted == Counted::seen) return has_area(mesh, triangle);
  const glm::vec3 &a = mesh.positions[triangle.x], &b = mesh.positions[triangle.y], &c = mesh.positions[triangle.z];
  return a != b && b != c && c != a;
}

/// Which vertices of `mesh` are corners of triangles that count.
std::vector<bool> used_vertices(const Mesh& mesh, Counted counted) {
  std::vector<bool> used(mesh.positions.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    if (!counts(mesh, triangle, counted)) continue;
    for (int c = 0; c < 3; ++c) used[triangle[c]] = true;
  }
  return used;
}

/// The vertices of `mesh` that are corners of triangles that count.
std::vector<glm::vec3> used_positions(const Mesh& mesh, Counted counted) {
  const std::vector<bool> used = used_vertices(mesh, counted);
  std::vector<glm::vec3> positions;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) positions.push_back(mesh.positions[i]);
  }
  return positions;
}

/// The corners of the box around some points.
std::vector<glm::vec3> box_corners(const std::vector<glm::vec3>& points) {
  if (points.empty()) return {};
  WorldBounds box;
  for (const glm::vec3& point : points) grow(box, glm::dvec3(point));
  std::vector<glm::vec3> corners;
  for (const glm::dvec3& corner : corners_of(box)) corners.push_back(glm::vec3(corner));
  return corners;
}

/// Points of each mesh that stand for it wherever it is placed: its vertices, or where all instances have very many of
/// them together, the corners of the box around them.
std::vector<std::vector<glm::vec3>> outlines(const Scene& scene, Counted counted) {
  std::vector<std::size_t> instances(scene.meshes.size());
  std::size_t visits = 0;
  for (const Instance& instance : scene.instances) {
    ++instances[instance.mesh];
    visits += scene.meshes[instance.mesh].positions.size();
  }
  std::vector<std::vector<glm::vec3>> points(scene.meshes.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (instances[i] == 0) continue;
    points[i] = used_positions(scene.meshes[i], counted);
    if (visits > kMostVisits && instances[i] > 1) points[i] = box_corners(points[i]);
  }
  return points;
}

/// The points of every instance's outline in the world.
template <typename Visit>
void for_each_vertex(const Scene& scene, Counted counted, const Visit& visit) {
  const std::vector<std::vector<glm::vec3>> points = outlines(scene, counted);
  for (const Instance& instance : scene.instances) {
    for (const glm::vec3& point : points[instance.mesh]) {
      visit(glm::dvec3(instance.world_from_object * glm::dvec4(point, 1.0)));
    }
  }
}

/// How far back the eye must be at least along one image axis: for all points |x - eye| <= slope (back - z), with the
/// eye where that is tight on both sides.
double least_back(std::span<const glm::dvec3> points, int axis, double slope) {
  double right = -std::numeric_limits<double>::infinity();
  double left = right;
  for (const glm::dvec3& point : points) {
    right = std::max(right, slope * point.z + point[axis]);
    left = std::max(left, slope * point.z - point[axis]);
  }
  return 0.5 * (right + left) / slope;
}

/// Place of the eye along an image axis from which, that far back, the points reach as far to one side of the picture
/// as to the other. Exchanges the outermost points until they stay the same; every exchange lessens the larger reach.
double centered_eye(std::span<const glm::dvec3> points, int axis, double back) {
  constexpr int kMostExchanges = 16;
  double eye = 0.0;
  for (int i = 0; i < kMostExchanges; ++i) {
    const auto reach = [&](const glm::dvec3& point) { return (point[axis] - eye) / (back - point.z); };
    const auto [left, right] = std::ranges::minmax_element(points, {}, reach);
    const double left_depth = back - left->z;
    const double right_depth = back - right->z;
    const double next = ((*right)[axis] * left_depth + (*left)[axis] * right_depth) / (left_depth + right_depth);
    if (next == eye) break;
    eye = next;
  }
  return eye;
}

/// Sees all `points` from the side `z`, which is not vertical.
Camera fitted_camera(std::vector<glm::dvec3> points, const WorldBounds& box, const glm::dvec3& z, double vertical_fov,
                     double aspect, const glm::dvec3& up) {
  const glm::dvec3 right = glm::cross(up, z);
  const bool is_along = glm::dot(right, right) == 0.0;
  const glm::dvec3 x = glm::normalize(is_along ? glm::cross(glm::dvec3(0, 1, 0), z) : right);
  const glm::dvec3 y = glm::cross(z, x);
  // About the middle, so that far points lose no digits.
  const glm::dvec3 middle = 0.5 * box.lo + 0.5 * box.hi;
  const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(x, y, z));
  for (glm::dvec3& point : points) point = view_from_world * (point - middle);
  const double slope = std::tan(0.5 * vertical_fov) / kMargin;
  const double nearest = std::ranges::max(points, {}, &glm::dvec3::z).z;
  const double back = std::max({least_back(points, 0, aspect * slope), least_back(points, 1, slope),
                                nearest + kLeastDistance * glm::length(box.hi - box.lo)});
  const glm::dvec3 eye = middle + centered_eye(points, 0, back) * x + centered_eye(points, 1, back) * y + back * z;
  Camera camera;
  camera.name = "framed";
  camera.vertical_fov = vertical_fov;
  camera.world_from_camera = glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(eye, 1));
  return camera;
}

WorldBounds bounds_of(const Scene& scene, Counted counted) {
  WorldBounds bounds;
  for_each_vertex(scene, counted, [&](const glm::dvec3& place) { grow(bounds, place); });
  return bounds;
}

}  // namespace

WorldBounds world_bounds(const Scene& scene) {
  return bounds_of(scene, Counted::traced);
}

WorldBounds seen_bounds(const Scene& scene) {
  return bounds_of(scene, Counted::seen);
}

Camera frame_camera(const WorldBounds& bounds, double vertical_fov, double aspect) {
  const WorldBounds box = with_extent(bounds);
  return fitted_camera(corners_of(box), box, view_side(box), vertical_fov, aspect, glm::dvec3(0, 1, 0));
}

Camera frame_scene(const Scene& scene, double vertical_fov, double aspect, const glm::dvec3& up) {
  const WorldBounds bounds = seen_bounds(scene);
  const WorldBounds box = with_extent(bounds);
  std::vector<glm::dvec3> points;
  if (bounds.lo == box.lo && bounds.hi == box.hi) {
    for_each_vertex(scene, Counted::seen, [&](const glm::dvec3& place) { points.push_back(place); });
  } else {
    points = corners_of(box);
  }
  return fitted_camera(std::move(points), box, choose_view_side(scene, box, view_side(box)), vertical_fov, aspect, up);
}

}  // namespace vernier
