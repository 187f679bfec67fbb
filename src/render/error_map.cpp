#include "render/error_map.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "image/difference.h"

namespace vernier {
namespace {

/// Of the normal distribution: 95 % lie below so many standard errors.
constexpr double kQuantile95 = 1.6448536269514722;

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

double ErrorEstimate::bound() const {
  return std::sqrt(rel_mse + kQuantile95 * standard_error);
}

ErrorMap::ErrorMap(int width, int height)
    : width_(width),
      height_(height),
      color_(std::size_t{3} * width * height),
      samples_(std::size_t{1} * width * height),
      rays_(samples_.size()),
      error_(samples_.size()) {}

void ErrorMap::update(const DevelopedFilm& film) {
  for (std::size_t pixel = 0; pixel < samples_.size(); ++pixel) {
    const std::uint32_t before = samples_[pixel];
    const std::uint32_t now = film.sample_count[pixel];
    if (now == before) continue;
    const float* color = film.color.data() + 4 * pixel;
    float* old_color = color_.data() + 3 * pixel;
    const double error = before == 0 ? 0.0 : relative_square_error(old_color, color, before, now);
    error_[pixel] = std::isfinite(error) ? static_cast<float>(error) : 0.0f;
    std::copy_n(color, 3, old_color);
    samples_[pixel] = now;
    rays_[pixel] = film.cost[3 * pixel];
  }
}

ErrorEstimate ErrorMap::estimate() const {
  double sum = 0.0;
  double squares = 0.0;
  for (const float error : error_) {
    sum += error;
    squares += static_cast<double>(error) * error;
  }
  return estimate_of(sum, squares, static_cast<double>(error_.size()));
}

std::vector<std::uint32_t> ErrorMap::choose_blocks(double target, std::uint32_t most) const {
  const auto count = static_cast<std::uint32_t>(block_columns() * ((height_ + kErrorBlock - 1) / kErrorBlock));
  BlockError total;
  std::priority_queue<Doubling> open;
  for (std::uint32_t number = 0; number < count; ++number) {
    const BlockError error = block_error(number);
    total.sum += error.sum;
    total.squares += error.squares;
    if (samples(number) < most) open.push({error.sum, error.squares, error.rays, number, samples(number)});
  }
  std::vector<bool> chosen(count);
  while (!open.empty() && open.top().sum > 0.0 &&
         estimate_of(total.sum, total.squares, static_cast<double>(error_.size())).bound() > target) {
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
  for (std::uint32_t number = 0; number < count; ++number) {
    if (chosen[number]) blocks.push_back(number);
  }
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
  return samples_[static_cast<std::size_t>(rect.y) * width_ + rect.x];
}

ErrorMap::BlockError ErrorMap::block_error(std::uint32_t number) const {
  BlockError error;
  const PixelRect rect = block(number);
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width_ + x;
      error.sum += error_[pixel];
      error.squares += static_cast<double>(error_[pixel]) * error_[pixel];
      error.rays += static_cast<double>(rays_[pixel]) * samples_[pixel];
    }
  }
  return error;
}

}  // namespace vernier
