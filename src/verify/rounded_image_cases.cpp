#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "verify/image_cases.h"
#include "verify/picture.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

constexpr int kSide = 96;

/// A unit sphere of 16 x 8 facets, its corners in the world; they are their own normals.
struct CoarseSphere {
  std::vector<std::array<glm::dvec3, 3>> facets;
  ImageScene made;
};

CoarseSphere coarse_sphere(SampleRandom& random, const glm::dvec3& to_light) {
  CoarseSphere sphere;
  const VerifyMesh mesh = sphere_mesh(16, 8, 1.0, 1.0, random);
  const glm::dmat4 turn = rotation(random);
  add_object(sphere.made.scene, mesh, matte(glm::vec3(1.0f)), turn);
  sphere.made.scene.meshes.back().normals = mesh.positions;
  surround(sphere.made.scene, glm::vec3(0.0f));
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = -to_light;
  sun.intensity = glm::vec3(1.0f);
  sphere.made.scene.lights.push_back(sun);
  for (const glm::uvec3& triangle : mesh.triangles) {
    std::array<glm::dvec3, 3> facet;
    for (int corner = 0; corner < 3; ++corner)
      facet[corner] = glm::dmat3(turn) * glm::dvec3(mesh.positions[triangle[corner]]);
    sphere.facets.push_back(facet);
  }
  return sphere;
}

/// The cosine by which the light falls on the rounded sphere where `ray` enters the facets; none where it misses them.
std::optional<double> rounded_cosine(const CoarseSphere& sphere, const PixelRay& ray, const glm::dvec3& to_light) {
  for (const auto& [p0, p1, p2] : sphere.facets) {
    const glm::dvec3 area = glm::cross(p1 - p0, p2 - p0);
    const double cosine = glm::dot(ray.direction, area);
    if (cosine >= 0.0) continue;  // wound outwards: a convex body is entered where a facet faces the eye
    const glm::dvec3 at = ray.origin + ray.direction * (glm::dot(p0 - ray.origin, area) / cosine);
    const double size = glm::dot(area, area);
    const glm::dvec3 weights(glm::dot(glm::cross(p1 - at, p2 - at), area) / size,
                             glm::dot(glm::cross(p2 - at, p0 - at), area) / size,
                             glm::dot(glm::cross(p0 - at, p1 - at), area) / size);
    if (std::min({weights.x, weights.y, weights.z}) < 0.0) continue;
    return std::max(glm::dot(glm::normalize(weights.x * p0 + weights.y * p1 + weights.z * p2), to_light), 0.0);
  }
  return std::nullopt;
}

}  // namespace

CaseResult run_rounded_terminator(const CaseSetup& setup) {
  constexpr const char* kName = "rounded_terminator";
  // Twenty roundings of numbers below 1: weights, normals, the cosine, and what it is multiplied by.
  Tally tally("absolute", 20.0 * 0x1p-24);
  std::uint64_t judged = 0;
  for_each_picture(setup, kName, kSide, 8, [&](SampleRandom& random, std::uint64_t number) {
    const glm::dvec3 to_light = random.direction();
    const CoarseSphere sphere = coarse_sphere(random, to_light);
    ImageScene made = sphere.made;
    const glm::dvec3 aside = glm::normalize(glm::cross(to_light, random.direction()));
    made.camera = looking(3.0 * aside + to_light, glm::dvec3(0.0), 0.6);
    Picture picture = render_picture(setup, made, picture_settings(setup, kSide));
    picture.number = number;
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      double least = 1.0, most = 0.0;
      for (const PixelRay& ray : nearby_rays(pixel_ray(made.camera, picture, pixel), 1e-6)) {
        const std::optional<double> cosine = rounded_cosine(sphere, ray, to_light);
        if (!cosine) return 0.0;
        least = std::min(least, *cosine);
        most = std::max(most, *cosine);
      }
      ++judged;
      const double seen = picture.color(pixel).x * std::numbers::pi;
      return std::max({0.0, seen - most, least - seen});
    });
  });
  return if_judged(tally.result(), judged);
}

}  // namespace vernier
