#include "image/whole_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "error.h"
#include "expect_error.h"
#include "file_size_limit.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

TEST(WholeFile, WritesBytesAsTheyAre) {
  const TemporaryFolder folder;
  const std::string text("a\r\n\0b", 5);
  write_text(folder.file("x.json"), text);
  EXPECT_EQ(bytes_of_file(folder.file("x.json")), text);
  write_text(folder.file("x.json"), "");
  EXPECT_EQ(bytes_of_file(folder.file("x.json")), "");
  EXPECT_EQ(folder.entry_count(), 1);
}

TEST(WholeFile, HasTheRightsOfAnyNewFile) {
  const TemporaryFolder folder;
  const mode_t old_mask = umask(022);
  write_text(folder.file("x"), "a");
  umask(old_mask);
  EXPECT_EQ(static_cast<int>(std::filesystem::status(folder.file("x")).permissions()), 0644);
}

TEST(WholeFile, AFailureKeepsTheOldFileAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string path = folder.file("x");
  write_text(path, "old");
  const auto write_half = [](const std::string& file) {
    write_text(file, "half");
    throw std::runtime_error("out of ink");
  };
  expect_error(ErrorKind::failed, path + ": cannot write: out of ink", [&] { write_whole(path, write_half); });
  EXPECT_EQ(bytes_of_file(path), "old");
  EXPECT_EQ(folder.entry_count(), 1);
}

TEST(WholeFile, PassesOtherKindsOfErrorOn) {
  const TemporaryFolder folder;
  const auto refuse = [](const std::string&) { throw Error(ErrorKind::refused, "no"); };
  expect_error(ErrorKind::refused, "no", [&] { write_whole(folder.file("x"), refuse); });
  EXPECT_EQ(folder.entry_count(), 0);
}

TEST(WholeFile, AFullDiskIsAnErrorWithTheReason) {
  const TemporaryFolder folder;
  const std::string path = folder.file("x");
  const FileSizeLimit limit(1000);
  expect_error(ErrorKind::failed, path + ": cannot write: File too large",
               [&] { write_text(path, std::string(1001, 'a')); });
  EXPECT_EQ(folder.entry_count(), 0);
}

TEST(WholeFile, ADeviceIsWrittenAndNotReplaced) {
  write_text("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  expect_error(ErrorKind::failed, "/dev/full: cannot write: No space left on device",
               [] { write_text("/dev/full", "a"); });
}

// As a shell's >(command) names one.
TEST(WholeFile, APipeIsWrittenByTheNameOfItsDescriptor) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  write_text("/dev/fd/" + std::to_string(ends[1]), "through");
  std::string read(7, ' ');
  EXPECT_EQ(::read(ends[0], read.data(), read.size()), 7);
  EXPECT_EQ(read, "through");
  close(ends[0]);
  close(ends[1]);
}

TEST(WholeFile, FollowsALinkAndKeepsIt) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("target", folder.file("link"));
  write_text(folder.file("link"), "a");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(bytes_of_file(folder.file("target")), "a");
}

TEST(WholeFile, SaysWhatIsWrongWithThePlace) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder.file("loop"));
  expect_error(ErrorKind::failed, "No such file or directory", [&] { write_text(folder.file("no/x"), "a"); });
  expect_error(ErrorKind::failed, "it is a folder", [&] { write_text(folder.file(""), "a"); });
  expect_error(ErrorKind::failed, "Too many levels of symbolic links", [&] { write_text(folder.file("loop"), "a"); });
  expect_error(ErrorKind::failed, "name is empty", [] { write_text("", "a"); });
}

}  // namespace
}  // namespace vernier
