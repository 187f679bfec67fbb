#include "reference/fresnel.h"

#include <algorithm>
#include <cmath>

namespace vernier::reference {

namespace {

// Square of the sine behind the surface; above 1 there is no ray behind it.
double squared_sine_behind(double cosine, double eta) {
  return (1.0 - cosine) * (1.0 + cosine) / (eta * eta);
}

}  // namespace

double fresnel_reflectance(double cosine, double eta) {
  if (eta == 1.0) return 0.0;
  const double sine2 = squared_sine_behind(cosine, eta);
  if (sine2 >= 1.0) return 1.0;
  const double behind = std::sqrt(1.0 - sine2);
  const double perpendicular = (cosine - eta * behind) / (cosine + eta * behind);
  const double parallel = (eta * cosine - behind) / (eta * cosine + behind);
  return 0.5 * (perpendicular * perpendicular + parallel * parallel);
}

double reflectance_at_normal(double ior) {
  const double root = (ior - 1.0) / (ior + 1.0);
  return root * root;
}

double grazing_share(double reflectance, double ior) {
  const double normal = reflectance_at_normal(ior);
  return normal < 1.0 ? (reflectance - normal) / (1.0 - normal) : 1.0;
}

glm::dvec3 refracted_direction(const glm::dvec3& view, const glm::dvec3& normal, double eta) {
  const double cosine = glm::dot(normal, view);
  const double behind = std::sqrt(std::max(0.0, 1.0 - squared_sine_behind(cosine, eta)));
  return glm::normalize((cosine / eta - behind) * normal - view / eta);
}

}  // namespace vernier::reference
