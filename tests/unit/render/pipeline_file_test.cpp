#include "render/pipeline_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "temporary_folder.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

const std::string kKey = "00010005-00000000-00000001-00112233445566778899aabbccddeeff";

std::vector<std::byte> some_bytes(std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(i * 37 + 11);
  return bytes;
}

class PipelineFileTest : public testing::Test {
 protected:
  std::string file() const { return folder_.file("deep/er/a.pipelines"); }
  void store(std::size_t count) const { write_pipelines(file(), kKey, some_bytes(count)); }
  StoredPipelines read() const { return read_pipelines(file(), kKey); }

  /// Nothing is read, and the line says `why`.
  void expect_nothing(const std::string& why) const {
    const StoredPipelines stored = read();
    EXPECT_TRUE(stored.bytes.empty());
    EXPECT_NE(stored.note.find(why), std::string::npos) << stored.note;
  }

  void overwrite(std::streamoff place, char byte) const {
    std::fstream stream(file(), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(place);
    stream.put(byte);
  }

  TemporaryFolder folder_;
};

TEST_F(PipelineFileTest, gives_back_what_was_written) {
  for (const std::size_t count : {0u, 1u, 32u, 100000u}) {
    store(count);
    EXPECT_EQ(read().bytes, some_bytes(count));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(file()).parent_path()), {}), 1) << "no partial files";
}

TEST_F(PipelineFileTest, a_missing_file_is_nothing) {
  expect_nothing("not there yet");
  fs::create_directories(file());
  expect_nothing("not there yet");
}

TEST_F(PipelineFileTest, a_file_cut_short_anywhere_is_nothing) {
  store(200);
  const std::uintmax_t whole = fs::file_size(file());
  for (std::uintmax_t size = 0; size < whole; size += 7) {
    store(200);
    fs::resize_file(file(), size);
    expect_nothing("cut short");
  }
  store(200);
  fs::resize_file(file(), whole + 5);
  expect_nothing("cut short");
}

TEST_F(PipelineFileTest, no_byte_may_change) {
  store(64);
  const auto whole = static_cast<std::streamoff>(fs::file_size(file()));
  std::ifstream stream(file(), std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(stream)), {});
  for (std::streamoff place = 0; place < whole; ++place) {
    store(64);
    overwrite(place, static_cast<char>(good[static_cast<std::size_t>(place)] ^ 0x20));
    EXPECT_TRUE(read().bytes.empty()) << place;
  }
}

TEST_F(PipelineFileTest, of_another_device_or_driver_is_nothing) {
  store(100);
  std::string newer = kKey;
  newer[newer.find("00000001")] = '2';
  const StoredPipelines stored = read_pipelines(file(), newer);
  EXPECT_TRUE(stored.bytes.empty());
  EXPECT_NE(stored.note.find("another device or driver"), std::string::npos) << stored.note;
}

TEST_F(PipelineFileTest, too_large_is_neither_read_nor_kept) {
  store(1000);
  EXPECT_TRUE(read_pipelines(file(), kKey, 999).bytes.empty());
  EXPECT_EQ(read_pipelines(file(), kKey, 1000).bytes.size(), 1000u);
  const std::string note = write_pipelines(file(), kKey, some_bytes(1000), 999);
  EXPECT_NE(note.find("more than 999 bytes"), std::string::npos) << note;
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(PipelineFileTest, a_place_that_cannot_be_written_is_no_error) {
  // A file stands where a folder would have to be: so it is for every user, root too.
  folder_.write("deep", "in the way");
  const std::string note = write_pipelines(file(), kKey, some_bytes(10));
  EXPECT_NE(note.find("not written"), std::string::npos) << note;
  expect_nothing("not there yet");
}

TEST_F(PipelineFileTest, nowhere_is_no_error) {
  EXPECT_TRUE(read_pipelines("", kKey).bytes.empty());
  EXPECT_EQ(write_pipelines("", kKey, some_bytes(10)), "");
}

/// Sets environment variables for a test and puts them back.
class Variables {
 public:
  ~Variables() {
    for (const auto& [name, value] : before_) put(name.c_str(), value ? value->c_str() : nullptr);
  }
  void set(const char* name, const char* value) {
    const char* old = std::getenv(name);
    before_.emplace_back(name, old == nullptr ? std::nullopt : std::optional<std::string>(old));
    put(name, value);
  }

 private:
  static void put(const char* name, const char* value) {
    if (value == nullptr) {
      unsetenv(name);
    } else {
      setenv(name, value, 1);
    }
  }
  std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

TEST(PipelineFile, lies_in_the_first_folder_that_is_named) {
  Variables variables;
  variables.set("VERNIER_PIPELINE_CACHE", "/own");
  variables.set("XDG_CACHE_HOME", "/cache");
  variables.set("HOME", "/houses/own");
  EXPECT_EQ(pipeline_file("key"), "/own/key.pipelines");
  variables.set("VERNIER_PIPELINE_CACHE", nullptr);
  EXPECT_EQ(pipeline_file("key"), "/cache/vernier/key.pipelines");
  variables.set("XDG_CACHE_HOME", "relative/is/ignored");
  EXPECT_EQ(pipeline_file("key"), "/houses/own/.cache/vernier/key.pipelines");
  variables.set("HOME", nullptr);
  EXPECT_EQ(pipeline_file("key"), "") << "no home, no file";
  variables.set("HOME", "/houses/own");
  variables.set("VERNIER_PIPELINE_CACHE", "none");
  EXPECT_EQ(pipeline_file("key"), "") << "switched off";
}

}  // namespace
}  // namespace vernier
