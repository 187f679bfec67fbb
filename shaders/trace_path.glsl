// The ray tree of a sample, one search after the other: what a ray sees, which lights reach that and which rays follow.
// shaders/README.md, Image formation 5.
#ifndef VERNIER_TRACE_PATH_GLSL
#define VERNIER_TRACE_PATH_GLSL

#include "count_runs.glsl"
#include "direct_light.glsl"
#include "environment.glsl"
#include "scatter_direction.glsl"
#include "transmittance.glsl"
#include "search_scene.glsl"

// Rays that follow from a hit; a weight of 0 means none.
struct Children {
  PathRay reflected;
  PathRay refracted;
  PathRay passed;
};

// What a path does at the end of a search.
struct Step {
  Children children;  // of the current ray, where it is done
  bool ray_done;
  bool asks_light;    // a shadow ray begins, or the search for what lies below a rounded surface; both count as shadow rays
  bool finished;      // false: cut off by a loop limit, nothing has changed and the search has to be made again
};

// `weight`, or 0 where a ray of that weight is not traced.
vec3 kept_weight(IN(vec3) weight) {
  float largest = max3(weight);
  vec3 kept = largest > 0.0f && largest >= render_constants().cutoff ? weight : vec3(0.0f);
  if (mutated(MUTATION_SHORT_FLOATS)) kept = uintBitsToFloat(floatBitsToUint(kept) & HALF_FLOAT_BITS);
  return kept;
}

PathRay child_ray(IN(PathRay) parent, IN(SurfacePoint) surface, IN(vec3) direction, IN(vec3) weight, IN(uint) medium) {
  return PathRay(spawn_origin(surface, direction), direction, weight, 0.0f, NONE, parent.depth + 1u, medium);
}

bool is_ray(IN(PathRay) ray) { return max3(ray.weight) > 0.0f; }

// Weights of the reflected and the refracted ray at a transmissive surface.
void split_weights(IN(DeviceMaterial) material, IN(ShadingTerms) terms, IN(Fresnel) fresnel, OUT(vec3) reflected, OUT(vec3) refracted) {
  bool total = is_total(fresnel);
  if (is_fresnel_free(material)) {
    reflected = total ? vec3(1.0f) : terms.mirror;
    refracted = total ? vec3(0.0f) : terms.transmission * (vec3(1.0f) - terms.mirror);
  } else {
    reflected = boundary_reflectance(fresnel, material.ior, terms.mirror, terms.mirror_grazing);
    refracted = terms.transmission * boundary_transmittance(fresnel, material.ior, terms.boundary_normal, terms.boundary_grazing);
  }
  if (total && mutated(MUTATION_TOTAL_LOST)) reflected = vec3(0.0f);
}

// Reflected and refracted ray of a hit that `weight` reaches.
void scatter(IN(PathRay) parent, IN(SurfacePoint) surface, IN(DeviceMaterial) material, IN(ShadingTerms) terms, IN(vec3) weight,
             INOUT(Children) children) {
  vec3 to_viewer = -parent.direction;
  vec3 normal = scatter_normal(surface.normal, to_viewer);
  float cosine = clamp(dot_product(normal, to_viewer), 0.0f, 1.0f);
  vec3 reflected = terms.mirror + (terms.mirror_grazing - terms.mirror) * schlick_weight(cosine);
  if (effect_on(EFFECT_REFRACTION) && max3(terms.transmission) > 0.0f) {
    note_run(EFFECT_REFRACTION);
    bool thin = has_flag(material, MATERIAL_THIN_WALLED);
    float eta = surface.front || thin ? material.ior : 1.0f / material.ior;
    Fresnel fresnel = fresnel_dielectric(cosine, eta);
    vec3 refracted = vec3(0.0f);
    split_weights(material, terms, fresnel, reflected, refracted);
    vec3 direction =
        thin ? parent.direction : refracted_direction(to_viewer, normal, surface.geometric_normal, eta, fresnel);
    uint outside = mutated(MUTATION_MEDIUM_KEPT) ? parent.medium : NONE;
    uint medium = thin ? parent.medium : surface.front ? surface.material : outside;
    children.refracted = child_ray(parent, surface, direction, kept_weight(weight * refracted), medium);
  }
  if (effect_on(EFFECT_REFLECTION)) {
    note_run(EFFECT_REFLECTION);
    vec3 direction = mirrored_direction(to_viewer, normal, surface.geometric_normal);
    children.reflected = child_ray(parent, surface, direction, kept_weight(weight * reflected), parent.medium);
  }
}

