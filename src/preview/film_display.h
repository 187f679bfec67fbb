#pragma once

#include <vector>

#include "gpu/submission.h"
#include "render/film.h"
#include "shared/display_constants.h"

namespace vernier {

/// What of a film is shown, and how bright.
struct DisplaySettings {
  std::uint32_t layer = DISPLAY_COLOR;  ///< DISPLAY_*
  float exposure_ev = 0.0f;             ///< stops
  float far_depth_m = 1.0f;             ///< where the depth is shown half as bright

  bool operator==(const DisplaySettings&) const = default;
};

/// A film as eight-bit words on the device; it never passes through the host. Owns pipeline and words.
class FilmDisplay {
 public:
  /// For `film`, which has room for AOVs; device and film outlive it.
  FilmDisplay(const Device& device, Film& film);

  /// Turns the upper left `size` pixels of the film into words. Waits. Throws Error(device_lost).
  void draw(glm::ivec2 size, const DisplaySettings& settings);

  /// R8G8B8A8 [size.y][size.x] of the last draw.
  const Buffer& words() const { return words_; }

 private:
  Film& film_;
  Buffer words_;
  Submitter submitter_;
  ComputePipeline pipeline_;
  std::vector<BindingSet> bindings_;
};

}  // namespace vernier
