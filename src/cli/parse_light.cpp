#include "cli/parse_light.h"

#include "cli/parse_values.h"
#include "error.h"

namespace vernier {
namespace {

constexpr const char* kOption = "--light";

glm::dvec3 parse_direction(const std::string& text) {
  const glm::dvec3 direction = parse_vec3(kOption, text);
  // Scaled first, so that neither huge nor tiny components overflow or vanish in the squares.
  const double largest = glm::max(glm::abs(direction.x), glm::max(glm::abs(direction.y), glm::abs(direction.z)));
  if (largest == 0.0) {
    throw Error(ErrorKind::usage, "--light: `" + text + "` is not a direction: it has no length");
  }
  return glm::normalize(direction / largest);
}

}  // namespace

Light parse_light(const std::string& text) {
  const std::size_t first = text.find(':');
  const std::size_t second = first == std::string::npos ? first : text.find(':', first + 1);
  const std::string kind = text.substr(0, first);
  if (second == std::string::npos || (kind != "point" && kind != "dir")) {
    throw Error(ErrorKind::usage, "--light: `" + text + "` is not point:x,y,z:r,g,b or dir:x,y,z:r,g,b");
  }
  const std::string place = text.substr(first + 1, second - first - 1);
  Light light;
  light.name = text;
  light.intensity = parse_color(kOption, text.substr(second + 1));
  if (kind == "point") {
    light.position = parse_vec3(kOption, place);
  } else {
    light.kind = LightKind::directional;
    light.direction = parse_direction(place);
  }
  return light;
}

}  // namespace vernier
