#include "preview/error_history.h"

namespace vernier {

bool ErrorHistory::wants(std::uint32_t samples) const {
  return samples > samples_ && 2 * samples >= 3 * samples_;
}

void ErrorHistory::add(const DevelopedFilm& film, std::uint32_t samples, double seconds) {
  map_.update(film);
  if (samples_ > 0) points_.push_back({seconds, static_cast<float>(map_.estimate().bound())});
  samples_ = samples;
  not_finite_ = film.non_finite_pixels;
}

}  // namespace vernier
