#include "render/error_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <queue>
#include <utility>

#include "image/difference.h"

namespace vernier {
namespace {

/// The estimated square error of a pixel's mean `now` of n samples, relative as in relMSE, `before` that of its first
/// m.
double relative_square_error(const float* before, const float* now, double m, double n) {
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double step = static_cast<double>(now[c]) - before[c];
    sum += step * step / (static_cast<double>(now[c]) * now[c] + kRelMseFloor);
  }
  return sum / 3.0 * (m / (n - m));
}

/// One doubling of a block's samples that may be made.
struct Doubling {
  double sum = 0.0;  // of the pixels' relMSE before
  double squares = 0.0;
  double rays = 0.0;  // that it takes
  std::uint32_t block = 0;
  std::uint32_t samples = 0;  // of a pixel before

  double gain() const { return sum / std::max(rays, 1.0); }
  /// The one of larger gain comes first; of equal ones that of the lower block.
  bool operator<(const Doubling& other) const {
    return gain() < other.gain() || (gain() == other.gain() && block > other.block);
  }
};

ErrorEstimate estimate_of(double sum, double squares, double pixels) {
  return {.rel_mse = sum / pixels, .standard_error = std::sqrt(squares) / pixels};
}

}  // namespace

ErrorMap::ErrorMap(int width, int height)
    : ErrorMap(width, height, std::vector<PixelError>(std::size_t{1} * width * height)) {}

ErrorMap::ErrorMap(int width, int height, std::vector<PixelError> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {}

void ErrorMap::update(const DevelopedFilm& film) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    PixelError& pixel = pixels_[i];
    const std::uint32_t now = film.sample_count[i];
    if (now == pixel.samples) continue;
    const float* color = film.color.data() + 4 * i;
    const double error = pixel.samples == 0 ? 0.0 : relative_square_error(pixel.color, color, pixel.samples, now);
    pixel.error = std::isfinite(error) ? static_cast<float>(error) : 0.0f;
    std::copy_n(color, 3, pixel.color);
    pixel.samples = now;
    pixel.rays = film.cost[3 * i];
  }
}

ErrorEstimate ErrorMap::estimate() const {
  double sum = 0.0;
  double squares = 0.0;
  for (const PixelError& pixel : pixels_) {
    sum += pixel.error;
    squares += static_cast<double>(pixel.error) * pixel.error;
  }
  return estimate_of(sum, squares, static_cast<double>(pixels_.size()));
}

std::vector<std::uint32_t> ErrorMap::choose_blocks(double target, std::uint32_t most) const {
  const std::vector<std::uint32_t> all = all_blocks();
  BlockError total;
  std::priority_queue<Doubling> open;
  for (const std::uint32_t number : all) {
    const BlockError error = block_error(number);
    total.sum += error.sum;
    total.squares += error.squares;
    if (samples(number) < most) open.push({error.sum, error.squares, error.rays, number, samples(number)});
  }
  std::vector<bool> chosen(all.size());
  while (!open.empty() && open.top().sum > 0.0 &&
         estimate_of(total.sum, total.squares, static_cast<double>(pixels_.size())).bound() > target) {
    Doubling doubling = open.top();
    open.pop();
    chosen[doubling.block] = true;
    // Half the error: a quarter of its square.
    total.sum -= 0.5 * doubling.sum;
    total.squares -= 0.75 * doubling.squares;
    doubling = {0.5 * doubling.sum, 0.25 * doubling.squares, 2.0 * doubling.rays, doubling.block, 2 * doubling.samples};
    if (doubling.samples < most) open.push(doubling);
  }
  std::vector<std::uint32_t> blocks;
  std::ranges::copy_if(all, std::back_inserter(blocks), [&](std::uint32_t number) { return chosen[number]; });
  return blocks;
}

std::vector<std::uint32_t> ErrorMap::all_blocks() const {
  const int rows = (height_ + kErrorBlock - 1) / kErrorBlock;
  std::vector<std::uint32_t> blocks(static_cast<std::size_t>(block_columns()) * rows);
  std::iota(blocks.begin(), blocks.end(), 0u);
  return blocks;
}

int ErrorMap::block_columns() const {
  return (width_ + kErrorBlock - 1) / kErrorBlock;
}

PixelRect ErrorMap::block(std::uint32_t number) const {
  const int x = static_cast<int>(number) % block_columns() * kErrorBlock;
  const int y = static_cast<int>(number) / block_columns() * kErrorBlock;
  return {x, y, std::min(kErrorBlock, width_ - x), std::min(kErrorBlock, height_ - y)};
}

std::uint32_t ErrorMap::samples(std::uint32_t block_number) const {
  const PixelRect rect = block(block_number);
  return pixels_[static_cast<std::size_t>(rect.y) * width_ + rect.x].samples;
}

ErrorMap::BlockError ErrorMap::block_error(std::uint32_t number) const {
  BlockError error;
  const PixelRect rect = block(number);
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const PixelError& pixel = pixels_[static_cast<std::size_t>(y) * width_ + x];
      error.sum += pixel.error;
      error.squares += static_cast<double>(pixel.error) * pixel.error;
      error.rays += static_cast<double>(pixel.rays) * pixel.samples;
    }
  }
  return error;
}

}  // namespace vernier
