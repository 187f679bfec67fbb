#include "render/lay_out_vertices.h"

#include <gtest/gtest.h>

#include <bit>

#include "bvh/decode_record.h"
#include "shared/bvh_record.h"
#include "shared/render_constants.h"
#include "unit/reference/test_scenes.h"

namespace vernier {
namespace {

constexpr std::uint32_t kMaterials = 3;

/// A grid of `cells` x `cells` x 2 triangles as one instance, the colour of a vertex being its position. Triangle i has
/// material i modulo `materials`.
Scene grid_scene(std::uint32_t cells, std::uint32_t materials) {
  Scene scene;
  for (std::uint32_t i = 0; i < kMaterials; ++i) test::add_black(scene);
  Mesh mesh;
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x) mesh.positions.push_back({x, y, static_cast<float>((x * y) % 3)});
  }
  for (const glm::vec3& position : mesh.positions) mesh.colors.push_back(glm::vec4(position, 1));
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t corner = y * (cells + 1) + x;
      mesh.triangles.push_back({corner, corner + 1, corner + cells + 1});
      mesh.triangles.push_back({corner + 1, corner + cells + 2, corner + cells + 1});
    }
  }
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) mesh.triangle_materials.push_back(i % materials);
  scene.meshes.push_back(mesh);
  scene.instances.push_back({.name = "", .mesh = 0});
  return scene;
}

/// A scene in its own coordinates, its vertices laid out.
struct LaidOut {
  InstancePlan plan;
  SceneTrees trees;
  VertexLayout layout;
  LargeArray<std::uint32_t> vertices;

  explicit LaidOut(const Scene& scene, Sharing sharing = Sharing::never, unsigned threads = 2)
      : plan(plan_instances(scene, sharing)) {
    BakedScene baked = bake_instances(scene, {}, plan, UvSets::all);
    layout = baked.layout;
    trees = build_trees(scene, plan, {}, baked, 1, BuildMethod::standard, {});
    vertices = lay_out_vertices(std::move(baked), trees, threads);
  }

  std::size_t vertex_count() const { return vertices.size() / (4 * layout.texels); }

  /// Word `word` of texel `texel` of a vertex.
  std::uint32_t word(std::uint32_t vertex, std::uint32_t texel, std::uint32_t word) const {
    return vertices.at(4 * (std::size_t{vertex} * layout.texels + texel) + word);
  }

  glm::vec3 color(std::uint32_t vertex) const {
    const auto channel = [&](std::uint32_t i) { return std::bit_cast<float>(word(vertex, layout.color, i)); };
    return {channel(0), channel(1), channel(2)};
  }
};

/// The vertices that a record says.
glm::uvec3 vertices_of(const BvhRecord& record) {
  const std::uint32_t first = BVH_VERTEX_NUMBER(record[3]);
  const auto offset = [&](std::uint32_t shift) {
    return static_cast<std::uint32_t>(static_cast<std::int16_t>(record[7] >> shift));
  };
  return {first, first + offset(0), first + offset(16)};
}

/// Expects of every triangle of the one mesh that its vertices have the positions of its corners, which are in `space`,
/// as colours, and that they have its material.
void expect_corners(const LaidOut& out, const TracedSpace& space, std::uint32_t materials) {
  std::size_t triangles = 0;
  for (const BvhRecord& record : out.trees.bvh.records) {
    if (!is_triangle(record)) continue;
    ++triangles;
    const BvhTriangle triangle = decode_triangle(record);
    const glm::uvec3 vertices = vertices_of(record);
    const glm::vec3 corners[] = {triangle.v0, triangle.v1, triangle.v2};
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 position = glm::dvec3(corners[i]) * space.metres_per_unit + space.center;
      ASSERT_EQ(out.color(vertices[i]), glm::vec3(position)) << triangle.id;
      ASSERT_EQ(out.word(vertices[i], 0, 3), triangle.id % materials) << triangle.id;
    }
  }
  EXPECT_EQ(triangles, out.trees.bvh.triangle_count);
}

TEST(LayOutVertices, every_triangle_finds_its_vertices_and_material) {
  for (const std::uint32_t cells : {1, 7, 60, 150}) {
    for (const std::uint32_t materials : {1u, kMaterials}) {
      expect_corners(LaidOut(grid_scene(cells, materials)), {}, materials);
    }
  }
}

