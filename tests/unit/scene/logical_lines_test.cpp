#include "scene/logical_lines.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace vernier {
namespace {

using Lines = std::vector<std::pair<std::string, std::size_t>>;

Lines lines_of(std::string_view text) {
  LogicalLines lines(text);
  Lines all;
  while (!lines.at_end()) {
    const std::string line(lines.next());
    all.emplace_back(line, lines.last_line());
  }
  return all;
}

TEST(LogicalLines, end_as_every_system_ends_them) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd"), (Lines{{"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}}));
  EXPECT_EQ(lines_of(" a \t\n\n"), (Lines{{"a", 1}, {"", 2}}));
  EXPECT_TRUE(lines_of("").empty());
}

TEST(LogicalLines, a_byte_order_mark_is_no_part_of_the_first) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBFnewmtl a"), (Lines{{"newmtl a", 1}}));
}

TEST(LogicalLines, a_backslash_joins_with_the_next) {
  EXPECT_EQ(lines_of("Kd 1 \\\n 0 0\nKs 1"), (Lines{{"Kd 1  0 0", 2}, {"Ks 1", 3}}));
  EXPECT_EQ(lines_of("a\\\r\nb\\\nc"), (Lines{{"a b c", 3}}));
  EXPECT_EQ(lines_of("a \\"), (Lines{{"a", 1}})) << "nothing follows";
}

TEST(LogicalLines, a_comment_ends_with_its_line) {
  EXPECT_EQ(lines_of("# C:\\\nv 1 2 3"), (Lines{{"# C:\\", 1}, {"v 1 2 3", 2}}));
}

}  // namespace
}  // namespace vernier
