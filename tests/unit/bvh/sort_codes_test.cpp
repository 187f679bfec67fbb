#include "bvh/sort_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <tuple>
#include <vector>

namespace vernier {
namespace {

using Codes = std::vector<CodedReference>;

Codes make_codes(std::uint32_t count, const std::function<std::uint64_t(std::mt19937_64&)>& code) {
  std::mt19937_64 random(7);
  Codes codes(count);
  for (std::uint32_t i = 0; i < count; ++i) codes[i] = {code(random) >> 1, i};
  return codes;
}

bool same(const CodedReference& a, const CodedReference& b) {
  return a.code == b.code && a.reference == b.reference;
}

void expect_sorted(const Codes& codes) {
  Codes expected = codes;
  std::ranges::sort(expected, {}, [](const CodedReference& one) { return std::tuple(one.code, one.reference); });
  for (const unsigned thread_count : {1u, 2u, 5u}) {
    Codes sorted = codes;
    ThreadTeam team(thread_count);
    Codes other(codes.size());
    EXPECT_TRUE(std::ranges::equal(sort_by_code(sorted, other, team), expected, same)) << thread_count;
  }
}

TEST(SortCodes, OfNothingAndOneIsThat) {
  expect_sorted({});
  expect_sorted(make_codes(1, [](auto& random) { return random(); }));
}

TEST(SortCodes, OfCodesOfAllBits) {
  expect_sorted(make_codes(150000, [](auto& random) { return random(); }));
}

// Runs that agree in the high bits are longer than a thread's piece, shorter, and across the border of two.
TEST(SortCodes, OfCodesThatDifferInTheirLowBits) {
  expect_sorted(make_codes(150000, [](auto& random) { return random() >> 40; }));
  expect_sorted(make_codes(150000, [](auto& random) { return (random() & 0x7u) << 60 | (random() >> 44); }));
  expect_sorted(make_codes(150000, [](auto& random) { return (random() & 0xffffu) << 40 | (random() & 6u); }));
}

TEST(SortCodes, EqualCodesKeepTheOrderOfTheirReferences) {
  expect_sorted(make_codes(100000, [](auto&) { return 12345u; }));
  expect_sorted(make_codes(100000, [](auto& random) { return random() % 3; }));
}

}  // namespace
}  // namespace vernier
