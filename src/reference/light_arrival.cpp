#include "reference/light_arrival.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/fresnel.h"
#include "reference/surface_terms.h"
#include "reference/vertex_values.h"

namespace vernier::reference {

namespace {

double spot_factor(const Light& light, const glm::dvec3& to_light) {
  // Keeps a cone with equal angles a step that is finite.
  constexpr double kNarrowestRim = 1.0 / 1024.0;
  const double cos_outer = std::cos(light.outer_cone_angle);
  const double rim = std::max(std::cos(light.inner_cone_angle) - cos_outer, kNarrowestRim);
  const double share = std::clamp((glm::dot(light.direction, -to_light) - cos_outer) / rim, 0.0, 1.0);
  return share * share;
}

double range_factor(double distance, double range) {
  return std::clamp(1.0 - std::pow(distance / range, 4.0), 0.0, 1.0);
}

// What one crossing lets pass, absorption apart.
struct Passage {
  glm::dvec3 share;
  bool absorbs = false;
};

Passage passage(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights, const glm::dvec3& direction) {
  const double alpha = coverage(scene, triangle, weights);
  if (alpha == 0.0) return {glm::dvec3(1.0), false};
  const Material& material = scene.materials[triangle.material];
  const SurfaceTerms terms = surface_terms(scene, triangle, weights);
  if (terms.transmission == glm::dvec3(0.0)) return {glm::dvec3(1.0 - alpha), false};
  const double cosine = std::abs(glm::dot(triangle.normal, direction));
  const double through =
      terms.plain_mirror ? 1.0 : passed_share(terms, fresnel_reflectance(cosine, material.ior), material.ior);
  return {1.0 - alpha + alpha * terms.transmission * through, !material.thin_walled};
}

// Whether a ray in `direction`, which starts `rise` above the point of `weights` on `triangle`, comes down through it.
// By the weights, so that it does however small the rise.
bool crosses_own(const Triangle& triangle, const glm::dvec3& weights, const glm::dvec3& rise,
                 const glm::dvec3& direction) {
  const double t = -glm::dot(rise, triangle.normal) / glm::dot(direction, triangle.normal);
  const glm::dvec3 aside = rise + t * direction;
  const glm::dvec3 e1 = triangle.corners[1] - triangle.corners[0];
  const glm::dvec3 e2 = triangle.corners[2] - triangle.corners[0];
  const glm::dvec3 area = glm::cross(e1, e2);
  const double to1 = glm::dot(glm::cross(aside, e2), area) / glm::dot(area, area);
  const double to2 = glm::dot(glm::cross(e1, aside), area) / glm::dot(area, area);
  const glm::dvec3 at = weights + glm::dvec3(-to1 - to2, to1, to2);
  return at.x >= 0.0 && at.y >= 0.0 && at.z >= 0.0;
}

// Whether no triangle but `source`, whatever its alpha, lies between `start` on that and `start` + `way`.
bool is_free(const TracedScene& scene, const glm::dvec3& start, const glm::dvec3& way, std::uint32_t source) {
  const Ray ray{start, glm::normalize(way)};
  const double distance = glm::length(way);
  const ShearedRay sheared(ray, source, scene.baked.largest_coordinate);
  bool free = true;
  visit_triangles(scene.tree, ray, distance, [&](std::uint32_t id) {
    const std::optional<Crossing> crossing = sheared.hit(scene.baked.triangles[id], id);
    free = free && !(crossing && crossing->t < distance);
    return free ? distance : -std::numeric_limits<double>::infinity();
  });
  return free;
}

}  // namespace

std::optional<LightArrival> light_arrival(const Light& light, const glm::dvec3& point) {
  const glm::dvec3 intensity(light.intensity);
  if (intensity == glm::dvec3(0.0)) return std::nullopt;
  if (light.kind == LightKind::directional)
    return LightArrival{-light.direction, std::numeric_limits<double>::infinity(), intensity};
  const double distance = glm::distance(light.position, point);
  if (distance == 0.0) return std::nullopt;
  LightArrival arrival{(light.position - point) / distance, distance, intensity / (distance * distance)};
  if (light.kind == LightKind::spot) arrival.irradiance *= spot_factor(light, arrival.direction);
  arrival.irradiance *= range_factor(distance, light.range);
  if (arrival.irradiance == glm::dvec3(0.0)) return std::nullopt;
  return arrival;
}

glm::dvec3 transmittance(const TracedScene& scene, const Ray& ray, double distance, std::uint32_t source) {
  const ShearedRay sheared(ray, source, scene.baked.largest_coordinate);
  glm::dvec3 share(1.0);
  glm::dvec3 optical_depth(0.0);
  visit_triangles(scene.tree, ray, distance, [&](std::uint32_t id) {
    const Triangle& triangle = scene.baked.triangles[id];
    const std::optional<Crossing> crossing = sheared.hit(triangle, id);
    if (!crossing || crossing->t >= distance) return distance;
    const Passage passed = passage(*scene.scene, triangle, crossing->weights, ray.direction);
    share *= passed.share;
    if (passed.absorbs) {
      const double signed_metres = glm::dot(triangle.normal, ray.direction) > 0.0 ? crossing->t : -crossing->t;
      optical_depth += signed_metres * glm::dvec3(scene.scene->materials[triangle.material].absorption);
    }
    return share == glm::dvec3(0.0) ? -std::numeric_limits<double>::infinity() : distance;
  });
  return share * glm::exp(-glm::max(optical_depth, glm::dvec3(0.0)));
}

glm::dvec3 visibility(const TracedScene& scene, const Hit& hit, const ShadingFrame& frame,
                      const LightArrival& arrival) {
  if (glm::dot(frame.geometric_normal, arrival.direction) > 0.0)
    return transmittance(scene, {frame.position, arrival.direction}, arrival.distance, hit.triangle);
  if (glm::dot(frame.geometric_normal, frame.rise) <= 0.0) return glm::dvec3(0.0);
  const bool ends = std::isfinite(arrival.distance);
  const glm::dvec3 way = ends ? arrival.distance * arrival.direction - frame.rise : arrival.direction;
  const Ray ray{frame.position + frame.rise, glm::normalize(way)};
  if (crosses_own(scene.baked.triangles[hit.triangle], hit.weights, frame.rise, ray.direction) ||
      !is_free(scene, frame.position, frame.rise, hit.triangle)) {
    return glm::dvec3(0.0);
  }
  return transmittance(scene, ray, ends ? glm::length(way) : arrival.distance, hit.triangle);
}

}  // namespace vernier::reference
