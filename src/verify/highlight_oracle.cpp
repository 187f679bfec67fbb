#include "verify/highlight_oracle.h"

#include <cmath>

namespace vernier {

long double exact_highlight(const glm::vec<3, long double>& normal, const glm::vec<3, long double>& to_light,
                            const glm::vec<3, long double>& to_viewer, long double exponent) {
  const glm::vec<3, long double> n = glm::normalize(normal);
  const glm::vec<3, long double> h = glm::normalize(to_light + to_viewer);
  if (glm::dot(n, h) <= 0.0L) return 0.0L;
  const glm::vec<3, long double> sine = glm::cross(n, h);
  return std::exp(0.5L * exponent * std::log1p(-glm::dot(sine, sine)));
}

}  // namespace vernier
