#include "reference/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vernier::reference {
namespace {

TEST(FresnelReflectance, NormalIncidence) {
  EXPECT_NEAR(fresnel_reflectance(1.0, 1.5), 0.04, 1e-15);
  EXPECT_NEAR(fresnel_reflectance(1.0, 1.0 / 1.5), 0.04, 1e-15);
  EXPECT_NEAR(fresnel_reflectance(1.0, 2.0), 1.0 / 9.0, 1e-15);
}

// At Brewster's angle, tan = eta, only the perpendicular part returns: ((1 - eta^2) / (1 + eta^2))^2 / 2.
TEST(FresnelReflectance, BrewstersAngle) {
  const double eta = 1.5;
  const double cosine = 1.0 / std::sqrt(1.0 + eta * eta);
  const double perpendicular = (1.0 - eta * eta) / (1.0 + eta * eta);
  EXPECT_NEAR(fresnel_reflectance(cosine, eta), 0.5 * perpendicular * perpendicular, 1e-15);
}

TEST(FresnelReflectance, TotalBeyondTheCriticalAngle) {
  const double critical = std::sqrt(1.0 - 1.0 / (1.5 * 1.5));
  EXPECT_EQ(fresnel_reflectance(critical * 0.999, 1.0 / 1.5), 1.0);
  EXPECT_EQ(fresnel_reflectance(0.0, 1.0 / 1.5), 1.0);
  EXPECT_LT(fresnel_reflectance(critical * 1.001, 1.0 / 1.5), 1.0);
}

TEST(FresnelReflectance, GrazingIsTotalAndEqualMediaReflectNothing) {
  EXPECT_EQ(fresnel_reflectance(0.0, 1.5), 1.0);
  EXPECT_EQ(fresnel_reflectance(0.0, 1.0), 0.0);
  EXPECT_EQ(fresnel_reflectance(0.3, 1.0), 0.0);
}

TEST(FresnelReflectance, IsTheSameFromBothSides) {
  for (double cosine = 0.05; cosine <= 1.0; cosine += 0.05) {
    const double behind = std::sqrt(1.0 - (1.0 - cosine * cosine) / (1.5 * 1.5));
    EXPECT_NEAR(fresnel_reflectance(cosine, 1.5), fresnel_reflectance(behind, 1.0 / 1.5), 1e-14);
  }
}

TEST(RefractedDirection, ObeysSnell) {
  const glm::dvec3 normal(0, 0, 1);
  const glm::dvec3 view(0.6, 0, 0.8);
  const glm::dvec3 direction = refracted_direction(view, normal, 1.5);
  EXPECT_NEAR(direction.x, -0.6 / 1.5, 1e-15);
  EXPECT_NEAR(direction.z, -std::sqrt(1.0 - 0.16), 1e-15);
  EXPECT_EQ(direction.y, 0.0);
}

TEST(RefractedDirection, EqualMediaLeaveTheRayStraight) {
  const glm::dvec3 view = glm::normalize(glm::dvec3(0.3, -0.2, 0.9));
  EXPECT_LT(glm::distance(refracted_direction(view, {0, 0, 1}, 1.0), -view), 1e-15);
}

}  // namespace
}  // namespace vernier::reference
