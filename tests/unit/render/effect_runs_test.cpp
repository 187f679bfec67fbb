#include "render/effect_runs.h"

#include <gtest/gtest.h>

#include "shared/effects.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

TEST(EffectRuns, no_counters_count_nothing) {
  EffectRuns runs;
  add_effect_runs({}, runs);
  EXPECT_TRUE(runs.searches.empty());
  EXPECT_TRUE(runs.by_depth.empty());
}

TEST(EffectRuns, dispatches_add_up_beyond_32_bits) {
  std::vector<std::uint32_t> counters(COUNTER_COUNT_WITH_RUNS - COUNTER_EFFECT_RUNS);
  for (std::uint32_t i = 0; i < counters.size(); ++i) counters[i] = 0xffffff00u + i;
  EffectRuns runs;
  for (int dispatch = 0; dispatch < 2; ++dispatch) add_effect_runs(std::as_bytes(std::span(counters)), runs);
  const auto twice = [](std::uint32_t counter) {
    return 2 * (std::uint64_t{0xffffff00u} + counter - COUNTER_EFFECT_RUNS);
  };
  ASSERT_EQ(runs.searches.size(), EFFECT_COUNT);
  ASSERT_EQ(runs.by_depth.size(), COUNTED_DEPTHS);
  EXPECT_EQ(runs.searches[3], twice(COUNTER_EFFECT_RUNS + 3));
  EXPECT_EQ(runs.by_depth[2].path, twice(COUNTER_PATH_RAYS + 2));
  EXPECT_EQ(runs.by_depth[31].shadow, twice(COUNTER_SHADOW_RAYS + 31));
}

}  // namespace
}  // namespace vernier
