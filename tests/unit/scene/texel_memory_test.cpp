#include "scene/texel_memory.h"

#include <gtest/gtest.h>

#include <limits>

#include "error.h"
#include "math/host_memory.h"

namespace vernier {
namespace {

std::string fault_of(std::uint64_t bytes, std::uint64_t others, std::optional<std::uint64_t> there) {
  try {
    check_texel_memory("a.png", bytes, others, there);
    return "";
  } catch (const MemoryError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
}

TEST(TexelMemory, is_refused_where_it_is_not_there) {
  EXPECT_EQ(fault_of(1'000'000'000, 0, 1'000'000'000), "");
  EXPECT_EQ(fault_of(1'000'000'001, 0, 1'000'000'000),
            "a.png: its texels need 1.1 GB of the host's memory, 1.0 GB are there; make the textures smaller");
  EXPECT_EQ(fault_of(1'000'000'000, 2'000'000'000, 2'900'000'000),
            "a.png: its texels need 1.0 GB of the host's memory beside 2.0 GB of others, 2.9 GB are there; make the "
            "textures smaller");
  EXPECT_EQ(fault_of(std::uint64_t{1} << 60, 0, std::nullopt), "");
}

TEST(TexelMemory, is_free_again_for_the_next_image) {
  const std::optional<std::uint64_t> there = host_memory_there();
  ASSERT_TRUE(there.has_value());
  for (int i = 0; i < 3; ++i) {
    TexelClaim claim;
    EXPECT_NO_THROW(claim.take("a.png", *there / 2));
    TexelClaim other;
    EXPECT_THROW(other.take("b.png", *there), MemoryError);
  }
}

}  // namespace
}  // namespace vernier
