#include "image/png_pixels.h"

#include <gtest/gtest.h>

#include "unit/image/deflated.h"

namespace vernier {
namespace {

/// The fault of `stream` handed over in parts of `part_bytes`.
std::string fault_in_parts(const PngLayout& layout, const std::string& stream, std::size_t part_bytes) {
  std::vector<std::span<const std::byte>> parts;
  std::span<const std::byte> rest = std::as_bytes(std::span(stream));
  while (!rest.empty()) {
    parts.push_back(rest.first(std::min(part_bytes, rest.size())));
    rest = rest.subspan(parts.back().size());
  }
  return png_pixel_fault(layout, parts);
}

/// The same whether the stream comes whole or byte by byte (in a damaged stream another fault may be met first).
std::string fault_of(const PngLayout& layout, const std::string& stream) {
  const std::string whole = fault_in_parts(layout, stream, stream.size() + 1);
  EXPECT_EQ(fault_in_parts(layout, stream, 1), whole);
  return whole;
}

/// `count` rows of `row_bytes` with filter `filter`.
std::string rows(std::size_t count, std::size_t row_bytes, char filter = 0) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += filter + std::string(row_bytes, 'x');
  return bytes;
}

TEST(PngPixels, RowsAreAsLongAsTheHeaderSays) {
  // 5 pixels of 1, 2 and 4 bits, then of 1, 3, 1, 2 and 4 channels of 8 or 16 bits.
  const std::vector<std::tuple<int, int, std::size_t>> cases = {{1, 0, 1},   {2, 0, 2},  {4, 3, 3},  {8, 0, 5},
                                                                {8, 2, 15},  {8, 3, 5},  {8, 4, 10}, {8, 6, 20},
                                                                {16, 0, 10}, {16, 6, 40}};
  for (const auto& [depth, color, row_bytes] : cases) {
    const PngLayout layout{5, 3, static_cast<std::uint8_t>(depth), static_cast<std::uint8_t>(color), false};
    EXPECT_EQ(fault_of(layout, deflated(rows(3, row_bytes))), "") << depth << " " << color;
    EXPECT_EQ(fault_of(layout, deflated(rows(2, row_bytes))), "the pixels end early") << depth << " " << color;
    EXPECT_EQ(fault_of(layout, deflated(rows(3, row_bytes) + '\0')), "");
  }
}

TEST(PngPixels, InterlacedPassesHaveRowsOfTheirOwn) {
  // 3 x 3: pass 1 takes pixel (0, 0); 2 and 3 have none; 4 takes (2, 0); 5 (0, 2) and (2, 2); 6 (1, 0) and (1, 2), a
  // row each; 7 the whole middle row.
  const std::string passes = rows(1, 1) + rows(1, 1) + rows(1, 2) + rows(2, 1) + rows(1, 3);
  EXPECT_EQ(fault_of({3, 3, 8, 0, true}, deflated(passes)), "");
  EXPECT_EQ(fault_of({3, 3, 8, 0, true}, deflated(passes.substr(1))), "a row's filter is 120");
  EXPECT_EQ(fault_of({3, 3, 8, 0, false}, deflated(passes)), "a row's filter is 120");
  EXPECT_EQ(fault_of({8, 8, 8, 0, true}, deflated(rows(1, 1) + rows(1, 1) + rows(1, 2) + rows(2, 2) + rows(2, 4) +
                                                  rows(4, 4) + rows(4, 8))),
            "");
}

TEST(PngPixels, FiltersEndAtFour) {
  for (char filter = 0; filter <= 4; ++filter)
    EXPECT_EQ(fault_of({2, 2, 8, 0, false}, deflated(rows(2, 2, filter))), "");
  EXPECT_EQ(fault_of({2, 2, 8, 0, false}, deflated(rows(1, 2) + rows(1, 2, 5))), "a row's filter is 5");
}

TEST(PngPixels, AnyByteOfTheStreamThatChangesIsFound) {
  // The stream's own checksum (Adler-32) sees what rows and codes let pass.
  const std::string stream = deflated(rows(20, 40));
  const PngLayout layout{40, 20, 8, 0, false};
  ASSERT_EQ(fault_of(layout, stream), "");
  for (std::size_t i = 0; i < stream.size(); ++i) {
    std::string damaged = stream;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    EXPECT_NE(fault_in_parts(layout, damaged, damaged.size()), "") << i;
    EXPECT_NE(fault_in_parts(layout, damaged, 1), "") << i;
  }
}

TEST(PngPixels, ATruncatedStreamIsFoundABitMoreIsNoFault) {
  const std::string stream = deflated(rows(4, 4));
  for (std::size_t size = 0; size < stream.size(); ++size) {
    EXPECT_EQ(fault_of({4, 4, 8, 0, false}, stream.substr(0, size)), "the pixels end early") << size;
  }
  EXPECT_EQ(fault_of({4, 4, 8, 0, false}, stream + "x"), "");
  EXPECT_EQ(fault_of({4, 4, 8, 0, false}, ""), "the pixels end early");
}

TEST(PngPixels, RowsLongerThanTheBuffer) {
  const std::string wide = rows(3, 400000);  // seven buffers a row
  EXPECT_EQ(fault_in_parts({100000, 3, 8, 6, false}, deflated(wide), 1u << 20), "");
  EXPECT_EQ(fault_in_parts({100000, 3, 8, 6, false}, deflated(wide.substr(1)), 1u << 20), "a row's filter is 120");
}

}  // namespace
}  // namespace vernier
