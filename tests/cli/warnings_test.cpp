#include "cli/warnings.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

TEST(TerminalLine, holds_nothing_that_controls_a_terminal) {
  EXPECT_EQ(terminal_line("a\x1b[2J\nerror: b\r\x7f"), "a?[2J?error: b??");
  EXPECT_EQ(terminal_line("sch\xc3\xb6n \xe2\x82\xac"), "sch\xc3\xb6n \xe2\x82\xac") << "other letters stay";
}

TEST(TerminalLine, loses_the_middle_of_what_is_long) {
  const std::string line = terminal_line("scene.gltf: " + std::string(3'000'000, 'x') + ": does not exist");
  EXPECT_LT(line.size(), 8300u);
  EXPECT_TRUE(line.starts_with("scene.gltf: xxx"));
  EXPECT_TRUE(line.ends_with("xxx: does not exist"));
  EXPECT_EQ(terminal_line(std::string(8192, 'x')), std::string(8192, 'x'));
}

TEST(PrintWarnings, stop_after_a_hundred) {
  testing::internal::CaptureStderr();
  print_warnings(std::vector<std::string>(4003, "again"));
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 101);
  EXPECT_TRUE(text.ends_with("warning: 3903 more are left out\n"));
}

}  // namespace
}  // namespace vernier
