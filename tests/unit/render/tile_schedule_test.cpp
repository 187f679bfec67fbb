#include "render/tile_schedule.h"

#include <gtest/gtest.h>

#include <map>

namespace vernier {
namespace {

void expect_covered_once(const PixelRect& area, glm::ivec2 tile, int band_height) {
  std::map<std::pair<int, int>, int> covered;
  for (const PixelRect& rect : schedule_tiles(area, tile, band_height)) {
    ASSERT_GT(rect.width, 0);
    ASSERT_GT(rect.height, 0);
    ASSERT_LE(rect.width, tile.x);
    ASSERT_LE(rect.height, tile.y);
    ASSERT_EQ((rect.y - area.y) / band_height, (rect.y + rect.height - 1 - area.y) / band_height) << "crosses a band";
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      for (int x = rect.x; x < rect.x + rect.width; ++x) ++covered[{x, y}];
    }
  }
  ASSERT_EQ(covered.size(), static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height));
  for (const auto& [place, times] : covered) {
    ASSERT_EQ(times, 1);
    ASSERT_GE(place.first, area.x);
    ASSERT_LT(place.first, area.x + area.width);
    ASSERT_GE(place.second, area.y);
    ASSERT_LT(place.second, area.y + area.height);
  }
}

TEST(TileSchedule, covers_every_pixel_once) {
  expect_covered_once({0, 0, 64, 64}, {64, 64}, 64);
  expect_covered_once({0, 0, 65, 63}, {64, 64}, 1000);
  expect_covered_once({5, 9, 37, 41}, {8, 16}, 10);
  expect_covered_once({5, 9, 1, 1}, {8, 16}, 10);
  expect_covered_once({3, 0, 20, 30}, {1, 7}, 1);
}

TEST(TileSchedule, goes_row_by_row) {
  const std::vector<PixelRect> tiles = schedule_tiles({10, 20, 12, 12}, {8, 8}, 100);
  ASSERT_EQ(tiles.size(), 4u);
  EXPECT_EQ(tiles[1].x, 18);
  EXPECT_EQ(tiles[1].y, 20);
  EXPECT_EQ(tiles[2].x, 10);
  EXPECT_EQ(tiles[2].y, 28);
}

TEST(TileSchedule, an_empty_area_has_no_tiles) {
  EXPECT_TRUE(schedule_tiles({0, 0, 0, 5}, {8, 8}, 8).empty());
  EXPECT_TRUE(schedule_tiles({0, 0, 5, 0}, {8, 8}, 8).empty());
}

TEST(FittingTile, is_halved_until_samples_and_groups_fit) {
  EXPECT_EQ(fitting_tile({256, 256}, 16), glm::ivec2(256, 256));
  // 2^22 jobs of 16 bytes would fill the buffer, but take 65536 groups.
  EXPECT_EQ(fitting_tile({2048, 2048}, 16), glm::ivec2(2048, 1024));
  EXPECT_EQ(fitting_tile({65536, 32}, 16), glm::ivec2(65536, 32));
  EXPECT_EQ(fitting_tile({65536, 64}, 32), glm::ivec2(32768, 64));
  for (const glm::ivec2 tile : {glm::ivec2(2048, 2048), glm::ivec2(4096, 1024), glm::ivec2(65536, 65536)}) {
    const glm::ivec2 fitting = fitting_tile(tile, 32);
    EXPECT_LE(jobs_per_sample(fitting) * 32, kMostPassBytes);
    EXPECT_LE((jobs_per_sample(fitting) + 63) / 64, 65535u);
  }
}

TEST(ListedSamples, fill_the_buffer_but_not_the_loop) {
  EXPECT_EQ(listed_samples(1000, 10), 100u);
  EXPECT_EQ(listed_samples(10, 1000), 1u);
  EXPECT_EQ(listed_samples(std::uint64_t{1} << 22, 8), 1u << 15);
}

TEST(SamplePasses, follow_one_another_and_grow_to_sixteen) {
  for (const auto& [begin, end] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {0, 100}, {7, 9}, {5, 1000}}) {
    std::uint32_t next = begin;
    std::uint32_t length = 0;
    for (const SamplePass& pass : schedule_passes(begin, end, 1, 100)) {
      EXPECT_EQ(pass.begin, next);
      EXPECT_GT(pass.end, pass.begin);
      EXPECT_LE(pass.end - pass.begin, 16u);
      EXPECT_TRUE(pass.end == end || pass.end - pass.begin >= length);
      length = pass.end - pass.begin;
      next = pass.end;
    }
    EXPECT_EQ(next, end);
  }
  EXPECT_TRUE(schedule_passes(4, 4, 1, 100).empty());
  EXPECT_EQ(schedule_passes(0, 16, 1, 100).size(), 3u);  // 1, 4, 11
  EXPECT_EQ(schedule_passes(0, 16, 4, 100).size(), 2u);  // 4, 12
  EXPECT_EQ(schedule_passes(0, 16, 1, 5).size(), 5u);    // 1, 4, 5, 5, 1
  EXPECT_EQ(schedule_passes(0, 3, 4, 1).size(), 3u);
}

TEST(FirstPass, takes_more_samples_where_the_picture_is_small) {
  EXPECT_EQ(choose_first_pass({0, 0, 1280, 720}), 1u);
  EXPECT_EQ(choose_first_pass({3, 5, 640, 512}), 3u);
  EXPECT_EQ(choose_first_pass({0, 0, 512, 512}), 4u);
  EXPECT_EQ(choose_first_pass({0, 0, 1, 1}), 4u);
  EXPECT_EQ(choose_first_pass({0, 0, 65535, 65535}), 1u);
}

TEST(DispatchJobs, are_as_many_as_make_the_searches) {
  EXPECT_EQ(choose_jobs(1000.0, 10, 25, 10000), 400u);
  EXPECT_EQ(choose_jobs(1000.0, 0, 0, 10000), 1000u) << "at least one search for each";
  EXPECT_EQ(choose_jobs(0.5, 10, 25, 10000), 1u);
}

TEST(DispatchJobs, leave_no_few_behind) {
  EXPECT_EQ(choose_jobs(1000.0, 10, 25, 500), 500u);
  EXPECT_EQ(choose_jobs(1000.0, 10, 25, 501), 400u);
  EXPECT_EQ(choose_jobs(1000.0, 10, 25, 0), 0u);
}

TEST(SearchBudget, spreads_the_time_wanted_over_the_invocations) {
  EXPECT_EQ(choose_search_budget(100.0, 0.5, 1), 200u);
  EXPECT_EQ(choose_search_budget(100.0, 0.5, 20), 10u);
  EXPECT_EQ(choose_search_budget(100.0, 0.5, 0), 200u);
}

TEST(SearchBudget, stays_in_its_bounds) {
  EXPECT_EQ(choose_search_budget(1e-3, 1.0, 4096), 1u);
  EXPECT_EQ(choose_search_budget(1e9, 1e-6, 1), 1024u);
}

TEST(SearchLimit, lets_paths_end_but_bounds_the_dispatch) {
  EXPECT_EQ(search_limit(1), 17u);
  EXPECT_EQ(search_limit(1024), 1168u);
}

}  // namespace
}  // namespace vernier
