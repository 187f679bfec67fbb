#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "shader/bumpy_sphere.h"
#include "shader/instanced_kernel.h"
#include "shader/random_values.h"
#include "shader/shader.h"
#include "shader/tiny_scene.h"

namespace vernier::shader {
namespace {

/// A bumpy sphere with normals, tangents and uvs.
Mesh sphere_mesh(int levels, const vec3& center) {
  const ClosedMesh closed = bumpy_sphere(levels);
  Mesh mesh;
  for (const vec3& position : closed.positions) {
    mesh.positions.push_back(position + center);
    mesh.normals.push_back(glm::normalize(position));
    mesh.tangents.push_back(vec4(glm::normalize(glm::cross(vec3(0.3f, 1, 0.2f), position)), 1));
    mesh.uvs[0].push_back(glm::vec2(position));
  }
  mesh.triangles = closed.triangles;
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  return mesh;
}

glm::dmat4 turned(RandomValues& random) {
  return glm::rotate(glm::dmat4(1.0), random.uniform(0, 6), glm::dvec3(random.direction()));
}

/// Scaled by up to `decades` along the mesh's axes, every third mirrored, every fourth sheared; near the origin.
glm::dmat4 random_place(RandomValues& random, int number, double decades) {
  glm::dvec3 scale;
  for (int axis = 0; axis < 3; ++axis) scale[axis] = random.power_of_ten(-decades, decades);
  if (number % 3 == 0) scale.x = -scale.x;
  glm::dmat4 shear(1.0);
  if (number % 4 == 0) shear[1].x = 0.5;
  glm::dmat4 place = turned(random) * shear * glm::scale(glm::dmat4(1.0), scale);
  place[3] = glm::dvec4(glm::dvec3(random.in_cube()) * 4.0, 1.0);
  return place;
}

/// Two meshes, far from their origins and around them, at `count` places, and a ground that is copied.
Scene placed_scene(int count, double decades) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, -3.0f, 8.0f);
  Mesh& ground = scene.meshes[0];
  ground.normals.assign(4, vec3(0, 0, 1));
  ground.tangents.assign(4, vec4(1, 0, 0, 1));
  // Sheared beyond what may be shared.
  scene.instances[0].world_from_object[1].x = 40.0;
  scene.meshes.push_back(sphere_mesh(2, vec3(0)));
  scene.meshes.push_back(sphere_mesh(1, vec3(100, -7, 30)));
  RandomValues random(3);
  for (int i = 0; i < count; ++i) {
    Instance instance{.name = "", .mesh = static_cast<std::uint32_t>(1 + i % 2)};
    instance.world_from_object = random_place(random, i, decades);
    if (instance.mesh == 2) {
      instance.world_from_object = instance.world_from_object * glm::translate(glm::dmat4(1), glm::dvec3(-100, 7, -30));
    }
    scene.instances.push_back(instance);
  }
  return scene;
}

struct Packed {
  PackedScene packed;
  Memory memory;
  Packed(const Scene& scene, Sharing sharing)
      : packed(pack_scene(scene, 1, BuildMethod::standard, sharing)), memory(memory_of(packed)) {}
};

/// A scene with its meshes copied and with them shared, which the kernels see while it lives.
struct SharedScene {
  Scene scene;
  Packed copied, shared;
  BoundMemory memory;
  InstancedKernel kernel;
  SharedScene(int count, double decades)
      : scene(placed_scene(count, decades)),
        copied(scene, Sharing::never),
        shared(scene, Sharing::always),
        memory(shared.memory) {}
};

/// From around the scene at one of its triangles.
Ray aimed_ray(RandomValues& random, const PackedScene& copied) {
  std::uint32_t index;
  do {
    index = random.word() % static_cast<std::uint32_t>(copied.bvh.records.size());
  } while ((copied.bvh.records[index][3] & BVH_TRIANGLE) == 0);
  const auto corner = [&](std::size_t word) {
    const BvhRecord& record = copied.bvh.records[index];
    return uintBitsToFloat(uvec3(record[word], record[word + 1], record[word + 2]));
  };
  const float b = random.in(0, 1), c = random.in(0, 1) * (1 - b);
  const vec3 aim = corner(0) * (1 - b - c) + corner(4) * b + corner(8) * c;
  const vec3 origin = random.in_cube();
  return Ray(origin, (aim - origin) * random.in(0.5, 2));
}

