#pragma once

#include <cstdint>
#include <vector>

#include "render/develop.h"
#include "render/error_estimate.h"

namespace vernier {

/// Pixels of a side of the blocks that get the same number of samples: enough pixels that the rule which stops a block
/// knows little of any one of them, small enough for an edge.
constexpr int kErrorBlock = 8;

/// What is known of a pixel's error. Part of film files: no padding.
struct PixelError {
  float color[3] = {0.0f, 0.0f, 0.0f};  ///< as of the last update
  std::uint32_t samples = 0;
  float rays = 0.0f;   ///< per sample
  float error = 0.0f;  ///< relMSE of the pixel
};
static_assert(sizeof(PixelError) == 24);

/// How wrong each pixel of a film is likely to be, from what its mean did when its samples grew, and where further
/// samples pay most. Pure.
///
/// A pixel's first n samples are stratified, and the error of their mean is at most weakly correlated with what the
/// next samples add. So the mean square of the step from m to n samples is the difference of the variances before and
/// after, V(m) - V(n); with V(n) <= V(m) m / n, as for independent samples or better, V(n) <= step^2 m / (n - m). At
/// edges, where V falls like n^-1.5, that is 1.8 times too large: the estimate errs on the side of more samples.
class ErrorMap {
 public:
  /// Of a film of `width` x `height` pixels without samples.
  ErrorMap(int width, int height);
  /// As it was when `pixels` were taken from it, [height][width].
  ErrorMap(int width, int height, std::vector<PixelError> pixels);

  /// What is known, [height][width].
  const std::vector<PixelError>& pixels() const { return pixels_; }

  /// Takes the film as it is now. Pixels that have more samples than at the call before are estimated anew; one without
  /// an estimate counts as not known. Pixels with a sample that is not finite count as right: no sample mends them.
  void update(const DevelopedFilm& film);

  /// Over all pixels. Call it after two updates in which all pixels got samples.
  ErrorEstimate estimate() const;

  /// The fewest blocks that should do, if doubling their samples halves their errors: sqrt(relMSE) then stays below
  /// `target` with 95 % confidence. Those first that lose most error for each ray. Only blocks with less than `most`
  /// samples; all of these where nothing less will do. In order of their numbers, row by row.
  std::vector<std::uint32_t> choose_blocks(double target, std::uint32_t most) const;

  /// All blocks, in order of their numbers.
  std::vector<std::uint32_t> all_blocks() const;
  /// Blocks in a row.
  int block_columns() const;
  /// Pixels [x, y, width, height] of a block.
  PixelRect block(std::uint32_t number) const;
  /// Samples that every pixel of the block has.
  std::uint32_t samples(std::uint32_t block_number) const;

 private:
  struct BlockError {
    double sum = 0.0;      // of the pixels' relMSE
    double squares = 0.0;  // of the same, squared
    double rays = 0.0;     // that its samples took
  };
  BlockError block_error(std::uint32_t number) const;

  int width_, height_;
  std::vector<PixelError> pixels_;
};

}  // namespace vernier
