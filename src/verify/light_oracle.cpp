#include "verify/light_oracle.h"

#include <algorithm>

namespace vernier {

long double exact_attenuation(const glm::vec<3, long double>& offset) {
  return 1.0L / glm::dot(offset, offset);
}

long double exact_cone(const glm::vec<3, long double>& direction, long double cos_outer, long double cone_scale,
                       const glm::vec<3, long double>& offset) {
  const long double cosine = glm::dot(direction, glm::normalize(offset));
  const long double cone = std::clamp((cosine - cos_outer) * cone_scale, 0.0L, 1.0L);
  return cone * cone;
}

}  // namespace vernier
