#include "image/png_pixels.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vernier {
namespace {

constexpr std::size_t kBufferBytes = 1u << 16;
constexpr std::byte kLastFilter{4};

// Rows of equal length: an image, or a pass of an interlaced one. A row is a filter byte and `row_bytes` of pixels.
struct Rows {
  std::uint64_t row_bytes;
  std::uint64_t count;
};

// Every `step`-th column and row from `first` on belongs to a pass: the specification's 8.1, Adam7.
struct Pass {
  std::uint32_t first_x, first_y, step_x, step_y;
};
constexpr std::array<Pass, 7> kAdam7 = {
    {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
constexpr std::array<Pass, 1> kWhole = {{{0, 0, 1, 1}}};

std::uint64_t channel_count(std::uint8_t color) {
  const bool has_alpha = (color & 4) != 0, has_hue = color == 2 || color == 6;
  return (has_hue ? 3 : 1) + (has_alpha ? 1 : 0);
}

// How many of 0 ... `size` - 1 a pass takes.
std::uint64_t taken(std::uint32_t size, std::uint32_t first, std::uint32_t step) {
  return size > first ? (std::uint64_t{size} - first + step - 1) / step : 0;
}

std::vector<Rows> rows_of(const PngLayout& layout) {
  const std::uint64_t bits = channel_count(layout.color) * layout.depth;
  std::vector<Rows> rows;
  for (const Pass& pass : layout.interlaced ? std::span<const Pass>(kAdam7) : std::span<const Pass>(kWhole)) {
    const std::uint64_t columns = taken(layout.width, pass.first_x, pass.step_x);
    const std::uint64_t count = taken(layout.height, pass.first_y, pass.step_y);
    if (columns > 0 && count > 0) rows.push_back({(columns * bits + 7) / 8, count});
  }
  return rows;
}

// Follows the inflated bytes row by row.
class RowReader {
 public:
  explicit RowReader(std::vector<Rows> rows) : rows_(std::move(rows)) {}

  // Takes the next bytes of the image; what is wrong with them, or nothing.
  std::string read(std::span<const std::byte> bytes) {
    while (!bytes.empty() && !is_done()) {
      if (left_in_row_ == 0) {
        if (bytes.front() > kLastFilter)
          return "a row's filter is " + std::to_string(std::to_integer<int>(bytes.front()));
        left_in_row_ = rows_[pass_].row_bytes;
        bytes = bytes.subspan(1);
      }
      const std::size_t count = std::min<std::uint64_t>(bytes.size(), left_in_row_);
      left_in_row_ -= count;
      bytes = bytes.subspan(count);
      if (left_in_row_ == 0 && ++row_ == rows_[pass_].count) ++pass_, row_ = 0;
    }
    return "";
  }

  bool is_done() const { return left_in_row_ == 0 && pass_ == rows_.size(); }

 private:
  std::vector<Rows> rows_;
  std::size_t pass_ = 0;
  std::uint64_t row_ = 0;
  std::uint64_t left_in_row_ = 0;
};

// An inflating zlib stream.
class Inflation {
 public:
  Inflation() { ready_ = inflateInit(&stream_) == Z_OK; }
  ~Inflation() {
    if (ready_) inflateEnd(&stream_);
  }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  // Takes `part`, of less than 2^32 bytes, and hands what comes out of it to `rows`; what is wrong, or nothing.
  std::string take(std::span<const std::byte> part, RowReader& rows) {
    if (!ready_) return "zlib cannot begin";
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(part.data()));  // zlib only reads it
    stream_.avail_in = static_cast<uInt>(part.size());
    while (!ended_ && (stream_.avail_in > 0 || stream_.avail_out == 0)) {
      stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      const int result = inflate(&stream_, Z_NO_FLUSH);
      if (result == Z_BUF_ERROR) break;  // nothing left of this part
      ended_ = result == Z_STREAM_END;
      if (result != Z_OK && !ended_) return stream_.msg != nullptr ? stream_.msg : "zlib refuses them";
      std::string fault = rows.read(std::span(buffer_).first(buffer_.size() - stream_.avail_out));
      if (!fault.empty()) return fault;
    }
    stream_.avail_out = static_cast<uInt>(buffer_.size());
    return "";
  }

  bool has_ended() const { return ended_; }

 private:
  z_stream stream_{};
  bool ready_ = false;
  bool ended_ = false;
  std::vector<std::byte> buffer_ = std::vector<std::byte>(kBufferBytes);
};

}  // namespace

std::string png_pixel_fault(const PngLayout& layout, std::span<const std::span<const std::byte>> parts) {
  RowReader rows(rows_of(layout));
  Inflation inflation;
  for (const std::span<const std::byte> part : parts) {
    std::string fault = inflation.take(part, rows);
    if (!fault.empty()) return fault;
  }
  return rows.is_done() && inflation.has_ended() ? "" : "the pixels end early";
}

}  // namespace vernier
