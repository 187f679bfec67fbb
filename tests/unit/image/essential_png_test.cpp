#include "image/essential_png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "error.h"
#include "unit/image/deflated.h"

namespace vernier {
namespace {

const std::string kSignature("\x89PNG\r\n\x1a\n", 8);

std::string big_endian(std::size_t word) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 0xFF);
  return bytes;
}

std::string chunk(const std::string& kind, const std::string& content) {
  const std::string summed = kind + content;
  const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size()));
  return big_endian(content.size()) + summed + big_endian(sum);
}

std::string header(char depth, char color) {
  return chunk("IHDR", big_endian(2) + big_endian(1) + std::string{depth, color, 0, 0, 0});
}

/// One row of `row_bytes` black bytes without a filter, deflated.
std::string black_row(std::size_t row_bytes) {
  return deflated(std::string(1 + row_bytes, '\0'));
}

const std::string kPixels = chunk("IDAT", black_row(6));  // of header(8, 2)
const std::string kEnd = chunk("IEND", "");

constexpr std::uint64_t kMostPixels = 100;

std::string essential(const std::string& file, PngText text = PngText::dropped) {
  const std::vector<std::byte> bytes = essential_png(std::as_bytes(std::span(file)), "a.png", kMostPixels, text);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void expect_refused(const std::string& file, const std::string& part) {
  try {
    essential(file);
    ADD_FAILURE() << "not refused: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_EQ(std::string(error.what()).substr(0, 7), "a.png: ");
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(EssentialPng, LeavesOutWhatPixelsDoNotNeed) {
  const std::string palette = chunk("PLTE", "abcdef"), alpha = chunk("tRNS", "x");
  const std::string stream = black_row(2);
  const std::string begin = chunk("IDAT", stream.substr(0, 3)), rest = chunk("IDAT", stream.substr(3));
  const std::string plain = kSignature + header(8, 3) + palette + alpha + begin + rest + kEnd;
  EXPECT_EQ(essential(plain), plain);
  EXPECT_EQ(essential(kSignature + header(8, 3) + chunk("iCCP", "sRGB") + palette + alpha + begin +
                      chunk("tEXt", "by") + rest + kEnd + "rubbish"),
            plain);
}

TEST(EssentialPng, TextsAreKeptWhereTheyAreAskedFor) {
  const std::string text = chunk("tEXt", "by");
  const std::string plain = kSignature + header(8, 2) + text + kPixels + text + kEnd;
  EXPECT_EQ(essential(plain, PngText::kept), plain);
  EXPECT_EQ(essential(plain), kSignature + header(8, 2) + kPixels + kEnd);
}

TEST(EssentialPng, AMissingEndIsAdded) {
  EXPECT_EQ(essential(kSignature + header(8, 2) + kPixels), kSignature + header(8, 2) + kPixels + kEnd);
}

TEST(EssentialPng, DamageIsRefusedWithItsName) {
  const std::string whole = kSignature + header(8, 2) + kPixels + kEnd;
  std::string damaged = whole;
  ++damaged[damaged.find("IDAT") + 4];
  expect_refused(damaged, "wrong checksum of a chunk IDAT");
  for (std::size_t size = kSignature.size() + 1; size + kEnd.size() < whole.size(); ++size) {
    if (size != kSignature.size() + header(8, 2).size()) expect_refused(whole.substr(0, size), "ends within a chunk");
  }
  expect_refused(kSignature, "no pixels");
  expect_refused(kSignature + header(8, 2) + kEnd, "no pixels");
  expect_refused(kSignature + kPixels, "no header");
  expect_refused(kSignature + header(8, 3) + kPixels, "no palette");
  expect_refused(kSignature + header(8, 2) + kPixels + header(8, 2), "IHDR is out of place");
  expect_refused(kSignature + header(8, 2) + kPixels + chunk("PLTE", "abc"), "PLTE is out of place");
}

TEST(EssentialPng, DamageWithinThePixelsIsRefused) {
  expect_refused(kSignature + header(8, 2) + chunk("IDAT", "rubbish") + kEnd, "damaged in its pixels: ");
  expect_refused(kSignature + header(8, 6) + kPixels + kEnd, "damaged in its pixels: the pixels end early");
}

TEST(EssentialPng, NothingIsInflatedForPixelsThatAreTooMany) {
  const std::string huge = chunk("IHDR", big_endian(1 << 20) + big_endian(1 << 20) + std::string{8, 2, 0, 0, 0});
  EXPECT_NO_THROW(essential(kSignature + huge + chunk("IDAT", "rubbish") + kEnd));
}

TEST(EssentialPng, TheHeaderMakesSense) {
  for (const auto& [depth, color] : {std::pair<char, char>{16, 3}, {4, 2}, {3, 0}, {8, 5}, {8, 7}}) {
    expect_refused(kSignature + header(depth, color) + kPixels, "header makes no sense");
  }
  EXPECT_NO_THROW(essential(kSignature + header(1, 0) + chunk("IDAT", black_row(1))));
  EXPECT_NO_THROW(essential(kSignature + header(16, 6) + chunk("IDAT", black_row(16))));
  const std::string wide = chunk("IHDR", big_endian(0) + big_endian(1) + std::string{8, 2, 0, 0, 0});
  expect_refused(kSignature + wide + kPixels, "0x1");
}

}  // namespace
}  // namespace vernier
