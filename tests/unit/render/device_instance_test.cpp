#include "render/device_instance.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "bvh/box.h"
#include "shader/random_values.h"

namespace vernier {
namespace {

glm::dvec3 mapped(const glm::vec4& x, const glm::vec4& y, const glm::vec4& z, const glm::dvec3& p) {
  const glm::dvec4 q(p, 1.0);
  return {glm::dot(glm::dvec4(x), q), glm::dot(glm::dvec4(y), q), glm::dot(glm::dvec4(z), q)};
}

glm::dvec3 to_object(const DeviceInstance& one, const glm::dvec3& p) {
  return mapped(one.object_from_traced_x, one.object_from_traced_y, one.object_from_traced_z, p);
}

glm::dvec3 to_traced(const DeviceInstance& one, const glm::dvec3& p) {
  return mapped(one.traced_from_object_x, one.traced_from_object_y, one.traced_from_object_z, p);
}

/// Turned, scaled by 0.01 to 100 along the mesh's axes, sometimes mirrored, in a scene of 1000 m.
glm::dmat4 random_place(RandomValues& random) {
  const glm::dvec3 scale(random.power_of_ten(-2, 2), -random.power_of_ten(-2, 2), random.power_of_ten(-2, 2));
  glm::dmat4 place = glm::rotate(glm::dmat4(1.0), random.uniform(0, 6), glm::dvec3(random.direction())) *
                     glm::scale(glm::dmat4(1.0), scale);
  place[3] = glm::dvec4(glm::dvec3(random.in_cube()) * 800.0, 1.0);
  return place;
}

const TracedSpace kScene{glm::dvec3(0, 50, 0), 1024.0};
const TracedSpace kObject{glm::dvec3(3, 0, -5), 2.0};
// Half ulps of a place of size 1, along three axes: 1 of each number of the map that rays take, spread by 3 at most for
// a rotation with scales (plan_instances.h), and 1 of the numbers of its inverse.
const double kPlaceError = (3.0 + 1.0) * 0x1p-24 * std::sqrt(3.0);

TEST(DeviceInstance, takes_points_to_the_object_and_back) {
  RandomValues random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dmat4 place = random_place(random);
    const DeviceInstance one = device_instance(place, kObject, kScene, 77);
    EXPECT_EQ(one.first_triangle, 77u);
    EXPECT_EQ(one.handedness, -1.0f);
    const glm::dvec3 p(random.in_cube());
    const glm::dvec3 world(place * glm::dvec4(p * kObject.metres_per_unit + kObject.center, 1.0));
    const glm::dvec3 traced = traced_from_world(kScene, world);
    EXPECT_LT(glm::length(to_traced(one, p) - traced), kPlaceError) << i;
    // A step of the traced space, as the object sees it.
    const glm::dvec3 step(glm::length(glm::dvec3(one.object_from_traced_x)),
                          glm::length(glm::dvec3(one.object_from_traced_y)),
                          glm::length(glm::dvec3(one.object_from_traced_z)));
    EXPECT_LT(glm::length((to_object(one, traced) - p) / step), kPlaceError) << i;
  }
}

TEST(DeviceInstance, the_box_holds_what_rays_meet) {
  RandomValues random(2);
  const std::vector<Box> boxes = {{glm::vec3(-1, -0.5, 0), glm::vec3(0, 0.25, 0)},
                                  {glm::vec3(0, 0, 0), glm::vec3(1, 1, 1)}};
  for (int i = 0; i < 200; ++i) {
    const DeviceInstance one = device_instance(random_place(random), kObject, kScene, 0);
    const Box box = instance_box(one, boxes);
    for (const Box& part : boxes) {
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) != 0 ? part.hi.x : part.lo.x, (corner & 2) != 0 ? part.hi.y : part.lo.y,
                           (corner & 4) != 0 ? part.hi.z : part.lo.z);
        const glm::dvec3 traced = to_traced(one, p);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_GT(traced[axis], box.lo[axis]);
          EXPECT_LT(traced[axis], box.hi[axis]);
        }
      }
    }
    EXPECT_GT(half_area(box), 0.0);
  }
}

TEST(DeviceInstance, the_world_is_left_as_it_is) {
  const DeviceInstance world = world_instance();
  const glm::dvec3 p(0.25, -3, 1e-30);
  EXPECT_EQ(to_object(world, p), p);
  EXPECT_EQ(to_traced(world, p), p);
  EXPECT_EQ(world.roundings, 0.0f);
}

}  // namespace
}  // namespace vernier
