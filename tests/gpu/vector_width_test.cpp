#include "gpu/vector_width.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>

#include "temporary_folder.h"

namespace vernier {
namespace {

constexpr const char* kVariable = "LP_NATIVE_VECTOR_WIDTH";
constexpr const char* kCache = "MESA_SHADER_CACHE_DIR";

/// The environment is afterwards as it was before; within, caches lie in a folder of the case.
class VectorWidthTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {kVariable, kCache, "XDG_CACHE_HOME", "HOME", "MESA_SHADER_CACHE_DISABLE"}) {
      const char* value = std::getenv(name);
      before_[name] = value != nullptr ? std::optional<std::string>(value) : std::nullopt;
    }
    unsetenv(kVariable);
    setenv(kCache, folder_.path().c_str(), 1);
  }
  void TearDown() override {
    for (const auto& [name, value] : before_) value ? setenv(name, value->c_str(), 1) : unsetenv(name);
  }
  std::string cache_of(const std::string& bits) const {
    return (folder_.path() / "vernier" / ("mesa-" + bits + "-bits")).string();
  }

  TemporaryFolder folder_;

 private:
  std::map<const char*, std::optional<std::string>> before_;
};

TEST_F(VectorWidthTest, wide_vectors_are_used_where_the_processor_has_them) {
  std::ifstream file("/proc/cpuinfo");
  const std::string processors{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(has_wide_vectors(), processors.find(" avx512vl") != std::string::npos);
  choose_vector_width();
  const char* bits = std::getenv(kVariable);
  EXPECT_EQ(bits != nullptr ? bits : "", has_wide_vectors() ? "512" : std::string());
}

TEST_F(VectorWidthTest, what_is_set_stays) {
  setenv(kVariable, "128", 1);
  choose_vector_width();
  EXPECT_STREQ(std::getenv(kVariable), "128");
  EXPECT_EQ(std::getenv(kCache), cache_of("128"));
  EXPECT_TRUE(std::filesystem::is_directory(cache_of("128")));
}

TEST_F(VectorWidthTest, a_window_has_narrow_ones) {
  keep_vectors_narrow();
  EXPECT_EQ(std::getenv(kVariable), nullptr);
  setenv(kVariable, "512", 1);
  keep_vectors_narrow();
  EXPECT_STREQ(std::getenv(kVariable), "256");
  EXPECT_EQ(std::getenv(kCache), cache_of("256"));
  setenv(kVariable, "128", 1);
  keep_vectors_narrow();
  EXPECT_STREQ(std::getenv(kVariable), "128");
}

TEST_F(VectorWidthTest, a_process_in_between_changes_nothing) {
  setenv(kVariable, "0x100", 1);
  choose_vector_width();
  choose_vector_width();
  EXPECT_STREQ(std::getenv(kVariable), "256");
  EXPECT_EQ(std::getenv(kCache), cache_of("256"));
}

TEST_F(VectorWidthTest, a_folder_that_only_looks_like_its_own_is_the_caller_s) {
  setenv(kVariable, "256", 1);
  setenv(kCache, folder_.file("mesa-shaders").c_str(), 1);
  choose_vector_width();
  EXPECT_EQ(std::getenv(kCache), folder_.file("mesa-shaders/vernier/mesa-256-bits"));
}

TEST_F(VectorWidthTest, no_folder_is_made_where_the_program_is_run) {
  setenv(kVariable, "256", 1);
  setenv(kCache, "", 1);
  setenv("XDG_CACHE_HOME", "caches", 1);
  setenv("HOME", "", 1);
  choose_vector_width();
  EXPECT_STREQ(std::getenv(kCache), "");
  EXPECT_STREQ(std::getenv("MESA_SHADER_CACHE_DISABLE"), "true");
}

TEST_F(VectorWidthTest, an_empty_width_is_none) {
  setenv(kVariable, "", 1);
  keep_vectors_narrow();
  EXPECT_EQ(std::getenv(kCache), folder_.path().string());
}

TEST_F(VectorWidthTest, the_width_is_no_part_of_a_name) {
  EXPECT_EQ(without_vector_width("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe (LLVM 15.0.6)");
  EXPECT_EQ(without_vector_width("llvmpipe (LLVM 15.0.6)"), "llvmpipe (LLVM 15.0.6)");
  EXPECT_EQ(without_vector_width("Card, 12 bits"), "Card, 12 bits");
  EXPECT_EQ(without_vector_width(""), "");
}

}  // namespace
}  // namespace vernier
