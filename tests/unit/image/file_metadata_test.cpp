#include "image/file_metadata.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

TEST(FileMetadata, SurvivesLineBreaksBackslashesAndEqualSigns) {
  const std::map<std::string, std::string> metadata = {
      {"vernier:recipe", "{\"a\": \"b\\n\"}\nsecond = line\n"}, {"a=b\\e", ""}, {"plain", "x"}};
  EXPECT_EQ(metadata_of_text(text_of_metadata(metadata)), metadata);
}

TEST(FileMetadata, NothingMakesAnEmptyText) {
  EXPECT_EQ(text_of_metadata({}), "");
}

TEST(FileMetadata, ATextWithoutTheMarkHasNone) {
  EXPECT_TRUE(metadata_of_text("a photograph\nf=2.8").empty());
  EXPECT_TRUE(metadata_of_text("").empty());
}

}  // namespace
}  // namespace vernier
