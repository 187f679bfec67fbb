#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "render/render_settings.h"
#include "render/traversal_form.h"

namespace vernier {

/// How the kernel that adds to a film reads back its sums on `device`, whatever form rays take through the scene.
constexpr SceneLoads film_loads(const DeviceDescription& device) {
  return choose_scene_loads(device);
}

/// The accumulator on the device: sums of every pixel of `area`, in bands of whole rows that keep every buffer within
/// the device's limits. shared/film_layout.h. Owns its buffers.
class Film {
 public:
  /// A band of rows, counted from the top of the area.
  struct Band {
    int first_row = 0;
    int row_count = 0;
    Buffer sums;
    Buffer aovs;  ///< only with AOVs
  };

  /// An empty film. `with_aovs` makes room for the AOVs as well.
  Film(const Device& device, const PixelRect& area, bool with_aovs);

  const PixelRect& area() const { return area_; }
  /// Rows of every band but the last.
  int band_height() const { return band_height_; }
  std::vector<Band>& bands() { return bands_; }
  /// Device memory in all.
  std::uint64_t size_bytes() const;

  /// What room for the AOVs of `area` takes.
  static std::uint64_t aov_bytes(const PixelRect& area);
  /// Takes all samples out; waits. AOVs stay.
  void clear(const Device& device);
  /// The same for the first `row_count` rows.
  void clear_rows(const Device& device, int row_count);
  /// Words per pixel [height][width][FILM_WORDS] of the sums. Waits for the device.
  std::vector<std::uint32_t> read_sums(const Device& device) const;
  /// Replaces the sums by `words`, as many as read_sums gives; waits. Throws std::logic_error for another number.
  void write_sums(const Device& device, std::span<const std::uint32_t> words);
  /// Words per pixel [height][width][AOV_WORDS]. Waits for the device. The film was made with AOVs.
  std::vector<std::uint32_t> read_aovs(const Device& device) const;

  /// The words of one pixel, counted from the upper left of the film: FILM_WORDS of its sums. Waits.
  std::vector<std::uint32_t> read_pixel(const Device& device, int x, int y) const;
  /// Its AOV_WORDS. The film was made with AOVs.
  std::vector<std::uint32_t> read_pixel_aovs(const Device& device, int x, int y) const;

 private:
  std::vector<std::uint32_t> read_words(const Device& device, int x, int y, Buffer Band::*member,
                                        std::size_t count) const;

  PixelRect area_;
  int band_height_ = 0;
  std::vector<Band> bands_;
};

}  // namespace vernier
