#include "preview/script.h"

#include <gtest/gtest.h>

#include "error.h"

namespace vernier {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_script("s", text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return "";
}

TEST(ScriptTest, LinesBecomeEvents) {
  const std::vector<ScriptEvent> events =
      parse_script("s", "# a comment\n\nmove 3 4.5\n  drop a file.glb\nset Samples 4\nclose");
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].verb, "move");
  EXPECT_EQ(events[0].line, 3);
  EXPECT_EQ(events[0].numbers, (std::vector<double>{3.0, 4.5}));
  EXPECT_EQ(events[1].words, (std::vector<std::string>{"a file.glb"}));
  EXPECT_EQ(events[2].words, (std::vector<std::string>{"Samples", "4"}));
  EXPECT_TRUE(events[3].words.empty());
}

TEST(ScriptTest, MistakesAreToldWithTheirLine) {
  EXPECT_EQ(refusal("wait 1\njump"), "s: line 2: there is no event `jump`");
  EXPECT_EQ(refusal("move 3"), "s: line 1: `move` needs more words");
  EXPECT_EQ(refusal("wait x"), "s: line 1: `x` is no number");
  EXPECT_EQ(refusal("wait nan"), "s: line 1: `nan` is no number");
  EXPECT_EQ(refusal("close now"), "s: line 1: `now` is too much");
  EXPECT_EQ(refusal("press thumb"), "s: line 1: `thumb` is not left, middle or right");
  EXPECT_EQ(refusal("size -5 10"), "s: line 1: no window has that size");
  EXPECT_EQ(refusal("key f13"), "s: line 1: there is no key `f13`");
}

TEST(ScriptTest, KeysHaveNames) {
  EXPECT_NE(key_code("f"), key_code("w"));
  EXPECT_GE(key_code("1"), 0);
  EXPECT_GE(key_code("escape"), 0);
  EXPECT_LT(key_code("F"), 0);
}

}  // namespace
}  // namespace vernier
