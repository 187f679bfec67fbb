// Whether a hit lies within every box around its triangle: what is culled behind it, or before it where a search goes
// on, hangs on that.
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "shader/bound_bvh.h"
#include "shader/coarse_kernel.h"
#include "shader/random_values.h"
#include "shader/shader.h"
#include "unit/bvh/triangle_sets.h"

namespace vernier::shader {
namespace {

/// The records of a tree with the node above each.
struct RecordTree {
  const std::vector<uvec4>& texels;
  std::vector<uint> above;
  std::map<uint, uint> record_of_triangle;

  explicit RecordTree(const Memory& memory) : texels(memory.records), above(memory.records.size() / 3, NONE) {
    for (uint record = 0; record < above.size(); ++record) {
      const uvec4 last = texels[3 * record + 2];
      if ((texels[3 * record].w & BVH_TRIANGLE) != 0u) {
        record_of_triangle[last.w] = record;
        continue;
      }
      for (uint child = 0; child < last.w; ++child) above[(last.z & BVH_CHILD_BASE_MASK) + child] = record;
    }
  }

  /// Whether a search of [t, t] reaches `triangle`.
  bool reaches(const SlabRay& ray, uint triangle, float t) const {
    for (uint record = record_of_triangle.at(triangle); record != 0u; record = above[record]) {
      const uint node = above[record];
      const ivec4 entries = intersect_children(ray, texels[3 * node], texels[3 * node + 1], texels[3 * node + 2], t, t);
      bool found = false;
      for (int i = 0; i < 4; ++i) {
        found = found || (entries[i] != SLAB_MISS &&
                          (texels[3 * node + 2].z & BVH_CHILD_BASE_MASK) + uint(entries[i] & 3) == record);
      }
      if (!found) return false;
    }
    return true;
  }
};

/// To a corner of `triangle`, nearly in its plane.
Ray grazing_ray(RandomValues& random, const BvhTriangle& triangle) {
  const std::array<vec3, 3> corners = {triangle.v0, triangle.v1, triangle.v2};
  const uint aim = random.word() % 3;
  const glm::dvec3 corner = corners[aim], along = glm::dvec3(corners[(aim + 1) % 3]) - corner,
                   beside = glm::dvec3(corners[(aim + 2) % 3]) - corner;
  const glm::dvec3 flat = glm::normalize(along * random.uniform(-1, 1) + beside * random.uniform(-1, 1));
  const glm::dvec3 normal = glm::normalize(glm::cross(along, beside));
  const glm::dvec3 back = flat + normal * std::exp2(random.uniform(-12, -4));
  const vec3 origin(corner + back * random.uniform(0.1, 1.0));
  return Ray(origin, vec3(corner - glm::dvec3(origin)));
}

/// With boxes padded for each node, or by one bound of the ray.
class HitInBoxes : public testing::TestWithParam<bool> {
  CoarseKernel kernel_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(HitInBoxes, HitInBoxes, testing::Bool(),
                         [](const auto& coarse) { return coarse.param ? "coarse" : "fine"; });

TEST_P(HitInBoxes, also_where_the_ray_runs_nearly_in_the_plane) {
  RandomValues random(12);
  for (const uint level : {LEVEL_EXACT, LEVEL_ROBUST}) {
    LEVELS = LEVELS_OF(level);
    int hits = 0, lost = 0;
    for (int mesh = 0; mesh < 50; ++mesh) {
      const test::Triangles triangles = test::random_soup(32, 0.3f, 100 + static_cast<std::uint32_t>(mesh));
      Memory memory = bvh_memory(triangles);
      const BoundMemory bound(memory);
      const RecordTree tree(memory);
      for (int i = 0; i < 2000; ++i) {
        const BvhTriangle& triangle = triangles[random.word() % triangles.size()];
        const Ray ray = grazing_ray(random, triangle);
        Hit hit = no_hit(LARGEST_FLOAT);
        if (!intersect_triangle(sheared_ray(ray), triangle.v0, triangle.v1, triangle.v2, triangle.id, 0u, 0.0f, NONE,
                                hit))
          continue;
        ++hits;
        lost += tree.reaches(slab_ray(ray), triangle.id, hit.t) ? 0 : 1;
      }
    }
    EXPECT_GT(hits, 20000);
    EXPECT_EQ(lost, 0) << "of " << hits << " hits";
  }
}

}  // namespace
}  // namespace vernier::shader
