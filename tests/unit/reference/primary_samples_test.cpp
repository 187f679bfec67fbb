#include "reference/primary_samples.h"

#include <gtest/gtest.h>

#include "test_scenes.h"

namespace vernier {
namespace {

// One pixel, one sample: the ray along x = y = 0 at a triangle whose right edge is moved, with a larger one behind or
// before it.
PrimarySamples sample_of(float right, float z_of_second = -9.0f) {
  Scene scene;
  test::add_black(scene);
  test::add_polygon(scene, {{right, -4, -1}, {right, 4, -1}, {right - 4, 0, -1}});
  test::add_polygon(scene, {{-9, -9, z_of_second}, {9, -9, z_of_second}, {0, 9, z_of_second}});
  Camera camera;
  camera.orthographic = true;
  ReferenceSettings settings;
  settings.width = settings.height = 1;
  settings.spp = 1;
  return primary_samples(scene, camera, settings, {});
}

TEST(PrimarySamples, HitsGiveTheirSmallestCoordinate) {
  const PrimarySamples samples = sample_of(1.0f);
  EXPECT_EQ(samples.triangle_ids, std::vector<std::uint32_t>{0});
  EXPECT_FLOAT_EQ(samples.edge_distances[0], 0.25f);  // weights 3/8, 3/8, 1/4
}

TEST(PrimarySamples, ANearMissInFrontCounts) {
  const PrimarySamples samples = sample_of(-1e-4f);
  EXPECT_EQ(samples.triangle_ids, std::vector<std::uint32_t>{1});
  EXPECT_NEAR(samples.edge_distances[0], 0.25e-4, 1e-10);
}

TEST(PrimarySamples, AMissBehindTheHitDoesNot) {
  const PrimarySamples samples = sample_of(-1e-4f, -0.5f);
  EXPECT_EQ(samples.triangle_ids, std::vector<std::uint32_t>{1});
  EXPECT_FLOAT_EQ(samples.edge_distances[0], 0.25f);  // weights 1/4, 1/4, 1/2
}

TEST(PrimarySamples, MissesHaveNoTriangle) {
  EXPECT_EQ(sample_of(-1.0f, 5.0f).triangle_ids, std::vector<std::uint32_t>{0xffffffffu});  // the second is behind
  EXPECT_EQ(sample_of(-1.0f, 5.0f).edge_distances[0], 1.0f);
  EXPECT_NEAR(sample_of(-1e-4f, 5.0f).edge_distances[0], 0.25e-4, 1e-10);
}

TEST(PrimarySamples, AreInPixelOrder) {
  Scene scene;
  test::add_black(scene);
  test::add_polygon(scene, {{-9, -9, -1}, {0, -9, -1}, {0, 9, -1}, {-9, 9, -1}});
  ReferenceSettings settings;
  settings.width = 2;
  settings.height = 3;
  settings.spp = 4;
  const PrimarySamples samples = primary_samples(scene, Camera{}, settings, {});
  ASSERT_EQ(samples.triangle_ids.size(), 24u);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(samples.triangle_ids[i] == 0xffffffffu, i % 8 >= 4) << i;
}

}  // namespace
}  // namespace vernier
