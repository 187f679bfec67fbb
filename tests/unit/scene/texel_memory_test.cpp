#include "scene/texel_memory.h"

#include <gtest/gtest.h>

#include "error.h"

namespace vernier {
namespace {

std::string fault_of(std::uint64_t bytes, std::uint64_t there) {
  try {
    check_texel_memory("a.png", bytes, there);
    return "";
  } catch (const MemoryError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
}

TEST(TexelMemory, is_refused_where_it_is_not_there) {
  EXPECT_EQ(fault_of(1'000'000'000, 1'000'000'000), "");
  EXPECT_EQ(fault_of(1'000'000'001, 1'000'000'000),
            "a.png: it needs 1.1 GB of the host's memory, 1.0 GB are there; make the textures smaller");
}

}  // namespace
}  // namespace vernier
