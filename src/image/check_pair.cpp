#include "image/check_pair.h"

#include <string>

#include "error.h"

namespace vernier {
namespace {

std::string size_text(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height);
}

void check(const Image& image) {
  if (image.width < 1 || image.height < 1) throw Error(ErrorKind::usage, "compare images: an image has no pixels");
  if (image.channel_count != 1 && image.channel_count != 3 && image.channel_count != 4)
    throw Error(ErrorKind::usage,
                "compare images: an image has " + std::to_string(image.channel_count) + " channels, not 1, 3 or 4");
  if (image.values.size() != static_cast<std::size_t>(image.width) * image.height * image.channel_count)
    throw Error(ErrorKind::usage, "compare images: an image has " + std::to_string(image.values.size()) +
                                      " values for " + size_text(image) + " pixels");
}

}  // namespace

void check_pair(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw Error(ErrorKind::usage, "compare images: sizes differ: " + size_text(a) + " and " + size_text(b) + " pixels");
  check(a);
  check(b);
}

std::array<double, 3> rgb_of_pixel(const Image& image, std::size_t pixel) {
  const float* values = image.values.data() + pixel * image.channel_count;
  if (image.channel_count == 1) return {values[0], values[0], values[0]};
  return {values[0], values[1], values[2]};
}

}  // namespace vernier