TEST(LayOutVertices, triangles_of_shared_meshes_too) {
  Scene scene = grid_scene(90, kMaterials);
  for (int i = 1; i < 4; ++i) {
    scene.instances.push_back(scene.instances[0]);
    scene.instances.back().world_from_object[3].x = 100.0 * i;
  }
  const LaidOut out(scene, Sharing::always);
  EXPECT_EQ(out.trees.bvh.instance_count, 4u);
  EXPECT_EQ(out.trees.bvh.triangle_count, 2u * 90 * 90);
  expect_corners(out, out.plan.spaces.at(0), kMaterials);
}

TEST(LayOutVertices, copies_beside_shared_meshes_keep_their_own) {
  Scene scene = grid_scene(3, 1);
  // Sheared beyond what may be shared.
  scene.instances.push_back(scene.instances[0]);
  scene.instances.back().world_from_object[1].x = 64.0;
  const LaidOut out(scene, Sharing::always);
  EXPECT_EQ(out.trees.bvh.triangle_count, 36u);
  EXPECT_EQ(out.vertex_count(), 32u);
  std::size_t copied = 0;
  for (const BvhRecord& record : out.trees.bvh.records) {
    if (!is_triangle(record) || record[11] < 18) continue;
    ++copied;
    const glm::vec3 position = out.color(vertices_of(record).z);
    EXPECT_EQ(decode_triangle(record).v2, position + glm::vec3(64 * position.y, 0, 0));
  }
  EXPECT_EQ(copied, 18u);
}

TEST(LayOutVertices, all_numbers_of_threads_give_the_same_bytes) {
  const Scene scene = grid_scene(150, kMaterials);
  const LaidOut one(scene, Sharing::never, 1);
  for (const unsigned threads : {2u, 3u, 7u}) {
    const LaidOut more(scene, Sharing::never, threads);
    EXPECT_EQ(more.vertices, one.vertices) << threads;
    EXPECT_EQ(more.trees.bvh.records, one.trees.bvh.records) << threads;
  }
}

TEST(LayOutVertices, few_vertices_are_there_twice) {
  // A chunk of 5700 triangles is a patch of some 54 x 54 vertices: the 4 x 54 of its border belong to others too, half
  // of them counted there. As much again for borders that are not straight.
  const std::size_t vertices = 151 * 151;
  const LaidOut out(grid_scene(150, 1));
  EXPECT_GE(out.vertex_count(), vertices);
  EXPECT_LE(out.vertex_count(), vertices + vertices * 4 * 54 / (54 * 54));
}

TEST(LayOutVertices, a_vertex_of_two_materials_is_two) {
  EXPECT_EQ(LaidOut(grid_scene(1, 1)).vertex_count(), 4u);
  EXPECT_EQ(LaidOut(grid_scene(1, 2)).vertex_count(), 6u);
}

TEST(LayOutVertices, what_no_traced_triangle_uses_is_left_out) {
  Scene scene = grid_scene(1, 1);
  Mesh& mesh = scene.meshes[0];
  mesh.positions.insert(mesh.positions.end(), {{5, 5, 5}, {6, 6, 6}, {7, 7, 7}});
  mesh.colors.resize(7, glm::vec4(9));
  mesh.triangles.push_back({4, 5, 6});          // of no area
  mesh.triangles.push_back(mesh.triangles[0]);  // hidden by the first
  mesh.triangle_materials.resize(4, 0);
  const LaidOut out(scene);
  EXPECT_EQ(out.trees.bvh.triangle_count, 2u);
  EXPECT_EQ(out.vertex_count(), 4u);
  expect_corners(out, {}, 1);
}

TEST(LayOutVertices, without_attributes_the_record_has_the_material) {
  Scene scene = grid_scene(90, kMaterials);
  scene.meshes[0].colors.clear();
  const LaidOut out(scene);
  EXPECT_TRUE(out.vertices.empty());
  for (const BvhRecord& record : out.trees.bvh.records) {
    if (!is_triangle(record)) continue;
    EXPECT_EQ(record[7], record[11] % kMaterials);
    EXPECT_EQ(BVH_VERTEX_NUMBER(record[3]), 0u);
  }
}

TEST(LayOutVertices, nothing_is_laid_out_of_nothing) {
  EXPECT_TRUE(LaidOut(Scene{}).vertices.empty());
  Scene scene = grid_scene(1, 1);
  scene.meshes[0].triangles.assign(2, glm::uvec3(0));
  EXPECT_TRUE(LaidOut(scene).vertices.empty());
}

}  // namespace
}  // namespace vernier
