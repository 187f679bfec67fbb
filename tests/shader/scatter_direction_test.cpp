#include <gtest/gtest.h>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// A unit vector on the side of `normal`.
vec3 above(RandomValues& random, const vec3& normal) {
  const vec3 v = unit_vector(random.direction());
  return dot_product(v, normal) < 0.0f ? -v : v;
}

TEST(ScatterDirection, mirrored_by_hand) {
  const vec3 up(0, 1, 0);
  EXPECT_LT(glm::distance(mirrored_direction(unit_vector(vec3(1, 1, 0)), up, up), unit_vector(vec3(-1, 1, 0))), 2e-7f);
  EXPECT_EQ(mirrored_direction(up, up, up), up);
}

TEST(ScatterDirection, mirrored_angles_are_equal_and_in_one_plane) {
  RandomValues random(14);
  for (int i = 0; i < 50000; ++i) {
    const vec3 normal = unit_vector(random.direction());
    const vec3 viewer = above(random, normal);
    const vec3 mirrored = mirrored_direction(viewer, normal, normal);
    ASSERT_NEAR(dot_product(mirrored, normal), dot_product(viewer, normal), 6e-7);
    ASSERT_NEAR(glm::dot(glm::cross(viewer, normal), mirrored), 0.0f, 6e-7);
    ASSERT_NEAR(glm::length(mirrored), 1.0f, 2e-7);
  }
}

TEST(ScatterDirection, refracted_by_snell) {
  RandomValues random(15);
  for (int i = 0; i < 100000; ++i) {
    const vec3 normal = unit_vector(random.direction());
    const vec3 viewer = above(random, normal);
    const float eta = i % 2 == 0 ? random.in(1, 3) : 1.0f / random.in(1, 3);
    const double cosine = glm::dot(glm::dvec3(viewer), glm::dvec3(normal));
    const double behind_squared = 1 - (1 - cosine * cosine) / (double(eta) * eta);
    if (behind_squared < 1e-3) continue;  // where the cosine behind is ill-conditioned
    const Fresnel fresnel = fresnel_dielectric(dot_product(normal, viewer), eta);
    const vec3 refracted = refracted_direction(viewer, normal, normal, eta, fresnel);
    const glm::dvec3 exact = (-glm::dvec3(viewer) + glm::dvec3(normal) * cosine) / double(eta) -
                             glm::dvec3(normal) * std::sqrt(behind_squared);
    // The cosine behind is a root: its error is that of its square, 2^-23, over twice the cosine, at least 0.03.
    ASSERT_LT(glm::length(glm::dvec3(refracted) - exact), 2e-6 / std::sqrt(behind_squared)) << eta << ' ' << cosine;
  }
}

TEST(ScatterDirection, exact_refraction_is_rounded_once) {
  LEVELS = LEVELS_OF(LEVEL_EXACT);
  RandomValues random(18);
  for (int i = 0; i < 20000; ++i) {
    const vec3 normal = unit_vector(random.direction());
    const vec3 viewer = above(random, normal);
    const float eta = i % 2 == 0 ? random.in(1, 3) : 1.0f / random.in(1, 3);
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal)), v = glm::normalize(glm::dvec3(viewer));
    const double cosine = glm::dot(v, n), behind_squared = 1 - (1 - cosine * cosine) / (double(eta) * eta);
    if (behind_squared < 1e-3) continue;  // where double itself runs out of digits
    const vec3 refracted = refracted_direction(viewer, normal, normal, eta, fresnel_dielectric(float(cosine), eta));
    const glm::dvec3 exact = (n * cosine - v) / double(eta) - n * std::sqrt(behind_squared);
    // Half an ulp of numbers below 1.
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(refracted[axis], exact[axis], 0x1p-25 * 1.001) << eta;
  }
  LEVELS = LEVELS_OF(LEVEL_ROBUST);
}

TEST(ScatterDirection, equal_indices_bend_nothing) {
  RandomValues random(16);
  for (int i = 0; i < 1000; ++i) {
    const vec3 normal = unit_vector(random.direction());
    const vec3 viewer = above(random, normal);
    const Fresnel fresnel = fresnel_dielectric(dot_product(normal, viewer), 1.0f);
    ASSERT_EQ(refracted_direction(viewer, normal, normal, 1.0f, fresnel), -viewer);
  }
}

TEST(ScatterDirection, shading_normals_never_lead_to_the_wrong_side) {
  RandomValues random(17);
  for (int i = 0; i < 100000; ++i) {
    const vec3 geometric = unit_vector(random.direction());
    const vec3 viewer = above(random, geometric);
    const vec3 shading = scatter_normal(above(random, geometric), viewer);
    // A rounding of the mirrored height may leave it 2^-22 on the other side.
    ASSERT_GE(dot_product(shading, viewer), -0x1p-22f);
    ASSERT_GE(dot_product(mirrored_direction(viewer, shading, geometric), geometric), -0x1p-22f);
    const float cosine = std::min(std::max(dot_product(shading, viewer), 0.0f), 1.0f);
    for (float eta : {1.5f, 1.0f / 1.5f}) {
      const Fresnel fresnel = fresnel_dielectric(cosine, eta);
      if (fresnel.transmitted == 0.0f) continue;
      ASSERT_LE(dot_product(refracted_direction(viewer, shading, geometric, eta, fresnel), geometric), 0x1p-22f);
    }
  }
}

TEST(ScatterDirection, a_normal_that_faces_away_is_mirrored_across_the_viewer) {
  const vec3 viewer(0, 0, 1);
  EXPECT_EQ(scatter_normal(vec3(0.6f, 0, 0.8f), viewer), vec3(0.6f, 0, 0.8f));
  EXPECT_LT(glm::distance(scatter_normal(vec3(0.6f, 0, -0.8f), viewer), vec3(0.6f, 0, 0.8f)), 2e-7f);
}

}  // namespace
}  // namespace vernier::shader
