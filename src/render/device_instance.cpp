#include "render/device_instance.h"

#include <algorithm>
#include <cmath>

namespace vernier {
namespace {

/// A ray's origin within the traced space, 1, and what it covers of that, 2.
constexpr double kRayReach = 3.0;
/// Half ulps of what a ray's coordinates are summed up from: 4 of the map (shaders/instance.glsl), 2 and 8 of the
/// corners in the ray's frame (shaders/intersect_box.glsl).
constexpr double kRoundings = 14.0 * 0x1p-24;

glm::vec4 row_of(const glm::dmat4& m, int row) {
  return {m[0][row], m[1][row], m[2][row], m[3][row]};
}

/// The affine map whose rows are x, y and z.
glm::dmat4 map_of(const glm::vec4& x, const glm::vec4& y, const glm::vec4& z) {
  return glm::transpose(glm::dmat4(x, y, z, glm::dvec4(0, 0, 0, 1)));
}

glm::dmat3 sizes_of(const glm::dmat3& m) {
  glm::dmat3 sizes;
  for (int column = 0; column < 3; ++column) sizes[column] = glm::abs(m[column]);
  return sizes;
}

glm::dmat4 object_from_traced(const DeviceInstance& instance) {
  return map_of(instance.object_from_traced_x, instance.object_from_traced_y, instance.object_from_traced_z);
}

}  // namespace

DeviceInstance world_instance() {
  const glm::vec4 x(1, 0, 0, 0), y(0, 1, 0, 0), z(0, 0, 1, 0);
  return {x, y, z, x, y, z, 0, 1.0f, 0.0f, 0};
}

DeviceInstance device_instance(const glm::dmat4& world_from_mesh, const TracedSpace& object, const TracedSpace& space,
                               std::uint32_t first_triangle) {
  const glm::dmat3 linear = glm::dmat3(world_from_mesh) * (object.metres_per_unit / space.metres_per_unit);
  const glm::dvec3 center = traced_from_world(space, glm::dvec3(world_from_mesh * glm::dvec4(object.center, 1.0)));
  glm::dmat4 map(linear);
  map[3] = glm::dvec4(center, 1.0);
  const glm::dmat4 inverse = glm::inverse(map);
  DeviceInstance instance{};
  instance.object_from_traced_x = row_of(inverse, 0);
  instance.object_from_traced_y = row_of(inverse, 1);
  instance.object_from_traced_z = row_of(inverse, 2);
  const glm::dmat4 back = glm::inverse(object_from_traced(instance));
  instance.traced_from_object_x = row_of(back, 0);
  instance.traced_from_object_y = row_of(back, 1);
  instance.traced_from_object_z = row_of(back, 2);
  instance.first_triangle = first_triangle;
  instance.handedness = glm::determinant(linear) < 0.0 ? -1.0f : 1.0f;
  instance.roundings = 1.0f;
  return instance;
}

Box instance_box(const DeviceInstance& instance, std::span<const Box> boxes) {
  const glm::dmat4 in = object_from_traced(instance);
  const glm::dmat4 out = glm::inverse(in);
  glm::dvec3 lo(out[3]), hi(out[3]);
  bool first = true;
  for (const Box& box : boxes) {
    glm::dvec3 box_lo(out[3]), box_hi(out[3]);
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 a = glm::dvec3(out[axis]) * static_cast<double>(box.lo[axis]);
      const glm::dvec3 b = glm::dvec3(out[axis]) * static_cast<double>(box.hi[axis]);
      box_lo += glm::min(a, b);
      box_hi += glm::max(a, b);
    }
    lo = first ? box_lo : glm::min(lo, box_lo);
    hi = first ? box_hi : glm::max(hi, box_hi);
    first = false;
  }
  const glm::dvec3 size = sizes_of(glm::dmat3(in)) * glm::dvec3(kRayReach) + glm::abs(glm::dvec3(in[3]));
  // To float and outwards: one more than nothing, since a box has extent.
  const glm::dvec3 padding = sizes_of(glm::dmat3(out)) * size * kRoundings + glm::dvec3(0x1p-23);
  return {glm::vec3(lo - padding), glm::vec3(hi + padding)};
}

}  // namespace vernier
