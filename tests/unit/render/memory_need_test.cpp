#include "render/memory_need.h"

#include <gtest/gtest.h>

#include "error.h"
#include "render/gpu_scene.h"
#include "render/pack_scene.h"
#include "unit/reference/test_scenes.h"

namespace vernier {
namespace {

/// A square grid of `cells` x `cells` x 2 triangles with vertex normals, at `copies` places.
Scene grid_scene(std::uint32_t cells, std::size_t copies) {
  Scene scene;
  scene.source = "grid";
  test::add_black(scene);
  Mesh mesh;
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x) mesh.positions.push_back({x, y, static_cast<float>((x * y) % 3)});
  }
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t corner = y * (cells + 1) + x;
      mesh.triangles.push_back({corner, corner + 1, corner + cells + 1});
      mesh.triangles.push_back({corner + 1, corner + cells + 2, corner + cells + 1});
    }
  }
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  scene.meshes.push_back(mesh);
  for (std::size_t i = 0; i < copies; ++i) {
    Instance instance{.name = "", .mesh = 0};
    instance.world_from_object[3].x = 1000.0 * static_cast<double>(i);
    scene.instances.push_back(instance);
  }
  return scene;
}

template <typename Elements>
std::uint64_t bytes_of(const Elements& elements) {
  return std::as_bytes(std::span(elements)).size();
}

TEST(MemoryNeed, the_device_takes_no_more_and_little_less) {
  const Scene scene = grid_scene(50, 3);
  const PackedScene packed = pack_scene(scene, 1);
  const std::uint64_t taken =
      bytes_of(packed.bvh.records) + bytes_of(packed.first_triangles) + bytes_of(packed.vertices);
  const MemoryNeed need = memory_need(scene);
  EXPECT_EQ(need.triangles, 15000u);
  EXPECT_GE(need.device_bytes, taken);
  EXPECT_LE(need.device_bytes, taken + taken / 5);
  EXPECT_GT(need.host_bytes, need.device_bytes);
}

TEST(MemoryNeed, of_shared_meshes_that_of_one) {
  const Scene scene = grid_scene(50, 40);
  const PackedScene packed = pack_scene(scene, 1, BuildMethod::standard, Sharing::always);
  const std::uint64_t taken = bytes_of(packed.bvh.records) + bytes_of(packed.first_triangles) +
                              bytes_of(packed.vertices) + bytes_of(packed.instances);
  const MemoryNeed need = memory_need(scene, Sharing::always);
  EXPECT_EQ(need.triangles, 200000u);
  EXPECT_EQ(need.stored_triangles, 5000u);
  EXPECT_GE(need.device_bytes, taken);
  EXPECT_LE(need.device_bytes, taken + taken / 5);
  EXPECT_EQ(packed.triangle_count, 200000u);
  EXPECT_EQ(packed.traced_triangles, 200000u);
}

TEST(MemoryNeed, shared_texels_count_once) {
  Scene scene = grid_scene(1, 1);
  const std::uint64_t without = memory_need(scene).device_bytes;
  auto texels = std::make_shared<Texels>();
  texels->words.assign(1000, 0);
  for (int i = 0; i < 3; ++i) scene.textures.push_back({.name = "", .sampler = {}, .texels = texels});
  EXPECT_EQ(memory_need(scene).device_bytes, without + 4000);
}

TEST(MemoryNeed, after_the_shape_textures_and_the_device_s_are_left) {
  Scene scene = grid_scene(50, 3);
  auto texels = std::make_shared<Texels>();
  texels->words.assign(1000, 0);
  scene.textures.push_back({.name = "", .sampler = {}, .texels = texels});
  const MemoryNeed need = memory_need(scene);
  const MemoryNeed left = after_shape(need);
  EXPECT_EQ(left.host_bytes, 4000u);
  EXPECT_EQ(left.device_bytes, need.device_bytes);
  EXPECT_EQ(left.triangles, need.triangles);
}

TEST(MemoryNeed, more_than_there_is_is_refused_with_both_numbers) {
  const MemoryNeed need{
      .triangles = 7, .stored_triangles = 7, .host_bytes = 3'000'000'000, .device_bytes = 1'000'000'000};
  const auto refusal = [&](const MemoryThere& there) -> std::string {
    try {
      check_memory("big.glb", need, there);
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      return error.what();
    }
  };
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.host_bytes = 3'000'000'000, .device_bytes = 1'000'000'000}), "");
  EXPECT_EQ(refusal({.host_bytes = 2'500'000'000, .device_bytes = 1'000'000'000}),
            "big.glb: 7 triangles need 3.0 GB of the host's memory, 2.5 GB are there; simplify or split the model");
  EXPECT_EQ(refusal({.host_bytes = 3'000'000'000, .device_bytes = 900'000'000}),
            "big.glb: 7 triangles need 1.0 GB of the device's memory, 0.9 GB are there; simplify or split the model");
  // A CPU device's is the host's.
  EXPECT_EQ(refusal({.host_bytes = 3'900'000'000, .device_bytes = {}, .shared = true}),
            "big.glb: 7 triangles need 4.0 GB of the host's memory, 3.9 GB are there; simplify or split the model");
}

TEST(MemoryNeed, the_text_has_what_is_known) {
  const MemoryNeed need{
      .triangles = 7, .stored_triangles = 7, .host_bytes = 3'000'000'000, .device_bytes = 1'000'000'000};
  EXPECT_EQ(memory_text(need, {.host_bytes = 8'000'000'000, .device_bytes = 9'000'000'000}),
            "memory: at most 3.0 GB of the host's 8.0 GB, 1.0 GB of the device's 9.0 GB");
  EXPECT_EQ(memory_text(need, {.host_bytes = 8'000'000'000, .device_bytes = {}, .shared = true}),
            "memory: at most 4.0 GB of the host's 8.0 GB, 1.0 GB of them for the device");
  EXPECT_EQ(memory_text(need, {}), "memory: at most 3.0 GB of the host's, 1.0 GB of the device's");
}

TEST(MemoryNeed, what_is_shared_is_told) {
  const MemoryNeed need{.triangles = 700, .stored_triangles = 7, .host_bytes = 3'000'000'000, .device_bytes = 1};
  EXPECT_EQ(
      memory_text(need, {.host_bytes = 8'000'000'000, .device_bytes = 9'000'000'000}),
      "memory: 700 triangles, 7 of them in memory; at most 3.0 GB of the host's 8.0 GB, 0.1 GB of the device's 9.0 GB");
  try {
    check_memory("big.glb", need, {.host_bytes = 2'500'000'000, .device_bytes = {}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "big.glb: 700 triangles (7 in memory) need 3.0 GB of the host's memory, 2.5 GB are there; "
                 "simplify or split the model");
  }
}

TEST(MemoryNeed, this_machine_has_some) {
  const MemoryThere there = memory_there();
  ASSERT_TRUE(there.host_bytes.has_value());
  EXPECT_GT(*there.host_bytes, std::uint64_t{1} << 26);
  EXPECT_LT(*there.host_bytes, std::uint64_t{1} << 50);
}

}  // namespace
}  // namespace vernier
