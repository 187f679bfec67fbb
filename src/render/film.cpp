#include "render/film.h"

#include <algorithm>
#include <stdexcept>

#include "render/setting_limits.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

/// A band is at most that large, whatever the device allows: smaller bands cost nothing and keep staging small.
constexpr std::uint64_t kLargestBandBytes = std::uint64_t{64} << 20;

int rows_per_band(const Device& device, int width) {
  const std::uint64_t limit = std::min(device.description().max_storage_buffer_range_bytes, kLargestBandBytes);
  const std::uint64_t row_bytes = static_cast<std::uint64_t>(width) * std::max(FILM_WORDS, AOV_WORDS) * 4;
  return static_cast<int>(std::clamp<std::uint64_t>(limit / row_bytes, 1, kMaxSide_px));
}

std::vector<std::uint32_t> read_bands(const Device& device, const std::vector<Film::Band>& bands, std::size_t row_words,
                                      int height, Buffer Film::Band::*member) {
  std::vector<std::uint32_t> words(row_words * static_cast<std::size_t>(height));
  for (const Film::Band& band : bands) {
    const std::span part(words.data() + row_words * static_cast<std::size_t>(band.first_row),
                         row_words * static_cast<std::size_t>(band.row_count));
    (band.*member).download(device, std::as_writable_bytes(part));
  }
  return words;
}

}  // namespace

Film::Film(const Device& device, const PixelRect& area, bool with_aovs)
    : area_(area), band_height_(rows_per_band(device, area.width)) {
  for (int row = 0; row < area.height; row += band_height_) {
    Band band{.first_row = row, .row_count = std::min(band_height_, area.height - row), .sums = {}, .aovs = {}};
    const std::uint64_t pixels = static_cast<std::uint64_t>(area.width) * static_cast<std::uint64_t>(band.row_count);
    band.sums = Buffer(device, pixels * FILM_WORDS * 4, stored_use(film_loads(device.description())));
    band.aovs = Buffer(device, with_aovs ? pixels * AOV_WORDS * 4 : 0, BufferUse::storage);
    bands_.push_back(std::move(band));
  }
}

std::uint64_t Film::size_bytes() const {
  std::uint64_t sum = 0;
  for (const Band& band : bands_) sum += band.sums.size_bytes() + band.aovs.size_bytes();
  return sum;
}

void Film::clear(const Device& device) {
  for (Band& band : bands_) band.sums.clear(device);
}

void Film::clear_rows(const Device& device, int row_count) {
  const std::uint64_t row_bytes = static_cast<std::uint64_t>(area_.width) * FILM_WORDS * 4;
  for (Band& band : bands_) {
    if (band.first_row >= row_count) return;
    band.sums.clear_front(device, row_bytes * static_cast<std::uint64_t>(row_count - band.first_row));
  }
}

std::vector<std::uint32_t> Film::read_sums(const Device& device) const {
  return read_bands(device, bands_, static_cast<std::size_t>(area_.width) * FILM_WORDS, area_.height, &Band::sums);
}

void Film::write_sums(const Device& device, std::span<const std::uint32_t> words) {
  const std::size_t row_words = static_cast<std::size_t>(area_.width) * FILM_WORDS;
  if (words.size() != row_words * static_cast<std::size_t>(area_.height)) {
    throw std::logic_error("Film::write_sums: words of another film");
  }
  for (Band& band : bands_) {
    const std::size_t first = row_words * static_cast<std::size_t>(band.first_row);
    band.sums.upload(device, std::as_bytes(words.subspan(first, row_words * static_cast<std::size_t>(band.row_count))));
  }
}

std::uint64_t Film::aov_bytes(const PixelRect& area) {
  return std::uint64_t{AOV_WORDS} * sizeof(std::uint32_t) * static_cast<std::uint64_t>(area.width) *
         static_cast<std::uint64_t>(area.height);
}

std::vector<std::uint32_t> Film::read_aovs(const Device& device) const {
  return read_bands(device, bands_, static_cast<std::size_t>(area_.width) * AOV_WORDS, area_.height, &Band::aovs);
}

std::vector<std::uint32_t> Film::read_words(const Device& device, int x, int y, Buffer Band::*member,
                                            std::size_t count) const {
  const Band& band = bands_.at(static_cast<std::size_t>(y / band_height_));
  const auto pixel = static_cast<std::uint64_t>(y - band.first_row) * static_cast<std::uint64_t>(area_.width) +
                     static_cast<std::uint64_t>(x);
  std::vector<std::uint32_t> words(count);
  (band.*member).download(device, std::as_writable_bytes(std::span(words)), pixel * count * sizeof(std::uint32_t));
  return words;
}

std::vector<std::uint32_t> Film::read_pixel(const Device& device, int x, int y) const {
  return read_words(device, x, y, &Band::sums, FILM_WORDS);
}

std::vector<std::uint32_t> Film::read_pixel_aovs(const Device& device, int x, int y) const {
  return read_words(device, x, y, &Band::aovs, AOV_WORDS);
}

}  // namespace vernier
