#include "math/memory_claim.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "math/host_memory.h"

namespace vernier {
namespace {

TEST(MemoryClaim, is_not_granted_beyond_what_is_there) {
  const std::optional<std::uint64_t> there = host_memory_there();
  ASSERT_TRUE(there.has_value());
  {
    MemoryClaim claim;
    EXPECT_LT(claim.take(~std::uint64_t{0}), ~std::uint64_t{0});
  }
  for (int i = 0; i < 3; ++i) {  // and ends with its claimer
    MemoryClaim claim;
    EXPECT_GE(claim.take(*there / 2), *there / 2);
  }
}

TEST(MemoryClaim, waits_for_what_others_claim) {
  const std::optional<std::uint64_t> there = host_memory_there();
  ASSERT_TRUE(there.has_value());
  std::optional<MemoryClaim> first(std::in_place);
  ASSERT_GE(first->take(*there / 2), *there / 2);
  std::atomic<bool> is_free = false, waited = false;
  std::jthread other([&] {
    MemoryClaim second;
    second.take(*there / 4 * 3);
    waited = is_free.load();
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  MemoryClaim small;
  EXPECT_GE(small.take(1), 1u) << "what is there is not waited for";
  is_free = true;
  first.reset();
  other.join();
  EXPECT_TRUE(waited);
}

}  // namespace
}  // namespace vernier