Found closest(const Ray& ray) {
  const Found found = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, false));
  EXPECT_TRUE(found.finished);
  return found;
}

// A vector that is made perpendicular to another and unit again turns with it, and may turn twice as far where they are
// within 30 degrees; the bent normal is the sum of three such.
constexpr float kFrameTurns = 6.0f;

/// How far apart along the normal a ray may meet a copy and the shared mesh: by the bounds of both places, and by the
/// copy's corners, which are rounded once, half an ulp of 1 along each axis.
float apart_along_normal(const SurfacePoint& copy, const SurfacePoint& shared) {
  return dot_product(abs(copy.geometric_normal), copy.position_error + shared.position_error + vec3(HALF_ULP_OF_ONE));
}

/// The same across the ray, `distance` from its origin: both searches move corners in the ray's frame by 10 roundings
/// of that (shaders/intersect_box.glsl, SLAB_ROUNDINGS).
float apart_across_ray(float distance) {
  return 2.0f * SLAB_ROUNDINGS * HALF_ULP_OF_ONE * distance;
}

TEST(Instance, rays_meet_what_they_meet_in_the_copies) {
  const Scene scene = placed_scene(24, 0.7);
  Packed copied(scene, Sharing::never), shared(scene, Sharing::always);
  EXPECT_EQ(copied.packed.bvh.instance_count, 0u);
  EXPECT_EQ(shared.packed.bvh.instance_count, 24u);
  EXPECT_EQ(shared.packed.traced_triangles, copied.packed.traced_triangles);
  EXPECT_LT(shared.packed.bvh.triangle_count * 8, copied.packed.bvh.triangle_count);
  RandomValues random(8);
  int others = 0, hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Ray ray = aimed_ray(random, copied.packed);
    Hit expected;
    {
      const BoundMemory bound(copied.memory);
      expected = closest(ray).hit;
    }
    const BoundMemory bound(shared.memory);
    const InstancedKernel instanced;
    const Hit hit = closest(ray).hit;
    hits += hit.triangle != NONE ? 1 : 0;
    others += hit.triangle != expected.triangle ? 1 : 0;
  }
  EXPECT_GT(hits, 3900);
  EXPECT_LE(others, 8);  // at edges
}

TEST(Instance, the_surface_is_that_of_the_copy) {
  const Scene scene = placed_scene(24, 0.7);
  Packed copied(scene, Sharing::never), shared(scene, Sharing::always);
  RandomValues random(9);
  SlotTexels texels = no_slot_texels();
  texels.normal = vec4(0.8f, 0.4f, 0.9f, 1);
  DeviceMaterial bumpy{};
  bumpy.textured_slots = 1u << TEXTURE_SLOT_NORMAL;
  bumpy.normal_scale = 1.0f;
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = aimed_ray(random, copied.packed);
    SurfacePoint expected;
    vec4 expected_frame;
    Hit first;
    {
      const BoundMemory bound(copied.memory);
      first = closest(ray).hit;
      if (first.triangle == NONE) continue;
      const TrianglePoint point = triangle_point(ray, first);
      expected = surface_point(point, bumpy, texels, ray.direction);
      expected_frame = tangent_frame(point, expected.normal, plain_use(0));
    }
    const BoundMemory bound(shared.memory);
    const InstancedKernel instanced;
    const Hit hit = closest(ray).hit;
    if (hit.triangle != first.triangle) continue;
    const TrianglePoint point = triangle_point(ray, hit);
    const SurfacePoint surface = surface_point(point, bumpy, texels, ray.direction);
    ++compared;
    const vec3 off = surface.position - expected.position;
    const vec3 way = glm::normalize(ray.direction);
    const float along = apart_along_normal(expected, surface);
    const float across = apart_across_ray(glm::length(expected.position - ray.origin));
    const float tilt = glm::length(glm::cross(surface.geometric_normal, expected.geometric_normal));
    const float cosine = std::abs(dot_product(way, expected.geometric_normal));
    EXPECT_LE(std::abs(dot_product(off, expected.geometric_normal)), along + tilt * glm::length(off)) << i;
    // A ray that grazes goes far from one plane to the other.
    EXPECT_LE(glm::length(off) * cosine, along + across) << i;
    EXPECT_LE(std::abs(hit.t - first.t) * glm::length(ray.direction) * cosine, along + across) << i;
    // Each corner may lie off by as much, over the least height of the triangle.
    const float height = glm::length(glm::cross(point.e1, point.e2)) /
                         std::max({glm::length(point.e1), glm::length(point.e2), glm::length(point.e2 - point.e1)});
    EXPECT_LE(tilt,
              3.0f * glm::length(expected.position_error + surface.position_error + vec3(HALF_ULP_OF_ONE)) / height)
        << i;
    // Normals and tangents of corners are weighed: a weight is off by the place's error over the height, and a corner's
    // normal differs from the next one's by less than 2.
    const float turn = 3.0f * 2.0f * (along + across) / (cosine * height);
    EXPECT_LE(glm::length(surface.normal - expected.normal), kFrameTurns * (turn + tilt)) << i;
    EXPECT_EQ(surface.front, expected.front) << i;
    EXPECT_EQ(object_of(hit.triangle), object_of(first.triangle));
    const vec4 frame = tangent_frame(point, surface.normal, plain_use(0));
    EXPECT_EQ(frame.w, expected_frame.w) << i;
    EXPECT_LE(glm::length(first_three(frame) - first_three(expected_frame)), kFrameTurns * kFrameTurns * (turn + tilt))
        << i;
  }
  EXPECT_GT(compared, 1900);
}

