#include "accuracy/cost_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "accuracy/converged_reference.h"

namespace vernier {
namespace {

CostPlanInput plan_input() {
  CostPlanInput input;
  input.effects.reasons = {{1u, "shadows", true, ""}, {2u, "reflection", false, ""}};
  return input;
}

std::size_t count_of(const std::vector<CostPoint>& points, const std::string& axis) {
  return static_cast<std::size_t>(std::ranges::count(points, axis, &CostPoint::axis));
}

TEST(CostPlanTest, HasEveryAxisAndNoNameTwice) {
  const std::vector<CostPoint> points = plan_points(plan_input());
  std::set<std::string> names;
  for (const CostPoint& point : points) EXPECT_TRUE(names.insert(point.name).second) << point.name;
  EXPECT_EQ(count_of(points, "spp"), 8u);  // 1 and 4 to 256
  EXPECT_EQ(count_of(points, "adaptive"), 3u);
  EXPECT_EQ(count_of(points, "level"), 2u);
  EXPECT_EQ(count_of(points, "bounces"), 4u);
  EXPECT_EQ(count_of(points, "cutoff"), 3u);
  EXPECT_EQ(count_of(points, "filter"), 2u);
  EXPECT_EQ(count_of(points, "effects"), 1u);  // the one that is on
  EXPECT_EQ(count_of(points, "spot"), 7u);
}

TEST(CostPlanTest, APointDiffersByItsOptionAlone) {
  for (const CostPoint& point : plan_points(plan_input())) {
    const RenderSettings base;
    EXPECT_EQ(point.settings.max_bounces != base.max_bounces, point.axis == "bounces") << point.name;
    EXPECT_EQ(point.settings.cutoff != base.cutoff, point.axis == "cutoff") << point.name;
    EXPECT_EQ(point.settings.accuracy != base.accuracy, point.axis == "level") << point.name;
    EXPECT_EQ(point.settings.pixel_filter != base.pixel_filter || point.settings.texture_filter != base.texture_filter,
              point.axis == "filter")
        << point.name;
    EXPECT_EQ(point.settings.effects != base.effects, point.axis == "effects") << point.name;
    EXPECT_EQ(point.settings.error_target.has_value(), point.axis == "adaptive") << point.name;
    EXPECT_EQ(point.has_command, point.axis != "spot") << point.name;
    EXPECT_EQ(point.settings.sample_end, point.settings.spp) << point.name;
  }
}

TEST(CostPlanTest, WhatIsNoCoarserThanTheSettingsIsNoPoint) {
  CostPlanInput input = plan_input();
  input.settings.max_bounces = 1;
  input.settings.cutoff = 0.5f;
  const std::vector<CostPoint> points = plan_points(input);
  EXPECT_EQ(count_of(points, "bounces"), 1u);
  EXPECT_EQ(count_of(points, "cutoff"), 0u);

  input.has_textures = false;
  input.settings.pixel_filter = PixelFilter::tent;
  EXPECT_EQ(count_of(plan_points(input), "filter"), 0u);
}

TEST(CostPlanTest, TheFrontOfThePlanFits) {
  const std::vector<PointTime> times{{0.0, 10.0}, {100.0, 10.0}, {0.0, 1.0}};
  EXPECT_EQ(points_that_fit(times, 4, 181.0), 2u);
  EXPECT_EQ(points_that_fit(times, 4, 184.0), 3u);
  EXPECT_EQ(points_that_fit(times, 4, 0.0), 1u);
}

TEST(CostPlanTest, PointsStayFarBelowTheReference) {
  EXPECT_EQ(most_spp(4096, 1.0, 1e9), 256u);
  EXPECT_EQ(most_spp(4095, 1.0, 1e9), 128u);
  EXPECT_EQ(most_spp(65536, 1.0, 100.0), 64u);
  EXPECT_EQ(most_spp(1, 1.0, 0.0), 4u);
}

TEST(ReferenceParts, two_fit_the_budget_at_twice_a_points_time) {
  EXPECT_EQ(choose_part_spp(1e9, 1.0), 64u);
  EXPECT_EQ(choose_part_spp(256.0, 1.0), 64u);
  EXPECT_EQ(choose_part_spp(255.0, 1.0), 32u);
  EXPECT_EQ(choose_part_spp(0.0, 1.0), 4u);
}

}  // namespace
}  // namespace vernier
