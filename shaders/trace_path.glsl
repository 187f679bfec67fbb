// One ray of the ray tree: what it sees and which rays follow. shaders/README.md, Image formation 5.
#ifndef VERNIER_TRACE_PATH_GLSL
#define VERNIER_TRACE_PATH_GLSL

#include "direct_light.glsl"
#include "environment.glsl"
#include "scatter_direction.glsl"

// Rays that follow from a hit; a weight of 0 means none.
struct Children {
  PathRay reflected;
  PathRay refracted;
  PathRay passed;
};

struct RayResult {
  vec3 radiance;  // already weighed
  bool hit;
  bool finished;  // false: cut off by a loop limit; the ray has to be traced again
  Children children;
};

// `weight`, or 0 where a ray of that weight is not traced.
vec3 kept_weight(IN(vec3) weight) {
  float largest = max3(weight);
  return largest > 0.0f && largest >= render_constants().cutoff ? weight : vec3(0.0f);
}

PathRay child_ray(IN(PathRay) parent, IN(SurfacePoint) surface, IN(vec3) direction, IN(vec3) weight, IN(uint) medium) {
  return PathRay(spawn_origin(surface, direction), direction, weight, 0.0f, NONE, parent.depth + 1u, medium);
}

PathRay no_ray() { return PathRay(vec3(0.0f), vec3(0.0f), vec3(0.0f), 0.0f, NONE, 0u, NONE); }

bool is_ray(IN(PathRay) ray) { return max3(ray.weight) > 0.0f; }

// Weights of the reflected and the refracted ray at a transmissive surface.
void split_weights(IN(DeviceMaterial) material, IN(ShadingTerms) terms, IN(Fresnel) fresnel, OUT(vec3) reflected, OUT(vec3) refracted) {
  bool total = fresnel.reflected >= 1.0f && fresnel.transmitted == 0.0f;
  if (workflow_of(material) == WORKFLOW_BLINN && !has_flag(material, MATERIAL_FRESNEL_REFLECTION)) {
    reflected = total ? vec3(1.0f) : terms.mirror;
    refracted = total ? vec3(0.0f) : terms.transmission * (vec3(1.0f) - terms.mirror);
  } else {
    reflected = terms.reflection_tint * fresnel.reflected;
    refracted = terms.transmission * fresnel.transmitted;
  }
}

// Reflected and refracted ray of a hit that `weight` reaches.
void scatter(IN(PathRay) parent, IN(SurfacePoint) surface, IN(DeviceMaterial) material, IN(ShadingTerms) terms, IN(vec3) weight,
             INOUT(Children) children) {
  vec3 to_viewer = -parent.direction;
  vec3 normal = scatter_normal(surface.normal, to_viewer);
  float cosine = clamp(dot_product(normal, to_viewer), 0.0f, 1.0f);
  vec3 reflected = terms.mirror + (terms.mirror_grazing - terms.mirror) * schlick_weight(cosine);
  if (effect_on(EFFECT_REFRACTION) && max3(terms.transmission) > 0.0f) {
    bool thin = has_flag(material, MATERIAL_THIN_WALLED);
    float eta = surface.front || thin ? material.ior : 1.0f / material.ior;
    Fresnel fresnel = fresnel_dielectric(cosine, eta);
    vec3 refracted = vec3(0.0f);
    split_weights(material, terms, fresnel, reflected, refracted);
    vec3 direction =
        thin ? parent.direction : refracted_direction(to_viewer, normal, surface.geometric_normal, eta, fresnel);
    uint medium = thin ? parent.medium : surface.front ? surface.material : NONE;
    children.refracted = child_ray(parent, surface, direction, kept_weight(weight * refracted), medium);
  }
  if (effect_on(EFFECT_REFLECTION)) {
    vec3 direction = mirrored_direction(to_viewer, normal, surface.geometric_normal);
    children.reflected = child_ray(parent, surface, direction, kept_weight(weight * reflected), parent.medium);
  }
}

// Follows `ray` to its closest hit.
RayResult trace_ray(IN(PathRay) ray, INOUT(RayCounts) counts) {
  RayResult result = RayResult(vec3(0.0f), false, true, Children(no_ray(), no_ray(), no_ray()));
  Hit hit = no_hit(LARGEST_FLOAT);
  TraversalCost cost = traverse_bvh(Ray(ray.origin, ray.direction), ray.t_min, ray.after_triangle, false, hit);
  count_cost(counts, cost);
  result.finished = cost.finished;
  if (hit.triangle == NONE) {
    result.radiance = ray.weight * environment_radiance(ray.direction);
    return result;
  }
  TrianglePoint point = triangle_point(hit);
  DeviceMaterial material = fetch_material(point.vertices.w);
  SlotTexels texels = fetch_slot_texels(point, material, readable_slots());
  vec4 color = vertex_color(point);
  result.finished = result.finished && texels.finished;
  vec3 weight = ray.weight;
  if (effect_on(EFFECT_ABSORPTION) && ray.medium != NONE) weight *= exp(-fetch_absorption(ray.medium) * hit.t);
  float alpha = 1.0f;
  if (effect_on(EFFECT_ALPHA_MASK) || effect_on(EFFECT_ALPHA_BLEND)) {
    alpha = surface_alpha(material, texels, color);
    if (alpha < 1.0f) {
      // The same ray goes on behind the hit; the part of it in the medium is weighed when it ends.
      result.children.passed = PathRay(ray.origin, ray.direction, kept_weight(ray.weight * (1.0f - alpha)), hit.t, hit.triangle, ray.depth, ray.medium);
    }
  }
  result.hit = alpha > 0.0f;
  weight *= alpha;
  SurfacePoint surface = surface_point(point, material, texels, ray.direction);
  ShadingTerms terms = shading_terms(material, texels, first_three(color));
  if (effect_on(EFFECT_UNLIT) && has_flag(material, MATERIAL_UNLIT)) {
    result.radiance = weight * terms.base;
    return result;
  }
  vec3 radiance = terms.emission;
  if (effect_on(EFFECT_AMBIENT)) radiance += terms.ambient * ambient_radiance(surface.normal);
  if (effect_on(EFFECT_POINT_LIGHTS) || effect_on(EFFECT_DIRECTIONAL_LIGHTS)) {
    Transmittance direct = direct_light(surface, terms, -ray.direction, alpha > 0.0f, counts);
    radiance += direct.value;
    result.finished = result.finished && direct.finished;
  }
  result.radiance = weight * radiance;
  if ((effect_on(EFFECT_REFLECTION) || effect_on(EFFECT_REFRACTION)) && ray.depth < render_constants().max_bounces) {
    scatter(ray, surface, material, terms, weight, result.children);
  }
  return result;
}

// Puts the children of a finished ray into the path; false when the sample is done.
bool next_ray(INOUT(Path) path, IN(Children) children, INOUT(RayCounts) counts) {
  bool reflected = is_ray(children.reflected);
  bool refracted = is_ray(children.refracted);
  bool passed = is_ray(children.passed);
  counts.reflection += reflected ? 1u : 0u;
  counts.refraction += refracted ? 1u : 0u;
  // The deepest ray goes first and what passes waits lowest: so at most two rays wait per depth.
  if (passed && (reflected || refracted)) push_ray(path, counts, children.passed);
  if (reflected && refracted) push_ray(path, counts, children.reflected);
  if (refracted) {
    path.current = children.refracted;
  } else if (reflected) {
    path.current = children.reflected;
  } else if (passed) {
    path.current = children.passed;
  } else {
    if (path.waiting == 0u) return false;
    path.current = pop_ray(path);
  }
  return true;
}

#endif
