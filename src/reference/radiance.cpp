#include "reference/radiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/fresnel.h"
#include "reference/light_arrival.h"
#include "reference/shading_frame.h"
#include "reference/surface_terms.h"

namespace vernier::reference {

namespace {

/// A ray on its way: what it is worth, how often it has turned, what it travels in.
struct Path {
  Ray ray;
  std::uint32_t source = kNoTriangle;
  glm::dvec3 weight = glm::dvec3(1.0);
  std::uint32_t depth = 0;
  const Material* medium = nullptr;
};

struct Context {
  const TracedScene& scene;
  const PathLimits& limits;
};

/// A hit with all that shading asks for.
struct Surface {
  const Hit& hit;
  const Material& material;
  ShadingFrame frame;
  SurfaceTerms terms;
  glm::dvec3 view;  // unit, towards where the ray came from
};

double max3(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

bool is_traced(const Context& context, const glm::dvec3& weight) {
  return max3(weight) > 0.0 && max3(weight) >= context.limits.cutoff;
}

double highlight(const Surface& surface, const glm::dvec3& to_light) {
  const glm::dvec3 sum = to_light + surface.view;
  const double length = glm::length(sum);
  if (length == 0.0) return 0.0;
  const double cosine = glm::dot(surface.frame.shading_normal, sum) / length;
  return cosine > 0.0 ? std::pow(std::min(cosine, 1.0), surface.terms.exponent) : 0.0;
}

glm::dvec3 lit_by(const Context& context, const Surface& surface, const Light& light) {
  const auto arrival = light_arrival(light, surface.frame.position);
  if (!arrival) return glm::dvec3(0.0);
  const double cosine = glm::dot(surface.frame.shading_normal, arrival->direction);
  if (cosine <= 0.0) return glm::dvec3(0.0);
  const SurfaceTerms& terms = surface.terms;
  const glm::dvec3 scattered = terms.diffuse * (cosine / std::numbers::pi) +
                               terms.specular * highlight(surface, arrival->direction) * (terms.cosine ? cosine : 1.0);
  if (scattered == glm::dvec3(0.0)) return glm::dvec3(0.0);
  return arrival->irradiance * scattered * visibility(context.scene, surface.hit, surface.frame, *arrival);
}

glm::dvec3 direct_light(const Context& context, const Surface& surface) {
  const SurfaceTerms& terms = surface.terms;
  glm::dvec3 sum =
      terms.emission + terms.ambient * ambient_radiance(context.scene.environment, surface.frame.shading_normal);
  for (const Light& light : context.scene.scene->lights) sum += lit_by(context, surface, light);
  return sum;
}

/// Weights of the two rays that follow a hit.
struct Split {
  glm::dvec3 reflected = glm::dvec3(0.0);
  glm::dvec3 refracted = glm::dvec3(0.0);
};

Split split(const SurfaceTerms& terms, double cosine, double eta) {
  if (terms.transmission == glm::dvec3(0.0)) {
    const double grazing = std::pow(1.0 - cosine, 5.0);
    return {terms.mirror_normal + (terms.mirror_grazing - terms.mirror_normal) * grazing, glm::dvec3(0.0)};
  }
  const double reflectance = fresnel_reflectance(cosine, eta);
  if (reflectance == 1.0) return {glm::dvec3(1.0), glm::dvec3(0.0)};
  if (!terms.plain_mirror) {
    const double share = grazing_share(reflectance, eta);
    return {glm::max(glm::mix(terms.mirror_normal, terms.mirror_grazing, share), glm::dvec3(0.0)),
            terms.transmission * passed_share(terms, reflectance, eta)};
  }
  return {terms.mirror_normal, terms.transmission * (1.0 - terms.mirror_normal)};
}

// Shading normals can send a ray to the wrong side of the triangle; it is folded back at the triangle's plane.
glm::dvec3 kept_on_side(const glm::dvec3& direction, const glm::dvec3& outward) {
  const double height = glm::dot(direction, outward);
  return glm::normalize(height < 0.0 ? direction - 2.0 * height * outward : direction);
}

// Paths that have yet to be followed, the last one first: not recursion, which at a thousand bounces would want more
// stack than every thread has.
using WaitingPaths = std::vector<Path>;

void turn(const Context& context, const Path& path, const Surface& surface, const glm::dvec3& weight,
          WaitingPaths& waiting) {
  if (path.depth >= context.limits.max_bounces) return;
  const ShadingFrame& frame = surface.frame;
  const Material& material = surface.material;
  const double tilt = glm::dot(frame.shading_normal, surface.view);
  const glm::dvec3 normal =
      tilt < 0.0 ? glm::normalize(frame.shading_normal - 2.0 * tilt * surface.view) : frame.shading_normal;
  const double cosine = std::min(glm::dot(normal, surface.view), 1.0);
  const double ior = material.ior;
  const double eta = frame.front || material.thin_walled ? ior : 1.0 / ior;
  const Split weights = split(surface.terms, cosine, eta);

  Path child{{frame.position, {}}, surface.hit.triangle, weight * weights.reflected, path.depth + 1, path.medium};
  if (is_traced(context, child.weight)) {
    child.ray.direction = kept_on_side(2.0 * cosine * normal - surface.view, frame.geometric_normal);
    waiting.push_back(child);
  }
  child.weight = weight * weights.refracted;
  if (is_traced(context, child.weight)) {
    child.ray.direction = material.thin_walled
                              ? -surface.view
                              : kept_on_side(refracted_direction(surface.view, normal, eta), -frame.geometric_normal);
    if (!material.thin_walled) child.medium = frame.front ? &material : nullptr;
    waiting.push_back(child);
  }
}

// The light that one hit adds, `weight` included.
glm::dvec3 hit_light(const Context& context, const Path& path, const Hit& hit, const ShadingFrame& frame,
                     WaitingPaths& waiting) {
  const Triangle& triangle = context.scene.baked.triangles[hit.triangle];
  const Scene& scene = *context.scene.scene;
  const Surface surface{hit, scene.materials[triangle.material], frame, surface_terms(scene, triangle, hit.weights),
                        -path.ray.direction};
  const glm::dvec3 weight = path.weight * hit.coverage;
  if (surface.material.unlit) return weight * surface.terms.base;
  turn(context, path, surface, weight, waiting);
  return weight * direct_light(context, surface);
}

// One straight line through everything that alpha blends; the forks wait.
glm::dvec3 follow(const Context& context, Path path, std::optional<Hit> hit, WaitingPaths& waiting) {
  glm::dvec3 sum(0.0);
  for (;;) {
    if (!hit) return sum + path.weight * environment_radiance(*context.scene.scene, path.ray.direction);
    if (path.medium) path.weight *= glm::exp(-hit->t * glm::dvec3(path.medium->absorption));
    const ShadingFrame frame = shading_frame(context.scene, *hit, path.ray.direction);
    sum += hit_light(context, path, *hit, frame, waiting);
    path.weight *= 1.0 - hit->coverage;
    if (!is_traced(context, path.weight)) return sum;
    path.ray.origin = frame.position;
    path.source = hit->triangle;
    hit = closest_hit(context.scene, path.ray, path.source);
  }
}

}  // namespace

Arrival radiance(const TracedScene& scene, const PathLimits& limits, const Ray& ray) {
  const std::optional<Hit> first = closest_hit(scene, ray, kNoTriangle);
  const Context context{scene, limits};
  WaitingPaths waiting;
  glm::dvec3 sum = follow(context, Path{ray}, first, waiting);
  while (!waiting.empty()) {
    const Path path = waiting.back();
    waiting.pop_back();
    sum += follow(context, path, closest_hit(scene, path.ray, path.source), waiting);
  }
  return {sum, first.has_value()};
}

}  // namespace vernier::reference
