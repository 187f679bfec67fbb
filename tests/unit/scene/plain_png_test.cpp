#include "scene/plain_png.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

#include "error.h"

namespace vernier {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kWidth = 5, kHeight = 11;

/// What filter `filter` predicts of the byte at `place` (PNG Specification, 9.2), by the definition.
int prediction(int filter, const Bytes& pixels, std::size_t row_bytes, std::size_t channels, std::size_t place) {
  const bool has_left = place % row_bytes >= channels, has_above = place >= row_bytes;
  const int left = has_left ? pixels[place - channels] : 0, above = has_above ? pixels[place - row_bytes] : 0;
  const int corner = has_left && has_above ? pixels[place - row_bytes - channels] : 0;
  if (filter < 3) return filter == 0 ? 0 : filter == 1 ? left : above;
  if (filter == 3) return (left + above) / 2;
  const int estimate = left + above - corner;
  const int nearest = std::min({std::abs(estimate - left), std::abs(estimate - above), std::abs(estimate - corner)});
  return nearest == std::abs(estimate - left) ? left : nearest == std::abs(estimate - above) ? above : corner;
}

/// `pixels` filtered by all five filters, row after row in turn, and deflated.
std::string filtered(const Bytes& pixels, std::size_t channels) {
  const std::size_t row_bytes = kWidth * channels;
  std::string rows;
  for (std::size_t place = 0; place < pixels.size(); ++place) {
    const int filter = static_cast<int>(place / row_bytes % 5);
    if (place % row_bytes == 0) rows += static_cast<char>(filter);
    rows += static_cast<char>(pixels[place] - prediction(filter, pixels, row_bytes, channels, place));
  }
  uLongf size = compressBound(static_cast<uLong>(rows.size()));
  std::string stream(size, '\0');
  compress(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
           static_cast<uLong>(rows.size()));
  stream.resize(size);
  return stream;
}

Bytes random_bytes(std::size_t count) {
  std::mt19937 random(count);
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

PngChunks chunks_of(std::uint8_t color, const std::string& stream) {
  PngChunks chunks;
  chunks.layout = {kWidth, kHeight, 8, color, false};
  chunks.pixels = {std::as_bytes(std::span(stream))};
  return chunks;
}

using Texel = std::array<std::uint32_t, 4>;

/// Renders random pixels of `channels` through all filters; `texel` says what becomes of the bytes of one.
template <typename TexelOf>
void expect_words(std::uint8_t color, std::size_t channels, const TexelOf& texel, PngChunks chunks = {}) {
  const Bytes pixels = random_bytes(kWidth * kHeight * channels);
  const std::string stream = filtered(pixels, channels);
  chunks.layout = {kWidth, kHeight, 8, color, false};
  chunks.pixels = {std::as_bytes(std::span(stream))};
  ASSERT_TRUE(is_plain_png(chunks));
  const std::vector<std::uint32_t> words = plain_png_words(chunks, "a.png");
  ASSERT_EQ(words.size(), std::size_t{kWidth} * kHeight);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Texel rgba = texel(&pixels[i * channels]);
    EXPECT_EQ(words[i], rgba[0] | rgba[1] << 8 | rgba[2] << 16 | rgba[3] << 24) << "texel " << i;
  }
}

TEST(PlainPng, EveryKindOfColourThroughAllFilters) {
  expect_words(0, 1, [](const std::uint8_t* v) { return Texel{v[0], v[0], v[0], 255}; });
  expect_words(2, 3, [](const std::uint8_t* v) { return Texel{v[0], v[1], v[2], 255}; });
  expect_words(4, 2, [](const std::uint8_t* v) { return Texel{v[0], v[0], v[0], v[1]}; });
  expect_words(6, 4, [](const std::uint8_t* v) { return Texel{v[0], v[1], v[2], v[3]}; });
}

TEST(PlainPng, PaletteWithTransparencyAndMissingEntries) {
  const Bytes colors = random_bytes(3 * 200), alphas = random_bytes(100);
  PngChunks chunks;
  chunks.palette = std::as_bytes(std::span(colors));
  chunks.transparency = std::as_bytes(std::span(alphas));
  const auto texel = [&](const std::uint8_t* v) {
    const std::size_t entry = v[0];
    if (entry >= 200) return Texel{0, 0, 0, 255};
    return Texel{colors[3 * entry], colors[3 * entry + 1], colors[3 * entry + 2], entry < 100 ? alphas[entry] : 255u};
  };
  expect_words(3, 1, texel, chunks);
}

TEST(PlainPng, DeepInterlacedAndKeyedImagesAreNotPlain) {
  EXPECT_TRUE(is_plain_png(chunks_of(2, "")));
  PngChunks chunks = chunks_of(2, "");
  chunks.layout.depth = 16;
  EXPECT_FALSE(is_plain_png(chunks));
  chunks = chunks_of(2, "");
  chunks.layout.interlaced = true;
  EXPECT_FALSE(is_plain_png(chunks));
  const Bytes key(6, 0);
  chunks = chunks_of(2, "");
  chunks.transparency = std::as_bytes(std::span(key));
  EXPECT_FALSE(is_plain_png(chunks));
}

TEST(PlainPng, DamagedPixelsAreRefused) {
  const std::string stream = filtered(random_bytes(kWidth * kHeight * 3), 3);
  try {
    plain_png_words(chunks_of(2, stream.substr(0, stream.size() / 2)), "a.png");
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_STREQ(error.what(), "a.png: the PNG file is damaged in its pixels: the pixels end early");
  }
}

}  // namespace
}  // namespace vernier
