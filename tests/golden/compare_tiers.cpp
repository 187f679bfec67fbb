#include "compare_tiers.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "error.h"
#include "image/difference.h"
#include "image/flip.h"

namespace vernier::golden {
namespace {

const std::vector<float>& floats(const ImageFile& image, const char* name) {
  return std::get<std::vector<float>>(layer_of(image, name).values);
}

const std::vector<std::uint32_t>& ids(const ImageFile& image, const char* name) {
  return std::get<std::vector<std::uint32_t>>(layer_of(image, name).values);
}

// Counts pixels and remembers the first.
struct PixelCount {
  std::size_t count = 0;
  std::size_t first = 0;
  void add(std::size_t pixel) {
    if (count++ == 0) first = pixel;
  }
  std::string text(int width) const {
    const std::size_t row = static_cast<std::size_t>(width);
    return std::to_string(count) + " pixels, the first " + std::to_string(first % row) + "," +
           std::to_string(first / row);
  }
};

// The worst channel of a pixel, relative to the golden; infinity for NaN.
double relative_difference(const float* a, const float* b) {
  double worst = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double difference = std::abs(static_cast<double>(a[c]) - b[c]) / std::max<double>(std::abs(b[c]), kDarkest);
    if (!(difference <= worst)) worst = difference;
  }
  return worst;
}

}  // namespace

const Layer& layer_of(const ImageFile& image, const std::string& name) {
  const auto found =
      std::find_if(image.layers.begin(), image.layers.end(), [&](const Layer& l) { return l.name == name; });
  if (found == image.layers.end()) throw Error(ErrorKind::refused, "golden: no layer '" + name + "'");
  return *found;
}

Image color_of(const ImageFile& image) {
  return {image.width, image.height, 4, floats(image, "")};
}

TierResult compare_hits(const ImageFile& render, const ImageFile& golden, const HitBounds& bounds, std::uint32_t spp) {
  const std::vector<float>&center = floats(golden, "edge_steps"), &samples = floats(golden, "sample_edge_steps");
  PixelCount undecided, wrong_ids, wrong_hits;
  for (std::size_t pixel = 0; pixel < center.size(); ++pixel) {
    if (!(center[pixel] > bounds.rounding_steps && samples[pixel] > bounds.rounding_steps)) undecided.add(pixel);
    const bool same_ids = ids(render, "object_id")[pixel] == ids(golden, "object_id")[pixel] &&
                          ids(render, "primitive_id")[pixel] == ids(golden, "primitive_id")[pixel];
    if (center[pixel] > bounds.rounding_steps && !same_ids) wrong_ids.add(pixel);
    const std::size_t alpha = 4 * pixel + 3;
    const bool same_hits = std::lround(floats(render, "")[alpha] * spp) == std::lround(floats(golden, "")[alpha] * spp);
    if (samples[pixel] > bounds.rounding_steps && !same_hits) wrong_hits.add(pixel);
  }
  TierResult result;
  const double share = static_cast<double>(undecided.count) / static_cast<double>(center.size());
  result.figures = "A undecided " + std::to_string(undecided.count) + " of " + std::to_string(center.size());
  if (share > bounds.undecided_share) result.faults += "too many undecided: " + undecided.text(render.width) + "; ";
  if (wrong_ids.count > 0) result.faults += "other ids: " + wrong_ids.text(render.width) + "; ";
  if (wrong_hits.count > 0) result.faults += "other hit counts: " + wrong_hits.text(render.width) + "; ";
  return result;
}

TierResult compare_linear(const ImageFile& render, const ImageFile& golden, const LinearBounds& bounds,
                          double rounding_steps) {
  const std::vector<float>&a = floats(render, ""), &b = floats(golden, "");
  const std::vector<float>& decided = floats(golden, "sample_edge_steps");
  PixelCount over;
  double worst = 0.0;
  for (std::size_t pixel = 0; pixel < decided.size(); ++pixel) {
    if (!(decided[pixel] > rounding_steps)) continue;
    const double difference = relative_difference(a.data() + 4 * pixel, b.data() + 4 * pixel);
    if (!(difference <= bounds.relative)) over.add(pixel);
    worst = std::max(worst, difference);
  }
  const Difference whole = compare_images(color_of(render), color_of(golden));
  std::ostringstream figures;
  figures << "B over " << over.count << ", worst " << worst << ", rmse " << whole.rmse;
  TierResult result{"", figures.str()};
  const double most = bounds.share_over * static_cast<double>(decided.size());
  if (static_cast<double>(over.count) > most) result.faults += "colour differs: " + over.text(render.width) + "; ";
  if (!(whole.rmse <= bounds.rmse)) result.faults += "RMSE is above " + std::to_string(bounds.rmse) + "; ";
  if (!whole.finite) result.faults += "non-finite pixels; ";
  return result;
}

TierResult compare_display(const Image& shown, const ImageFile& golden, const DisplayBounds& bounds) {
  const FlipError error = flip(color_of(golden), shown);
  std::ostringstream figures;
  figures << "C FLIP mean " << error.mean << ", p99 " << error.p99;
  TierResult result{"", figures.str()};
  if (!(error.mean <= bounds.flip_mean)) result.faults += "FLIP mean is above its bound; ";
  if (!(error.p99 <= bounds.flip_p99)) result.faults += "FLIP p99 is above its bound; ";
  return result;
}

}  // namespace vernier::golden
