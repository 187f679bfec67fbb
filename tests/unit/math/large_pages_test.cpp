#include "math/large_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace vernier {
namespace {

/// Whether the system was asked for large pages at `address` ("hg" among the flags of its mapping).
bool is_wished_for(const void* address) {
  std::ifstream maps("/proc/self/smaps");
  const auto place = reinterpret_cast<std::uintptr_t>(address);
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    unsigned long long begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%llx-%llx ", &begin, &end) == 2) inside = begin <= place && place < end;
    if (inside && line.starts_with("VmFlags:")) return line.find(" hg") != std::string::npos;
  }
  return false;
}

TEST(LargePages, are_wished_for_where_they_fit_and_nowhere_else) {
  constexpr std::size_t kBytes = 4 * kLargePageBytes;
  const std::unique_ptr<std::byte, decltype(&std::free)> memory(
      static_cast<std::byte*>(std::aligned_alloc(kLargePageBytes, kBytes)), &std::free);
  ASSERT_NE(memory, nullptr);
  std::byte* first = memory.get();
  std::fill(first, first + kBytes, std::byte{7});
  wish_for_large_pages({first + 64, kBytes - 64});
#ifdef __linux__
  EXPECT_FALSE(is_wished_for(first)) << "its page begins before the memory";
  EXPECT_TRUE(is_wished_for(first + kLargePageBytes));
  EXPECT_TRUE(is_wished_for(first + kBytes - 1));
#endif
  EXPECT_EQ(std::count(first, first + kBytes, std::byte{7}), static_cast<std::ptrdiff_t>(kBytes));
}

TEST(LargePages, little_memory_and_none_are_left_alone) {
  std::vector<std::byte> little(kLargePageBytes / 2, std::byte{3});
  wish_for_large_pages(little);
  wish_for_large_pages({});
  EXPECT_FALSE(is_wished_for(little.data()));
  EXPECT_EQ(little.front(), std::byte{3});
}

}  // namespace
}  // namespace vernier
