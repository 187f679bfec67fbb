#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "shader/job_count.h"
#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

TEST(Job, every_sample_of_every_pixel_is_one_job) {
  for (const auto& [width, height, samples] : {std::tuple{8u, 8u, 1u}, {13u, 9u, 3u}, {1u, 1u, 16u}, {64u, 17u, 11u}}) {
    Memory scene;
    scene.dispatch.tile_width = width;
    scene.dispatch.tile_height = height;
    scene.dispatch.sample_begin = 5;
    scene.dispatch.sample_end = 5 + samples;
    const BoundMemory bound(scene);
    std::set<std::tuple<uint, uint, uint>> met;
    for (uint number = 0; number < job_count(); ++number) {
      const Job job = job_at(number);
      if (!is_in_tile(job)) continue;
      EXPECT_EQ(first_job_of(job.x, job.y) + (job.sample_index - 5), number);
      EXPECT_GE(job.sample_index, 5u);
      EXPECT_LT(job.sample_index, 5 + samples);
      EXPECT_TRUE(met.insert({job.x, job.y, job.sample_index}).second);
    }
    EXPECT_EQ(met.size(), width * height * samples);
  }
}

TEST(Job, listed_pixels_have_all_their_samples) {
  Memory scene;
  scene.pixels = {0, 3, 5u << 16 | 7, 12u << 16};
  scene.dispatch.tile_width = 8;
  scene.dispatch.tile_height = 13;
  scene.dispatch.pixel_count = 4;
  scene.dispatch.sample_begin = 2;
  scene.dispatch.sample_end = 5;
  const BoundMemory bound(scene);
  LISTED_PIXELS = true;
  ASSERT_EQ(job_count(), 12u);
  for (uint number = 0; number < job_count() + 3; ++number) {
    const Job job = job_at(number);  // beyond the last pixel: of the last one, nothing outside is read
    const uint pixel = scene.pixels[std::min(number / 3, 3u)];
    EXPECT_EQ(job.x, pixel & 0xffffu);
    EXPECT_EQ(job.y, pixel >> 16);
    EXPECT_TRUE(number >= job_count() || job.sample_index == 2 + number % 3);
    EXPECT_TRUE(is_in_tile(job));
  }
  LISTED_PIXELS = false;
}

TEST(Job, division_is_exact) {
  RandomValues random(31);
  for (int i = 0; i < 200000; ++i) {
    const uint b = 1u + random.word() % (i % 2 == 0 ? 20u : 5000u);
    const uint a = i % 3 == 0 ? b * (random.word() % ((1u << 22) / b)) : random.word() >> 10;
    ASSERT_EQ(divided(a, b), a / b) << a << " / " << b;
    ASSERT_EQ(divided(a - (a > 0 ? 1u : 0u), b), (a - (a > 0 ? 1u : 0u)) / b);
  }
}

}  // namespace
}  // namespace vernier::shader