TEST(Instance, rays_that_go_on_do_not_meet_where_they_were) {
  for (const double decades : {0.0, 1.0, 3.0}) {
    const SharedScene bound(16, decades);
    RandomValues random(10);
    int again = 0;
    for (int i = 0; i < 4000; ++i) {
      const Ray ray = aimed_ray(random, bound.copied.packed);
      const Hit hit = closest(ray).hit;
      if (hit.triangle == NONE) continue;
      const TrianglePoint point = triangle_point(ray, hit);
      const SurfacePoint surface = surface_point(point, DeviceMaterial{}, no_slot_texels(), ray.direction);
      const vec3 outgoing = random.direction();
      again += closest(Ray(spawn_origin(surface, outgoing), outgoing)).hit.triangle == hit.triangle ? 1 : 0;
    }
    EXPECT_EQ(again, 0) << decades;
  }
}

TEST(Instance, no_ray_gets_out_of_a_closed_mesh) {
  const SharedScene bound(12, 1.0);
  RandomValues random(11);
  int out = 0;
  for (int i = 0; i < 6000; ++i) {
    const Instance& instance = bound.scene.instances[1 + random.word() % 12];
    const Mesh& mesh = bound.scene.meshes[instance.mesh];
    const glm::uvec3 triangle = mesh.triangles[random.word() % mesh.triangles.size()];
    const double along = i % 2 == 0 ? 0.0 : random.uniform(0, 1);
    const glm::dvec3 at =
        glm::mix(glm::dvec3(mesh.positions[triangle.x]), glm::dvec3(mesh.positions[triangle.y]), along);
    const glm::dvec3 center = instance.mesh == 2 ? glm::dvec3(100, -7, 30) : glm::dvec3(0);
    const auto traced = [&](const glm::dvec3& p) {
      return vec3(
          traced_from_world(bound.shared.packed.space, glm::dvec3(instance.world_from_object * glm::dvec4(p, 1.0))));
    };
    const vec3 origin = traced(center + glm::dvec3(random.in_cube()) * 0.2);
    out += closest(Ray(origin, traced(at) - origin)).hit.triangle == NONE ? 1 : 0;
  }
  EXPECT_EQ(out, 0);
}

TEST(Instance, any_hit_ends_at_an_opaque_triangle_in_whatever_tree) {
  const SharedScene bound(24, 0.7);
  RandomValues random(12);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = aimed_ray(random, bound.copied.packed);
    const bool any = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, true)).hit.triangle != NONE;
    EXPECT_EQ(any, closest(ray).hit.triangle != NONE) << i;
  }
}

TEST(Instance, hits_come_one_after_the_other) {
  const SharedScene bound(12, 0.3);
  RandomValues random(13);
  for (int i = 0; i < 300; ++i) {
    const Ray ray = aimed_ray(random, bound.copied.packed);
    Hit before = closest(ray).hit;
    while (before.triangle != NONE) {
      const Hit next = traverse_bvh(Search(ray, before.t, before.triangle, LARGEST_FLOAT, false)).hit;
      EXPECT_TRUE(next.triangle == NONE || next.t > before.t ||
                  (next.t == before.t && next.triangle > before.triangle));
      before = next;
    }
  }
}

}  // namespace
}  // namespace vernier::shader
