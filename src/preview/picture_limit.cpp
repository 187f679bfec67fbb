#include "preview/picture_limit.h"

#include <cstdint>

#include "preview/widgets.h"

namespace vernier {
namespace {

// 4.5 GiB of film.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 25;

}  // namespace

std::string picture_fault(glm::ivec2 size) {
  if (std::int64_t{size.x} * size.y <= kMostPixels) return "";
  return "at most " + grouped(static_cast<std::uint64_t>(kMostPixels)) + " pixels in a window";
}

}  // namespace vernier