// The search that the path waits for. In PHASE_LIGHT, and without a job, there is nothing to look for: no ray.
Search path_search(IN(Path) path) {
  bool shadow = path.phase == PHASE_SHADOW || path.phase == PHASE_RISE;
  Ray ray = Ray(path.current.origin, path.current.direction);
  if (shadow) ray = path.visit.ray;
  if (path.phase == PHASE_LIGHT || path.job == NONE) ray.direction = vec3(0.0f);
  return Search(ray, shadow ? path.visit.t_min : path.current.t_min,
                shadow ? path.visit.after_triangle : path.current.after_triangle,
                shadow ? path.visit.t_max : LARGEST_FLOAT, shadow);
}

// Emission, ambient light and the next light of the current ray's hit; with the last light, the rays that follow. `weight`
// reaches the surface.
void shade_lit(INOUT(Path) path, INOUT(Step) result, IN(HitSurface) surface, IN(SlotTexels) texels, IN(vec3) weight) {
  PathRay ray = path.current;
  SurfacePoint at = surface_point(surface.point, surface.material, texels, ray.direction);
  vec3 radiance = vec3(0.0f);
  if (path.phase == PHASE_HIT) {
    radiance = surface.terms.emission;
    if (max3(radiance) > 0.0f) note_run(EFFECT_EMISSION);
    if (effect_on(EFFECT_AMBIENT)) {
      note_run(EFFECT_AMBIENT);
      radiance += surface.terms.ambient * ambient_radiance(at.normal);
    }
    path.visit.next_light = 0u;
  }
  result.ray_done = true;
  if ((effect_on(EFFECT_POINT_LIGHTS) || effect_on(EFFECT_DIRECTIONAL_LIGHTS)) && surface.alpha > 0.0f) {
    path.phase = ask_lights(at, surface.terms, -ray.direction, path.phase == PHASE_RISE, path.visit, radiance);
    path.visit.value *= weight;
    result.asks_light = path.phase != PHASE_LIGHT;
    result.ray_done = !result.asks_light && lights_are_done(path.visit);
  }
  path.radiance += weight * radiance;
  if (result.ray_done && (effect_on(EFFECT_REFLECTION) || effect_on(EFFECT_REFRACTION)) &&
      ray.depth < render_constants().max_bounces) {
    scatter(ray, at, surface.material, surface.terms, weight, result.children);
  }
}

// The current ray's hit `hit` on `surface`, for the first time or once more for the next light.
void shade(INOUT(Path) path, INOUT(Step) result, IN(Hit) hit, IN(HitSurface) surface, IN(SlotTexels) texels) {
  PathRay ray = path.current;
  vec3 weight = ray.weight;
  if (effect_on(EFFECT_ABSORPTION) && ray.medium != NONE) {
    note_run(EFFECT_ABSORPTION);
    weight *= exp(-fetch_absorption(ray.medium) * surface.point.t);
  }
  if (rays_pass_hits() && surface.alpha < 1.0f) {
    // The same ray goes on behind the hit; the part of it in the medium is weighed when it ends.
    result.children.passed = PathRay(ray.origin, ray.direction, kept_weight(ray.weight * (1.0f - surface.alpha)), hit.t,
                                     hit.triangle, ray.depth, ray.medium);
  }
  weight *= surface.alpha;
  path.hit = path.hit || (surface.alpha > 0.0f && ray.depth == 0u);
  path.visit.hit = hit;
  if (effect_on(EFFECT_UNLIT) && has_flag(surface.material, MATERIAL_UNLIT)) {
    note_run(EFFECT_UNLIT);
    path.radiance += weight * surface.terms.base;
    result.ray_done = true;
  } else {
    shade_lit(path, result, surface, texels, weight);
  }
}

