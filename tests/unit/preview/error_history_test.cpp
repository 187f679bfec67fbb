#include "preview/error_history.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

/// 16 x 16 pixels of `samples` each whose mean is `grey`.
DevelopedFilm film_of(float grey, std::uint32_t samples) {
  DevelopedFilm film;
  for (int pixel = 0; pixel < 256; ++pixel) film.color.insert(film.color.end(), {grey, grey, grey, 1.0f});
  film.sample_count.assign(256, samples);
  film.cost.assign(3 * 256, 1.0f);
  return film;
}

TEST(ErrorHistoryTest, LooksOnlyWhereTheSamplesGrewByHalf) {
  ErrorHistory history(16, 16);
  EXPECT_FALSE(history.wants(0));
  EXPECT_TRUE(history.wants(1));
  history.add(film_of(0.5f, 20), 20, 1.0);
  EXPECT_FALSE(history.wants(20));
  EXPECT_FALSE(history.wants(29));
  EXPECT_TRUE(history.wants(30));
}

TEST(ErrorHistoryTest, OneLookTellsNothing) {
  ErrorHistory history(16, 16);
  history.add(film_of(0.5f, 1), 1, 1.0);
  EXPECT_TRUE(history.points().empty());
}

TEST(ErrorHistoryTest, AStillPictureHasNoErrorAndAMovingOneHas) {
  ErrorHistory history(16, 16);
  history.add(film_of(0.5f, 1), 1, 1.0);
  history.add(film_of(0.6f, 5), 5, 2.0);
  history.add(film_of(0.6f, 21), 21, 3.0);
  ASSERT_EQ(history.points().size(), 2u);
  EXPECT_EQ(history.points()[0].seconds, 2.0);
  EXPECT_GT(history.points()[0].error, 0.01f) << "a step of 0.1 from 1 to 5 samples";
  EXPECT_EQ(history.points()[1].error, 0.0f) << "nothing moved from 5 to 21";
}

}  // namespace
}  // namespace vernier
