#include "preview/recent_files.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace vernier {
namespace {

using Files = std::vector<std::string>;

TEST(RecentFilesTest, TheLastOneComesFirstAndOnce) {
  EXPECT_EQ(with_recent({"a", "b", "c"}, "b"), (Files{"b", "a", "c"}));
}

TEST(RecentFilesTest, NoMoreThanTen) {
  Files files;
  for (int number = 0; number < 15; ++number) files = with_recent(files, std::to_string(number));
  ASSERT_EQ(files.size(), 10u);
  EXPECT_EQ(files.front(), "14");
  EXPECT_EQ(files.back(), "5");
}

TEST(RecentFilesTest, WhatIsWrittenIsReadAgain) {
  const TemporaryFolder folder;
  const std::string file = folder.file("made/recent");
  write_recent_files(file, {"/b c.glb", "/a.obj"});
  EXPECT_EQ(read_recent_files(file), (Files{"/b c.glb", "/a.obj"}));
}

TEST(RecentFilesTest, NowhereIsNoError) {
  write_recent_files("", {"a"});
  write_recent_files("/proc/none/recent", {"a"});
  EXPECT_TRUE(read_recent_files("/proc/none/recent").empty());
}

}  // namespace
}  // namespace vernier