// Takes the path on by the answer to its search. Functions have one way out: compilers turn another into more branches, and
// llvmpipe pays for every word of a path at the end of each.
Step step_of(INOUT(Path) path, IN(Found) found) {
  Step result = Step(Children(no_ray(), no_ray(), no_ray()), false, false, found.finished);
  bool struck = found.hit.triangle != NONE;
  bool looks_for_hit = path.phase == PHASE_HIT;
  bool in_the_way = effect_on(EFFECT_TINTED_SHADOWS) && path.phase == PHASE_SHADOW && struck && !found.is_opaque;
  if (looks_for_hit && !struck) {
    if (found.finished) path.radiance += path.current.weight * environment_radiance(path.current.direction);
    result.ray_done = found.finished;
  } else {
    // A shadow ray that got through, or ended, leads back to the hit it left: to the next light there.
    Hit hit = path.visit.hit;
    if (looks_for_hit || in_the_way) hit = found.hit;
    HitSurface surface;
    Ray ray = Ray(path.current.origin, path.current.direction);
    if (in_the_way) ray = path.visit.ray;
    surface.point = triangle_point(ray, hit);
    surface.material = fetch_material(surface.point.vertices.w);
    SlotTexels texels = fetch_slot_texels(surface.point, surface.material, readable_slots());
    vec4 color = vertex_color(surface.point);
    surface.terms = shading_terms(surface.material, texels, first_three(color));
    surface.alpha = rays_pass_hits() ? surface_alpha(surface.material, texels, color) : 1.0f;
    result.finished = found.finished && texels.finished;
    if (result.finished) {
      if (path.phase == PHASE_SHADOW && !struck) path.radiance += arriving_light(path.visit);
      if (path.phase == PHASE_RISE && struck) path.phase = PHASE_LIGHT;
      if (in_the_way) {
        note_run(EFFECT_TINTED_SHADOWS);
        pass_surface(path.visit, hit, surface);
        path.phase = max3(path.visit.value) > 0.0f ? PHASE_SHADOW : PHASE_LIGHT;
      } else {
        shade(path, result, hit, surface, texels);
      }
    }
  }
  return result;
}

// Puts the children of a finished ray into the path; false when the sample is done.
bool next_ray(IN(uint) place, INOUT(Path) path, IN(Children) children, INOUT(RayCounts) counts) {
  bool reflected = is_ray(children.reflected);
  bool refracted = is_ray(children.refracted);
  bool passed = is_ray(children.passed);
  path.phase = PHASE_HIT;
  counts.reflection += reflected ? 1u : 0u;
  counts.refraction += refracted ? 1u : 0u;
  if (COUNT_EFFECTS) {
    uint begun = (reflected ? 1u : 0u) + (refracted ? 1u : 0u);
    add_to_counter(COUNTER_PATH_RAYS + counted_depth(path.current.depth + 1u), begun);
  }
  // The deepest ray goes first and what passes waits lowest: so at most two rays wait per depth.
  if (passed && (reflected || refracted)) push_ray(place, path, counts, children.passed);
  if (reflected && refracted) push_ray(place, path, counts, children.reflected);
  PathRay next = children.passed;
  if (reflected) next = children.reflected;
  if (refracted) next = children.refracted;
  bool goes_on = reflected || refracted || passed;
  if (!goes_on && PATH_STACK_SIZE > 0u && path.waiting > 0u) {
    next = pop_ray(place, path);
    goes_on = true;
  }
  path.current = next;
  return goes_on;
}

#endif
