#include "scene/plain_png.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "error.h"

namespace vernier {
namespace {

constexpr std::uint8_t kGrey = 0, kTrueColor = 2, kPaletteColor = 3, kGreyAlpha = 4;
constexpr std::uint32_t kOpaque = 0xff000000u;

using Palette = std::array<std::uint32_t, 256>;

std::uint32_t byte_at(std::span<const std::byte> bytes, std::size_t place) {
  return std::to_integer<std::uint32_t>(bytes[place]);
}

std::size_t channel_count(const PngLayout& layout) {
  if (layout.color == kGrey || layout.color == kPaletteColor) return 1;
  return layout.color == kTrueColor ? 3 : layout.color == kGreyAlpha ? 2 : 4;
}

Palette make_palette(const PngChunks& chunks) {
  Palette palette;
  palette.fill(kOpaque);
  for (std::size_t i = 0; i < std::min(palette.size(), chunks.palette.size() / 3); ++i) {
    const std::uint32_t alpha = i < chunks.transparency.size() ? byte_at(chunks.transparency, i) : 255u;
    palette[i] = byte_at(chunks.palette, 3 * i) | byte_at(chunks.palette, 3 * i + 1) << 8 |
                 byte_at(chunks.palette, 3 * i + 2) << 16 | alpha << 24;
  }
  return palette;
}

// That of left, above and upper left which is nearest to left + above - upper left: section 9.4 of the specification.
int paeth(int left, int above, int upper_left) {
  const int to_left = std::abs(above - upper_left), to_above = std::abs(left - upper_left);
  const int to_upper_left = std::abs(left + above - 2 * upper_left);
  const int nearer = to_above <= to_upper_left ? above : upper_left;
  return to_left <= to_above && to_left <= to_upper_left ? left : nearer;
}

// Adds to each byte of `row` what `predict` makes of those to the left, above and above left (0 outside the image).
template <std::size_t kChannels, typename Predict>
void add_prediction(std::span<std::byte> row, std::span<const std::byte> above, const Predict& predict) {
  std::array<int, kChannels> left{}, upper_left{};
  for (std::size_t place = 0; place < row.size(); place += kChannels) {
    for (std::size_t c = 0; c < kChannels; ++c) {
      const int up = std::to_integer<int>(above[place + c]);
      left[c] = (std::to_integer<int>(row[place + c]) + predict(left[c], up, upper_left[c])) & 0xff;
      upper_left[c] = up;
      row[place + c] = std::byte(left[c]);
    }
  }
}

// Undoes `filter`, 0 to 4: section 9.2 of the specification.
template <std::size_t kChannels>
void unfilter(int filter, std::span<std::byte> row, std::span<const std::byte> above) {
  if (filter == 1) add_prediction<kChannels>(row, above, [](int left, int, int) { return left; });
  if (filter == 2) add_prediction<kChannels>(row, above, [](int, int up, int) { return up; });
  if (filter == 3) add_prediction<kChannels>(row, above, [](int left, int up, int) { return (left + up) / 2; });
  if (filter == 4) add_prediction<kChannels>(row, above, paeth);
}

void unfilter_row(std::size_t channels, int filter, std::span<std::byte> row, std::span<const std::byte> above) {
  switch (channels) {
    case 1:
      return unfilter<1>(filter, row, above);
    case 2:
      return unfilter<2>(filter, row, above);
    case 3:
      return unfilter<3>(filter, row, above);
    default:
      return unfilter<4>(filter, row, above);
  }
}

std::uint32_t texel_word(const PngLayout& layout, const Palette& palette, std::span<const std::byte> texel) {
  const std::uint32_t first = byte_at(texel, 0);
  switch (layout.color) {
    case kGrey:
      return first * 0x010101u | kOpaque;
    case kPaletteColor:
      return palette[first];
    case kGreyAlpha:
      return first * 0x010101u | byte_at(texel, 1) << 24;
    default:
      return first | byte_at(texel, 1) << 8 | byte_at(texel, 2) << 16 |
             (texel.size() == 4 ? byte_at(texel, 3) << 24 : kOpaque);
  }
}

}  // namespace

bool is_plain_png(const PngChunks& chunks) {
  const PngLayout& layout = chunks.layout;
  const bool is_keyed = layout.color != kPaletteColor && chunks.transparency.data() != nullptr;
  return layout.depth == 8 && !layout.interlaced && !is_keyed;
}

std::vector<std::uint32_t> plain_png_words(const PngChunks& chunks, const std::string& name) {
  const PngLayout& layout = chunks.layout;
  const std::size_t channels = channel_count(layout);
  const Palette palette = make_palette(chunks);
  std::vector<std::byte> above(layout.width * channels);
  std::vector<std::uint32_t> words;
  words.reserve(std::size_t{layout.width} * layout.height);
  const std::string fault = read_png_rows(layout, chunks.pixels, [&](int filter, std::span<std::byte> row) {
    unfilter_row(channels, filter, row, above);
    for (std::size_t place = 0; place < row.size(); place += channels) {
      words.push_back(texel_word(layout, palette, row.subspan(place, channels)));
    }
    std::ranges::copy(row, above.begin());
  });
  if (!fault.empty()) throw Error(ErrorKind::refused, name + ": the PNG file is damaged in its pixels: " + fault);
  return words;
}

}  // namespace vernier
